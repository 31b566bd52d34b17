// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "renderer/model/rounded.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// What a technique reads, as it is stored; upper row first. Access counts y from the bottom.
struct SeenBuffers {
    int width = 0;
    int height = 0;
    Camera camera;  ///< of an image of that size
    std::vector<float> depth_m;
    std::vector<std::uint8_t> empty;  ///< 1 where nothing is seen
    /// Three code values a pixel, of a format with fewer the rest is 0; empty: none is read.
    std::vector<std::uint16_t> normal;
    std::string normal_format = "rgb8";          ///< of Variant::normal_format
    std::string position = "similar-triangles";  ///< of Variant::position
    /// Where it is stored: the points' components; empty: they are rebuilt.
    std::vector<float> position_m;
    /// The second layer's depth, of every so many columns and rows; empty: there is none.
    std::vector<float> second_m;
    int second_step = 1;
    int samples = 0;  ///< of the technique whose accessibility a filter reads

    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(height - 1 - y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] float depth_at(int x, int y) const { return depth_m[index(x, y)]; }
    /// Of the second layer where a texel of the first is.
    [[nodiscard]] float second_at(int x, int y) const {
        const int across = (width + second_step - 1) / second_step;
        const int up = (height + second_step - 1) / second_step;
        return second_m[static_cast<std::size_t>(up - 1 - y / second_step) *
                            static_cast<std::size_t>(across) +
                        static_cast<std::size_t>(x / second_step)];
    }
    [[nodiscard]] bool is_empty(int x, int y) const { return empty[index(x, y)] != 0; }
    /// Whether every model finds the same in both.
    [[nodiscard]] bool operator==(const SeenBuffers& other) const {
        const auto view = [](const Camera& of) {
            return std::tuple(of.vertical_fov_rad, of.lens_shift.x, of.lens_shift.y, of.far_m);
        };
        return width == other.width && height == other.height && samples == other.samples &&
               depth_m == other.depth_m && empty == other.empty && normal == other.normal &&
               normal_format == other.normal_format && position == other.position &&
               position_m == other.position_m && second_m == other.second_m &&
               second_step == other.second_step && view(camera) == view(other.camera);
    }
};

/// A place in the image, from 0 to 1 or, where it says so, in pixels.
struct ImagePoint {
    Rounded x;
    Rounded y;
};

/// What a read of the depth buffer may give. Where a place lies within rounding of the border
/// between texels, or of the image's, it may be one or the other.
class SeenDepths {
  public:
    float nominal_m = 0.0F;  ///< where nothing is rounded
    bool any = false;        ///< the place is so uncertain that it may be any depth

    void add(float depth_m);
    [[nodiscard]] std::span<const float> all_m() const { return {list_.data(), count_}; }

  private:
    std::array<float, 16> list_{};
    std::size_t count_ = 0;
};

/// passes/view.glsl and passes/normal_codec.glsl in double precision.
class SeenView {
  public:
    explicit SeenView(const SeenBuffers& buffers);

    /// The middle of a pixel.
    [[nodiscard]] ImagePoint place_of(int x, int y) const;
    /// The view-space ray through a place, with z = -1.
    [[nodiscard]] Rounded3 ray(const ImagePoint& place) const;
    /// The point of a pixel's surface, as the variant's `position` says, and the ray through it.
    [[nodiscard]] Rounded3 point(int x, int y) const;
    [[nodiscard]] Rounded3 ray_to(int x, int y) const;
    /// Depths where a view-space point falls; very far behind the camera and outside the image.
    [[nodiscard]] SeenDepths depths_at(const Rounded3& point) const;
    [[nodiscard]] SeenDepths depths_at(const ImagePoint& place) const;
    [[nodiscard]] SeenDepths depths_at_px(const ImagePoint& place_px) const;
    [[nodiscard]] Rounded3 normal(int x, int y) const;
    /// View y per metre of depth and pixel.
    [[nodiscard]] Rounded pixel() const {
        return Rounded(2.0) * scale_y_ / Rounded(buffers_.height);
    }

  private:
    const SeenBuffers& buffers_;
    Rounded scale_x_;  ///< view x per metre of depth at the right border
    Rounded scale_y_;
    ImagePoint ray_to_px_;  ///< pixels per view x, y per metre of depth
    ImagePoint axis_px_;    ///< where the view's axis meets the image, in pixels
};

}  // namespace obscura::renderer
