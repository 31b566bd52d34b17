// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/kiosk/procedure.h"

namespace obscura::app::kiosk {

/// Rows on their way to the disk, in order. A row stays until it is committed: when the store
/// fails, it and all after it wait for another try.
class Journal {
  public:
    /// `commit` returns when the row is on the disk, or throws having changed nothing.
    explicit Journal(std::function<void(const Row&)> commit) : commit_(std::move(commit)) {}

    void add(std::vector<Row> rows);
    /// Commits what waits. Gives the reason when that failed; then the rest still waits.
    [[nodiscard]] std::optional<std::string> flush();
    [[nodiscard]] const std::deque<Row>& waiting() const { return waiting_; }

  private:
    std::function<void(const Row&)> commit_;
    std::deque<Row> waiting_;
};

/// What a row is, without what it says: the answer to pair 2. A participant may read it.
[[nodiscard]] std::string name_of(const Row& row);

/// A row in words, with all that an answer says: for the terminal.
[[nodiscard]] std::string describe(const Row& row);

}  // namespace obscura::app::kiosk
