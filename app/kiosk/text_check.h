// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// What of a text (UTF-8) the pages cannot set rightly, a sentence for each kind: it names the
/// characters with their code points, and the package of a font that this machine lacks, or
/// what to do about them. Empty: all is well. `language` (BCP 47) is that of the page.
[[nodiscard]] std::vector<std::string> problems_of_text(const std::string& text,
                                                        const std::string& language = "en");

/// The same for all that a participant of the study reads, each problem at its line; those of the
/// kiosk's own words are told once, of the whole file.
[[nodiscard]] std::vector<stimuli::StudyProblem> problems_of_texts(const stimuli::Study& study);

/// A sentence where the kiosk's words are not all in the study's language, nor given by the study:
/// those are English. Empty: they are.
[[nodiscard]] std::string note_on_words(const stimuli::Study& study);

}  // namespace obscura::app::kiosk
