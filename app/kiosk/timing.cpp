// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/timing.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::app::kiosk {
namespace {

using Json = nlohmann::ordered_json;

[[nodiscard]] Json json_of(const Figures& figures) {
    return {{"count", figures.count},
            {"mean", figures.mean},
            {"sd", figures.sd},
            {"worst", figures.worst}};
}

[[nodiscard]] Figures figures_in(const Json& json) {
    return {json.at("count"), json.at("mean"), json.at("sd"), json.at("worst")};
}

[[nodiscard]] Json json_of(const SelfTest& test) {
    return {{"time_utc", test.time_utc},
            {"display", test.display},
            {"gpu_renderer", test.gpu_renderer},
            {"source", test.source},
            {"told_hz", test.told_hz},
            {"frame_ms", test.frame_ms},
            {"waits", test.waits},
            {"interval_ms", test.interval_ms},
            {"error_ms", json_of(test.error_ms)},
            {"dropped_frames", test.dropped_frames},
            {"key_to_swap_ms", json_of(test.key_to_swap_ms)}};
}

[[nodiscard]] std::string text_of(const Figures& figures) {
    return fmt::format("mean {:.3f} ms, SD {:.3f} ms, worst {:.3f} ms, of {}", figures.mean,
                       figures.sd, figures.worst, figures.count);
}

}  // namespace

Figures figures_of(const std::vector<double>& values) {
    Figures figures;
    figures.count = static_cast<int>(values.size());
    if (values.empty()) return figures;
    const auto n = static_cast<double>(values.size());
    for (const double value : values) {
        figures.mean += value / n;
        if (std::abs(value) > std::abs(figures.worst)) figures.worst = value;
    }
    double squares = 0.0;
    for (const double value : values) squares += (value - figures.mean) * (value - figures.mean);
    if (values.size() > 1) figures.sd = std::sqrt(squares / (n - 1.0));
    return figures;
}

std::string to_json(const SelfTest& test) { return json_of(test).dump(2) + "\n"; }

SelfTest self_test_from(const std::string& json, const std::string& where) {
    try {
        const Json parsed = Json::parse(json);
        SelfTest test;
        test.time_utc = parsed.at("time_utc");
        test.display = parsed.at("display");
        test.gpu_renderer = parsed.at("gpu_renderer");
        test.source = parsed.at("source");
        test.told_hz = parsed.at("told_hz");
        test.frame_ms = parsed.at("frame_ms");
        test.waits = parsed.at("waits");
        test.interval_ms = parsed.at("interval_ms");
        test.error_ms = figures_in(parsed.at("error_ms"));
        test.dropped_frames = parsed.at("dropped_frames");
        test.key_to_swap_ms = figures_in(parsed.at("key_to_swap_ms"));
        return test;
    } catch (const Json::exception& error) {
        throw base::bad_input(
            "{} is no self-test of this program ({}): make it anew with obscura "
            "run --selftest",
            where, error.what());
    }
}

std::string to_text(const SelfTest& test) {
    const std::string told = test.told_hz > 0.0 ? fmt::format("{} Hz", test.told_hz) : "no rate";
    return fmt::format(
        "{}, {}\n"
        "frame period  {:.3f} ms measured, the monitor tells {}; swapping {} for the refresh\n"
        "interval      error of {:g} ms: {}; {} frames dropped\n"
        "key to swap   {}\n"
        "times are of  {}\n"
        "{}\n",
        test.display, test.gpu_renderer, test.frame_ms, told,
        test.waits ? "waits" : "does not wait", test.interval_ms, text_of(test.error_ms),
        test.dropped_frames, text_of(test.key_to_swap_ms), test.source,
        test.holds() ? "intervals on this machine can be relied on"
                     : "intervals on this machine cannot be relied on");
}

std::filesystem::path self_test_file(const std::filesystem::path& data) {
    return data / "selftest" / "selftest.json";
}

std::optional<SelfTest> last_self_test(const std::filesystem::path& data) {
    const std::filesystem::path file = self_test_file(data);
    if (!std::filesystem::exists(file)) return std::nullopt;
    return self_test_from(base::read_file(file), file.string());
}

std::string session_timing(const std::string& source, double frame_ms, bool waits,
                           const std::optional<SelfTest>& last, const std::string& screen) {
    Json timing{{"source", source}, {"frame_ms", frame_ms}, {"waits", waits}};
    timing["self_test"] = last ? json_of(*last) : Json(nullptr);
    if (!screen.empty()) timing["screen"] = Json::parse(screen);
    return timing.dump();
}

}  // namespace obscura::app::kiosk
