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
    /// `require_in_place` throws when the store is no longer where it was.
    explicit Journal(
        std::function<void(const Row&)> commit, std::function<void()> require_in_place = [] {})
        : commit_(std::move(commit)), require_in_place_(std::move(require_in_place)) {}

    void add(std::vector<Row> rows);
    /// Commits what waits. Gives the reason when that failed; then the rest still waits. Also where
    /// nothing waits, the reason why the store is no longer what earlier rows went to.
    [[nodiscard]] std::optional<std::string> flush();
    [[nodiscard]] const std::deque<Row>& waiting() const { return waiting_; }

  private:
    std::function<void(const Row&)> commit_;
    std::function<void()> require_in_place_;
    std::deque<Row> waiting_;
};

/// What a row is, without what it says: the answer to pair 2. A participant may read it.
[[nodiscard]] std::string name_of(const Row& row);

/// A row in words, with all that an answer says: for the terminal.
[[nodiscard]] std::string describe(const Row& row);

}  // namespace obscura::app::kiosk
