// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/buffers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/passes/shared_constants.h"

namespace obscura::stimuli {
namespace {

using renderer::Frame;
using renderer::Target;

/// sRGB code values in [0, 1] to linear light (IEC 61966-2-1).
float decode_srgb(float code) {
    return code <= 0.04045F ? code / 12.92F : std::pow((code + 0.055F) / 1.055F, 2.4F);
}

/// The same of values that eight bits hold.
std::vector<float> decoded(std::vector<float> codes) {
    constexpr float kMost = 255.0F;
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        table[i] = decode_srgb(static_cast<float>(i) / kMost);
    }
    for (float& code : codes) code = table[static_cast<std::size_t>(std::lround(code * kMost))];
    return codes;
}

/// Three channels of interleaved values.
void add_three(renderer::FloatImage& image, const std::array<const char*, 3>& names,
               const std::vector<float>& interleaved) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
        std::vector<float> values(interleaved.size() / 3);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = interleaved[3 * i + channel];
        image.channels.push_back({names[channel], std::move(values)});
    }
}

/// View-space normals of unit length; 0 where there is no surface.
std::vector<float> normals_of(const Frame& frame, const std::vector<float>& depth_m) {
    std::vector<float> values = frame.read_components(Target::kNormal, 3);
    for (std::size_t i = 0; i < depth_m.size(); ++i) {
        glm::vec3 normal(0.0F);
        if (depth_m[i] < kBackgroundLimit_m) {
            for (int c = 0; c < 3; ++c) normal[c] = (values[3 * i + c] * 255.0F - 128.0F) / 127.0F;
            normal /= std::max(glm::length(normal), 1e-6F);
        }
        std::copy_n(&normal.x, 3, &values[3 * i]);
    }
    return values;
}

/// All light on a surface, / pi, before accessibility; 0 where there is no surface.
std::vector<float> light_of(const Frame& frame, const renderer::Lighting& lighting,
                            const std::vector<float>& depth_m) {
    const renderer::FramePlan& plan = frame.plan();
    std::vector<float> values(3 * depth_m.size());
    if (plan.find(Target::kAmbient) != nullptr) {
        values = frame.read_components(Target::kAmbient, 3);
    } else {
        for (std::size_t i = 0; i < depth_m.size(); ++i) {
            if (depth_m[i] < kBackgroundLimit_m)
                std::copy_n(&lighting.ambient.x, 3, &values[3 * i]);
        }
    }
    if (plan.find(Target::kDirect) != nullptr) {
        const std::vector<float> direct = frame.read_components(Target::kDirect, 3);
        for (std::size_t i = 0; i < values.size(); ++i) values[i] += direct[i];
    }
    return values;
}

}  // namespace

renderer::FloatImage buffers_of(const Frame& frame, const renderer::Lighting& lighting) {
    const renderer::FramePlan& plan = frame.plan();
    renderer::FloatImage image;
    image.width = plan.width;
    image.height = plan.height;
    std::vector<float> depth_m = frame.read_floats(Target::kDepth);

    add_three(image, {"N.X", "N.Y", "N.Z"}, normals_of(frame, depth_m));
    add_three(image, {"albedo.R", "albedo.G", "albedo.B"},
              decoded(frame.read_components(Target::kAlbedo, 3)));
    add_three(image, {"light.R", "light.G", "light.B"}, light_of(frame, lighting, depth_m));
    image.channels.push_back({"ao.Y", frame.read_accessibility()});
    image.channels.push_back({"Z", std::move(depth_m)});
    return image;
}

std::array<float, 16> column_major(const glm::mat4& matrix) {
    std::array<float, 16> values{};
    std::copy_n(glm::value_ptr(matrix), values.size(), values.begin());
    return values;
}

}  // namespace obscura::stimuli
