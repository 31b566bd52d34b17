// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/starcraft2.h"

#include <fmt/format.h>

#include <cmath>

#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {
namespace {

double value_of(const Variant& variant, const char* name) {
    return variant.value_of(*find_technique(variant.technique)->find_parameter(name));
}

std::string define_of(const char* name, const std::vector<WeightedPoint>& points) {
    std::string text = fmt::format("{}(DO)", name);
    for (const auto& [point, weight] : points) {
        text += fmt::format(" DO(vec3({}, {}, {}), {:.9e})", point.x, point.y, point.z, weight);
    }
    return text;
}

Recipe recipe_of(const Variant& variant) {
    const Starcraft2Points points = starcraft2_points(variant);
    const int halvings = starcraft2_halvings(variant);
    const std::string shift = fmt::format("DEPTH_SHIFT {}", halvings);
    Recipe recipe;
    recipe.tables = {rotation_table(variant.noise)};
    Step step =
        accessibility_step(variant, "technique/starcraft2.glsl",
                           {Target::kDepth, Target::kPosition, Target::kNormal, "rotations"},
                           samples_of_frame(variant) + 3);
    if (halvings > 0) {
        recipe.buffers = {
            {"small depth", "r32f", Extent::kPixels, 1.0F / static_cast<float>(1 << halvings)}};
        recipe.steps = {{"small depth",
                         "technique/starcraft2_depth.glsl",
                         {Target::kDepth},
                         "small depth",
                         {shift},
                         1,
                         Cover::kAll}};
        step.reads.emplace_back("small depth");
    }
    step.defines.push_back(shift);
    step.defines.push_back(define_of("FOR_EACH_WIDE", points.wide));
    if (!points.small.empty()) step.defines.push_back(define_of("FOR_EACH_SMALL", points.small));
    // What both of these say is in the points and in the buffer.
    for (const char* name : {"distance_weight", "depth_halvings"}) {
        step.defines.push_back(fmt::format("p_{} {:.9e}", name, value_of(variant, name)));
    }
    recipe.steps.push_back(step);
    return recipe;
}

}  // namespace

namespace {

/// The part of a set that the variant's frame takes; at least one point, so that no frame goes
/// without one of the two radii.
std::vector<WeightedPoint> frame_of(const std::vector<WeightedPoint>& set, const Variant& variant) {
    std::vector<WeightedPoint> part = part_of(set, variant);
    if (part.empty() && !set.empty()) {
        part.push_back(set[static_cast<std::size_t>(variant.frame) % set.size()]);
    }
    return part;
}

}  // namespace

Starcraft2Points starcraft2_points(const Variant& variant) {
    constexpr std::size_t kEvery = 4;
    const double exponent = value_of(variant, "distance_weight");
    const std::vector<glm::vec3> kernel = ball_kernel(variant.samples);
    const bool dual = value_of(variant, "small_radius") > 0.0 && kernel.size() >= kEvery;
    Starcraft2Points points;
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const double length = static_cast<double>(glm::length(kernel[i]));
        auto& set = dual && i % kEvery == kEvery / 2 ? points.small : points.wide;
        set.push_back({kernel[i], std::pow(length, exponent)});
    }
    for (auto* set : {&points.wide, &points.small}) {
        *set = frame_of(*set, variant);
        double sum = 0.0;
        for (const WeightedPoint& point : *set) sum += point.weight;
        for (WeightedPoint& point : *set) point.weight /= sum;
    }
    return points;
}

int starcraft2_halvings(const Variant& variant) {
    return static_cast<int>(value_of(variant, "depth_halvings"));
}

Technique starcraft2_technique() {
    const std::string coarse =
        "a texel's depth is that of its middle, and a normal has 8 bits: on a steep surface what "
        "lies beside a sample occludes it";
    Technique technique;
    technique.name = "starcraft2";
    technique.variant = "StarCraft";
    technique.citation =
        "Filion and McNaughton 2008, StarCraft II: Effects and Techniques, 1.2; it gives no values "
        "but epsilon's, at a radius of half a metre";
    technique.samples = {1, 128, 16, 1};
    technique.parameters = {
        {"radius_m", "Distance to which surfaces are taken into account", "m", 0.0, 1000.0, 0.5},
        {"epsilon", "A surface no farther before a sample does not occlude it", "of the radius",
         0.0, 1.0, 0.02},
        {"full_threshold", "A surface nearer before a sample occludes it wholly", "of the radius",
         0.0, 100.0, 0.25},
        {"no_threshold", "A surface farther before a sample does not occlude it", "of the radius",
         0.0, 100.0, 1.0},
        {"power", "Exponent of the curve between the thresholds", "", 0.01, 100.0, 2.0},
        {"small_radius", "Radius of a quarter of the samples; 0: all have the same", "of radius_m",
         0.0, 1.0, 0.25, false, false},
        {"small_power", "Exponent of the curve of those", "", 0.01, 100.0, 0.5, false, false},
        {"distance_weight",
         "Exponent of a sample's distance in its weight; below 0 near ones count more", "", -4.0,
         4.0, 1.0, false, false},
        {"footprint", "The most that the radius covers in the image; closer by, it shrinks",
         "of the image's height", 0.001, 100.0, 0.25, false, false},
        {"depth_halvings", "How often the sides of the depth that samples read are halved", "", 0.0,
         2.0, 0.0, true, false},
    };
    technique.recipe = recipe_of;
    technique.reach = "radius_m";
    technique.model = starcraft2_model;
    technique.by_nature = slice_nature();
    technique.by_nature[Ideal::kOpenFacing] =
        "it asks how far a surface lies before a sample, so what is up to the radius and the "
        "no-threshold before a wall occludes it";
    technique.by_nature[Ideal::kOpenTilted] = coarse;
    return technique;
}

}  // namespace obscura::renderer
