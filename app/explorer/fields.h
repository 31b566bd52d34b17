// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/explorer/desk.h"

namespace obscura::app::explorer {

/// A number between two ends.
struct NumberField {
    std::string name;
    std::string tooltip;
    std::string unit;
    double low = 0.0;
    double high = 1.0;
    double standard = 0.0;
    bool whole = false;
    double value = 0.0;
    std::string at_zero = {};  ///< what is shown in place of 0, where that stands for something
};

/// A slider with its name before it, marked where it is not at its standard, and a button that
/// puts it back. A double click lets one type. Gives the new value while it changes; what is typed
/// and not allowed is said and changes nothing.
[[nodiscard]] std::optional<double> number_field(Desk& desk, const NumberField& field);

/// A line's text read as a number of the field; where it is none, `problem` says what is allowed.
[[nodiscard]] std::optional<double> typed_number(const NumberField& field, const std::string& text,
                                                 std::string& problem);

/// One word out of a list, with its name before it; gives another that was chosen. `tooltips` may
/// be shorter than `words`. Marked where it is not `standard`, if there is one.
[[nodiscard]] std::optional<std::string> choice_field(Desk& desk, const std::string& name,
                                                      const std::string& tooltip,
                                                      const std::vector<std::string>& words,
                                                      const std::string& now,
                                                      const std::vector<std::string>& tooltips = {},
                                                      const std::string& standard = "");

/// A line of text. True when Enter was pressed.
bool text_field(const char* name, std::string& text, float width_px);

/// Shown over the item just drawn, wrapped.
void tooltip(const std::string& text);

[[nodiscard]] bool escape_pressed();

/// Two columns: names, and what follows them.
[[nodiscard]] bool begin_fields(const char* name);
void end_fields();

}  // namespace obscura::app::explorer
