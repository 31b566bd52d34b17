// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// What of a text (UTF-8) the pages cannot set rightly, a sentence for each kind: it names the
/// characters with their code points, and the package of a font that this machine lacks, how to
/// write them otherwise, or that the kiosk does not support them yet. Empty: all is well.
///
/// The pages draw one glyph for each code point, from left to right, in one colour. That sets
/// rightly what is written so (Latin, Greek, Cyrillic, Chinese, Japanese, Korean ...), not what is
/// joined, reordered, stacked, or runs from right to left.
[[nodiscard]] std::vector<std::string> problems_of_text(const std::string& text);

/// The same for texts of a study, each problem at its line.
[[nodiscard]] std::vector<stimuli::StudyProblem> problems_of_texts(
    const std::vector<stimuli::ShownText>& texts);

}  // namespace obscura::app::kiosk
