// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "analysis/store/database.h"

namespace obscura::analysis {

/// Store::back_up, of an SQLite database.
std::filesystem::path back_up(Database& database, const std::filesystem::path& folder,
                              const std::string& utc, std::size_t keep);

}  // namespace obscura::analysis
