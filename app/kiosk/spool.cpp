// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/spool.h"

#include "analysis/store/address.h"
#include "app/kiosk/recording.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"

namespace obscura::app::kiosk {

using analysis::Store;

namespace fs = std::filesystem;

Spool::Spool(const fs::path& folder, const std::string& store_url) {
    constexpr std::size_t kDigits = 16;
    const std::string server = analysis::store_address(store_url).shown;
    own_ =
        fs::absolute(folder) / ("session-" + base::sha256_hex(server).substr(0, kDigits) + ".txt");
    file_ =
        fs::absolute(folder) / ("spool-" + base::sha256_hex(server).substr(0, kDigits) + ".sqlite");
}

bool Spool::waits() const {
    std::error_code ignored;
    return fs::exists(file_, ignored);
}

void Spool::follow(const Row& row) {
    if (const auto* begin = std::get_if<BeginSession>(&row)) {
        session_.clear();
        base::write_file_atomically(own_, begin->session.session_id);
    }
    session_.push_back(row);
}

bool Spool::is_own(const std::string& session_id) const {
    std::error_code ignored;
    return fs::exists(own_, ignored) && base::read_file(own_) == session_id;
}

void Spool::keep(const Row& row) {
    Store here("sqlite3://" + file_.string(), Store::Access::kReadWrite);
    // The session's rows before this one make it whole; what is here already is passed over.
    for (const Row& before : session_) {
        if (!std::holds_alternative<analysis::EventRecord>(before)) commit(here, before);
    }
    commit(here, row);
    follow(row);
}

void Spool::deliver(Store& store) {
    analysis::MergedRows merged;
    {
        Store here("sqlite3://" + file_.string(), Store::Access::kReadWrite);
        merged = store.take_in(here);
    }
    fs::remove(file_);
    base::log::info(
        "the server answers again: {} answers and {} events that were kept here are "
        "delivered",
        merged.trials, merged.events);
}

}  // namespace obscura::app::kiosk
