// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/frame.h"

#include "renderer/frame/kept_shadows.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/frame/format.h"

namespace obscura::renderer {
namespace {

bool depends_on_the_view_only(Phase phase) {
    return phase == Phase::kGeometry || phase == Phase::kShadow || phase == Phase::kOccluders ||
           phase == Phase::kSecondLayer || phase == Phase::kLight;
}

/// Whether a pass of one plan gives what the same pass of another one gave.
bool gives_the_same(const PlannedPass& pass, const FramePlan& plan, const FramePlan& known) {
    if (!depends_on_the_view_only(pass.phase) || !known.has(pass.phase)) return false;
    if (!(plan.needs == known.needs)) return false;
    if (pass.phase != Phase::kShadow && !(plan.options == known.options)) return false;
    // What fewer buffers hold would be the same, but not the time that it takes.
    if (pass.phase == Phase::kGeometry && plan.lit_forward() != known.lit_forward()) return false;
    if (pass.phase == Phase::kOccluders && plan.blended_occlude() != known.blended_occlude()) {
        return false;
    }
    // What is peeled depends on the depths that it is peeled off.
    if (pass.phase == Phase::kSecondLayer &&
        (plan.separation_m != known.separation_m || plan.blended_occlude() ||
         known.blended_occlude() || plan.has(Phase::kSeen) || known.has(Phase::kSeen))) {
        return false;
    }
    const auto same = [&](const std::string& buffer) {
        const PlannedTarget* other = known.find(buffer);
        return other != nullptr && *other == *plan.find(buffer);
    };
    return std::all_of(pass.reads.begin(), pass.reads.end(),
                       [&](const Read& read) { return same(read.name); }) &&
           std::all_of(pass.writes.begin(), pass.writes.end(), same);
}

}  // namespace

std::vector<PassTime> by_name(const std::vector<PassTime>& times) {
    std::vector<PassTime> sums;
    for (const PassTime& time : times) {
        if (sums.empty() || sums.back().name != time.name) {
            sums.push_back(time);
        } else {
            sums.back().milliseconds += time.milliseconds;
            sums.back().query_milliseconds += time.query_milliseconds;
        }
    }
    return sums;
}

Frame::Frame(FramePlan plan, const ViewBuffers& known, TexturePool& pool) : plan_(std::move(plan)) {
    for (const PlannedPass& pass : plan_.passes) {
        if (!gives_the_same(pass, plan_, known.plan)) continue;
        for (const std::string& buffer : pass.writes) {
            textures_.emplace(buffer, known.textures.at(buffer));
        }
        for (const PassTime& time : known.times) {
            if (time.phase == pass.phase) taken_over_.push_back(time);
        }
    }
    for (const PlannedTarget& planned : plan_.targets) {
        std::shared_ptr<gl::Texture>& texture = textures_[planned.name];
        if (!texture) texture = pool.take(planned);
    }
    pool.free_unused();
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throw base::failure(
            "the buffers of a {}x{} frame ({} bytes) could not be made: OpenGL "
            "error 0x{:x}",
            plan_.width, plan_.height, plan_.bytes(), error);
    }
}

ViewBuffers shadows_of(const ViewBuffers& buffers) {
    ViewBuffers shadows = buffers;
    std::erase_if(shadows.plan.passes,
                  [](const PlannedPass& pass) { return pass.phase != Phase::kShadow; });
    std::erase_if(shadows.times, [](const PassTime& time) { return time.phase != Phase::kShadow; });
    std::erase_if(shadows.textures, [&](const auto& texture) {
        return std::none_of(
            shadows.plan.passes.begin(), shadows.plan.passes.end(), [&](const PlannedPass& pass) {
                return std::find(pass.writes.begin(), pass.writes.end(), texture.first) !=
                       pass.writes.end();
            });
    });
    return shadows;
}

double Frame::milliseconds() const {
    double sum_ms = 0.0;
    for (const PassTime& time : times) sum_ms += time.milliseconds;
    return sum_ms;
}

ViewBuffers Frame::view_buffers() const {
    ViewBuffers buffers;
    buffers.plan = plan_;
    for (const PlannedPass& pass : plan_.passes) {
        if (!depends_on_the_view_only(pass.phase)) continue;
        for (const std::string& buffer : pass.writes) {
            buffers.textures.emplace(buffer, textures_.at(buffer));
        }
    }
    std::copy_if(times.begin(), times.end(), std::back_inserter(buffers.times),
                 [](const PassTime& time) { return depends_on_the_view_only(time.phase); });
    return buffers;
}

