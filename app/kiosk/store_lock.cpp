// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/store_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "renderer/base/error.h"

namespace obscura::app::kiosk {
namespace {

constexpr std::string_view kSqliteScheme = "sqlite3://";
constexpr mode_t kMode = 0666;  // less the umask, as for the store

}  // namespace

StoreLock::StoreLock(const std::string& store_url) {
    if (!store_url.starts_with(kSqliteScheme)) return;
    const std::string store = store_url.substr(kSqliteScheme.size());
    // Links to one store lead to one lock.
    std::error_code error;
    std::filesystem::path path = std::filesystem::weakly_canonical(store, error);
    if (error) path = store;
    path += ".kiosk-lock";
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, kMode);
    if (descriptor_ < 0) {
        throw base::failure("cannot open {}, which keeps the store to one kiosk: {}", path.string(),
                            std::system_category().message(errno));
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
    const int reason = errno;
    ::close(descriptor_);
    if (reason == EWOULDBLOCK) {
        throw base::failure(
            "another kiosk is running on the store {}; leave that one first, or choose another "
            "store",
            store);
    }
    throw base::failure("cannot lock {}, which keeps the store to one kiosk: {}", path.string(),
                        std::system_category().message(reason));
}

StoreLock::~StoreLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace obscura::app::kiosk
