// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/recipe/normal_format.h"

#include <cassert>
#include <cmath>

namespace obscura::renderer {
namespace {

constexpr NormalFormat kNormalFormats[] = {
    {"rgb8", "rgba8", "", 3, 255},
    {"rg8", "rg8", "NORMAL_RG8", 2, 255},
    {"oct16", "rg16", "NORMAL_OCT16", 2, 65535},
    {"from-depth", "rg16", "NORMAL_OCT16", 2, 65535},
};

glm::vec3 unit(const glm::vec3& n) {
    const float squared = glm::dot(n, n);
    return squared > 1.0e-12F ? n / std::sqrt(squared) : glm::vec3(0.0F, 0.0F, 1.0F);
}

}  // namespace

const NormalFormat& normal_format_of(std::string_view name) {
    for (const NormalFormat& format : kNormalFormats) {
        if (format.name == name) return format;
    }
    assert(false);
    return kNormalFormats[0];
}

glm::vec3 decoded_normal(const NormalFormat& format, const glm::vec3& code) {
    if (format.most == 65535) {
        const float x = code.x * 2.0F - 1.0F;
        const float y = code.y * 2.0F - 1.0F;
        const float z = 1.0F - std::abs(x) - std::abs(y);
        const float fold = std::max(-z, 0.0F);
        return unit({x >= 0.0F ? x - fold : x + fold, y >= 0.0F ? y - fold : y + fold, z});
    }
    glm::vec3 n = (code * 255.0F - 128.0F) * (1.0F / 127.0F);
    if (format.channels == 2) n.z = std::sqrt(std::max(1.0F - n.x * n.x - n.y * n.y, 0.0F));
    return unit(n);
}

}  // namespace obscura::renderer
