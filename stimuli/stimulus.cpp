// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/stimulus.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/gl/context.h"
#include "renderer/gl/embedded_shaders.h"
#include "renderer/gl/program.h"

namespace obscura::stimuli {
namespace {

using Json = nlohmann::ordered_json;

std::map<std::string, double> parameters_of(const renderer::TechniqueChoice& choice) {
    std::map<std::string, double> values;
    for (const auto& parameter : renderer::find_technique(choice.technique)->parameters) {
        values[parameter.name] = choice.value_of(parameter);
    }
    return values;
}

/// Program, driver and, where they are read from a folder, shaders.
std::string hash_of_environment() {
    std::string all = base::sha256_hex(base::read_file("/proc/self/exe"));
    all += renderer::gpu_description();
    if (!renderer::gl::shader_folder().empty()) {
        for (const std::string_view path : renderer::shaders::embedded_names()) {
            all += renderer::gl::shader_source(std::string(path));
        }
    }
    return base::sha256_hex(all);
}

}  // namespace

std::string Stimulus::file() const { return condition->id + '-' + side + ".png"; }

std::vector<Stimulus> stimuli_of(const Study& study) {
    std::vector<Stimulus> list;
    for (const Condition& condition : study.conditions) {
        for (const char side : {'a', 'b'}) list.push_back({&condition, side});
    }
    return list;
}

StimulusRenderer::StimulusRenderer(const Study& study, const std::vector<BuiltinScene>& catalogue)
    : study_(study), catalogue_(catalogue), environment_sha256_(hash_of_environment()) {}

const BuiltinScene& StimulusRenderer::builtin(const std::string& source) const {
    for (const BuiltinScene& scene : catalogue_) {
        if (scene.id == source) return scene;
    }
    throw base::bad_input("there is no scene \"{}\"", source);
}

void StimulusRenderer::load(const std::string& source) {
    if (loaded_.source == source) return;
    loaded_ = {};
    loaded_.scene = builtin(source).build();
    loaded_.gpu = std::make_unique<renderer::GpuScene>(loaded_.scene);
    loaded_.source = source;
}

renderer::Frame StimulusRenderer::render(const Stimulus& stimulus) {
    const StudyScene& scene = study_.scene_of(*stimulus.condition);
    load(scene.source);
    const renderer::Camera* camera = loaded_.scene.find_camera(scene.camera);
    if (camera == nullptr) {
        throw base::bad_input("scene \"{}\" has no camera \"{}\"", scene.source, scene.camera);
    }
    const auto key = std::pair(scene.source, scene.validity);
    if (!lightings_.contains(key)) {
        lightings_.emplace(key, builtin(scene.source).lighting(scene.validity));
    }
    const renderer::Lighting& lighting = lightings_.at(key);
    const renderer::FramePlan plan =
        renderer::plan_frame(renderer::needs_of(loaded_.scene, lighting), stimulus.choice(),
                             study_.width, study_.height);
    const auto traced = [this](const renderer::Camera& view, int width, int height,
                               const renderer::TechniqueChoice& choice) {
        if (!loaded_.reference) {
            loaded_.reference = std::make_unique<renderer::ReferenceScene>(loaded_.scene);
        }
        return loaded_.reference->trace(view, width, height, renderer::reference_options(choice))
            .accessibility;
    };
    return renderer_.render(*loaded_.gpu, lighting, *camera, stimulus.choice(), plan, traced);
}

ManifestImage StimulusRenderer::describe(const Stimulus& stimulus,
                                         const renderer::Frame& frame) const {
    const StudyScene& scene = study_.scene_of(*stimulus.condition);
    const renderer::TechniqueChoice& choice = stimulus.choice();
    ManifestImage image;
    image.file = stimulus.file();
    image.condition = stimulus.condition->id;
    image.side = std::string(1, stimulus.side);
    image.scene = scene.id;
    image.source = scene.source;
    image.camera = scene.camera;
    image.validity = to_string(scene.validity);
    image.technique = choice.technique;
    image.samples = choice.samples;
    image.parameters = parameters_of(choice);
    image.denoise = choice.denoise;
    image.width = study_.width;
    image.height = study_.height;
    for (const renderer::PassTime& time : frame.times) {
        image.passes.push_back(renderer::to_string(time.pass));
        image.milliseconds += time.milliseconds;
    }
    image.inputs_sha256 = inputs_sha256(stimulus);
    return image;
}

std::string StimulusRenderer::inputs_sha256(const Stimulus& stimulus) const {
    const StudyScene& scene = study_.scene_of(*stimulus.condition);
    const renderer::TechniqueChoice& choice = stimulus.choice();
    const Json inputs = {{"environment", environment_sha256_},
                         {"source", scene.source},
                         {"camera", scene.camera},
                         {"validity", to_string(scene.validity)},
                         {"technique", choice.technique},
                         {"samples", choice.samples},
                         {"parameters", parameters_of(choice)},
                         {"denoise", choice.denoise},
                         {"width", study_.width},
                         {"height", study_.height}};
    return base::sha256_hex(inputs.dump());
}

RgbImage image_of(const renderer::Frame& frame) {
    return {frame.plan().width, frame.plan().height, frame.read_display()};
}

}  // namespace obscura::stimuli
