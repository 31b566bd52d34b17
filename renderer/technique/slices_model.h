// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "renderer/model/seen_buffers.h"
#include "renderer/technique/slices.h"

namespace obscura::renderer {

/// A texel that a place in the image may fall on.
struct SeenTexel {
    bool inside = false;  ///< of the image
    int x = 0;
    int y = 0;
};
struct SeenTexels {
    std::vector<SeenTexel> list;  ///< the first where nothing is rounded; no other but those that
                                  ///< rounding may lead to
    bool any = false;             ///< the place is so uncertain that it may be any texel
};

/// Of a place in pixels.
[[nodiscard]] SeenTexels seen_texels(const SeenBuffers& buffers, const Rounded& px_x,
                                     const Rounded& px_y);

/// A surface as techniques that march along slices see it: technique/slices.glsl in double
/// precision.
struct SliceSurface {
    int x = 0;
    int y = 0;
    Rounded z;
    Rounded3 ray;
    Rounded length;  ///< of the ray
    Rounded squared_length;
    Rounded3 normal;
    Rounded facing;   ///< cosine of the normal against the ray to the camera
    Rounded pixel;    ///< view x or y per metre of depth and pixel
    Rounded slope_x;  ///< change of 1 / z per pixel on the surface's plane, in 1/m
    Rounded slope_y;
};

/// The plane of the ray and a direction of the image.
struct SlicePlane {
    Rounded x;
    Rounded y;
    Rounded along;   ///< of the direction on the ray
    Rounded across;  ///< cosine of the normal against the direction at right angles to the ray
    Rounded sine;    ///< of the projected normal's angle against the ray to the camera
    Rounded cosine;
};

/// What a sample may find.
struct SliceSample {
    bool seen = false;  ///< false outside the image and where nothing is
    bool known = true;  ///< false where it may be any surface
    Rounded there;      ///< its depth, in m
    Rounded deeper;     ///< than the surface, in m
    Rounded cosine;     ///< of the angle to the ray to the camera
    Rounded squared;    ///< of the distance, in m
};

/// The first is what is found where nothing is rounded.
using SliceSamples = std::vector<SliceSample>;

class SlicesModel {
  public:
    explicit SlicesModel(const SeenBuffers& buffers);

    [[nodiscard]] SliceSurface surface(int x, int y) const;
    /// The direction of `turn` turned on by `by`.
    [[nodiscard]] SlicePlane slice(const SliceSurface& p, const Turn& turn, const Turn& by) const;
    /// At a distance along the slice's direction, negative on the other side; of the first layer
    /// or, where the buffers have it, of the second.
    [[nodiscard]] SliceSamples samples(const SliceSurface& p, const SlicePlane& s,
                                       const Rounded& distance_px, bool second = false) const;
    /// The same with another depth, along the same ray.
    [[nodiscard]] static SliceSample moved(const SliceSurface& p, const SlicePlane& s,
                                           const Rounded& distance_px, SliceSample sample,
                                           const Rounded& farther_m);

  private:
    [[nodiscard]] SliceSample sample(const SliceSurface& p, const SlicePlane& s,
                                     const Rounded& distance_px, const SeenTexel& texel,
                                     float depth_m, const Rounded& px_x, const Rounded& px_y) const;

    const SeenBuffers& buffers_;
    SeenView view_;
};

/// A value between bounds.
struct Bounded {
    double value = 0.0;
    double low = 0.0;
    double high = 0.0;

    void operator+=(const Bounded& other);
};

/// How far along a slice sample i of `steps` lies where samples lie evenly (spread 0), squared (1)
/// or cubed (2).
[[nodiscard]] Rounded slice_distance_px(int i, int steps, const Turn& turn,
                                        const Rounded& radius_px, const Rounded& spread);

/// Twice the cosine-weighted integral over a slice's angles from the ray to the camera to one whose
/// cosine is c, on the side where the normal's cosines are `facing` and `across`; it falls where c
/// rises. With what rounding and the shader's inverse cosine add.
[[nodiscard]] Bounded arc_of(const Rounded& facing, const Rounded& across, const Bounded& c);

/// The bounds of a rounded number.
[[nodiscard]] inline Bounded bounds_of(const Rounded& a) { return {a.value, a.low(), a.high()}; }

/// a^power, both as the shader computes them; a is at least 0.
[[nodiscard]] Bounded power_of(const Bounded& a, const Rounded& power);

}  // namespace obscura::renderer
