// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "analysis/store/address.h"
#include "analysis/store/store.h"
#include "app/commands/list.h"
#include "app/kiosk/store_lock.h"
#include "renderer/base/log.h"

namespace obscura::app {
namespace {

using analysis::Store;

struct MergeOptions {
    std::string into;
    std::vector<std::string> files;
};

/// A file is a store too: of SQLite.
[[nodiscard]] std::string url_of(const std::string& file_or_url) {
    const bool is_url =
        file_or_url.find("://") != std::string::npos || file_or_url.find("dbname=") == 0;
    return is_url ? file_or_url : "sqlite3://" + file_or_url;
}

[[nodiscard]] std::string counted(int count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

base::ExitCode merge(const MergeOptions& options) {
    const std::string url = url_of(options.into);
    // No kiosk counts slots in a store that is being merged into.
    const kiosk::StoreLock lock(url);
    Store into(url, Store::Access::kReadWrite);
    for (const std::string& file : options.files) {
        Store from(url_of(file), Store::Access::kReadOnly);
        const analysis::MergedRows merged = into.take_in(from);
        fmt::print(
            "{}: {} with {} and {} merged into {}{}{}\n", analysis::without_password(file),
            counted(merged.sessions, "session", "sessions"),
            counted(merged.trials, "answer", "answers"), counted(merged.events, "event", "events"),
            analysis::without_password(options.into),
            merged.sessions_there == 0
                ? ""
                : fmt::format("; {} there before",
                              counted(merged.sessions_there, "session was", "sessions were")),
            merged.shared_slots == 0
                ? ""
                : fmt::format("; {} a row of the order with another kiosk's",
                              counted(merged.shared_slots, "session shares", "sessions share")));
    }
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_merge(const Options& command, const Globals&) {
    auto options = std::make_shared<MergeOptions>();
    command.add("--into", options->into, "Store to merge into: postgresql://... or sqlite3://FILE")
        .type("URL")
        .required();
    command.add("files", options->files, "Stores of kiosks that ran for themselves")
        .type("FILE")
        .required();
    command.footer(
        "All of a file or nothing: it is refused where the study file or its images are not those "
        "of the store. Merging a file again adds what it has more.");
    return [options] { return merge(*options); };
}

}  // namespace

Command merge_command() { return {"merge", "Join the stores of separate kiosks", &attach_merge}; }

}  // namespace obscura::app
