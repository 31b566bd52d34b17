// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::base {

/// The name of `names` that `word` is most likely a misspelling of: the fewest letters inserted,
/// removed, replaced or two neighbours exchanged, at most a third of the longer word; or nothing.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word,
                                                 const std::vector<std::string>& names);

/// `; did you mean NAME?`, the end of a message that refuses `word`; empty where none is near.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& names);

}  // namespace obscura::base
