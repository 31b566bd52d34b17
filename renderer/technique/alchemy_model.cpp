// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "renderer/passes/shared_constants.h"
#include "renderer/technique/disc_model.h"

namespace obscura::renderer {
namespace {

class AlchemyModel {
  public:
    AlchemyModel(const SeenBuffers& buffers, const Variant& variant)
        : buffers_(buffers), disc_(buffers, variant), clamped_(!variant.unclamped) {
        const Technique& technique = *find_technique(variant.technique);
        const auto value = [&](const char* name) {
            return nearest_float(variant.value_of(*technique.find_parameter(name)));
        };
        radius_m_ = value("radius_m");
        strength_ = value("strength");
        bias_ = value("bias");
        least_squared_ = value("epsilon") * radius_m_ * radius_m_ + nearest_float(1.0e-30);
        power_ = value("power");
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const Rounded z(buffers_.depth_at(x, y));
        const SeenView& view = disc_.view();
        const bool rebuilt = buffers_.position == "similar-triangles";
        const Rounded3 ray = view.ray(view.place_of(x, y));
        const Rounded3 p = view.point(x, y);
        const Rounded3 n = view.normal(x, y);
        const auto worth = [&](int at_x, int at_y) {
            const float seen_m = buffers_.depth_at(at_x, at_y);
            if (seen_m >= kBackgroundLimit_m) return Rounded(0.0);
            const Rounded there(seen_m);
            const Rounded scale = view.pixel() * there;
            const Rounded3 v = rebuilt ? Rounded3{Rounded(at_x - x) * scale,
                                                  Rounded(at_y - y) * scale, Rounded(0.0)} +
                                             ray * (there - z)
                                       : view.point(at_x, at_y) + -p;
            const Rounded squared = dot(v, v);
            // A sum of squares is not negative, whatever its rounding.
            const Rounded divisor =
                between(squared.value, std::max(squared.low(), 0.0), squared.high()) +
                least_squared_;
            const Rounded above = max(dot(v, n) - z * bias_, Rounded(0.0));
            const Rounded quotient = above / divisor;
            return quotient;
        };
        const Rounded sum = disc_.sum(x, y, INFINITY, worth);
        Bounded mean = bounds_of(Rounded(1.0) - Rounded(2.0) * strength_ * radius_m_ * sum /
                                                    Rounded(disc_.samples()));
        if (clamped_) {
            for (double* end : {&mean.value, &mean.low, &mean.high}) {
                *end = std::clamp(*end, 0.0, 1.0);
            }
        }
        const Bounded found = power_of(mean, power_);
        return {found.value, found.low, found.high, disc_.samples()};
    }

  private:
    const SeenBuffers& buffers_;
    DiscModel disc_;
    Rounded radius_m_;
    Rounded strength_;
    Rounded bias_;
    Rounded least_squared_;
    Rounded power_;
    bool clamped_;
};

}  // namespace

PixelModel alchemy_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const AlchemyModel>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
