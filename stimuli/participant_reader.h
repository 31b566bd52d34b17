// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stimuli/study.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {

// What a study file says to a participant: its texts, the kiosk's words, information, consent and
// the form. Each function notes what is wrong, at its line, and every text among the study's
// shown_texts.

/// A text that is not blank; `where` begins its messages: study. Empty where it is missing.
std::string read_shown_text(TableReader& reader, const std::string& where, const std::string& key,
                            TableReader::Need need, Study& study);

/// The kiosk's words: `language` of [study] and the root's table [texts], which may be null.
void read_words(TableReader& study_table, const toml::table* texts, Study& study,
                std::vector<StudyProblem>& problems);

/// The tables [information] and [consent].
void read_information(const toml::table& table, Study& study, std::vector<StudyProblem>& problems);
void read_consent(const toml::table& table, Study& study, std::vector<StudyProblem>& problems);

/// The table [form] with its [[form.field]].
void read_form(const toml::table& table, Study& study, std::vector<StudyProblem>& problems);

}  // namespace obscura::stimuli
