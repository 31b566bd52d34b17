// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/start_checks.h"

#include <fmt/ranges.h>

#include <cstdint>
#include <system_error>
#include <vector>

#include "analysis/store/address.h"
#include "app/kiosk/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "stimuli/pairs.h"

namespace obscura::app::kiosk {

void refuse_incomplete_stimuli(const stimuli::Study& study, const std::filesystem::path& folder,
                               const std::string& remedy) {
    const std::vector<std::string> problems = stimuli::problems_of_stimuli(study, folder);
    if (problems.empty()) return;
    throw base::bad_input("the stimuli of {} are not ready:\n  {}\nmake them with: {}", study.name,
                          fmt::join(problems, "\n  "), remedy);
}

void refuse_alike_pairs(const stimuli::Study& study, const stimuli::Manifest& manifest,
                        const std::filesystem::path& folder) {
    const std::vector<std::string> alike =
        stimuli::alike_pairs(study, stimuli::compared_pairs(study, manifest, folder));
    if (alike.empty()) return;
    throw base::bad_input(
        "{} has pairs that nobody can tell apart:\n  {}\nmend the study and render it again, or "
        "say identical = true in the condition of a pair that is meant so",
        study.name, fmt::join(alike, "\n  "));
}

void refuse_full_disk(const std::string& store_url) {
    constexpr std::uintmax_t kLeastBytes = 100'000'000;
    if (!store_url.starts_with("sqlite3://")) return;
    const std::filesystem::path file = analysis::store_address(store_url).file;
    std::error_code error;
    const auto space = std::filesystem::space(std::filesystem::absolute(file).parent_path(), error);
    if (error || space.available >= kLeastBytes) return;
    throw base::failure(
        "the disk of the store {} has room for {} MB only, needed are {} MB: make room, or choose "
        "another place with --db",
        file.string(), space.available / 1'000'000, kLeastBytes / 1'000'000);
}

void refuse_clock_that_ran_backwards(analysis::Store& store) {
    constexpr double kMost_s = 60.0;
    const std::string latest = store.latest_utc();
    if (latest.empty()) return;
    const std::string now = utc_now();
    if (seconds_between(now, latest) <= kMost_s) return;
    throw base::failure(
        "the clock ran backwards: it is {} now, and the store has answers of {}: set the clock of "
        "this machine",
        now, latest);
}

void refuse_loose_pace(const Pace& pace, const Window& window) {
    if (pace.locked) return;
    throw base::failure(
        "the refresh test failed: frames come {:.2f} ms apart, {} are {:.2f} ms: let "
        "swapping wait for the display (vblank_mode, the driver's settings), and turn off what "
        "composes windows",
        pace.measured_s * 1000.0,
        window.refresh_hz() > 0.0 ? fmt::format("the monitor's {:.0f} Hz", window.refresh_hz())
                                  : "60 Hz, since the monitor tells no rate,",
        pace.period_s * 1000.0);
}

void unless_overridden(const std::string& reason, const std::function<void()>& check) {
    try {
        check();
    } catch (const base::Error& error) {
        if (reason.empty()) {
            throw base::failure(
                "{}; --override \"REASON\" goes on all the same, and puts the reason into every "
                "row",
                error.what());
        }
        base::log::warn("{}; goes on: {}", error.what(), reason);
    }
}

}  // namespace obscura::app::kiosk
