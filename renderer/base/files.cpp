// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "renderer/base/error.h"

namespace obscura::base {
namespace {

namespace fs = std::filesystem;

/// A file that exists only if it was finished: removed again unless kept.
class PartialFile {
  public:
    explicit PartialFile(const fs::path& target)
        : path_(target.string() + fmt::format(".part-{}", ::getpid())) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
        if (descriptor_ < 0) {
            throw failure("cannot write {}: {}", target.string(), std::strerror(errno));
        }
    }
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;
    ~PartialFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (!kept_) ::unlink(path_.c_str());
    }

    void write(std::string_view bytes, const fs::path& target) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0) {
                if (errno == EINTR) continue;
                throw failure("cannot write {}: {}", target.string(), std::strerror(errno));
            }
            bytes.remove_prefix(static_cast<size_t>(written));
        }
    }

    void keep_as(const fs::path& target) {
        const bool flushed = ::fsync(descriptor_) == 0;
        const int flush_error = errno;
        const bool closed = ::close(descriptor_) == 0;
        descriptor_ = -1;
        if (!flushed || !closed) {
            throw failure("cannot write {}: {}", target.string(),
                          std::strerror(flushed ? errno : flush_error));
        }
        if (::rename(path_.c_str(), target.c_str()) != 0) {
            throw failure("cannot rename {} to {}: {}", path_, target.string(),
                          std::strerror(errno));
        }
        kept_ = true;
    }

  private:
    std::string path_;
    int descriptor_ = -1;
    bool kept_ = false;
};

}  // namespace

std::string read_file(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        throw bad_input("cannot read {}: it is a directory", path.string());
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw bad_input("cannot read {}: {}", path.string(), std::strerror(errno));
    std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (stream.bad()) throw bad_input("cannot read {}: {}", path.string(), std::strerror(errno));
    return bytes;
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
    if (path.has_parent_path()) {
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        if (error) {
            throw failure("cannot make the folder {}: {}", path.parent_path().string(),
                          error.message());
        }
    }
    PartialFile file(path);
    file.write(bytes, path);
    file.keep_as(path);
}

void require_writable_folder(const fs::path& folder, std::string_view option) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        throw bad_input("{}: cannot make the folder {}: {}", option, folder.string(),
                        error.message());
    }
    if (!fs::is_directory(folder)) {
        throw bad_input("{}: {} is not a folder", option, folder.string());
    }
    const fs::path probe = folder / fmt::format(".probe-{}", ::getpid());
    const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor < 0) {
        throw bad_input("{}: cannot write in the folder {}: {}", option, folder.string(),
                        std::strerror(errno));
    }
    ::close(descriptor);
    ::unlink(probe.c_str());
}

}  // namespace obscura::base
