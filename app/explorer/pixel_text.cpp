// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/pixel_text.h"

#include <fmt/format.h>

#include "renderer/passes/shared_constants.h"

namespace obscura::app::explorer {

std::string pixel_text(const Model& model, const glm::vec2& at_px) {
    const int width = model.choices().width;
    const int height = model.choices().height;
    const bool inside = at_px.x >= 0.0F && at_px.y >= 0.0F && at_px.x < static_cast<float>(width) &&
                        at_px.y < static_cast<float>(height);
    if (!inside) return "";
    const int x = static_cast<int>(at_px.x);
    const int y = static_cast<int>(at_px.y);
    const std::size_t i =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    std::string text = fmt::format("pixel {}, {}", x, y);
    const auto a = model.buffers('a');
    const auto b = model.buffers('b');
    const auto& any = a ? a : b;
    if (any && any->width == width && any->height == height) {
        const auto value = [&](const Shot& shot, const char* channel) {
            const std::vector<float>* values = shot.buffers.find(channel);
            return values != nullptr && i < values->size() ? (*values)[i] : 0.0F;
        };
        const float depth = value(*any, "Z");
        if (depth >= kBackgroundLimit_m) {
            text += "   no surface";
        } else {
            text += fmt::format("   depth {:.3f} m   normal {:+.2f} {:+.2f} {:+.2f}", depth,
                                value(*any, "N.X"), value(*any, "N.Y"), value(*any, "N.Z"));
        }
        for (const auto& shot : {a, b}) {
            if (!shot) continue;
            text +=
                fmt::format("   {} {:.4f}", shot->side == 'a' ? 'A' : 'B', value(*shot, "ao.Y"));
        }
    }
    const auto& truth = model.truth();
    if (truth && truth->width() == width && truth->height() == height && truth->rays(i) > 0) {
        text += fmt::format("   truth {:.4f} \u00b1 {:.4f} ({} rays)", truth->accessibility(i),
                            truth->standard_error(i), truth->rays(i));
    }
    for (const char side : {'a', 'b'}) {
        const auto shot = model.image(side);
        if (!shot || shot->width != width || 3 * i + 2 >= shot->rgb.size()) continue;
        text += fmt::format("   {} rgb {} {} {}", side == 'a' ? 'A' : 'B', shot->rgb[3 * i],
                            shot->rgb[3 * i + 1], shot->rgb[3 * i + 2]);
    }
    return text;
}

}  // namespace obscura::app::explorer
