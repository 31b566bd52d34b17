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

/// A file that exists only if it was finished. Where the file system can, it has no name until
/// then, so that not even a killed program leaves a part of it behind.
class PartialFile {
  public:
    explicit PartialFile(const fs::path& target)
        : path_(target.string() + fmt::format(".part-{}", ::getpid())) {
        const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
        descriptor_ = ::open(parent.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0644);
        named_ = descriptor_ < 0;
        if (named_) {
            descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
        }
        if (descriptor_ < 0) {
            throw failure("cannot write {}: {}", target.string(), std::strerror(errno));
        }
    }
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;
    ~PartialFile() {
        if (descriptor_ >= 0) ::close(descriptor_);
        if (named_) ::unlink(path_.c_str());
    }

    void write(std::string_view bytes, const fs::path& target) {
        while (!bytes.empty()) {
            const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
            if (written < 0) {
                if (errno == EINTR) continue;
                fail("write", target);
            }
            bytes.remove_prefix(static_cast<size_t>(written));
        }
    }

    void keep_as(const fs::path& target) {
        if (::fsync(descriptor_) != 0) fail("write", target);
        if (!named_) {
            const std::string self = fmt::format("/proc/self/fd/{}", descriptor_);
            ::unlink(path_.c_str());
            if (::linkat(AT_FDCWD, self.c_str(), AT_FDCWD, path_.c_str(), AT_SYMLINK_FOLLOW) != 0) {
                fail("write", target);
            }
            named_ = true;
        }
        const int closed = ::close(descriptor_);
        descriptor_ = -1;
        if (closed != 0) fail("write", target);
        if (::rename(path_.c_str(), target.c_str()) != 0) fail("replace", target);
        named_ = false;
    }

  private:
    [[noreturn]] static void fail(const char* what, const fs::path& target) {
        throw failure("cannot {} {}: {}", what, target.string(), std::strerror(errno));
    }

    std::string path_;
    int descriptor_ = -1;
    bool named_ = false;  ///< the file is to be seen under path_
};

}  // namespace

std::string read_file(const fs::path& path) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        throw bad_input("cannot read {}: it is a directory", path.string());
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw bad_input("cannot read {}: {}", path.string(), std::strerror(errno));
    try {
        return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    } catch (const std::ios_base::failure&) {
        throw bad_input("cannot read {}: {}", path.string(), std::strerror(errno));
    }
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
    // What is not there yet is made where its nearest parent is; nothing is made before the work.
    fs::path there = folder.empty() ? "." : folder;
    while (!fs::exists(there, error)) {
        const fs::path parent = there.parent_path();
        there = parent.empty() ? "." : parent;
    }
    if (!fs::is_directory(there, error)) {
        throw bad_input("{}: {} is not a folder", option, there.string());
    }
    const fs::path probe = there / fmt::format(".probe-{}", ::getpid());
    const int descriptor = ::open(probe.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor < 0) {
        throw bad_input("{}: cannot {} {}: {}", option,
                        there == folder ? "write in the folder" : "make the folder",
                        folder.string(), std::strerror(errno));
    }
    ::close(descriptor);
    ::unlink(probe.c_str());
}

}  // namespace obscura::base
