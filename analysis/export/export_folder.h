// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::analysis {

/// A file that is written from its beginning to its end.
class OutputFile {
  public:
    /// Makes the file and the folders above it. Throws failure naming the file.
    explicit OutputFile(const std::filesystem::path& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    /// All of it is on the disk when this returns; throws failure when that cannot be.
    void close();

  private:
    void flush();
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    int descriptor_ = -1;
    std::string buffer_;
};

/// Throws bad input where the folder holds files that no earlier export or report put there.
void require_own_export_folder(const std::filesystem::path& folder);

/// Files on their way into a folder: all of them get there or none. They are first made in the
/// folder .export-PID in there, then each is renamed to its place; when that fails half-way, what
/// stood there before comes back. Only a program killed between two renames leaves some files and
/// not others, and the earlier ones in .export-PID. The list .obscura-export names the files, so
/// that the next export into the folder replaces them all, also those that it has no like of.
class ExportFolder {
  public:
    /// Throws bad input when the folder cannot be written, or holds an export and `overwrite` is
    /// false.
    ExportFolder(std::filesystem::path folder, bool overwrite);
    /// Removes what was not kept.
    ~ExportFolder();
    ExportFolder(const ExportFolder&) = delete;
    ExportFolder& operator=(const ExportFolder&) = delete;

    /// Where to write the file of that name, which may have folders in it. Throws bad input when it
    /// is there already and may not be overwritten, or is a folder.
    [[nodiscard]] std::filesystem::path add(const std::string& name);
    /// A whole small file.
    void add(const std::string& name, std::string_view bytes);

    /// Brings the files to their places. Throws failure, with everything as it was, when it cannot.
    void keep();

  private:
    std::filesystem::path folder_;
    std::filesystem::path partial_;
    bool overwrite_;
    std::vector<std::string> names_;
    std::vector<std::string> earlier_;  ///< files of the export that was there
};

}  // namespace obscura::analysis
