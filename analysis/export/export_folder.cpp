// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/export_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <sstream>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/own_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

constexpr const char* kListFile = ".obscura-export";
constexpr std::size_t kBufferBytes = std::size_t{1} << 20U;

void make_folder_of(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) {
        throw base::failure("cannot make the folder {}: {}", path.parent_path().string(),
                            error.message());
    }
}

/// Renames files to their places; unless all are kept, takes them away again and what stood there
/// goes back.
class Placement {
  public:
    Placement(fs::path from, fs::path to) : from_(std::move(from)), to_(std::move(to)) {}
    ~Placement() {
        std::error_code ignored;
        for (const std::string& name : placed_) remove_with_folders(name);
        for (const std::string& name : set_aside_) {
            fs::create_directories((to_ / name).parent_path(), ignored);
            fs::rename(aside(name), to_ / name, ignored);
        }
    }
    Placement(const Placement&) = delete;
    Placement& operator=(const Placement&) = delete;

    void set_aside(const std::string& name) {
        if (!fs::exists(fs::symlink_status(to_ / name))) return;
        move(to_ / name, aside(name));
        set_aside_.push_back(name);
    }
    void place(const std::string& name) {
        set_aside(name);
        move(from_ / name, to_ / name);
        placed_.push_back(name);
    }
    void keep() {
        placed_.clear();
        for (const std::string& name : set_aside_) remove_empty_folders(name);
        set_aside_.clear();
    }

  private:
    [[nodiscard]] fs::path aside(const std::string& name) const {
        return from_ / ".earlier" / name;
    }
    void remove_with_folders(const std::string& name) const {
        std::error_code ignored;
        fs::remove(to_ / name, ignored);
        remove_empty_folders(name);
    }
    void remove_empty_folders(const std::string& name) const {
        std::error_code error;
        for (fs::path part = fs::path(name).parent_path(); !part.empty() && !error;
             part = part.parent_path()) {
            fs::remove(to_ / part, error);  // refuses a folder that holds something
        }
    }
    static void move(const fs::path& from, const fs::path& to) {
        make_folder_of(to);
        std::error_code error;
        fs::rename(from, to, error);
        if (error) {
            throw base::failure("cannot rename {} to {}: {}", from.string(), to.string(),
                                error.message());
        }
    }

    fs::path from_;
    fs::path to_;
    std::vector<std::string> placed_;
    std::vector<std::string> set_aside_;
};

/// The files of the export that is in the folder; a list that was edited names none outside it.
std::vector<std::string> files_of_earlier(const fs::path& folder) {
    const fs::path list = folder / kListFile;
    std::vector<std::string> names;
    if (!fs::is_regular_file(list)) return names;
    std::istringstream lines(base::read_file(list));
    for (std::string line; std::getline(lines, line);) {
        const fs::path name(line);
        const bool inside = name.is_relative() && !name.empty() &&
                            name.lexically_normal() == name && *name.begin() != "..";
        if (inside && !fs::is_directory(fs::symlink_status(folder / name))) names.push_back(line);
    }
    return names;
}

}  // namespace

OutputFile::OutputFile(const fs::path& path) : path_(path) {
    make_folder_of(path);
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail();
    buffer_.reserve(kBufferBytes + kBufferBytes / 4);
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
    buffer_ += bytes;
    if (buffer_.size() >= kBufferBytes) flush();
}

void OutputFile::flush() {
    std::string_view left = buffer_;
    while (!left.empty()) {
        const ssize_t written = ::write(descriptor_, left.data(), left.size());
        if (written < 0 && errno != EINTR) fail();
        if (written > 0) left.remove_prefix(static_cast<std::size_t>(written));
    }
    buffer_.clear();
}

void OutputFile::close() {
    flush();
    if (::fsync(descriptor_) != 0) fail();
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail();
}

void OutputFile::fail() const {
    throw base::failure("cannot write {}: {}", path_.string(), std::strerror(errno));
}

void require_own_export_folder(const fs::path& folder) {
    const std::vector<std::string> own = files_of_earlier(folder);
    base::require_own_folder(folder, "--out", [&](const std::string& name) {
        return std::find(own.begin(), own.end(), name) != own.end();
    });
}

ExportFolder::ExportFolder(fs::path folder, bool overwrite)
    : folder_(std::move(folder)), overwrite_(overwrite) {
    base::require_writable_folder(folder_, "--out");
    earlier_ = files_of_earlier(folder_);
    if (!overwrite_ && !earlier_.empty()) {
        throw base::bad_input(
            "--out {}: an export of {} files ({}, ...) is there already; --force replaces it, or "
            "choose another folder",
            folder_.string(), earlier_.size(), earlier_.front());
    }
    if (earlier_.empty() && !overwrite_) require_own_export_folder(folder_);
    partial_ = folder_ / fmt::format(".export-{}", ::getpid());
}

ExportFolder::~ExportFolder() {
    std::error_code ignored;
    fs::remove_all(partial_, ignored);
}

fs::path ExportFolder::add(const std::string& name) {
    std::error_code ignored;
    const fs::file_status status = fs::symlink_status(folder_ / name, ignored);
    if (fs::is_directory(status)) {
        throw base::bad_input("--out {}: {} is a folder there", folder_.string(), name);
    }
    if (!overwrite_ && fs::exists(status)) {
        throw base::bad_input(
            "--out {}: {} is there already; --force overwrites, or choose another folder",
            folder_.string(), name);
    }
    names_.push_back(name);
    return partial_ / name;
}

void ExportFolder::add(const std::string& name, std::string_view bytes) {
    OutputFile file(add(name));
    file.write(bytes);
    file.close();
}

void ExportFolder::keep() {
    std::string list;
    for (const std::string& name : names_) list += name + '\n';
    base::write_file_atomically(partial_ / kListFile, list);
    const std::set<std::string> now(names_.begin(), names_.end());
    Placement placement(partial_, folder_);
    for (const std::string& name : earlier_) {
        if (!now.contains(name)) placement.set_aside(name);
    }
    for (const std::string& name : names_) placement.place(name);
    placement.place(kListFile);
    placement.keep();
}

}  // namespace obscura::analysis
