// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "renderer/technique/disc_model.h"

namespace obscura::renderer {
namespace {

class HomebrewedModel {
  public:
    HomebrewedModel(const SeenBuffers& buffers, const Variant& variant)
        : buffers_(buffers),
          disc_(buffers, variant),
          far_m_(buffers.camera.far_m),
          clamped_(!variant.unclamped) {
        const Technique& technique = *find_technique(variant.technique);
        strength_ = nearest_float(variant.value_of(*technique.find_parameter("strength")));
    }

    [[nodiscard]] Admitted at(int x, int y) const {
        const Rounded z(buffers_.depth_at(x, y));
        const Rounded3 n = disc_.view().normal(x, y);
        const auto worth = [&](int at_x, int at_y) {
            const Rounded there(buffers_.depth_at(at_x, at_y));
            const Rounded apart = min(abs(there - z) / far_m_, Rounded(1.0));
            const Rounded share = Rounded(1.0) - apart;
            const Rounded near = share * share;
            return (Rounded(1.0) - dot(n, disc_.view().normal(at_x, at_y))) * near * near *
                   (Rounded(3.0) - Rounded(2.0) * near);
        };
        const Rounded sum = disc_.sum(x, y, 2.0, worth);
        const Rounded mean = Rounded(1.0) - strength_ * sum / Rounded(disc_.samples());
        const auto end = [this](double value) {
            return clamped_ ? std::clamp(value, 0.0, 1.0) : value;
        };
        return {end(mean.value), end(mean.low()), end(mean.high()), disc_.samples()};
    }

  private:
    const SeenBuffers& buffers_;
    DiscModel disc_;
    Rounded far_m_;
    Rounded strength_;
    bool clamped_;
};

}  // namespace

PixelModel homebrewed_model(const SeenBuffers& buffers, const Variant& variant) {
    return [model = std::make_shared<const HomebrewedModel>(buffers, variant)](int x, int y) {
        return model->at(x, y);
    };
}

}  // namespace obscura::renderer
