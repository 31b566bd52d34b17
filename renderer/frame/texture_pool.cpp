// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/texture_pool.h"

#include <algorithm>

#include "renderer/frame/format.h"

namespace obscura::renderer {
namespace {

gl::Texture make_texture(const PlannedTarget& planned) {
    const GLenum internal = format_of(planned.format).internal;
    const bool shadow = planned.extent == Extent::kShadow;
    const bool layered = shadow || planned.layers > 1;
    gl::Texture texture =
        gl::Texture::make(static_cast<GLenum>(layered ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D));
    const GLuint name = texture.name();
    if (layered) {
        glTextureStorage3D(name, planned.levels, internal, planned.width, planned.height,
                           planned.layers);
    } else {
        glTextureStorage2D(name, planned.levels, internal, planned.width, planned.height);
    }
    if (shadow) {
        glTextureParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTextureParameteri(name, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    }
    const GLint filter = shadow ? GL_LINEAR : GL_NEAREST;
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER,
                        planned.levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : filter);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, filter);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

/// Whether what was made for one serves for the other.
bool alike(const PlannedTarget& a, const PlannedTarget& b) {
    return a.format == b.format && a.width == b.width && a.height == b.height &&
           a.levels == b.levels && a.layers == b.layers &&
           (a.extent == Extent::kShadow) == (b.extent == Extent::kShadow);
}

}  // namespace

TexturePool::TexturePool() : unused_(std::make_shared<Unused>()) {}
TexturePool::~TexturePool() = default;

std::shared_ptr<gl::Texture> TexturePool::take(const PlannedTarget& target) {
    const auto found = std::find_if(unused_->begin(), unused_->end(),
                                    [&](const auto& one) { return alike(one.first, target); });
    gl::Texture texture;
    if (found != unused_->end()) {
        texture = std::move(found->second);
        unused_->erase(found);
    } else {
        texture = make_texture(target);
    }
    const std::weak_ptr<Unused> back = unused_;
    return {new gl::Texture(std::move(texture)), [back, target](gl::Texture* gone) {
                const std::unique_ptr<gl::Texture> owned(gone);
                if (const auto unused = back.lock()) {
                    unused->emplace_back(target, std::move(*owned));
                }
            }};
}

void TexturePool::free_unused() { unused_->clear(); }

}  // namespace obscura::renderer
