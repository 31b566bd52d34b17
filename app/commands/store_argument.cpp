// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/store_argument.h"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace obscura::app {
namespace {

namespace fs = std::filesystem;

/// Those of simulated observers, in order.
std::vector<std::string> rehearsals_in(const fs::path& data) {
    std::vector<std::string> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(data / "rehearsal", none)) {
        if (entry.path().extension() == ".sqlite") found.push_back(entry.path().string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

Option add_store(const Options& app, std::string& store) {
    return app
        .add("--db", store,
             "Store of the answers: an SQLite file, also as sqlite3://FILE, or postgresql://... "
             "(default: DATA/responses.sqlite)")
        .type("FILE|URL");
}

std::string store_url_from(const std::string& word, const Globals& globals) {
    if (word.empty()) return globals.store_url();
    const bool is_url =
        word.find("://") != std::string::npos || word.find("dbname=") != std::string::npos;
    return is_url ? word : "sqlite3://" + word;
}

void refuse_no_answers(const std::string& word, const Globals& globals) {
    const fs::path file = globals.data / "responses.sqlite";
    std::error_code ignored;
    if (!word.empty() || fs::exists(file, ignored)) return;
    std::string simulated;
    for (const std::string& one : rehearsals_in(globals.data)) {
        simulated += fmt::format("; simulated answers: --db {} --kind simulated", one);
    }
    throw base::bad_input(
        "there are no answers yet: no {}; obscura run collects them, --db FILE names another "
        "store{}",
        file.string(), simulated);
}

}  // namespace obscura::app
