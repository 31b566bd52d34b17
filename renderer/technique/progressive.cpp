// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/progressive.h"

#include <fmt/format.h>

#include "renderer/model/rounded.h"
#include "renderer/model/stored.h"

namespace obscura::renderer {
namespace {

/// The variant in one of its frames.
Variant in_frame(Variant variant, int frame) {
    variant.frame = frame;
    return variant;
}

/// What the frame computes is averaged with the mean of those before it.
void accumulate(Step& step, int frames_before) {
    step.reads.emplace_back(Target::kHistory);
    step.defines.push_back(fmt::format("FRAMES_BEFORE {}.0", frames_before));
    ++step.fetches;
}

/// What passes/accessibility.glsl makes of the mean before and a frame's own.
Admitted averaged(const Admitted& before, const Admitted& own, int frames_before) {
    const double share = 1.0 / (frames_before + 1.0);
    const auto mean = [share](double a, double b) { return a + (b - a) * share; };
    // Of the share, the difference, the product and the sum.
    const double rounding = 5.0 * kUlp * std::max(1.0, std::max(before.high, own.high));
    return {mean(before.value, own.value), mean(before.low, own.low) - rounding,
            mean(before.high, own.high) + rounding, before.depth_reads + own.depth_reads};
}

}  // namespace

int samples_of_frame(const Variant& variant) { return variant.samples / frames_of(variant); }

std::string why_not_progressive(const Technique& technique) {
    if (technique.recipe == nullptr || !technique.makes_accessibility()) {
        return "has no kernel that frames could share";
    }
    return technique.ray_traced ? "traces all rays of a pixel at once" : "";
}

Recipe recipe_of(const Technique& technique, const Variant& variant) {
    if (technique.recipe == nullptr) return {};
    // Buffers and tables are those of every frame: only the kernel is spread.
    Recipe recipe = technique.recipe(in_frame(variant, 0));
    const int frames = frames_of(variant);
    if (frames == 1) return recipe;
    recipe.frames = frames;
    recipe.steps.clear();
    for (int frame = 0; frame < frames; ++frame) {
        for (Step step : technique.recipe(in_frame(variant, frame)).steps) {
            step.frame = frame;
            const bool last = step.writes == Target::kAccessibility.name;
            if (last && frame > 0) accumulate(step, frame);
            recipe.steps.push_back(std::move(step));
        }
    }
    return recipe;
}

PixelModel model_of(const Technique& technique, const SeenBuffers& buffers,
                    const Variant& variant) {
    std::vector<PixelModel> frames;
    for (int frame = 0; frame < frames_of(variant); ++frame) {
        frames.push_back(technique.model(buffers, in_frame(variant, frame)));
    }
    if (frames.size() == 1) return frames.front();
    return [frames, format = variant.ao_format](int x, int y) {
        Admitted mean = frames.front()(x, y);
        for (std::size_t frame = 1; frame < frames.size(); ++frame) {
            mean = averaged(as_stored(mean, format), frames[frame](x, y), static_cast<int>(frame));
        }
        return mean;
    };
}

}  // namespace obscura::renderer
