// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/crytek.h"

#include <cmath>

#include "renderer/technique/progressive.h"
#include "renderer/technique/sampling.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {
namespace {

std::map<Ideal, std::string> crytek_nature() {
    const std::string half =
        "half of the samples around a flat surface lie below it: 0.75 where it faces the camera, "
        "other values where it is tilted or where samples leave the image";
    const std::string texture_space =
        "its offsets are fractions of the image, not lengths in the scene";
    return {{Ideal::kOpenFacing, half},
            {Ideal::kOpenTilted, half},
            {Ideal::kWholeScene, texture_space},
            {Ideal::kAnyImage, texture_space},
            {Ideal::kAnyFarPlane, "it weighs occluders by depth / far"}};
}

/// The corners of the unit cube, normalised, in rounds of eight; each 1 + 2.4/N times as long as
/// the one before.
constexpr int kCorners = 8;  // of a cube: a round of samples

std::vector<glm::vec3> offsets(int samples) {
    std::vector<glm::vec3> list;
    double length = 1.0 / std::sqrt(3.0);
    for (int i = 0; i < samples; ++i) {
        length *= 1.0 + 2.4 / samples;
        const auto along = [&](int bit) { return ((i >> bit) & 1) != 0 ? length : -length; };
        list.emplace_back(along(2), along(1), along(0));
    }
    return list;
}

Recipe recipe_of(const Variant& variant) {
    Recipe recipe;
    recipe.tables = {rotation_table(variant.noise)};
    // Each sample's depth; the pixel's own depth and rotation.
    recipe.steps = {accessibility_step(variant, "technique/crytek.glsl",
                                       {Target::kDepth, "rotations"},
                                       samples_of_frame(variant) + 2)};
    recipe.steps.front().defines.push_back(
        points_define(part_of(offsets(variant.samples), variant, kCorners)));
    return recipe;
}

}  // namespace

Technique crytek_technique() {
    Technique technique;
    technique.name = "crytek";
    technique.variant = "Crytek";
    technique.citation = "Jakobsen 2010, Appendix A, after Kajalin 2009 (ShaderX7)";
    technique.samples = {kCorners, 128, 24, kCorners};
    technique.parameters = {
        {"offset_scale",
         "Length of the offsets before the first sample; each sample multiplies it by 1 + 2.4/N",
         "fraction of the image, and of the depth", 0.0, 1.0, 0.01},
    };
    technique.recipe = recipe_of;
    technique.reach = "offset_scale";
    technique.model = crytek_model;
    technique.by_nature = crytek_nature();
    technique.facing_wall = 0.75;  // half of the samples lie behind the wall: a = 1/2, a^2 + a
    return technique;
}

}  // namespace obscura::renderer
