// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/slices.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"

namespace obscura::renderer {
namespace {

constexpr int kTurns = kTileSize * kTileSize;

Turn turn_by(double angle_rad, double jitter) {
    return {static_cast<float>(std::cos(angle_rad)), static_cast<float>(std::sin(angle_rad)),
            static_cast<float>(jitter)};
}

/// Values of parameters for which a program that knows them leaves something out.
const std::map<std::string, std::set<double>> kWorthKnowing{
    {"power", {1.0, 2.0}}, {"step_spread", {0.0, 1.0, 2.0}}, {"thin_occluder", {0.0}}};

/// The four bits of `i` the other way round.
int reversed(int i) { return ((i & 1) << 3) | ((i & 2) << 1) | ((i & 4) >> 1) | ((i & 8) >> 3); }

}  // namespace

Tile<Turn> turn_tile(double sector_rad, std::string_view noise) {
    if (noise != "tile4x4") {
        Tile<Turn> tile{noise_tile(noise).size, {}};
        for (const glm::dvec2& value : noise_tile(noise)) {
            tile.values.push_back(turn_by(sector_rad * value.x, value.y));
        }
        return tile;
    }
    Tile<Turn> tile{kTileSize, {}};
    for (int y = 0; y < kTileSize; ++y) {
        for (int x = 0; x < kTileSize; ++x) {
            // Neighbours in a row or column are far apart in angle.
            const int i = kTileSize * ((x + y) % kTileSize) + x;
            tile.values.push_back(
                turn_by(sector_rad * (i + 0.5) / kTurns, (reversed(i) + 0.5) / kTurns));
        }
    }
    return tile;
}

NumberTable turn_table(double sector_rad, std::string_view noise) {
    const Tile<Turn> tile = turn_tile(sector_rad, noise);
    NumberTable table{"turns", tile.size, tile.size, {}};
    for (const Turn& turn : tile) {
        table.texels.emplace_back(turn.cosine, turn.sine, turn.jitter);
    }
    return table;
}

namespace {

int steps_of(const Variant& variant) {
    const Technique& technique = *find_technique(variant.technique);
    return static_cast<int>(variant.value_of(*technique.find_parameter(slice_steps().name)));
}

}  // namespace

Fan fan_of_slices(const Variant& variant) {
    const int steps = steps_of(variant);
    const int count = variant.samples / (2 * steps);
    return {count, std::numbers::pi / count, steps};
}

Fan fan_of_directions(const Variant& variant) {
    const int steps = steps_of(variant);
    const int count = variant.samples / steps;
    return {count, 2.0 * std::numbers::pi / count, steps};
}

std::vector<Turn> fan_turns(const Fan& fan) {
    std::vector<Turn> turns;
    for (int i = 0; i < fan.count; ++i) turns.push_back(turn_by(fan.sector_rad * i, 0.0));
    return turns;
}

Recipe fan_recipe(const Variant& variant, const std::string& shader, const Fan& fan) {
    const std::vector<Turn> part = part_of(fan_turns(fan), variant);
    std::string turns;
    for (const Turn& turn : part) {
        turns += fmt::format("{}vec2({:.9e}, {:.9e})", turns.empty() ? "" : ", ", turn.cosine,
                             turn.sine);
    }
    Recipe recipe;
    recipe.tables = {turn_table(fan.sector_rad, variant.noise)};
    Step step = accessibility_step(variant, shader,
                                   {Target::kDepth, Target::kPosition, Target::kNormal, "turns"},
                                   samples_of_frame(variant) + 3);
    step.defines.push_back(fmt::format("FAN_COUNT {}", part.size()));
    // What the parameter says is in the program's loop.
    step.defines.push_back(fmt::format("FAN_STEPS {}", fan.steps));
    step.defines.push_back(fmt::format("p_{} {}", slice_steps().name, fan.steps));
    step.defines.push_back(fmt::format("FAN_TURNS vec2[]({})", turns));
    for (const Parameter& parameter : find_technique(variant.technique)->parameters) {
        const double value = variant.value_of(parameter);
        const auto& known = kWorthKnowing.find(parameter.name);
        if (known != kWorthKnowing.end() && known->second.contains(value)) {
            step.defines.push_back(fmt::format("p_{} {:.1f}", parameter.name, value));
        }
    }
    recipe.steps = {step};
    return recipe;
}

Parameter slice_steps() {
    return {"steps", "Samples on one side of a slice", "", 1.0, 16.0, 4.0, true, false};
}

Parameter slice_radius() {
    return {"radius_m", "Distance to which surfaces occlude", "m", 0.0, 1000.0, 0.5, false, false};
}

Parameter slice_reach(double standard) {
    return {"reach", "How far samples look for occluders", "of radius_m", 0.0, 20.0, standard};
}

Parameter slice_spread(double standard) {
    return {
        "step_spread",
        "How samples lie along a slice: 0 evenly, 1 by the square of their number, 2 by its cube",
        "",
        0.0,
        2.0,
        standard};
}

Parameter slice_power() {
    return {"power", "Exponent of the accessibility", "", 0.0, 10000.0, 1.0};
}

std::map<Ideal, std::string> slice_nature() {
    return {{Ideal::kWholeScene,
             "what lies outside the image is not in the buffer and reads as very far"}};
}

}  // namespace obscura::renderer
