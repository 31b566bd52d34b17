// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct zip;

namespace obscura::stimuli {

/// What all files of an archive may hold together, bytes: a small archive can unfold to any size.
inline constexpr std::uint64_t kMostArchiveBytes = std::uint64_t{2} << 30U;

/// A file in an archive.
struct ArchivedFile {
    std::string name;   ///< with / between folders
    std::string bytes;  ///< its contents
};

/// Whether a file of that name lands below the folder that it is unpacked into and nowhere else: a
/// relative path of plain names.
[[nodiscard]] bool is_inside(const std::string& name);

/// Writes a ZIP archive beside and renames it. The same files give the same bytes: no time of day
/// is kept. PNGs are stored as they are. Throws bad input where all together are more than
/// kMostArchiveBytes, failure where it cannot be written.
void write_zip(const std::filesystem::path& file, const std::vector<ArchivedFile>& files);

/// A ZIP archive that is read. Nothing in it is trusted.
class ZipReader {
  public:
    /// Throws bad input naming the file: it is not there, no ZIP archive, holds more than
    /// kMostArchiveBytes, two files of one name, a name that is not inside, a link or anything else
    /// that is no plain file, or one that needs a password.
    explicit ZipReader(const std::filesystem::path& file);
    ~ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;

    /// Every file with its contents, in the archive's order. Throws bad input for one that is cut
    /// off or whose checksum is not that of its bytes.
    [[nodiscard]] std::vector<ArchivedFile> read_all() const;

  private:
    struct Entry {
        std::string name;
        std::uint64_t index = 0;
        std::uint64_t bytes = 0;
    };
    void list_entries();
    [[nodiscard]] std::string read(const Entry& entry) const;

    std::filesystem::path file_;
    struct zip* archive_ = nullptr;
    std::vector<Entry> entries_;
};

}  // namespace obscura::stimuli
