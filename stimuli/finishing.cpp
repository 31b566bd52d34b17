// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/finishing.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/base/version.h"
#include "renderer/gl/context.h"

namespace obscura::stimuli {

namespace fs = std::filesystem;

bool is_part_manifest(std::string_view name) {
    const auto take = [&name](std::string_view word) {
        const bool there = name.starts_with(word);
        if (there) name.remove_prefix(word.size());
        return there;
    };
    const auto take_number = [&name] {
        const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
        name.remove_prefix(digits);
        return digits > 0;
    };
    return take("manifest-") && take_number() && take("-of-") && take_number() && name == ".json";
}

namespace {

/// manifest.json, or the list of a part; nothing else that may lie there.
bool is_manifest(const std::string& name) {
    return name == "manifest.json" || is_part_manifest(name);
}

/// What the manifest says of an image that is the copy of another.
ManifestImage as_copy(const Study& study, const Stimulus& stimulus, ManifestImage image) {
    image.file = stimulus.file();
    image.condition = stimulus.condition->id;
    image.side = std::string(1, stimulus.side);
    image.scene = study.scene_of(*stimulus.condition).id;
    return image;
}

/// Nothing can be seen in it: a scene as bright as its background, or a camera that misses it.
bool is_of_one_colour(const RgbImage& image) {
    for (std::size_t i = 3; i < image.rgb.size(); ++i) {
        if (image.rgb[i] != image.rgb[i - 3]) return false;
    }
    return true;
}

}  // namespace

FinishedImages finished_images(const Study& study, const StimulusRenderer& renderer,
                               const fs::path& folder) {
    std::map<std::string, std::string> inputs;
    for (const Stimulus& stimulus : stimuli_of(study)) {
        inputs[stimulus.file()] = renderer.inputs_sha256(stimulus);
    }
    FinishedImages finished;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!is_manifest(name)) continue;
        Manifest manifest;
        try {
            manifest = load_manifest(entry.path());
        } catch (const base::Error&) {
            continue;  // what it listed is made again, and the list with it
        }
        const bool same_gpu = manifest.gpu_renderer == renderer::gpu_renderer();
        for (const ManifestImage& image : manifest.images) {
            const fs::path file = folder / image.file;
            if (!inputs.contains(image.file) || !fs::is_regular_file(file)) continue;
            if (!shows_what_is_asked(study, image)) continue;
            const bool current = same_gpu && image.inputs_sha256 == inputs.at(image.file);
            if (!current && !same_gpu) continue;
            if (base::sha256_hex(base::read_file(file)) != image.sha256) continue;
            Finished& known = finished[image.file];
            if (!known.current) known = {image, current};
        }
    }
    return finished;
}

Manifest manifest_of(const Study& study, const FinishedImages& finished,
                     const std::string& gpu_renderer) {
    Manifest manifest{study.name, study.seed, gpu_renderer, {}, {}, base::program_version()};
    for (const Stimulus& stimulus : stimuli_of(study)) {
        const auto found = finished.find(stimulus.file());
        if (found != finished.end()) manifest.images.push_back(found->second.image);
    }
    return manifest;
}

bool is_current(const FinishedImages& finished, const std::string& file) {
    const auto found = finished.find(file);
    return found != finished.end() && found->second.current;
}

void add_twins(const FinishedImages& finished, const fs::path& folder, Twins& twins) {
    for (const auto& [file, one] : finished) {
        if (one.current) twins.try_emplace(one.image.inputs_sha256, Twin{folder / file, one.image});
    }
}

std::string title_of(const Stimulus& stimulus) {
    return fmt::format("{} ({})", stimulus.file(), stimulus.choice().variant_name());
}

Finishing::Finishing(const Study& study, fs::path folder, fs::path list, FinishedImages& finished,
                     Twins& twins, base::Progress& progress)
    : study_(study),
      folder_(std::move(folder)),
      list_(std::move(list)),
      gpu_(renderer::gpu_renderer()),
      finished_(finished),
      twins_(twins),
      progress_(progress) {}

void Finishing::begin(const Stimulus& stimulus, ManifestImage entry, RgbImage image) {
    await_last();
    last_ = std::async(std::launch::async, [this, &stimulus, entry = std::move(entry),
                                            image = std::move(image)]() mutable {
        const std::string bytes = encode_png(image);
        entry.sha256 = base::sha256_hex(bytes);
        const Brightness brightness = brightness_of(image);
        entry.mean_luminance = brightness.mean;
        entry.contrast = brightness.contrast;
        finish(stimulus, entry, std::move(image), bytes, title_of(stimulus));
    });
}

void Finishing::copy(const Stimulus& stimulus, const std::string& inputs_sha256) {
    await_last();
    const Twin& twin = twins_.at(inputs_sha256);
    const std::string bytes = base::read_file(twin.file);
    finish(stimulus, as_copy(study_, stimulus, twin.image), decode_png(bytes, twin.file.string()),
           bytes, stimulus.file() + " (copied)");
}

void Finishing::keep(const Stimulus& stimulus) {
    await_last();
    progress_.step(stimulus.file() + " (kept)");
}

std::vector<ManifestPair> Finishing::end() {
    await_last();
    return made_.pairs();
}

void Finishing::await_last() {
    if (last_.valid()) last_.get();
}

void Finishing::finish(const Stimulus& stimulus, const ManifestImage& entry, RgbImage image,
                       const std::string& bytes, const std::string& told) {
    if (is_of_one_colour(image)) {
        base::log::warn("warning: {}: the whole image has one colour", stimulus.file());
    }
    base::write_file_atomically(folder_ / entry.file, bytes);
    made_.add(entry, std::move(image));
    finished_.insert_or_assign(entry.file, Finished{entry, true});
    twins_.try_emplace(entry.inputs_sha256, Twin{folder_ / entry.file, entry});
    save_manifest(list_, manifest_of(study_, finished_, gpu_));
    progress_.step(told);
}

}  // namespace obscura::stimuli
