// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stimuli/participant_form.h"

namespace obscura::app::kiosk {

/// What was answered to one field of the study's form.
struct FieldAnswer {
    std::string text;                 ///< of a text, number, scale, code or choice; empty: none
    std::vector<std::string> chosen;  ///< of choices
};

enum class FieldProblem { kNone, kMissing, kNoNumber, kOutOfRange };
[[nodiscard]] FieldProblem problem_of(const stimuli::FormField& field, const FieldAnswer& answer);

/// Without blanks around it; a code is compared and kept so, whatever the case of its letters.
[[nodiscard]] std::string trimmed(const std::string& text);

/// The number that somebody typed, with a point or a comma; nothing: it is none.
[[nodiscard]] std::optional<double> number_in(const std::string& text);

/// Fields and answers as the store keeps them: a JSON array of objects with field, kind, label,
/// unit (of a number), choices, levels (what the ends of a scale mean) and value, null where
/// nothing was answered. `answers` are in the order of the fields; those that are missing count as
/// none.
[[nodiscard]] std::string form_json(const std::vector<stimuli::FormField>& fields,
                                    const std::vector<FieldAnswer>& answers);

/// The answer to the field of that kind `code`; empty: the form asks for none, or none was given.
[[nodiscard]] std::string code_in(const std::vector<stimuli::FormField>& fields,
                                  const std::vector<FieldAnswer>& answers);

/// A new code that is none of `known`: six letters and digits that are not mistaken for each other.
[[nodiscard]] std::string make_code(const std::vector<std::string>& known);

/// Whether two codes are the same, whatever the case of their letters.
[[nodiscard]] bool is_same_code(const std::string& one, const std::string& other);

}  // namespace obscura::app::kiosk
