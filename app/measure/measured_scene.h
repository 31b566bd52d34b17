// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/measure/measured_settings.h"
#include "renderer/frame/renderer.h"
#include "renderer/reference/irradiance_baker.h"
#include "renderer/reference/reference.h"

namespace obscura::app {

/// Where settings are rendered and truths are traced. Needs a current OpenGL context; keeps one
/// scene at a time, so ask for views of one scene together.
class MeasuredScene {
  public:
    explicit MeasuredScene(const MeasureRequest& request) : request_(request) {}

    /// Every buffer of one image, as the study shows it; those of `known`, an image of the same
    /// view and size, are taken over where they would be the same. Throws bad input for a scene
    /// without triangles.
    [[nodiscard]] renderer::Frame render(const MeasuredView& view, const renderer::Variant& choice,
                                         int width, int height,
                                         const renderer::ViewBuffers& known = {});

    /// Accessibility and filter of another choice with the same plan, once more on those buffers.
    std::vector<renderer::PassTime> render_again(const MeasuredView& view, renderer::Frame& frame,
                                                 const renderer::Variant& choice);

    /// The same as render() without environment and lights, for what looks at accessibility alone.
    [[nodiscard]] renderer::Frame render_plainly(const MeasuredView& view,
                                                 const renderer::Variant& choice, int width,
                                                 int height);

    /// The truth within R, from the cache or traced.
    [[nodiscard]] const renderer::ReferenceImage& truth(const MeasuredView& view, double radius_m,
                                                        int width, int height, int rays);

    /// The view's image with the truth in place of a technique's accessibility.
    [[nodiscard]] std::vector<std::uint8_t> true_image(const MeasuredView& view,
                                                       const renderer::ReferenceImage& truth,
                                                       double radius_m);

  private:
    void load(const MeasuredView& view);
    /// The view as the study shows it.
    [[nodiscard]] renderer::View shown(const MeasuredView& view);
    [[nodiscard]] renderer::RaysOfScene rays_of_scene() const {
        return [this]() -> const renderer::ReferenceScene& { return *rays_; };
    }
    [[nodiscard]] const renderer::Camera& camera_of(const MeasuredView& view) const;
    const renderer::Lighting& lighting_of(const MeasuredView& view);

    const MeasureRequest& request_;
    std::shared_ptr<const stimuli::SceneSource> loaded_;
    renderer::Scene scene_;
    std::unique_ptr<renderer::GpuScene> gpu_;
    std::unique_ptr<renderer::ReferenceScene> rays_;
    std::unique_ptr<renderer::IrradianceBaker> baker_;  ///< where a built-in scene's light asks
    std::map<stimuli::Validity, renderer::Lighting> lightings_;  ///< of the loaded scene
    std::map<std::string, renderer::ReferenceImage> truths_;     ///< of the loaded scene
    renderer::Renderer renderer_;
};

}  // namespace obscura::app
