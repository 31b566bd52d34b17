// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "renderer/passes/shared_constants.h"

namespace obscura::app::explorer {
namespace {

constexpr Rgb kEmpty{96, 96, 104};  ///< where there is no surface

[[nodiscard]] std::size_t count_of(const Shot& shot) {
    return static_cast<std::size_t>(shot.width) * static_cast<std::size_t>(shot.height);
}

[[nodiscard]] stimuli::RgbImage painted(int width, int height,
                                        const std::function<Rgb(std::size_t)>& colour) {
    stimuli::RgbImage image{width, height, {}};
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.rgb.resize(3 * count);
    for (std::size_t i = 0; i < count; ++i) {
        const Rgb rgb = colour(i);
        std::copy(rgb.begin(), rgb.end(), &image.rgb[3 * i]);
    }
    return image;
}

/// IEC 61966-2-1.
[[nodiscard]] std::uint8_t encoded(float linear) {
    if (std::isnan(linear)) return 0;
    const float held = std::clamp(linear, 0.0F, 1.0F);
    const float code =
        held <= 0.0031308F ? 12.92F * held : 1.055F * std::pow(held, 1.0F / 2.4F) - 0.055F;
    return static_cast<std::uint8_t>(std::lround(255.0F * code));
}

[[nodiscard]] Picture missing(std::string why) { return {{}, {}, std::move(why)}; }

[[nodiscard]] Picture colours_of(const Shot& shot, const char* stem,
                                 const std::array<const char*, 3>& parts, bool is_normal) {
    std::array<const std::vector<float>*, 3> planes{};
    for (std::size_t c = 0; c < 3; ++c) {
        planes[c] = shot.buffers.find(fmt::format("{}.{}", stem, parts[c]));
        if (planes[c] == nullptr) return missing("This image has no such buffer.");
    }
    const std::vector<float>* depth = shot.buffers.find("Z");
    const auto colour = [&](std::size_t i) {
        if (is_normal && (*depth)[i] >= kBackgroundLimit_m) return kEmpty;
        Rgb rgb{};
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = (*planes[c])[i];
            rgb[c] = is_normal ? grey(0.5F * value + 0.5F)[0] : encoded(value);
        }
        return rgb;
    };
    return {painted(shot.width, shot.height, colour), {}, ""};
}

[[nodiscard]] Picture depth_of(const Shot& shot, const Layout& layout) {
    const std::vector<float>* depth = shot.buffers.find("Z");
    if (depth == nullptr) return missing("This image has no depth.");
    Range range{layout.depth_low_m, layout.depth_high_m};
    if (!(range.high > range.low)) range = depth_range(shot);
    const float size = std::max(range.high - range.low, 1e-6F);
    const auto colour = [&](std::size_t i) {
        const float z = (*depth)[i];
        return z >= kBackgroundLimit_m ? kEmpty : viridis(1.0F - (z - range.low) / size);
    };
    // Near is light, as in fog.
    return {painted(shot.width, shot.height, colour),
            {[](float value) { return viridis(1.0F - value); }, range.low, range.high, false, " m"},
            ""};
}

[[nodiscard]] Picture accessibility_of(const Shot& shot) {
    const std::vector<float>* values = shot.buffers.find("ao.Y");
    if (values == nullptr) return missing("This image has no accessibility.");
    return {painted(shot.width, shot.height, [&](std::size_t i) { return grey((*values)[i]); }),
            {&grey, 0.0F, 1.0F, false, ""},
            ""};
}

[[nodiscard]] Picture truth_of(const Shot& shot, const Truth& truth) {
    const auto colour = [&](std::size_t i) {
        return truth.rays(i) > 0 ? grey(truth.accessibility(i)) : kEmpty;
    };
    return {painted(shot.width, shot.height, colour), {&grey, 0.0F, 1.0F, false, ""}, ""};
}

[[nodiscard]] Picture uncertainty_of(const Shot& shot, const Truth& truth) {
    constexpr float kMost = 0.1F;
    const auto colour = [&](std::size_t i) {
        return truth.rays(i) > 0 ? viridis(truth.standard_error(i) / kMost) : kEmpty;
    };
    return {painted(shot.width, shot.height, colour), {&viridis, 0.0F, kMost, false, ""}, ""};
}

[[nodiscard]] Picture error_of(const Shot& shot, const Truth& truth, float range) {
    const std::vector<float>* values = shot.buffers.find("ao.Y");
    const std::vector<float>* depth = shot.buffers.find("Z");
    if (values == nullptr || depth == nullptr) return missing("This image has no accessibility.");
    const auto colour = [&](std::size_t i) {
        if (truth.rays(i) == 0 || (*depth)[i] >= kBackgroundLimit_m) return kEmpty;
        return orange_to_blue(((*values)[i] - truth.accessibility(i)) / range);
    };
    return {
        painted(shot.width, shot.height, colour), {&orange_to_blue, -range, range, true, ""}, ""};
}

[[nodiscard]] Picture emission_of(const Shot& shot) {
    if (shot.emission.size() < 3 * count_of(shot)) {
        return missing("No material of this scene sends out light.");
    }
    const auto colour = [&](std::size_t i) {
        return Rgb{encoded(shot.emission[3 * i]), encoded(shot.emission[3 * i + 1]),
                   encoded(shot.emission[3 * i + 2])};
    };
    return {painted(shot.width, shot.height, colour), {}, ""};
}

/// One component as grey, two or more as colours; over the range of what is finite in it.
[[nodiscard]] Picture own_of(const Shot& shot, const std::string& name) {
    const auto found = std::find_if(shot.own.begin(), shot.own.end(),
                                    [&](const OwnBuffer& own) { return own.name == name; });
    if (found == shot.own.end()) {
        return missing(
            fmt::format("{} has no buffer \"{}\" of its own.", shot.variant.variant_name(), name));
    }
    const auto channels = static_cast<std::size_t>(found->channels);
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (std::size_t i = 0; i < found->values.size(); i += channels) {
        const float value = found->values[i];
        if (!std::isfinite(value) || std::abs(value) >= kBackgroundLimit_m) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (!(high > low)) {
        low = std::isfinite(low) ? low : 0.0F;
        high = low + 1.0F;
    }
    const auto colour = [&](std::size_t i) {
        const float value = found->values[i * channels];
        if (std::abs(value) >= kBackgroundLimit_m) return kEmpty;
        return viridis((value - low) / (high - low));
    };
    return {painted(found->width, found->height * found->layers, colour),
            {&viridis, low, high, false, ""},
            ""};
}

}  // namespace

Range depth_range(const Shot& shot) {
    const std::vector<float>* depth = shot.buffers.find("Z");
    Range range{std::numeric_limits<float>::infinity(), 0.0F};
    for (const float z : depth != nullptr ? *depth : std::vector<float>{}) {
        if (!std::isfinite(z) || z >= kBackgroundLimit_m) continue;
        range.low = std::min(range.low, z);
        range.high = std::max(range.high, z);
    }
    return range.high > range.low ? range : Range{};
}

bool needs_buffers(const std::string& layer) { return layer != layer::kImage; }

bool needs_truth(const std::string& layer) {
    return layer == layer::kError || layer == layer::kTruth || layer == layer::kTruthError;
}

Picture picture_of(const Shot& shot, const Truth* truth, const std::string& layer,
                   const Layout& layout) {
    if (layer == layer::kImage) return {{shot.width, shot.height, shot.rgb}, {}, ""};
    if (needs_buffers(layer) && shot.buffers.channels.empty()) {
        return missing("Comes with the image at full size.");
    }
    if (needs_truth(layer)) {
        const bool known =
            truth != nullptr && truth->width() == shot.width && truth->height() == shot.height;
        if (!known) return missing("The truth is traced once the view stands still.");
        if (layer == layer::kTruth) return truth_of(shot, *truth);
        if (layer == layer::kTruthError) return uncertainty_of(shot, *truth);
        return error_of(shot, *truth, layout.error_range);
    }
    if (layer == layer::kAccessibility) return accessibility_of(shot);
    if (layer == layer::kAlbedo) return colours_of(shot, "albedo", {"R", "G", "B"}, false);
    if (layer == layer::kLight) return colours_of(shot, "light", {"R", "G", "B"}, false);
    if (layer == layer::kNormal) return colours_of(shot, "N", {"X", "Y", "Z"}, true);
    if (layer == layer::kDepth) return depth_of(shot, layout);
    if (layer == layer::kEmission) return emission_of(shot);
    return own_of(shot, layer.substr(std::string(layer::kOwn).size()));
}

}  // namespace obscura::app::explorer
