// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/attendance.h"
#include "analysis/conclusions/shown_image.h"

namespace obscura::analysis {

/// One thing that a reader should know before believing a result, with its number.
struct Caveat {
    std::string about;     ///< in a few words: `Sides`
    std::string sentence;  ///< what is so, counted; of what cannot be counted, why
};

/// What nobody asks and everybody should know: how well sides, places in the session and carry-over
/// came out balanced; what differs together by design, so that the answers cannot tell which of it
/// mattered (scene and validity, technique and samples, accuracy and darkness); images that recur
/// in several pairs; how many views a scene has; what of the display is known. All of it is counted
/// over the answers, the images and the sessions that are given. A point that cannot arise in the
/// study is left out.
[[nodiscard]] std::vector<Caveat> caveats_of(const Analysis& analysis,
                                             const std::vector<ShownImage>& images,
                                             const Possible<Attendance>& attendance);

}  // namespace obscura::analysis
