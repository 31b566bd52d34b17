// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace obscura::analysis {

/// Whom a study leaves out, fixed before any data: participants with less than any of these.
struct ExclusionRule {
    std::optional<double> min_catch_correct;     ///< share of catch trials, 0 to 1
    std::optional<double> min_repeat_agreement;  ///< share of repeated answers, 0 to 1
    std::optional<double> min_response_time_s;   ///< median time of the answers, from 0

    bool operator==(const ExclusionRule&) const = default;
};

/// What is allowed, where the text of SessionRecord::exclusion is not such a rule: an object of
/// JSON with any of min_catch_correct, min_repeat_agreement, min_response_time_s, or empty.
[[nodiscard]] std::optional<std::string> exclusion_problem(std::string_view text);

/// The rule of such a text; no member has a value where it is empty. Throws bad input that begins
/// with `where` for text that is no rule.
[[nodiscard]] ExclusionRule exclusion_rule(std::string_view text, std::string_view where);

}  // namespace obscura::analysis
