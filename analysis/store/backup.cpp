// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/backup.h"

#include <unistd.h>

#include <algorithm>
#include <vector>

#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

/// 2026-11-26T21:05:33.120Z as 20261126T210533Z.
std::string compact(const std::string& utc) {
    std::string name = utc.substr(0, 19);
    std::erase(name, '-');
    std::erase(name, ':');
    return name + 'Z';
}

/// Those of the store, oldest first: their names tell.
std::vector<fs::path> backups_of(const fs::path& folder, const std::string& stem) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with(stem + '-') && name.ends_with("Z.sqlite")) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

fs::path back_up(Database& database, const fs::path& folder, const std::string& utc,
                 std::size_t keep) {
    base::require_writable_folder(folder, "backups");
    fs::create_directories(folder);
    const std::string stem = fs::path(database.name()).stem().string();
    const fs::path file = folder / fmt::format("{}-{}.sqlite", stem, compact(utc));
    const fs::path part = folder / fmt::format(".{}.part", file.filename().string());
    std::error_code ignored;
    fs::remove(part, ignored);
    try {
        database.copy_to(part.string());
        // A copy that cannot be read is none.
        Database copy("sqlite3://" + part.string(), true);
        copy.guarded("read the backup", [&] { copy.require_whole(); });
    } catch (...) {
        fs::remove(part, ignored);
        throw;
    }
    fs::permissions(part, fs::perms::owner_read | fs::perms::owner_write);
    fs::rename(part, file);
    std::vector<fs::path> files = backups_of(folder, stem);
    for (std::size_t i = 0; i + keep < files.size(); ++i) fs::remove(files[i], ignored);
    return file;
}

}  // namespace obscura::analysis
