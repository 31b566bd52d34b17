// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace obscura::app {

/// What remembers when the answers to a study were looked at: a table in the data folder,
/// `looks/STUDY.csv` with a row for each new number of participants.
class LookLog {
  public:
    LookLog(const std::filesystem::path& data, const std::string& study);

    /// Participants at each look so far. Throws bad input for a table that is none.
    [[nodiscard]] const std::vector<std::int64_t>& looks() const { return looks_; }

    /// Notes a look with so many participants, unless there was one. What cannot be written is only
    /// warned of: the answers can be read all the same.
    void note(std::int64_t participants);

  private:
    std::filesystem::path file_;
    std::string text_;
    std::vector<std::int64_t> looks_;
};

}  // namespace obscura::app
