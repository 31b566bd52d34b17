// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/model/seen_buffers.h"

#include <algorithm>
#include <cmath>

#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {
namespace {

/// The texels along one side that `place` may fall on, clamped to the image.
struct Texels {
    int first = 0;
    int last = 0;
    int nominal = 0;
    bool may_be_outside = false;
    bool may_be_inside = true;
    bool nominally_inside = true;
};

Texels texels_of(const Rounded& place, int size) {
    Texels texels;
    if (!std::isfinite(place.value) || !std::isfinite(place.error)) {
        texels.last = size - 1;
        texels.may_be_outside = true;
        texels.nominally_inside = false;
        return texels;
    }
    const Rounded at = place * Rounded(size);
    const auto texel = [size](double value) {
        return static_cast<int>(std::floor(std::clamp(value, 0.0, size - 1.0)));
    };
    texels.first = texel(at.low());
    texels.last = texel(at.high());
    texels.nominal = texel(at.value);
    texels.nominally_inside = place.value >= 0.0 && place.value < 1.0;
    texels.may_be_outside = !(place.low() >= 0.0 && place.high() < 1.0);
    texels.may_be_inside = place.high() >= 0.0 && place.low() < 1.0;
    return texels;
}

}  // namespace

void SeenDepths::add(float depth_m) {
    const auto end = list_.begin() + static_cast<std::ptrdiff_t>(count_);
    if (std::find(list_.begin(), end, depth_m) != end) return;
    if (count_ == list_.size()) {
        any = true;
        return;
    }
    list_[count_++] = depth_m;
}

SeenView::SeenView(const SeenBuffers& buffers) : buffers_(buffers) {
    // As renderer/frame/camera.cpp and glm::perspective compute them, in floats.
    const double half_rad = 0.5 * static_cast<double>(buffers.camera.vertical_fov_rad);
    const Rounded up = Rounded(std::tan(half_rad), 2.0 * kUlp * std::tan(half_rad));
    const Rounded aspect = Rounded(buffers.width) / Rounded(buffers.height);
    scale_x_ = up * aspect;
    scale_y_ = up;
    to_clip_x_ = Rounded(1.0) / (aspect * up);
    to_clip_y_ = Rounded(1.0) / up;
}

ImagePoint SeenView::place_of(int x, int y) const {
    return {Rounded(x + 0.5) / Rounded(buffers_.width),
            Rounded(y + 0.5) / Rounded(buffers_.height)};
}

Rounded3 SeenView::ray(const ImagePoint& place) const {
    const Rounded shift_x(buffers_.camera.lens_shift.x);
    const Rounded shift_y(buffers_.camera.lens_shift.y);
    const Rounded x = place.x * Rounded(2.0) - Rounded(1.0);
    const Rounded y = place.y * Rounded(2.0) - Rounded(1.0);
    return {x * scale_x_ + shift_x * scale_x_, y * scale_y_ + shift_y * scale_y_, Rounded(-1.0)};
}

SeenDepths SeenView::depths_at(const Rounded3& point) const {
    constexpr double kLeast_m = 1.0e-6;  // of the distance before the camera, as in the shader
    SeenDepths depths;
    const Rounded w = -point.z;
    if (!(w.high() > kLeast_m)) {
        depths.nominal_m = kBackgroundDepth_m;
        depths.add(kBackgroundDepth_m);
        return depths;
    }
    if (!(w.low() > kLeast_m)) {
        depths.any = true;
        depths.nominal_m = kBackgroundDepth_m;
        if (!(w.value > kLeast_m)) return depths;
    }
    const auto place = [&w](const Rounded& clip) { return clip / w * Rounded(0.5) + Rounded(0.5); };
    const Rounded shift_x(buffers_.camera.lens_shift.x);
    const Rounded shift_y(buffers_.camera.lens_shift.y);
    SeenDepths found = depths_at(ImagePoint{place(to_clip_x_ * point.x + shift_x * point.z),
                                            place(to_clip_y_ * point.y + shift_y * point.z)});
    found.any |= depths.any;
    return found;
}

SeenDepths SeenView::depths_at(const ImagePoint& place) const {
    SeenDepths depths;
    const Texels across = texels_of(place.x, buffers_.width);
    const Texels up = texels_of(place.y, buffers_.height);
    depths.nominal_m = across.nominally_inside && up.nominally_inside
                           ? buffers_.depth_at(across.nominal, up.nominal)
                           : kBackgroundDepth_m;
    if (across.may_be_outside || up.may_be_outside) depths.add(kBackgroundDepth_m);
    if (!across.may_be_inside || !up.may_be_inside) return depths;
    constexpr int kMany = 4;  // texels along a side: no rounding of a sound place is as wide
    if (across.last - across.first > kMany || up.last - up.first > kMany) {
        depths.any = true;
        return depths;
    }
    for (int y = up.first; y <= up.last; ++y) {
        for (int x = across.first; x <= across.last; ++x) depths.add(buffers_.depth_at(x, y));
    }
    return depths;
}

Rounded3 SeenView::normal(int x, int y) const {
    const std::uint8_t* code = &buffers_.normal[3 * buffers_.index(x, y)];
    const auto component = [](int value) {
        const Rounded stored = Rounded(value) / Rounded(255.0);  // as an 8-bit texture is read
        return (stored * Rounded(255.0) - Rounded(128.0)) / Rounded(127.0);
    };
    // The sum is a whole number; only its rounding is not.
    const auto exact = [&component](int value) {
        return Rounded((value - 128.0) / 127.0, component(value).error);
    };
    const Rounded3 n{exact(code[0]), exact(code[1]), exact(code[2])};
    const Rounded squared = dot(n, n);
    if (!(squared.value > 1.0e-12)) return {Rounded(0.0), Rounded(0.0), Rounded(1.0)};
    return n * inverse_sqrt(squared);
}

}  // namespace obscura::renderer
