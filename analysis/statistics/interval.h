// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::analysis {

/// From low to high, low <= high, in the unit of what it bounds.
struct Interval {
    double low = 0.0;
    double high = 0.0;
};

}  // namespace obscura::analysis
