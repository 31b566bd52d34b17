// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace obscura::app::kiosk {

inline constexpr std::size_t kShortestPin = 4;
inline constexpr std::size_t kLongestPin = 12;

/// Where a data folder keeps it.
[[nodiscard]] std::filesystem::path pin_file(const std::filesystem::path& data);

/// Keeps the PIN as a salted hash (yescrypt, by libcrypt), in a file that only its owner reads; an
/// empty one takes the PIN away. Throws bad input unless it is of kShortestPin to kLongestPin
/// digits.
void set_pin(const std::filesystem::path& file, const std::string& pin);

/// Whether that is the PIN; takes a tenth of a second.
[[nodiscard]] bool is_pin(const std::filesystem::path& file, const std::string& pin);

/// How long after so many wrong ones the next may be tried, in seconds: 1, 2, 4, up to a minute.
[[nodiscard]] double wait_after_wrong_s(int wrong);

}  // namespace obscura::app::kiosk
