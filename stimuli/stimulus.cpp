// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/stimulus.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/frame/everything.h"
#include "renderer/gl/drawing_hash.h"
#include "renderer/technique/reference.h"
#include "stimuli/buffers.h"
#include "stimuli/pairs.h"
#include "stimuli/variant_format.h"

namespace obscura::stimuli {
namespace {

using Json = nlohmann::ordered_json;

/// Two images whose mean luminances are that near to each other, as a share, are equally bright.
constexpr double kSameLuminance = 0.001;
constexpr int kExposureSteps = 5;
constexpr double kLeastFactor = 1.0 / 64.0;
constexpr double kMostFactor = 64.0;
/// By how much fewer columns and rows an image has that only compiles shaders.
constexpr int kFewerToCompile = 8;

int fewer_px(int length_px, int fewer) { return std::max(1, length_px / fewer); }

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
    : study_(study), catalogue_(catalogue), environment_sha256_(renderer::drawing_sha256()) {}

void StimulusRenderer::load(const StudyScene& scene) {
    if (loaded_.source == scene.source && loaded_.scale == scene.settings.scale) return;
    loaded_ = {};
    known_ = {};
    compiled_ = {};
    SceneSettings geometry;
    geometry.scale = scene.settings.scale;
    loaded_.opened = open_scene(scene.source, geometry, study_.folder, catalogue_);
    loaded_.gpu = std::make_unique<renderer::GpuScene>(*loaded_.opened.scene);
    loaded_.source = scene.source;
    loaded_.scale = scene.settings.scale;
}

const renderer::Lighting& StimulusRenderer::lighting_of(const StudyScene& scene) {
    const auto known = lightings_.find(scene.id);
    if (known != lightings_.end()) return known->second;
    renderer::Lighting lighting = loaded_.opened.with_probes(with_settings(
        loaded_.opened.lighting(scene.validity), scene.validity, scene.settings, study_.folder));
    return lightings_.emplace(scene.id, std::move(lighting)).first->second;
}

const std::vector<renderer::ImportedFile>& StimulusRenderer::files_of(
    const StudyScene& scene) const {
    if (!scene.files.empty()) return scene.files;  // as they were when the study was read
    const auto [entry, fresh] = files_.try_emplace(scene.id);
    if (fresh && (is_file_source(scene.source) || !scene.settings.environment.empty())) {
        entry->second = open_scene(scene.source, scene.settings, study_.folder, catalogue_).files;
    }
    return entry->second;
}

StimulusRenderer::View StimulusRenderer::view_of(const Stimulus& stimulus) {
    const StudyScene& scene = study_.scene_of(*stimulus.condition);
    load(scene);
    const renderer::Camera& camera =
        scene.settings.camera ? *scene.settings.camera : loaded_.opened.camera(scene.camera);
    return {lighting_of(scene), camera};
}

const renderer::ReferenceScene& StimulusRenderer::rays() {
    if (!loaded_.reference) {
        loaded_.reference = std::make_unique<renderer::ReferenceScene>(*loaded_.opened.scene);
    }
    return *loaded_.reference;
}

renderer::TracedAccessibility StimulusRenderer::tracer() {
    return [this](const renderer::Camera& camera, int width, int height,
                  const renderer::Variant& choice) {
        return rays()
            .trace(camera, width, height, renderer::reference_options(choice))
            .accessibility;
    };
}

renderer::Frame StimulusRenderer::render_with(const Stimulus& stimulus,
                                              const renderer::FrameOptions& options,
                                              const renderer::ViewBuffers& known, int fewer) {
    const View view = view_of(stimulus);
    return renderer_.render(
        {*loaded_.gpu, view.lighting, view.camera, options, tracer(), rays_of_scene()},
        stimulus.choice(), fewer_px(study_.width, fewer), fewer_px(study_.height, fewer), known);
}

renderer::Frame StimulusRenderer::render_exposed(const Stimulus& stimulus, double factor,
                                                 const renderer::ViewBuffers& known, int fewer) {
    const View view = view_of(stimulus);
    renderer::Lighting lighting = view.lighting;
    renderer::ToneMapping tone =
        lighting.tone_mapping.value_or(renderer::ToneMapping{.curve = renderer::ToneCurve::kClip});
    tone.exposure = static_cast<float>(tone.exposure * factor);
    lighting.tone_mapping = tone;
    return renderer_.render(
        {*loaded_.gpu, lighting, view.camera, study_.frame_options(), tracer(), rays_of_scene()},
        stimulus.choice(), fewer_px(study_.width, fewer), fewer_px(study_.height, fewer), known);
}

std::optional<double> StimulusRenderer::exposure_factor(const Stimulus& stimulus) {
    if (!study_.match_luminance || stimulus.side == 'a') return std::nullopt;
    const auto [entry, fresh] = exposure_factors_.try_emplace(stimulus.condition->id, 1.0);
    if (!fresh) return entry->second;
    const renderer::Frame first = render_with({stimulus.condition, 'a'}, study_.frame_options());
    const double wanted = brightness_of(image_of(first)).mean;
    const renderer::ViewBuffers known = first.view_buffers();
    double factor = 1.0;
    double power = 1.0;  // by which luminance follows the factor; a tone curve makes it less
    for (int step = 0; step < kExposureSteps && wanted > 0.0; ++step) {
        const double met = brightness_of(image_of(render_exposed(stimulus, factor, known))).mean;
        if (met <= 0.0 || std::abs(met / wanted - 1.0) < kSameLuminance) break;
        const double next =
            std::clamp(factor * std::pow(wanted / met, 1.0 / power), kLeastFactor, kMostFactor);
        if (next == factor) break;
        const double after = brightness_of(image_of(render_exposed(stimulus, next, known))).mean;
        if (after > 0.0 && after != met) {
            power = std::clamp(std::log(after / met) / std::log(next / factor), 0.2, 2.0);
        }
        factor = next;
    }
    return entry->second = factor;
}

std::optional<Accuracy> StimulusRenderer::accuracy(const Stimulus& stimulus,
                                                   const renderer::Frame& frame) {
    const std::optional<double> radius_m = truth_radius_m(*stimulus.condition);
    if (!radius_m || frame.plan().makes_colour) return std::nullopt;
    const View view = view_of(stimulus);
    const StudyScene& scene = study_.scene_of(*stimulus.condition);
    const auto [truth, fresh] = loaded_.truths.try_emplace(
        {scene.camera + to_json(scene.settings), *radius_m}, std::nullopt);
    if (fresh) {
        try {
            truth->second =
                sparse_truth(rays(), view.camera, study_.width, study_.height, *radius_m);
        } catch (const base::Error& none) {  // no triangle of it can be met by a ray
            base::log::warn("warning: {}: its accuracy is not measured: {}", stimulus.file(),
                            none.what());
        }
    }
    if (!truth->second) return std::nullopt;
    return accuracy_of(frame.read_accessibility(), *truth->second);
}

renderer::Frame StimulusRenderer::render_at(const Stimulus& stimulus,
                                            const renderer::ViewBuffers& known, int fewer) {
    if (const std::optional<double> factor = exposure_factor(stimulus)) {
        return render_exposed(stimulus, *factor, known, fewer);
    }
    return render_with(stimulus, study_.frame_options(), known, fewer);
}

renderer::Frame StimulusRenderer::render(const Stimulus& stimulus,
                                         const renderer::ViewBuffers& known) {
    return render_at(stimulus, known, 1);
}

void StimulusRenderer::compile(const Stimulus& stimulus) {
    const std::string& scene = stimulus.condition->scene;
    if (compiled_.scene != scene) compiled_ = {scene};
    compiled_.planned = render_at(stimulus, compiled_.planned, kFewerToCompile).view_buffers();
    compiled_.everything =
        render_everything(stimulus, compiled_.everything, kFewerToCompile).view_buffers();
}

renderer::Frame StimulusRenderer::render_next(const Stimulus& stimulus) {
    if (known_scene_ != stimulus.condition->scene) {
        known_ = {};
        known_scene_ = stimulus.condition->scene;
    }
    renderer::Frame frame = render(stimulus, known_);
    renderer::ViewBuffers buffers = frame.view_buffers();
    // What took over everything may hold less than what it took it from.
    if (frame.taken_over().size() < buffers.times.size()) known_ = std::move(buffers);
    return frame;
}

renderer::Frame StimulusRenderer::render_everything(const Stimulus& stimulus,
                                                    const renderer::ViewBuffers& known) {
    return render_everything(stimulus, known, 1);
}

renderer::Frame StimulusRenderer::render_everything(const Stimulus& stimulus,
                                                    const renderer::ViewBuffers& known, int fewer) {
    const View view = view_of(stimulus);
    const renderer::Lighting lighting = renderer::with_everything(view.lighting);
    renderer::FrameOptions options = study_.frame_options();
    options.all_buffers = true;
    return renderer_.render(
        {*loaded_.gpu, lighting, view.camera, options, tracer(), rays_of_scene(),
         renderer::needs_of_everything(*loaded_.opened.scene, lighting)},
        stimulus.choice(), fewer_px(study_.width, fewer), fewer_px(study_.height, fewer), known);
}

renderer::FloatImage StimulusRenderer::render_buffers(const Stimulus& stimulus) {
    const View view = view_of(stimulus);
    const renderer::Frame frame =
        render_with(stimulus, {.occluding_opacity = study_.occluding_opacity, .all_buffers = true});
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

std::string StimulusRenderer::reason_of_likeness(const Condition& condition) {
    const PairBuffers pair{render_buffers({&condition, 'a'}), render_buffers({&condition, 'b'})};
    return stimuli::reason_of_likeness(condition, *loaded_.opened.scene,
                                       view_of({&condition, 'a'}).camera, pair);
}

ManifestImage StimulusRenderer::describe(const Stimulus& stimulus, const renderer::Frame& frame) {
    const StudyScene& scene = study_.scene_of(*stimulus.condition);
    ManifestImage image;
    image.file = stimulus.file();
    image.condition = stimulus.condition->id;
    image.side = std::string(1, stimulus.side);
    image.scene = scene.id;
    image.source = scene.source;
    image.camera = scene.camera;
    image.validity = to_string(scene.validity);
    image.settings = to_json(scene.settings);
    for (const renderer::ImportedFile& file : files_of(scene)) {
        image.scene_files.push_back({file.path.filename().string(), file.sha256});
    }
    image.scene_notes = scene.notes;
    image.variant = stimulus.choice();
    image.width = study_.width;
    image.height = study_.height;
    image.supersampling = study_.supersampling;
    image.occluding_opacity = study_.occluding_opacity;
    image.tone_mapping = tone_mapping_of(lightings_.at(scene.id));
    for (const renderer::PassTime& time : renderer::by_name(frame.times)) {
        image.passes.push_back(time.name);
    }
    image.milliseconds = frame.milliseconds();
    image.exposure_factor = exposure_factor(stimulus);
    if (!frame.plan().makes_colour) {
        const std::vector<float> open = frame.read_accessibility();
        image.mean_occlusion =
            1.0 - std::accumulate(open.begin(), open.end(), 0.0) / static_cast<double>(open.size());
    }
    image.inputs_sha256 = inputs_sha256(stimulus);
    return image;
}

std::string StimulusRenderer::inputs_sha256(const Stimulus& stimulus) const {
    const StudyScene& scene = study_.scene_of(*stimulus.condition);
    Json files = Json::array();
    for (const renderer::ImportedFile& file : files_of(scene)) files.push_back(file.sha256);
    Json inputs = {{"environment", environment_sha256_},
                   {"source", scene.source},
                   {"camera", scene.camera},
                   {"validity", to_string(scene.validity)},
                   {"settings", to_json(scene.settings)},
                   {"files", files},
                   {"width", study_.width},
                   {"height", study_.height},
                   {"supersampling", study_.supersampling},
                   {"occluding_opacity", study_.occluding_opacity.value_or(0.0F)}};
    put_variant(inputs, stimulus.choice());
    if (study_.match_luminance && stimulus.side == 'b') {
        put_variant(inputs["as_bright_as"], stimulus.condition->a);
    }
    return base::sha256_hex(inputs.dump());
}

RgbImage image_of(const renderer::Frame& frame) {
    return {frame.plan().image_width, frame.plan().image_height, frame.read_display()};
}

}  // namespace obscura::stimuli
