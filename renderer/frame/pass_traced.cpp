// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cstring>
#include <limits>

#include "renderer/base/error.h"
#include "renderer/frame/job.h"

namespace obscura::renderer {

void Renderer::run_traced(Job& job) {
    if (!job.traced) {
        throw base::failure("technique {} needs a ray tracer, and this frame has none",
                            job.plan.variant.technique);
    }
    const int width = job.plan.image_width;
    const int height = job.plan.image_height;
    std::vector<float> upper_first = job.traced(job.source, width, height, job.plan.variant);
    const std::vector<std::uint8_t> visibility =
        job.frame.read_bytes(job.plan.seen_by_technique(Target::kVisibility));
    std::vector<float> values(upper_first.size());
    const auto row = static_cast<std::size_t>(width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) {
        for (std::size_t x = 0; x < row; ++x) {
            std::uint32_t depth = 0;
            std::memcpy(&depth, &visibility[(y * row + x) * sizeof depth], sizeof depth);
            // Along a silhouette ray and rasteriser may differ; an empty pixel stays open.
            const bool empty = depth == std::numeric_limits<std::uint32_t>::max();
            const float traced = upper_first[(static_cast<std::size_t>(height) - 1 - y) * row + x];
            values[y * row + x] = empty ? 1.0F : traced;
        }
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(job.frame.texture(Target::kAccessibility), 0, 0, 0, width, height, GL_RED,
                        GL_FLOAT, values.data());
}

}  // namespace obscura::renderer
