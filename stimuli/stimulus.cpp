// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/stimulus.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/frame/everything.h"
#include "renderer/gl/context.h"
#include "renderer/gl/embedded_shaders.h"
#include "renderer/gl/program.h"
#include "stimuli/buffers.h"

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

ManifestToneMapping tone_mapping_of(const renderer::Lighting& lighting) {
    if (!lighting.tone_mapping) return {};
    const renderer::ToneMapping& tone = *lighting.tone_mapping;
    return {std::string(to_string(tone.curve)), tone.exposure, tone.white};
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

StimulusRenderer::View StimulusRenderer::view_of(const Stimulus& stimulus) {
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
    return {lightings_.at(key), *camera};
}

renderer::TracedAccessibility StimulusRenderer::tracer() {
    return [this](const renderer::Camera& camera, int width, int height,
                  const renderer::TechniqueChoice& choice) {
        if (!loaded_.reference) {
            loaded_.reference = std::make_unique<renderer::ReferenceScene>(loaded_.scene);
        }
        return loaded_.reference->trace(camera, width, height, renderer::reference_options(choice))
            .accessibility;
    };
}

renderer::Frame StimulusRenderer::render(const Stimulus& stimulus,
                                         const renderer::FrameOptions& options) {
    const View view = view_of(stimulus);
    const renderer::FramePlan plan =
        renderer::plan_frame(renderer::needs_of(loaded_.scene, view.lighting), stimulus.choice(),
                             study_.width, study_.height, options);
    return renderer_.render(*loaded_.gpu, view.lighting, view.camera, stimulus.choice(), plan,
                            tracer());
}

renderer::Frame StimulusRenderer::render(const Stimulus& stimulus) {
    return render(stimulus, {.supersampling = study_.supersampling});
}

renderer::Frame StimulusRenderer::render_everything(const Stimulus& stimulus) {
    const View view = view_of(stimulus);
    const renderer::Lighting lighting = renderer::with_everything(view.lighting);
    const renderer::FramePlan plan = renderer::plan_frame(
        renderer::needs_of_everything(loaded_.scene, lighting), stimulus.choice(), study_.width,
        study_.height, {.supersampling = study_.supersampling, .all_buffers = true});
    return renderer_.render(*loaded_.gpu, lighting, view.camera, stimulus.choice(), plan, tracer());
}

renderer::FloatImage StimulusRenderer::render_buffers(const Stimulus& stimulus) {
    const View view = view_of(stimulus);
    const renderer::Frame frame = render(stimulus, {.all_buffers = true});
    renderer::FloatImage image = buffers_of(frame, view.lighting);
    const auto matrices = renderer::matrices_of(view.camera, study_.width, study_.height);
    image.matrices["obscura:view"] = column_major(matrices.view_from_world);
    image.matrices["obscura:projection"] = column_major(matrices.clip_from_view);
    const ManifestImage facts = describe(stimulus, frame);
    image.texts["obscura:study"] = study_.name;
    image.texts["obscura:condition"] = facts.condition;
    image.texts["obscura:side"] = facts.side;
    image.texts["obscura:scene"] = facts.source;
    image.texts["obscura:camera"] = facts.camera;
    image.texts["obscura:validity"] = facts.validity;
    image.texts["obscura:variant"] = stimulus.choice().variant_name();
    image.texts["obscura:inputs_sha256"] = facts.inputs_sha256;
    return image;
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
    image.supersampling = study_.supersampling;
    image.tone_mapping = tone_mapping_of(lightings_.at({scene.source, scene.validity}));
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
                         {"height", study_.height},
                         {"supersampling", study_.supersampling}};
    return base::sha256_hex(inputs.dump());
}

RgbImage image_of(const renderer::Frame& frame) {
    return {frame.plan().image_width, frame.plan().image_height, frame.read_display()};
}

}  // namespace obscura::stimuli
