// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/comparison.h"

#include <algorithm>
#include <cmath>

#include "renderer/passes/shared_constants.h"

namespace obscura::app::explorer {

std::optional<Region> within(const Region& region, int width, int height) {
    const auto right = std::min<std::int64_t>(std::int64_t{region.left} + region.width, width);
    const auto bottom = std::min<std::int64_t>(std::int64_t{region.top} + region.height, height);
    Region inside;
    inside.left = std::max(0, region.left);
    inside.top = std::max(0, region.top);
    if (right <= inside.left || bottom <= inside.top) return std::nullopt;
    inside.width = static_cast<int>(right) - inside.left;
    inside.height = static_cast<int>(bottom) - inside.top;
    return inside;
}

analysis::Possible<Comparison> compare(const Shot& shot, const Truth& truth,
                                       const std::optional<Region>& region) {
    using None = analysis::Possible<Comparison>;
    const std::vector<float>* measured = shot.buffers.find("ao.Y");
    const std::vector<float>* depth = shot.buffers.find("Z");
    if (measured == nullptr || depth == nullptr) return None::none("the image has no buffers yet");
    if (truth.width() != shot.width || truth.height() != shot.height) {
        return None::none("the truth is of another image");
    }
    const auto whole = Region{0, 0, shot.width, shot.height};
    const auto inside = within(region.value_or(whole), shot.width, shot.height);
    if (!inside) return None::none("the region lies outside the image");
    std::vector<float> values(measured->size());
    std::vector<std::uint8_t> counted(measured->size());
    Comparison comparison;
    double squares = 0.0;
    std::size_t pixels = 0;
    for (int y = inside->top; y < inside->top + inside->height; ++y) {
        for (int x = inside->left; x < inside->left + inside->width; ++x) {
            const std::size_t i =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(shot.width) +
                static_cast<std::size_t>(x);
            if ((*depth)[i] >= kBackgroundLimit_m || truth.rays(i) == 0) continue;
            counted[i] = 1;
            values[i] = truth.accessibility(i);
            const double error = truth.standard_error(i);
            squares += error * error;
            const float off = (*measured)[i] - values[i];
            if (!std::isfinite(off)) continue;
            ++pixels;
            const float bin =
                0.5F * (std::clamp(off, -1.0F, 1.0F) + 1.0F) * (Comparison::kBins - 1);
            comparison.histogram[static_cast<std::size_t>(std::lround(bin))] += 1.0F;
        }
    }
    const auto error = analysis::accessibility_error(*measured, values, counted);
    if (!error.has_value()) return None::none(error.reason);
    comparison.error = *error;
    if (pixels > 0) {
        const auto count = static_cast<double>(pixels);
        comparison.truth_rmse = std::sqrt(squares / count);
        for (float& share : comparison.histogram) share /= static_cast<float>(pixels);
    }
    const double rest = error->rmse * error->rmse - comparison.truth_rmse * comparison.truth_rmse;
    comparison.rmse_without_truths = std::sqrt(std::max(0.0, rest));
    return comparison;
}

}  // namespace obscura::app::explorer
