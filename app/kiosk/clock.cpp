// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/clock.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <optional>
#include <sstream>
#include <thread>

namespace obscura::app::kiosk {
namespace {

using Steady = std::chrono::steady_clock;

/// The scheduler may wake a thread this much too late; the rest of a wait polls the clock.
constexpr double kSchedulerSlack_s = 0.001;

[[nodiscard]] double wall_clock_s() {
    const auto since = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since).count();
}

[[nodiscard]] std::optional<double> parse_utc(const std::string& text) {
    std::tm parts{};
    std::istringstream in(text);
    in >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%S");
    if (in.fail()) return std::nullopt;
    double fraction = 0.0;
    if (in.peek() == '.') in >> fraction;
    return static_cast<double>(::timegm(&parts)) + fraction;
}

}  // namespace

double monotonic_s() {
    return std::chrono::duration<double>(Steady::now().time_since_epoch()).count();
}

std::string utc_text(double seconds_since_1970) {
    const double whole = std::floor(seconds_since_1970);
    const int milliseconds = static_cast<int>((seconds_since_1970 - whole) * 1000.0);
    const auto time = static_cast<std::time_t>(whole);
    std::tm parts{};
    ::gmtime_r(&time, &parts);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", parts.tm_year + 1900,
                       parts.tm_mon + 1, parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec,
                       milliseconds);
}

std::string utc_now() { return utc_text(wall_clock_s()); }

double seconds_between(const std::string& from_utc, const std::string& to_utc) {
    const std::optional<double> from = parse_utc(from_utc);
    const std::optional<double> to = parse_utc(to_utc);
    return from && to ? *to - *from : 0.0;
}

Moment moment_now() {
    const double now_s = monotonic_s();
    return {now_s, utc_now(), now_s};
}

Moment moment_at(double time_s) { return moment_of_press(time_s, time_s); }

Moment moment_of_press(double time_s, double pressed_s) {
    return {time_s, utc_text(wall_clock_s() - (monotonic_s() - time_s)), pressed_s};
}

void wait_until(double time_s) {
    const double asleep_s = time_s - kSchedulerSlack_s - monotonic_s();
    if (asleep_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(asleep_s));
    while (monotonic_s() < time_s) std::this_thread::yield();
}

}  // namespace obscura::app::kiosk
