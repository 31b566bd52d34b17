// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/look_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "app/kiosk/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"

namespace obscura::app {
namespace {

constexpr const char* kHeader = "participants,looked_utc\n";

}  // namespace

LookLog::LookLog(const std::filesystem::path& data, const std::string& study)
    : file_(data / "looks" / (study + ".csv")), text_(kHeader) {
    std::error_code ignored;
    if (!std::filesystem::exists(file_, ignored)) return;
    text_ = base::read_file(file_);
    std::istringstream lines(text_);
    std::string line;
    std::getline(lines, line);
    for (int number = 2; std::getline(lines, line); ++number) {
        std::int64_t participants = 0;
        const char* const end = line.data() + line.size();
        const auto [comma, error] = std::from_chars(line.data(), end, participants);
        if (error != std::errc() || participants < 1 || comma == end || *comma != ',') {
            throw base::bad_input(
                "{}:{}: '{}', allowed is a number of participants from 1, a comma and a time",
                file_.string(), number, line);
        }
        looks_.push_back(participants);
    }
}

void LookLog::note(std::int64_t participants) {
    if (std::find(looks_.begin(), looks_.end(), participants) != looks_.end()) return;
    looks_.push_back(participants);
    text_ += fmt::format("{},{}\n", participants, kiosk::utc_now());
    try {
        std::filesystem::create_directories(file_.parent_path());
        base::write_file_atomically(file_, text_);
    } catch (const std::exception& error) {
        base::log::warn("this look at the answers is not remembered: {}", error.what());
    }
}

}  // namespace obscura::app
