// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/model/seen_buffers.h"

#include <algorithm>
#include <cmath>

#include "renderer/passes/shared_constants.h"
#include "renderer/recipe/normal_format.h"

namespace obscura::renderer {
namespace {

/// The texels along one side that a place in pixels may fall on, clamped to the image.
struct Texels {
    int first = 0;
    int last = 0;
    int nominal = 0;
    bool may_be_outside = false;
    bool may_be_inside = true;
    bool nominally_inside = true;
};

Texels texels_of(const Rounded& at, int size) {
    Texels texels;
    if (!std::isfinite(at.value) || !std::isfinite(at.error)) {
        texels.last = size - 1;
        texels.may_be_outside = true;
        texels.nominally_inside = false;
        return texels;
    }
    const auto texel = [size](double value) {
        return static_cast<int>(std::floor(std::clamp(value, 0.0, size - 1.0)));
    };
    texels.first = texel(at.low());
    texels.last = texel(at.high());
    texels.nominal = texel(at.value);
    texels.nominally_inside = at.value >= 0.0 && at.value < size;
    texels.may_be_outside = !(at.low() >= 0.0 && at.high() < size);
    texels.may_be_inside = at.high() >= 0.0 && at.low() < size;
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
    // As renderer/scene/camera.cpp and job.h compute them, in floats.
    const double half_rad = 0.5 * static_cast<double>(buffers.camera.vertical_fov_rad);
    const Rounded up = Rounded(std::tan(half_rad), 2.0 * kUlp * std::tan(half_rad));
    const Rounded aspect = Rounded(buffers.width) / Rounded(buffers.height);
    scale_x_ = up * aspect;
    scale_y_ = up;
    const Rounded half_x(0.5 * buffers.width);
    const Rounded half_y(0.5 * buffers.height);
    ray_to_px_ = {half_x / scale_x_, half_y / scale_y_};
    const auto shift = [](float lens_shift, const Rounded& scale) {
        return Rounded(lens_shift) * scale / scale;
    };
    axis_px_ = {half_x * (Rounded(1.0) - shift(buffers.camera.lens_shift.x, scale_x_)),
                half_y * (Rounded(1.0) - shift(buffers.camera.lens_shift.y, scale_y_))};
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

Rounded3 SeenView::point(int x, int y) const {
    if (buffers_.position == "stored") {
        const float* point = &buffers_.position_m[3 * buffers_.index(x, y)];
        return {Rounded(point[0]), Rounded(point[1]), Rounded(point[2])};
    }
    const Rounded z(buffers_.depth_at(x, y));
    Rounded3 point = ray(place_of(x, y)) * z;
    if (buffers_.position == "inverse-projection") {
        // The inverse is made in floats, by cofactors, and its product is a sum of four.
        constexpr double kOperations = 24.0;
        const auto widen = [&](Rounded& along, const Rounded& scale, float shift) {
            const double size = scale.size() * (1.0 + std::abs(static_cast<double>(shift)));
            along.error += kOperations * kUlp * size * z.size();
        };
        widen(point.x, scale_x_, buffers_.camera.lens_shift.x);
        widen(point.y, scale_y_, buffers_.camera.lens_shift.y);
        point.z.error += kOperations * kUlp * z.size();
    }
    return point;
}

Rounded3 SeenView::ray_to(int x, int y) const {
    if (buffers_.position == "similar-triangles") return ray(place_of(x, y));
    const Rounded3 to = point(x, y);
    return {to.x / -to.z, to.y / -to.z, Rounded(-1.0)};
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
    SeenDepths found = depths_at_px(ImagePoint{point.x * (ray_to_px_.x / w) + axis_px_.x,
                                               point.y * (ray_to_px_.y / w) + axis_px_.y});
    found.any |= depths.any;
    return found;
}

SeenDepths SeenView::depths_at(const ImagePoint& place) const {
    return depths_at_px({place.x * Rounded(buffers_.width), place.y * Rounded(buffers_.height)});
}

SeenDepths SeenView::depths_at_px(const ImagePoint& place_px) const {
    SeenDepths depths;
    const Texels across = texels_of(place_px.x, buffers_.width);
    const Texels up = texels_of(place_px.y, buffers_.height);
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

namespace {

/// A component of 8 bits; the sum is a whole number, and only its rounding is not.
Rounded decoded_8(int code) {
    const Rounded stored = Rounded(code) / Rounded(255.0);  // as an 8-bit texture is read
    const Rounded rounded = (stored * Rounded(255.0) - Rounded(128.0)) / Rounded(127.0);
    return {(code - 128.0) / 127.0, rounded.error};
}

/// Unfolded from an octahedron.
Rounded3 decoded_16(int code_x, int code_y) {
    const auto component = [](int code) {
        return Rounded(code) / Rounded(65535.0) * Rounded(2.0) - Rounded(1.0);
    };
    const Rounded x = component(code_x);
    const Rounded y = component(code_y);
    const Rounded z = Rounded(1.0) - abs(x) - abs(y);
    const Rounded fold = max(-z, Rounded(0.0));
    // No code is zero, so that rounding never moves one across it.
    return {x.value >= 0.0 ? x - fold : x + fold, y.value >= 0.0 ? y - fold : y + fold, z};
}

}  // namespace

Rounded3 SeenView::normal(int x, int y) const {
    const std::uint16_t* code = &buffers_.normal[3 * buffers_.index(x, y)];
    const NormalFormat& format = normal_format_of(buffers_.normal_format);
    if (format.most == 65535) {
        const Rounded3 n = decoded_16(code[0], code[1]);
        return n * inverse_sqrt(dot(n, n));
    }
    Rounded3 n{decoded_8(code[0]), decoded_8(code[1]), decoded_8(code[2])};
    if (format.channels == 2) {
        n.z = sqrt(max(Rounded(1.0) - (n.x * n.x + n.y * n.y), Rounded(0.0)));
    }
    const Rounded squared = dot(n, n);
    if (!(squared.value > 1.0e-12)) return {Rounded(0.0), Rounded(0.0), Rounded(1.0)};
    return n * inverse_sqrt(squared);
}

}  // namespace obscura::renderer
