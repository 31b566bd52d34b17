// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/store/store.h"
#include "app/kiosk/procedure.h"

namespace obscura::app::kiosk {

/// Answers of a session whose store is on a server that is away: kept in an SQLite store on this
/// machine, each on the disk when keep() returns, and delivered once and in order when the server
/// answers again, also after this program has ended.
class Spool {
  public:
    /// In that folder, one file for each address of a server. Nothing is made before keep().
    Spool(const std::filesystem::path& folder, const std::string& store_url);

    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// Whether rows wait for the server.
    [[nodiscard]] bool waits() const;
    /// What the session had before, so that it is whole here; rows that went to the server. The
    /// session is this machine's from then on, also after this program has ended.
    void follow(const Row& row);
    /// Whether that session was the last that ran on this machine.
    [[nodiscard]] bool is_own(const std::string& session_id) const;
    /// Keeps a row that the server did not take. Throws where this machine cannot either.
    void keep(const Row& row);
    /// Brings all of it to the server, and forgets it. Throws, and keeps it, where that fails.
    void deliver(analysis::Store& store);

  private:
    std::filesystem::path file_;
    std::filesystem::path own_;  ///< file with the id of the session that ran here last
    std::vector<Row> session_;   ///< of the session under way, from its beginning
};

}  // namespace obscura::app::kiosk
