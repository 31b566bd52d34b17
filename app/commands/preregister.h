// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "stimuli/questions.h"
#include "stimuli/study.h"

namespace obscura::app {

/// What a pre-registration needs beside the study.
struct PreregisterRequest {
    std::filesystem::path folder;
    std::filesystem::path data;  ///< where the study's images lie
    int participants = 0;
    bool quiet = false;
    stimuli::Questions questions = {};  ///< that the study asks of each pair
};

/// Writes FOLDER/preregistration.md: hypotheses and family, margins, participants and their power,
/// order, rules of exclusion and stopping, the analysis and its seed, SHA-256 of the study file and
/// of every image; and gives its path. Throws bad input where the study fixes no hypothesis, where
/// an image is not ready, and where such a document is there already.
std::filesystem::path preregister(const stimuli::Study& study, const PreregisterRequest& request);

}  // namespace obscura::app
