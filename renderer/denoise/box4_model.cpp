// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "renderer/denoise/denoise.h"
#include "renderer/model/seen_buffers.h"
#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {

std::vector<Admitted> box4_model(const SeenBuffers& buffers, std::span<const float> accessibility) {
    constexpr int kTaps = kTileSize * kTileSize;
    std::vector<Admitted> image(accessibility.size());
    for (int y = 0; y < buffers.height; ++y) {
        for (int x = 0; x < buffers.width; ++x) {
            if (buffers.is_empty(x, y)) continue;
            double sum = 0.0;
            for (int j = 0; j < kTileSize; ++j) {
                for (int i = 0; i < kTileSize; ++i) {
                    const int at_x = std::clamp(x + i - kTileSize / 2, 0, buffers.width - 1);
                    const int at_y = std::clamp(y + j - kTileSize / 2, 0, buffers.height - 1);
                    sum += static_cast<double>(accessibility[buffers.index(at_x, at_y)]);
                }
            }
            const double mean = sum / kTaps;
            const double rounding = (kTaps + 3) * kUlp * mean;
            image[buffers.index(x, y)] = {mean, mean - rounding, mean + rounding};
        }
    }
    return image;
}

}  // namespace obscura::renderer
