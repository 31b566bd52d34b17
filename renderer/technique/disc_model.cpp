// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/disc_model.h"

#include <algorithm>
#include <numbers>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/progressive.h"

namespace obscura::renderer {

DiscModel::DiscModel(const SeenBuffers& buffers, const Variant& variant)
    : buffers_(buffers),
      view_(buffers),
      kernel_(part_of(disc_kernel(variant.samples), variant)),
      tile_(turn_tile(2.0 * std::numbers::pi, variant.noise)) {
    const Technique& technique = *find_technique(variant.technique);
    const auto value = [&](const char* name) {
        return nearest_float(variant.value_of(*technique.find_parameter(name)));
    };
    radius_m_ = value("radius_m") * value("reach");
}

Rounded DiscModel::sum(int x, int y, double most,
                       const std::function<Rounded(int x, int y)>& worth) const {
    const Turn& turn = tile_.at(x, y);
    const Rounded cosine(turn.cosine);
    const Rounded sine(turn.sine);
    const Rounded z(buffers_.depth_at(x, y));
    const Rounded radius_px = radius_m_ / (z * view_.pixel());
    Rounded total;
    for (const DiscPoint& point : kernel_) {
        const Rounded along = nearest_float(point.x);
        const Rounded across = nearest_float(point.y);
        const Rounded px_x = Rounded(x + 0.5) + (cosine * along - sine * across) * radius_px;
        const Rounded px_y = Rounded(y + 0.5) + (cosine * across + sine * along) * radius_px;
        const SeenTexels seen = seen_texels(buffers_, px_x, px_y);
        const auto worth_of = [&](const SeenTexel& texel) {
            return texel.inside ? worth(texel.x, texel.y) : Rounded(0.0);
        };
        Rounded found = worth_of(seen.list.front());
        double low = found.low();
        double high = found.high();
        for (const SeenTexel& texel : seen.list) {
            const Rounded may_be = worth_of(texel);
            low = std::min(low, may_be.low());
            high = std::max(high, may_be.high());
        }
        found = seen.any ? between(found.value, 0.0, most) : between(found.value, low, high);
        total = total + found;
    }
    return total;
}

}  // namespace obscura::renderer
