// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::stimuli {

/// What a participant agrees to before anything is asked.
struct Consent {
    std::string version;             ///< of the text, as the study names it
    std::string text;                ///< above the items; may be empty
    std::vector<std::string> items;  ///< each is to be ticked
};

enum class FieldKind {
    kText,
    kNumber,
    kChoice,   ///< one of several
    kChoices,  ///< any of several
    kScale,    ///< a whole number, by buttons
    kCode      ///< stands for the participant; typed, scanned, or made by the kiosk
};
inline constexpr std::array kFieldKinds{FieldKind::kText,    FieldKind::kNumber, FieldKind::kChoice,
                                        FieldKind::kChoices, FieldKind::kScale,  FieldKind::kCode};
[[nodiscard]] std::string_view to_string(FieldKind kind);

/// Characters that a text of the form or a code may have.
inline constexpr std::size_t kLongestFieldText = 100;
/// Buttons of a scale.
inline constexpr int kLongestScale = 11;

/// One question of the form.
struct FormField {
    std::string id;
    FieldKind kind = FieldKind::kText;
    std::string label = {};
    bool required = false;
    std::string unit = {};                  ///< of a number; may be empty
    std::optional<double> min = {};         ///< of a number or scale
    std::optional<double> max = {};         ///< of a number or scale
    std::vector<std::string> choices = {};  ///< of a choice or choices, in order
    std::vector<std::string> labels = {};   ///< of the two ends of a scale; may be empty
    bool generate = false;                  ///< the kiosk offers to make a code
};

}  // namespace obscura::stimuli
