// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/frame.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "renderer/base/error.h"

namespace obscura::renderer {
namespace {

struct GlFormat {
    GLenum internal;
    GLenum format;
    GLenum type;
};

GlFormat gl_format(const PlannedTarget& planned) {
    switch (planned.target) {
        case Target::kAlbedo:
            return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Target::kNormal:
        case Target::kOccluderNormal:
        case Target::kDisplay:
        case Target::kResolved:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Target::kDepth:
        case Target::kOccluderDepth:
            if (planned.format == "r16f") return {GL_R16F, GL_RED, GL_HALF_FLOAT};
            return {GL_R32F, GL_RED, GL_FLOAT};
        case Target::kAccessibility:
        case Target::kDenoiseStep:
        case Target::kDenoised:
            return {GL_R32F, GL_RED, GL_FLOAT};
        case Target::kVisibility:
        case Target::kOccluderVisibility:
            return {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT};
        case Target::kShadow:
        case Target::kPointShadow:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
        case Target::kEmission:
        case Target::kAmbient:
        case Target::kDirect:
        case Target::kHdr:
            return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
    }
    return {};
}

gl::Texture make_texture(const PlannedTarget& planned) {
    const GLenum internal = gl_format(planned).internal;
    const bool layered =
        planned.target == Target::kShadow || planned.target == Target::kPointShadow;
    gl::Texture texture =
        gl::Texture::make(static_cast<GLenum>(layered ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D));
    if (layered) {
        glTextureStorage3D(texture.name(), 1, internal, planned.width, planned.height,
                           planned.layers);
        glTextureParameteri(texture.name(), GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTextureParameteri(texture.name(), GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    } else {
        glTextureStorage2D(texture.name(), 1, internal, planned.width, planned.height);
    }
    const GLint filter = layered ? GL_LINEAR : GL_NEAREST;
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, filter);
    glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, filter);
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(texture.name(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return texture;
}

bool depends_on_the_view_only(Pass pass) {
    return pass == Pass::kGeometry || pass == Pass::kShadow || pass == Pass::kOccluders ||
           pass == Pass::kLight;
}

/// Whether a pass of one plan gives what the same pass of another one gave.
bool gives_the_same(const PlannedPass& pass, const FramePlan& plan, const FramePlan& known) {
    if (!depends_on_the_view_only(pass.pass) || !known.has(pass.pass)) return false;
    if (!(plan.needs == known.needs) || !(plan.options == known.options)) return false;
    if (pass.pass == Pass::kOccluders && plan.blended_occlude() != known.blended_occlude()) {
        return false;
    }
    const auto same = [&](Target target) {
        const PlannedTarget* other = known.find(target);
        return other != nullptr && *other == *plan.find(target);
    };
    return std::all_of(pass.reads.begin(), pass.reads.end(), same) &&
           std::all_of(pass.writes.begin(), pass.writes.end(), same);
}

}  // namespace

Frame::Frame(FramePlan plan, const ViewBuffers& known) : plan_(std::move(plan)) {
    for (const PlannedPass& pass : plan_.passes) {
        if (!gives_the_same(pass, plan_, known.plan)) continue;
        for (const Target target : pass.writes) {
            textures_.emplace(target, known.textures.at(target));
        }
        for (const PassTime& time : known.times) {
            if (time.pass == pass.pass) taken_over_.push_back(time);
        }
    }
    for (const PlannedTarget& planned : plan_.targets) {
        std::shared_ptr<gl::Texture>& texture = textures_[planned.target];
        if (!texture) texture = std::make_shared<gl::Texture>(make_texture(planned));
    }
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throw base::failure(
            "the buffers of a {}x{} frame ({} bytes) could not be made: OpenGL "
            "error 0x{:x}",
            plan_.width, plan_.height, plan_.bytes(), error);
    }
}

ViewBuffers Frame::view_buffers() const {
    ViewBuffers buffers;
    buffers.plan = plan_;
    for (const PlannedPass& pass : plan_.passes) {
        if (!depends_on_the_view_only(pass.pass)) continue;
        for (const Target target : pass.writes) {
            buffers.textures.emplace(target, textures_.at(target));
        }
    }
    std::copy_if(times.begin(), times.end(), std::back_inserter(buffers.times),
                 [](const PassTime& time) { return depends_on_the_view_only(time.pass); });
    return buffers;
}

std::vector<std::uint8_t> Frame::read_bytes(Target target) const {
    const PlannedTarget* planned = plan_.find(target);
    if (planned == nullptr) {
        throw base::failure("this frame has no {} target", to_string(target));
    }
    const GlFormat format = gl_format(*planned);
    std::vector<std::uint8_t> bytes(planned->bytes);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture(target), 0, format.format, format.type,
                      static_cast<GLsizei>(bytes.size()), bytes.data());
    return bytes;
}

std::vector<float> Frame::read_accessibility() const {
    if (plan_.has(Pass::kAccessibility)) return read_floats(plan_.final_accessibility());
    return std::vector<float>(
        static_cast<std::size_t>(plan_.image_width) * static_cast<std::size_t>(plan_.image_height),
        1.0F);
}

std::vector<float> Frame::read_floats(Target target) const { return read_components(target, 1); }

std::vector<float> Frame::read_components(Target target, int channels) const {
    const PlannedTarget* planned = plan_.find(target);
    if (planned == nullptr) {
        throw base::failure("this frame has no {} target", to_string(target));
    }
    constexpr GLenum kFormats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    const std::size_t row = static_cast<std::size_t>(planned->width) * channels;
    const auto height = static_cast<std::size_t>(planned->height);
    std::vector<float> stored(row * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture(target), 0, kFormats[channels - 1], GL_FLOAT,
                      static_cast<GLsizei>(stored.size() * sizeof(float)), stored.data());
    std::vector<float> values(stored.size());
    for (std::size_t y = 0; y < height; ++y) {
        std::copy_n(&stored[y * row], row, &values[(height - 1 - y) * row]);
    }
    return values;
}

std::vector<std::uint8_t> Frame::read_display() const {
    const std::vector<std::uint8_t> rgba = read_bytes(plan_.image());
    const auto width = static_cast<std::size_t>(plan_.image_width);
    const auto height = static_cast<std::size_t>(plan_.image_height);
    std::vector<std::uint8_t> rgb(3 * width * height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            std::copy_n(&rgba[4 * ((height - 1 - y) * width + x)], 3, &rgb[3 * (y * width + x)]);
        }
    }
    return rgb;
}

}  // namespace obscura::renderer
