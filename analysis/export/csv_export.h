// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/export/contents.h"

namespace obscura::analysis {

/// A file of an export, not yet written.
struct ExportFile {
    std::string name;
    std::string bytes;
};

/// participants.csv, sessions.csv, trials.csv, conditions.csv (RFC 4180, UTF-8, LF, doubles in the
/// shortest digits that read back the same) and data_dictionary.json, which has for each file and
/// column the BIDS keys Description, Levels and Units.
[[nodiscard]] std::vector<ExportFile> csv_export(const StoreContents& contents);

/// Writes all of the files or none: first into the folder .export-PID in there, then each is
/// renamed to its place; when that fails half-way, what stood there before comes back. Only a
/// program killed between two renames leaves some files and not others, and the earlier ones in
/// .export-PID. Throws bad input when the folder cannot be written or a file is there already and
/// `overwrite` is false; failure, with nothing left behind, when writing fails.
void write_export(const std::vector<ExportFile>& files, const std::filesystem::path& folder,
                  bool overwrite);

}  // namespace obscura::analysis
