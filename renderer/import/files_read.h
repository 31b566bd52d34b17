// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/import/import.h"
#include "renderer/import/notes.h"

namespace obscura::renderer::import_detail {

/// A file that is there and may be read.
struct FoundFile {
    std::filesystem::path path;  ///< as the scene leads to it
    std::filesystem::path key;   ///< without links: one for each file however it is called
};

/// The files around a scene: finds and reads them, within the limit of bytes, and keeps the list of
/// them. What lies outside the scene's own folder and those that ImportOptions allow, be it by
/// `..`, by an absolute path or by a link, is not touched.
class FilesRead {
  public:
    /// Names are relative to `folder`.
    FilesRead(const std::filesystem::path& folder,
              const std::vector<std::filesystem::path>& allowed_folders, Notes& notes);

    /// The file of that name; nothing and why in `why` where it is missing, no ordinary file or
    /// outside. A name whose case (with a note) or slashes are those of another system finds the
    /// file that differs in nothing else; one that begins with file: is a URI of a path.
    [[nodiscard]] std::optional<FoundFile> find(const std::string& name, std::string& why);

    /// The bytes of a file that find() gave, or nothing and why: too large, not readable. Read
    /// again, it counts no second time.
    [[nodiscard]] std::optional<std::string> read(const FoundFile& found, std::string& why);
    [[nodiscard]] std::optional<std::string> read(const std::string& name, std::string& why);

    /// The scene's own file, wherever its name leads to.
    [[nodiscard]] std::optional<std::string> read_scene(const std::string& name, std::string& why);

    [[nodiscard]] const std::vector<ImportedFile>& list() const { return list_; }

  private:
    struct Looked {
        std::optional<FoundFile> file;
        std::string why;
    };
    [[nodiscard]] Looked look_for(const std::string& name);
    [[nodiscard]] bool is_allowed(const std::filesystem::path& path) const;

    std::filesystem::path folder_;
    std::vector<std::filesystem::path> allowed_;  ///< without links, the scene's folder first
    Notes& notes_;
    std::map<std::string, Looked> known_;
    std::set<std::filesystem::path> read_;
    std::vector<ImportedFile> list_;
    std::size_t left_bytes_ = ImportLimits::kFileBytes;
};

/// `%20` and its like as the bytes they stand for (RFC 3986, 2.1); a stray % stays.
[[nodiscard]] std::string percent_decoded(std::string_view uri);

}  // namespace obscura::renderer::import_detail
