// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
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
    const std::vector<float> upper_first = job.traced(job.source, width, height, job.plan.variant);
    const std::vector<std::uint8_t> empty =
        job.frame.read_empty(job.plan.seen_by_technique(Target::kVisibility));
    std::vector<float> values(upper_first.size());
    const auto row = static_cast<std::size_t>(width);
    for (std::size_t i = 0; i < values.size(); ++i) {
        // Along a silhouette ray and rasteriser may differ; an empty pixel stays open.
        const std::size_t from_below = static_cast<std::size_t>(height) - 1 - i / row;
        values[from_below * row + i % row] = empty[i] != 0 ? 1.0F : upper_first[i];
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(job.frame.texture(Target::kAccessibility), 0, 0, 0, width, height, GL_RED,
                        GL_FLOAT, values.data());
}

}  // namespace obscura::renderer
