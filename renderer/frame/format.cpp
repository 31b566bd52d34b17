// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/format.h"

#include "renderer/base/error.h"

namespace obscura::renderer {
namespace {

constexpr Format kFormats[] = {
    {"r8", 1, GL_R8, GL_RED, GL_UNSIGNED_BYTE},
    {"rg8", 2, GL_RG8, GL_RG, GL_UNSIGNED_BYTE},
    {"rgba8", 4, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {"srgb8_alpha8", 4, GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE},
    {"rg16", 4, GL_RG16, GL_RG, GL_UNSIGNED_SHORT},
    {"r16f", 2, GL_R16F, GL_RED, GL_HALF_FLOAT},
    {"rg16f", 4, GL_RG16F, GL_RG, GL_HALF_FLOAT},
    {"rgba16f", 8, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT},
    {"r32f", 4, GL_R32F, GL_RED, GL_FLOAT},
    {"rg32f", 8, GL_RG32F, GL_RG, GL_FLOAT},
    {"rgba32f", 16, GL_RGBA32F, GL_RGBA, GL_FLOAT},
    {"depth24", 4, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT},
    {"depth32f", 4, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT},
};

}  // namespace

int components_of(const Format& format) {
    return format.format == GL_RGBA ? 4 : format.format == GL_RG ? 2 : 1;
}

bool can_be_stored(const Format& format) {
    return format.format != GL_DEPTH_COMPONENT && format.internal != GL_SRGB8_ALPHA8;
}

const Format& format_of(std::string_view name) {
    std::string known;
    for (const Format& format : kFormats) {
        if (format.name == name) return format;
        known += (known.empty() ? "" : ", ") + std::string(format.name);
    }
    throw base::failure("there is no buffer format \"{}\"; there are {}", name, known);
}

}  // namespace obscura::renderer