const PlannedTarget& Frame::planned(std::string_view buffer) const {
    const PlannedTarget* found = plan_.find(buffer);
    if (found == nullptr) throw base::failure("this frame has no buffer \"{}\"", buffer);
    return *found;
}

GLuint Frame::texture(std::string_view buffer) const {
    return textures_.find(planned(buffer).name)->second->name();
}

std::vector<std::uint8_t> Frame::read_bytes(std::string_view buffer) const {
    const PlannedTarget& target = planned(buffer);
    const Format& format = format_of(target.format);
    std::vector<std::uint8_t> bytes(
        format.bytes_per_texel * static_cast<std::size_t>(target.width) *
        static_cast<std::size_t>(target.height) * static_cast<std::size_t>(target.layers));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture(buffer), 0, format.format, format.type,
                      static_cast<GLsizei>(bytes.size()), bytes.data());
    return bytes;
}

std::vector<std::uint8_t> Frame::read_empty(std::string_view visibility) const {
    const PlannedTarget& target = planned(visibility);
    const std::vector<std::uint8_t> bytes = read_bytes(visibility);
    const auto row = static_cast<std::size_t>(target.width);
    const auto height = static_cast<std::size_t>(target.height);
    std::vector<std::uint8_t> empty(row * height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < row; ++x) {
            std::uint32_t depth = 0;
            std::memcpy(&depth, &bytes[(y * row + x) * sizeof depth], sizeof depth);
            empty[(height - 1 - y) * row + x] = depth == std::numeric_limits<std::uint32_t>::max();
        }
    }
    return empty;
}

std::vector<float> Frame::read_floats(std::string_view buffer) const {
    return read_components(buffer, 1);
}

std::vector<float> Frame::read_accessibility() const {
    if (plan_.makes_accessibility()) return read_floats(plan_.final_accessibility());
    return std::vector<float>(
        static_cast<std::size_t>(plan_.image_width) * static_cast<std::size_t>(plan_.image_height),
        1.0F);
}

std::vector<float> Frame::read_columns(const PlannedTarget& target, int channels) const {
    const Format& format = format_of(target.format);
    const auto all = static_cast<std::size_t>(components_of(format));
    const std::size_t each = all / static_cast<std::size_t>(target.columns);
    const std::size_t texel_row = all * static_cast<std::size_t>(target.width);
    const auto height = static_cast<std::size_t>(target.height);
    std::vector<float> stored(texel_row * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture(target.name), 0, format.format, GL_FLOAT,
                      static_cast<GLsizei>(stored.size() * sizeof(float)), stored.data());
    const auto wanted = static_cast<std::size_t>(channels);
    const auto row = static_cast<std::size_t>(target.row);
    std::vector<float> values(row * height * wanted);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < row; ++x) {
            for (std::size_t c = 0; c < std::min(wanted, each); ++c) {
                values[((height - 1 - y) * row + x) * wanted + c] =
                    stored[y * texel_row + x * each + c];
            }
        }
    }
    return values;
}

std::vector<float> Frame::read_components(std::string_view buffer, int channels, int level) const {
    const PlannedTarget& target = planned(buffer);
    if (target.columns > 1) return read_columns(target, channels);
    constexpr GLenum kFormats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
    const auto row = static_cast<std::size_t>(std::max(1, target.width >> level)) *
                     static_cast<std::size_t>(channels);
    const auto height = static_cast<std::size_t>(std::max(1, target.height >> level));
    const auto layers = static_cast<std::size_t>(target.layers);
    std::vector<float> stored(row * height * layers);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture(buffer), level, kFormats[channels - 1], GL_FLOAT,
                      static_cast<GLsizei>(stored.size() * sizeof(float)), stored.data());
    std::vector<float> values(stored.size());
    for (std::size_t layer = 0; layer < layers; ++layer) {
        for (std::size_t y = 0; y < height; ++y) {
            std::copy_n(&stored[(layer * height + y) * row], row,
                        &values[(layer * height + height - 1 - y) * row]);
        }
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
