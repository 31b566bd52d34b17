// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/machine_lines.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <system_error>

namespace obscura::app::kiosk {
namespace {

[[nodiscard]] std::string screen_line(const stimuli::Words& words, const nlohmann::json& timing) {
    const auto screen = timing.find("screen");
    if (screen == timing.end() || !screen->contains("pixels_per_degree")) {
        return words("op_no_screen");
    }
    const auto shown = [&](const char* name) {
        return fmt::format("{:.4g}", screen->at(name).get<double>());
    };
    return words("op_screen", {{"distance", shown("viewing_distance_cm")},
                               {"width", shown("screen_width_cm")},
                               {"height", shown("screen_height_cm")},
                               {"pixels", shown("pixels_per_degree")}});
}

}  // namespace

std::vector<std::string> machine_lines(const stimuli::Words& words,
                                       const std::filesystem::path& data,
                                       const std::string& timing) {
    std::vector<std::string> lines;
    std::error_code error;
    const auto space = std::filesystem::space(std::filesystem::absolute(data), error);
    if (!error) {
        lines.push_back(words("op_disk", {{"free", std::to_string(space.available / 1'000'000)}}));
    }
    const auto json = nlohmann::json::parse(timing);
    const auto ms = [](double value) { return fmt::format("{:.2f}", value); };
    lines.push_back(words("op_timing", {{"source", json.at("source").get<std::string>()},
                                        {"frame", ms(json.at("frame_ms").get<double>())}}));
    lines.push_back(screen_line(words, json));
    const auto& test = json.at("self_test");
    if (test.is_null()) {
        lines.push_back(words("op_no_selftest"));
        return lines;
    }
    const auto& error_ms = test.at("error_ms");
    lines.push_back(
        words("op_selftest", {{"mean", ms(error_ms.at("mean").get<double>())},
                              {"sd", ms(error_ms.at("sd").get<double>())},
                              {"worst", ms(error_ms.at("worst").get<double>())},
                              {"dropped", std::to_string(test.at("dropped_frames").get<int>())}}));
    return lines;
}

}  // namespace obscura::app::kiosk
