// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/measured_scene.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/progress.h"

namespace obscura::app {

void MeasuredScene::load(const MeasuredView& view) {
    if (loaded_ == view.scene) return;
    loaded_ = nullptr;
    lightings_.clear();
    truths_.clear();
    baker_.reset();
    rays_.reset();
    gpu_.reset();
    scene_ = view.scene->build();
    if (scene_.triangle_count() == 0) {
        throw base::bad_input("the scene \"{}\" has no triangle: there is nothing to measure",
                              view.scene->id);
    }
    gpu_ = std::make_unique<renderer::GpuScene>(scene_);
    rays_ = std::make_unique<renderer::ReferenceScene>(scene_);
    loaded_ = view.scene;
}

const renderer::Camera& MeasuredScene::camera_of(const MeasuredView& view) const {
    const renderer::Camera* camera = scene_.find_camera(view.camera);
    if (camera == nullptr) {
        throw base::bad_input("scene \"{}\" has no camera \"{}\"", view.scene->id, view.camera);
    }
    return *camera;
}

const renderer::Lighting& MeasuredScene::lighting_of(const MeasuredView& view) {
    if (!lightings_.contains(view.validity)) {
        renderer::Lighting light = view.scene->lighting(view.validity);
        if (light.wants_probes() && !light.irradiance_grid) {
            if (!baker_) {
                baker_ = std::make_unique<renderer::IrradianceBaker>(
                    std::shared_ptr<const renderer::Scene>(std::shared_ptr<void>(), &scene_));
            }
            light.irradiance_grid = baker_->bake(light);
        }
        lightings_.emplace(view.validity, std::move(light));
    }
    return lightings_.at(view.validity);
}

renderer::View MeasuredScene::shown(const MeasuredView& view) {
    load(view);
    return {*gpu_, lighting_of(view), camera_of(view), view.options, {}, rays_of_scene()};
}

renderer::Frame MeasuredScene::render(const MeasuredView& view, const renderer::Variant& choice,
                                      int width, int height, const renderer::ViewBuffers& known) {
    return renderer_.render(shown(view), choice, width, height, known);
}

std::vector<renderer::PassTime> MeasuredScene::render_again(const MeasuredView& view,
                                                            renderer::Frame& frame,
                                                            const renderer::Variant& choice) {
    return renderer_.render_accessibility_again(frame, shown(view), choice);
}

renderer::Frame MeasuredScene::render_plainly(const MeasuredView& view,
                                              const renderer::Variant& choice, int width,
                                              int height) {
    load(view);
    renderer::Lighting lighting;
    lighting.normal_mapping = lighting_of(view).normal_mapping;
    // Accessibility is computed once a pixel, whatever the samples of the image.
    const renderer::FrameOptions options{.occluding_opacity = view.options.occluding_opacity};
    return renderer_.render({*gpu_, lighting, camera_of(view), options, {}, rays_of_scene()},
                            choice, width, height);
}

const renderer::ReferenceImage& MeasuredScene::truth(const MeasuredView& view, double radius_m,
                                                     int width, int height, int rays) {
    load(view);
    const std::string key =
        fmt::format("{} {} {}x{} {}", view.camera, radius_m, width, height, rays);
    const auto found = truths_.find(key);
    if (found != truths_.end()) return found->second;
    renderer::ReferenceOptions options;
    options.radius_m = radius_m;
    options.rays = rays;
    constexpr std::size_t kSteps = 50;
    base::Progress progress(fmt::format("truth of {}, {}", view.scene->id, view.camera), kSteps,
                            request_.quiet);
    std::size_t said = 0;
    const auto say = [&](double share) {
        for (; said < static_cast<std::size_t>(share * kSteps); ++said) progress.step("rays");
        return true;
    };
    return truths_
        .emplace(key, renderer::cached_reference(request_.cache, *rays_, camera_of(view), width,
                                                 height, options, say))
        .first->second;
}

std::vector<std::uint8_t> MeasuredScene::true_image(const MeasuredView& view,
                                                    const renderer::ReferenceImage& truth,
                                                    double radius_m) {
    renderer::Variant choice;
    choice.technique = "reference";
    choice.samples = 1;
    choice.parameters["radius_m"] = radius_m;
    renderer::View with_truth = shown(view);
    with_truth.traced = [&truth](const renderer::Camera&, int, int, const renderer::Variant&) {
        return truth.accessibility;
    };
    return renderer_.render(with_truth, choice, truth.width, truth.height).read_display();
}

}  // namespace obscura::app
