// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::app::kiosk {

/// Keeps an SQLite store to one kiosk: while it lives, a second lock on the same store is refused.
/// Only so is an open session one that was cut off, and never one that another kiosk is playing.
/// The lock is on the file STORE.kiosk-lock beside the store, which stays there and says nothing;
/// the system releases the lock when the program ends, however it ends (flock(2)). Programs that
/// only read are not kept out. A PostgreSQL store is not locked: several kiosks may share it.
class StoreLock {
  public:
    /// Throws failure when another kiosk holds the store, or the lock cannot be had.
    explicit StoreLock(const std::string& store_url);
    ~StoreLock();
    StoreLock(const StoreLock&) = delete;
    StoreLock& operator=(const StoreLock&) = delete;

  private:
    int descriptor_ = -1;  ///< of the lock's file; -1: nothing to lock
};

}  // namespace obscura::app::kiosk
