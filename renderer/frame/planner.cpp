// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/planner.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/base/check.h"
#include "renderer/frame/format.h"

namespace obscura::renderer {

Buffer Planner::in_its_format(Buffer buffer) const {
    const auto is_one_of = [&buffer](std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), buffer.name) != names.end();
    };
    const Variant& variant = plan_.variant;
    const bool rebuilt = variant.depth_format == "d24";
    if (is_one_of(
            {Target::kDepth, Target::kOccluderDepth, Target::kSeenDepth, Target::kSecondDepth}) &&
        !rebuilt) {
        buffer.format = variant.depth_format;
    }
    if (is_one_of({Target::kPosition, Target::kOccluderPosition, Target::kSeenPosition}) &&
        variant.depth_format == "r16f") {
        buffer.format = "rgba16f";
    }
    if (is_one_of({Target::kSeenNormal}) || (buffer.is(Target::kOccluderNormal) && draws_normals()))
        buffer.format = normal_.buffer;
    if (is_one_of(
            {Target::kAccessibility, Target::kHistory, Target::kDenoised, Target::kUpsampled})) {
        buffer.format = variant.ao_format;
        // Two numbers a texel: r32f becomes rg32f.
        const bool beside = depth_beside_ && buffer.is(Target::kAccessibility);
        if (buffer.columns == 2 || beside) buffer.format.insert(1, "g");
    }
    if (is_one_of({Target::kSeenDepth, Target::kSeenNormal, Target::kSeenPosition,
                   Target::kSeenVisibility, Target::kAccessibility, Target::kHistory,
                   Target::kDenoised})) {
        buffer.scale = 1.0F / static_cast<float>(plan_.ao_step);
    }
    if (is_one_of({Target::kSecondDepth, Target::kSecondVisibility})) {
        buffer.scale = 1.0F / static_cast<float>(plan_.ao_step * plan_.second_step);
    }
    return buffer;
}

const std::string& Planner::add(const Buffer& asked) {
    if (const PlannedTarget* known = plan_.find(asked)) return known->name;
    const Buffer buffer = in_its_format(asked);
    PlannedTarget planned{buffer};
    const bool samples = buffer.extent == Extent::kSamples;
    const auto scaled = [&buffer](int size) {
        return std::max(1, static_cast<int>(std::ceil(static_cast<float>(size) * buffer.scale)));
    };
    planned.width = scaled(samples ? plan_.width : plan_.image_width);
    planned.height = scaled(samples ? plan_.height : plan_.image_height);
    if (buffer.is(Target::kShadow)) {
        planned.width = planned.height = needs().shadow_size;
        planned.layers = needs().lights;
    }
    if (buffer.is(Target::kPointShadow)) {
        planned.width = planned.height = needs().point_shadow_size;
        planned.layers = 6 * needs().point_lights;
    }
    planned.row = planned.width;
    planned.width = (planned.row + buffer.columns - 1) / buffer.columns;
    const int longest = std::max(planned.width, planned.height);
    planned.levels =
        std::min(buffer.levels, static_cast<int>(std::bit_width(static_cast<unsigned>(longest))));
    for (int level = 0; level < planned.levels; ++level) {
        planned.bytes += format_of(planned.format).bytes_per_texel *
                         static_cast<std::size_t>(std::max(1, planned.width >> level)) *
                         static_cast<std::size_t>(std::max(1, planned.height >> level)) *
                         static_cast<std::size_t>(planned.layers);
    }
    plan_.targets.push_back(std::move(planned));
    return plan_.targets.back().name;
}

FramePlan plan_frame(const SceneNeeds& needs, const Variant& variant, int width, int height,
                     const FrameOptions& options) {
    base::check_range("resolution", "supersampling", options.supersampling, 1, kMostSupersampling);
    const int most = 16384 / options.supersampling;
    base::check_range("resolution", "width", width, 1, most);
    base::check_range("resolution", "height", height, 1, most);
    if (options.occluding_opacity) {
        base::check_above("blended surfaces", "occluding opacity", *options.occluding_opacity, 0.0F,
                          1.0F);
    }
    for (const VariantProblem& problem : problems_of(variant)) {
        throw base::bad_input("{}: {}", problem.key, problem.message);
    }
    return plan_frame(needs, *find_technique(variant.technique), variant, width, height, options);
}

FramePlan plan_frame(const SceneNeeds& needs, const Technique& technique, const Variant& variant,
                     int width, int height, const FrameOptions& options) {
    Planner planner(needs, technique, variant, options, width, height);
    planner.plan_geometry();
    planner.plan_shadow();
    planner.plan_accessibility();
    planner.plan_light();
    planner.plan_image();
    return planner.take();
}

}  // namespace obscura::renderer
