// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "renderer/import/import.h"

namespace obscura::renderer::import_detail {

/// The files around a scene: reads them, within the limit of bytes, and keeps the list of them.
class FilesRead {
  public:
    /// Names are relative to `folder`.
    explicit FilesRead(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The bytes of a file, or nothing and why in `why`: missing, no ordinary file, too large. A
    /// name whose case or slashes are wrong finds the file that differs in nothing else.
    [[nodiscard]] std::optional<std::string> read(const std::string& name, std::string& why);

    [[nodiscard]] const std::vector<ImportedFile>& list() const { return list_; }

  private:
    std::filesystem::path folder_;
    std::vector<ImportedFile> list_;
    std::size_t left_bytes_ = ImportLimits::kFileBytes;
};

/// `%20` and its like as the bytes they stand for (RFC 3986, 2.1); a stray % stays.
[[nodiscard]] std::string percent_decoded(std::string_view uri);

}  // namespace obscura::renderer::import_detail
