// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/store/database.h"

namespace obscura::analysis {

/// One step of the schema. Words in braces differ between the systems: {identity} a column that
/// numbers the rows as they come, {integer} 64-bit, {real} double precision, {strict} SQLite's
/// table option that makes it check types.
struct Migration {
    int version = 0;  ///< the schema's version after it; 1, 2, 3 ...
    std::vector<std::string> statements;
};

/// Every step from an empty database to the current schema. A published step never changes.
[[nodiscard]] const std::vector<Migration>& migrations();

/// The version that the database has; 0 when it is empty. Throws bad input for an SQLite database
/// that is somebody else's.
[[nodiscard]] int schema_version(Database& database);

/// Brings the database to the last of `steps` in one transaction. Throws bad input when it is newer
/// than that; nothing is changed then.
void migrate(Database& database, const std::vector<Migration>& steps);

/// Throws bad input unless the database has exactly the version of the last of `steps`.
void require_current(Database& database, const std::vector<Migration>& steps);

}  // namespace obscura::analysis
