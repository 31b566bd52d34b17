// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>

#include "analysis/store/address.h"
#include "analysis/store/store.h"
#include "app/commands/list.h"
#include "app/commands/store_argument.h"
#include "app/kiosk/store_lock.h"
#include "renderer/base/log.h"

namespace obscura::app {
namespace {

using analysis::Store;

struct MergeOptions {
    std::string into;
    std::vector<std::string> files;
};

[[nodiscard]] std::string counted(int count, const char* one, const char* several) {
    return fmt::format("{} {}", count, count == 1 ? one : several);
}

base::ExitCode merge(const MergeOptions& options, const Globals& globals) {
    const std::string url = store_url_from(options.into, globals);
    // No kiosk counts slots in a store that is being merged into.
    const kiosk::StoreLock lock(url);
    Store into(url, Store::Access::kReadWrite);
    for (const std::string& file : options.files) {
        Store from(store_url_from(file, globals), Store::Access::kReadOnly);
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

std::function<base::ExitCode()> attach_merge(const Options& command, const Globals& globals) {
    auto options = std::make_shared<MergeOptions>();
    command
        .add("--into", options->into,
             "Store to merge into: an SQLite file, also as sqlite3://FILE, or postgresql://...")
        .type("FILE|URL")
        .required();
    command.add("STORE", options->files, "Stores of kiosks that ran for themselves, as --into")
        .required();
    command.footer(
        "All of a file or nothing: it is refused where the study file or its images are not those "
        "of the store. Merging a file again adds what it has more.");
    return [options, &globals] { return merge(*options, globals); };
}

}  // namespace

Command merge_command() { return {"merge", "Join the stores of separate kiosks", &attach_merge}; }

}  // namespace obscura::app
