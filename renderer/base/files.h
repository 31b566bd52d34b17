// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace obscura::base {

/// The whole file as bytes. Throws bad input naming the path when it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Writes beside `path`, flushes to the disk and renames: a reader sees the old file or the whole
/// new one, never a part. Makes missing parent folders. On failure throws with the path and the
/// system's reason (exit code 1), removes the partial file and leaves an existing `path` as it was.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// Proves that a file can be made in the folder, or the folder itself; makes nothing. Throws bad
/// input (exit code 2) naming `option` and the path when that is not so.
void require_writable_folder(const std::filesystem::path& folder, std::string_view option);

}  // namespace obscura::base
