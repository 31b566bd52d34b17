// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/report_input.h"

#include <fmt/format.h>

#include "app/kiosk/machine.h"
#include "stimuli/embedded.h"
#include "stimuli/manifest.h"
#include "stimuli/stimulus.h"
#include "stimuli/variant_names.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;
using analysis::ShownImage;

void put_variant(ShownImage& shown, const renderer::Variant& variant, const std::string& name) {
    shown.technique = variant.technique;
    shown.variant = name;
    shown.samples = variant.samples;
    shown.parameters = variant.all_parameters();
    shown.denoise = variant.denoise;
    shown.depth_format = variant.depth_format;
}

ShownImage shown(const stimuli::ManifestImage& image, const stimuli::VariantNames& names,
                 const fs::path& folder) {
    ShownImage result;
    result.condition = image.condition;
    result.side = image.side == "a" ? 'A' : 'B';
    result.scene_id = image.scene;
    result.scene = image.source;
    result.camera = image.camera;
    result.validity = image.validity;
    put_variant(result, image.variant, names.at({image.condition, image.side == "a" ? 'a' : 'b'}));
    result.mean_luminance = image.mean_luminance;
    result.mean_occlusion = image.mean_occlusion;
    result.contrast = image.contrast;
    result.exposure_factor = image.exposure_factor;
    if (image.accuracy) result.rmse = image.accuracy->rmse;
    result.file = folder / image.file;
    result.sha256 = image.sha256;
    return result;
}

/// As the study asks for it, where no file was made.
ShownImage planned(const stimuli::Study& study, const stimuli::VariantNames& names,
                   const stimuli::Stimulus& stimulus) {
    const stimuli::StudyScene& scene = study.scene_of(*stimulus.condition);
    ShownImage result;
    result.condition = stimulus.condition->id;
    result.side = stimulus.side == 'a' ? 'A' : 'B';
    result.scene_id = scene.id;
    result.scene = scene.source;
    result.camera = scene.camera;
    result.validity = std::string(to_string(scene.validity));
    put_variant(result, stimulus.choice(), names.at({result.condition, stimulus.side}));
    return result;
}

void add_images(analysis::ReportInput& input, const ReportSources& sources,
                const std::string& name) {
    if (name.empty()) {
        input.images_unknown = "the answers do not name their study";
        return;
    }
    const fs::path folder = sources.data / "stimuli" / name;
    const fs::path manifest = folder / "manifest.json";
    if (fs::exists(manifest)) {
        const stimuli::Manifest made = stimuli::load_manifest(manifest);
        const stimuli::VariantNames names = stimuli::variant_names(made);
        for (const auto& image : made.images) {
            ShownImage entry = shown(image, names, folder);
            for (const stimuli::ManifestPair& pair : made.pairs) {
                if (pair.condition != image.condition) continue;
                entry.noticeable_share = pair.difference.over_threshold;
            }
            input.images.push_back(std::move(entry));
        }
        return;
    }
    input.images_unknown =
        fmt::format("there is no {}; obscura render makes it", manifest.string());
    if (!sources.study) return;
    const stimuli::VariantNames names = stimuli::variant_names(*sources.study);
    for (const auto& stimulus : stimuli::stimuli_of(*sources.study)) {
        input.images.push_back(planned(*sources.study, names, stimulus));
    }
}

}  // namespace

void add_sources(analysis::ReportInput& input, const ReportSources& sources) {
    input.software = kiosk::software_version();
    std::string name = input.analysis.tally.study;
    if (sources.study) {
        const stimuli::Study& study = *sources.study;
        input.study = {study.title, study.question, to_words(study.presentation),
                       std::string(to_string(study.order))};
        name = sources.study->name;
    }
    add_images(input, sources, name);
    const fs::path standard = sources.data / "reports" / "measure" / "measure.csv";
    if (!sources.measurement.empty()) {
        input.measurement = analysis::read_measurement(sources.measurement);
    } else if (fs::exists(standard)) {
        input.measurement = analysis::read_measurement(standard);
    } else {
        input.measurement_unknown = fmt::format("there is no {}", standard.string());
    }
}

std::optional<stimuli::Study> builtin_study(const std::string& name) {
    const std::string_view text = stimuli::embedded("studies/" + name + ".toml");
    if (name.empty() || text.data() == nullptr) return std::nullopt;
    return stimuli::parse_study(text, name);
}

}  // namespace obscura::app
