// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "renderer/base/error.h"

namespace obscura::base {

/// Throws bad input unless low <= value <= high. NaN fails, because the test is negated.
template <typename T>
void check_range(std::string_view where, std::string_view name, T value, T low, T high) {
    if (!(value >= low && value <= high)) {
        throw bad_input("{}: {} is {}, allowed is {} to {}", where, name, value, low, high);
    }
}

/// Throws bad input unless low < value <= high. NaN fails, because the test is negated.
template <typename T>
void check_above(std::string_view where, std::string_view name, T value, T low, T high) {
    if (!(value > low && value <= high)) {
        throw bad_input("{}: {} is {}, allowed is more than {} and at most {}", where, name, value,
                        low, high);
    }
}

}  // namespace obscura::base
