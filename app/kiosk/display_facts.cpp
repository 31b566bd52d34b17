// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/display_facts.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::app::kiosk {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Every fact with its name in files, its option and its range.
struct Fact {
    const char* name;
    const char* option;
    std::optional<double> DisplayFacts::*value;
    double low;
    double high;
};
constexpr std::array kFacts{
    Fact{"viewing_distance_cm", "--viewing-distance", &DisplayFacts::viewing_distance_cm, 1.0,
         2000.0},
    Fact{"screen_width_cm", "--screen-size", &DisplayFacts::screen_width_cm, 1.0, 1000.0},
    Fact{"screen_height_cm", "--screen-size", &DisplayFacts::screen_height_cm, 1.0, 1000.0},
    Fact{"luminance_cd_m2", "--luminance", &DisplayFacts::luminance_cd_m2, 0.01, 100000.0},
    Fact{"gamma", "--gamma", &DisplayFacts::gamma, 0.5, 5.0}};

void require_range(const std::string& where, const Fact& fact, double value) {
    if (value >= fact.low && value <= fact.high) return;  // NaN is not
    throw base::bad_input("{}: {} is out of range, allowed is {:g} to {:g}", where, value, fact.low,
                          fact.high);
}

[[nodiscard]] fs::path file_in(const fs::path& data) { return data / "display.json"; }

[[nodiscard]] DisplayFacts facts_in(const Json& json, const std::string& where) {
    DisplayFacts facts;
    for (const auto& [name, value] : json.items()) {
        const Fact* known = nullptr;
        for (const Fact& fact : kFacts) {
            if (name == fact.name) known = &fact;
        }
        if (known == nullptr || !value.is_number()) {
            throw base::bad_input(
                "{}: {} is no fact of a display, allowed are numbers called viewing_distance_cm, "
                "screen_width_cm, screen_height_cm, luminance_cd_m2 and gamma",
                where, name);
        }
        require_range(where + ": " + name, *known, value.get<double>());
        facts.*(known->value) = value.get<double>();
    }
    return facts;
}

[[nodiscard]] Json json_of(const DisplayFacts& facts) {
    Json json = Json::object();
    for (const Fact& fact : kFacts) {
        if (facts.*(fact.value)) json[fact.name] = *(facts.*(fact.value));
    }
    return json;
}

}  // namespace

DisplayFacts DisplayFacts::with(const DisplayFacts& given) const {
    DisplayFacts all = *this;
    for (const Fact& fact : kFacts) {
        if (given.*(fact.value)) all.*(fact.value) = given.*(fact.value);
    }
    return all;
}

void check(const DisplayFacts& facts) {
    for (const Fact& fact : kFacts) {
        if (facts.*(fact.value)) require_range(fact.option, fact, *(facts.*(fact.value)));
    }
}

void set_screen_size(DisplayFacts& facts, const std::string& text) {
    const char* const end = text.data() + text.size();
    double width = 0.0;
    double height = 0.0;
    const auto first = std::from_chars(text.data(), end, width);
    const bool crossed = first.ec == std::errc() && first.ptr != end && *first.ptr == 'x';
    const auto second = std::from_chars(crossed ? first.ptr + 1 : end, end, height);
    if (!crossed || second.ec != std::errc() || second.ptr != end) {
        throw base::bad_input("--screen-size {}: allowed is the lit width and height in cm, 60x34",
                              text);
    }
    facts.screen_width_cm = width;
    facts.screen_height_cm = height;
}

KnownDisplays known_displays(const fs::path& data) {
    const fs::path file = file_in(data);
    KnownDisplays known;
    if (!fs::exists(file)) return known;
    const Json json = Json::parse(base::read_file(file), nullptr, false);
    const bool sound = json.is_object() && json.value("monitor", Json("")).is_string() &&
                       json.value("monitors", Json::object()).is_object();
    if (!sound) {
        throw base::bad_input(
            "{} is not what obscura run keeps of displays, an object of JSON with monitor and "
            "monitors: mend or remove it",
            file.string());
    }
    known.monitor = json.value("monitor", "");
    const Json monitors = json.value("monitors", Json::object());
    for (const auto& [name, facts] : monitors.items()) {
        known.facts[name] = facts_in(facts, file.string() + ": " + name);
    }
    return known;
}

void keep(const fs::path& data, const KnownDisplays& displays) {
    Json json = {{"monitor", displays.monitor}, {"monitors", Json::object()}};
    for (const auto& [name, facts] : displays.facts) json["monitors"][name] = json_of(facts);
    fs::create_directories(data);
    base::write_file_atomically(file_in(data), json.dump(2) + "\n");
}

double visual_angle_deg(double size, double distance) {
    return 2.0 * std::atan(size / (2.0 * distance)) * 180.0 / std::numbers::pi;
}

std::string screen_json(const DisplayFacts& facts, PixelSize monitor, PixelSize image) {
    Json json = json_of(facts);
    if (json.empty()) return "";
    const bool derivable = facts.viewing_distance_cm && facts.screen_width_cm &&
                           facts.screen_height_cm && monitor.width > 0 && monitor.height > 0;
    if (derivable) {
        const double pixel_width_cm = *facts.screen_width_cm / monitor.width;
        const double pixel_height_cm = *facts.screen_height_cm / monitor.height;
        const double distance = *facts.viewing_distance_cm;
        json["image_width_deg"] = visual_angle_deg(image.width * pixel_width_cm, distance);
        json["image_height_deg"] = visual_angle_deg(image.height * pixel_height_cm, distance);
        json["pixels_per_degree"] = 1.0 / visual_angle_deg(pixel_width_cm, distance);
    }
    return json.dump();
}

}  // namespace obscura::app::kiosk
