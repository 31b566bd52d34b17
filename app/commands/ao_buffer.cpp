// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/ao_buffer.h"

#include <fmt/format.h>

#include "app/commands/scene_argument.h"
#include "renderer/base/interrupt.h"
#include "renderer/base/progress.h"
#include "renderer/technique/reference.h"
#include "stimuli/buffers.h"

namespace obscura::app {
namespace {

using renderer::FloatImage;
using renderer::Variant;

/// Says of the image what it is of.
void describe(FloatImage& image, const std::string& scene, const renderer::Camera& camera,
              stimuli::Validity validity, const Variant& choice) {
    image.texts = {{"obscura:scene", scene},
                   {"obscura:camera", camera.name.empty() ? line_of(camera) : camera.name},
                   {"obscura:validity", std::string(to_string(validity))},
                   {"obscura:technique", choice.technique},
                   {"obscura:samples", std::to_string(choice.samples)},
                   {"obscura:denoise", choice.denoise}};
    for (const auto& [name, value] : choice.all_parameters()) {
        image.texts["obscura:" + name] = fmt::format("{}", value);
    }
    for (const renderer::VariantOption& option : renderer::variant_options()) {
        const std::string& value = choice.*option.value;
        if (value != option.standard()) image.texts["obscura:" + option.name] = value;
    }
    const renderer::CameraMatrices matrices =
        renderer::matrices_of(camera, image.width, image.height);
    image.matrices = {{"obscura:view", stimuli::column_major(matrices.view_from_world)},
                      {"obscura:projection", stimuli::column_major(matrices.clip_from_view)}};
}

}  // namespace

const renderer::ReferenceScene& AoBuffers::rays() {
    if (!rays_) rays_ = std::make_unique<renderer::ReferenceScene>(*opened_.scene);
    return *rays_;
}

renderer::ReferenceImage AoBuffers::trace(const renderer::Camera& camera,
                                          const renderer::ReferenceOptions& options) {
    const base::StopOnInterrupt stop;
    base::Progress progress("trace", 100, settings_.quiet);
    int percent = 0;
    const auto tell = [&](double share) {
        for (; percent < static_cast<int>(100.0 * share); ++percent) progress.step("%");
        return !stop.asked();
    };
    return renderer::cached_reference(settings_.cache, rays(), camera, settings_.width,
                                      settings_.height, options, tell);
}

std::vector<float> AoBuffers::rendered(const renderer::Camera& camera, const Variant& variant) {
    if (!gpu_) {
        context_ = std::make_unique<renderer::HeadlessContext>();
        renderer_ = std::make_unique<renderer::Renderer>();
        gpu_ = std::make_unique<renderer::GpuScene>(*opened_.scene);
    }
    renderer::Lighting lighting = opened_.lighting(validity_);
    lighting.irradiance_probes = false;  // accessibility is the same with them
    const auto traced = [&](const renderer::Camera& from, int, int, const Variant& choice) {
        return trace(from, renderer::reference_options(choice)).accessibility;
    };
    const auto of_scene = [this]() -> const renderer::ReferenceScene& { return rays(); };
    return renderer_
        ->render({*gpu_, lighting, camera, {}, traced, of_scene}, variant, settings_.width,
                 settings_.height)
        .read_accessibility();
}

FloatImage AoBuffers::make(const renderer::Camera& camera, const Variant& variant) {
    FloatImage image;
    image.width = settings_.width;
    image.height = settings_.height;
    describe(image, opened_.id, camera, validity_, variant);
    const bool as_traced =
        renderer::find_technique(variant.technique)->is_truth() && variant.denoise == "none";
    if (as_traced) {
        renderer::ReferenceImage truth = trace(camera, renderer::reference_options(variant));
        image.channels = {{"ao.Y", std::move(truth.accessibility)},
                          {"ao.stderr", std::move(truth.standard_error)}};
    } else {
        image.channels = {{"ao.Y", rendered(camera, variant)}};
    }
    return image;
}

}  // namespace obscura::app
