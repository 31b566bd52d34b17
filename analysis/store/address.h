// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace obscura::analysis {

/// Where a store is, as its URL says.
struct StoreAddress {
    std::string file;        ///< of SQLite; empty: PostgreSQL
    std::string connection;  ///< to PostgreSQL, as SOCI takes it: with the password, for no message
    std::string shown;       ///< for messages: the file, or the server's URL without a password
};

/// Reads sqlite3://FILE, or whatever libpq takes as a connection (PostgreSQL 15, 34.1.1): a URI
/// that begins with postgresql:// or postgres://, or words like host=... dbname=.... What it leaves
/// open libpq takes from the environment, a service file and ~/.pgpass. Throws bad input, without
/// any password, for what is neither.
[[nodiscard]] StoreAddress store_address(const std::string& url);

/// The URL for messages: without a password, whatever else is wrong with it.
[[nodiscard]] std::string without_password(const std::string& url);

}  // namespace obscura::analysis
