// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/stimulus.h"

namespace obscura::stimuli {

/// Which images of a study to make.
struct Selection {
    std::string condition = {};  ///< id of one; empty: all
    int shard = 1;               ///< this one of `shards` parts, from 1
    int shards = 1;
    bool buffers = false;  ///< also CONDITION-a.exr, the buffers behind each image
    std::filesystem::path known =
        {};  ///< a folder whose finished images are taken over; may be empty
};

/// The selected images, those of one scene together so that it is built once, and of those the ones
/// of one view, so that their surfaces and light are made once. Throws bad input for an unknown
/// pair or part.
[[nodiscard]] std::vector<Stimulus> selected(const Study& study, const Selection& selection);

}  // namespace obscura::stimuli
