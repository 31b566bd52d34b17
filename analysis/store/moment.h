// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::analysis {

/// How a store stays as it is while it is read. Of an SQLite file a million answers are copied in
/// some 1 s and read once in some 1.5 s; a kiosk that wants to write waits for either, 10 s at
/// most. A server keeps the moment for its readers by itself.
enum class Moment {
    kCopied,  ///< a copy is read: for who reads on
    kHeld,    ///< the store itself is read: for who reads once
};

}  // namespace obscura::analysis
