// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "renderer/base/check.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/progress.h"
#include "renderer/gl/context.h"
#include "stimuli/png.h"
#include "stimuli/stimulus.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;

/// The selected images, those of one scene together so that it is built once.
std::vector<Stimulus> select(const Study& study, const Selection& selection) {
    base::check_range("--shard", "N", selection.shards, 1, 1000000);
    base::check_range("--shard", "K", selection.shard, 1, selection.shards);
    if (!selection.pair.empty() && study.find_condition(selection.pair) == nullptr) {
        std::string known;
        for (const Condition& condition : study.conditions) {
            known += (known.empty() ? "" : ", ") + condition.id;
        }
        throw base::bad_input("--pair: study {} has no condition \"{}\"; it has {}", study.name,
                              selection.pair, known);
    }
    std::vector<Stimulus> wanted;
    for (const Stimulus& stimulus : stimuli_of(study)) {
        if (selection.pair.empty() || stimulus.condition->id == selection.pair) {
            wanted.push_back(stimulus);
        }
    }
    std::stable_sort(wanted.begin(), wanted.end(), [&study](const auto& left, const auto& right) {
        return study.scene_of(*left.condition).source < study.scene_of(*right.condition).source;
    });
    // Neighbouring images go to the same part, so that few parts need the same scene.
    const std::size_t count = wanted.size();
    const auto shards = static_cast<std::size_t>(selection.shards);
    const auto shard = static_cast<std::size_t>(selection.shard);
    const std::size_t first = count * (shard - 1) / shards;
    const std::size_t last = count * shard / shards;
    return {wanted.begin() + static_cast<std::ptrdiff_t>(first),
            wanted.begin() + static_cast<std::ptrdiff_t>(last)};
}

/// Every image that some manifest in the folder calls finished and whose bytes are as it says.
std::map<std::string, ManifestImage> finished_images(const fs::path& folder) {
    std::map<std::string, ManifestImage> finished;
    if (!fs::is_directory(folder)) return finished;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!name.starts_with("manifest") || !name.ends_with(".json")) continue;
        Manifest manifest;
        try {
            manifest = load_manifest(entry.path());
        } catch (const base::Error&) {
            continue;  // what it listed is made again, and the list with it
        }
        for (const ManifestImage& image : manifest.images) {
            const fs::path file = folder / image.file;
            if (fs::is_regular_file(file) &&
                base::sha256_hex(base::read_file(file)) == image.sha256) {
                finished.insert_or_assign(image.file, image);
            }
        }
    }
    return finished;
}

/// The finished images of the study whose inputs are today's, in the study's order.
Manifest manifest_of(const Study& study, const StimulusRenderer& renderer,
                     const std::map<std::string, ManifestImage>& finished) {
    Manifest manifest{study.name, study.seed, renderer::gpu_renderer(), {}};
    for (const Stimulus& stimulus : stimuli_of(study)) {
        const auto found = finished.find(stimulus.file());
        if (found != finished.end() &&
            found->second.inputs_sha256 == renderer.inputs_sha256(stimulus)) {
            manifest.images.push_back(found->second);
        }
    }
    return manifest;
}

std::string title_of(const Stimulus& stimulus) {
    return fmt::format("{} ({})", stimulus.file(), stimulus.choice().variant_name());
}

/// The passes, buffers and omissions of one image.
std::string explanation_of(const Study& study, const Stimulus& stimulus,
                           const renderer::Frame& frame) {
    const renderer::FramePlan& plan = frame.plan();
    const StudyScene& scene = study.scene_of(*stimulus.condition);
    std::string text =
        fmt::format("\n{}: {} over {} ({}, camera {}), {}x{}\n", stimulus.file(),
                    stimulus.choice().variant_name(), scene.source, to_string(scene.validity),
                    scene.camera, plan.width, plan.height);
    double sum_ms = 0.0;
    for (const renderer::PassTime& time : frame.times) {
        text += fmt::format("  pass    {:14} {:9.2f} ms\n", renderer::to_string(time.pass),
                            time.milliseconds);
        sum_ms += time.milliseconds;
    }
    text += fmt::format("  passes  {:14} {:9.2f} ms\n", "in all", sum_ms);
    for (const renderer::PlannedTarget& target : plan.targets) {
        text += fmt::format("  buffer  {:14} {:9} bytes  {} {}x{}{}\n",
                            renderer::to_string(target.target), target.bytes, target.format,
                            target.width, target.height,
                            target.layers > 1 ? fmt::format("x{}", target.layers) : "");
    }
    text += fmt::format("  buffers {:14} {:9} bytes\n", "in all", plan.bytes());
    for (const renderer::LeftOut& left_out : plan.left_out) {
        text += fmt::format("  without {}: {}\n", left_out.what, left_out.why);
    }
    return text;
}

}  // namespace

Generated generate(const Study& study, const Selection& selection, const fs::path& folder,
                   bool quiet, const std::vector<BuiltinScene>& catalogue) {
    const std::vector<Stimulus> wanted = select(study, selection);
    base::require_writable_folder(folder, "--out");
    const renderer::HeadlessContext context;
    StimulusRenderer renderer(study, catalogue);
    std::map<std::string, ManifestImage> finished = finished_images(folder);
    const fs::path list =
        folder / (selection.shards == 1
                      ? std::string("manifest.json")
                      : fmt::format("manifest-{}-of-{}.json", selection.shard, selection.shards));
    Generated generated;
    base::Progress progress("render", wanted.size(), quiet);
    for (const Stimulus& stimulus : wanted) {
        const auto found = finished.find(stimulus.file());
        if (found != finished.end() &&
            found->second.inputs_sha256 == renderer.inputs_sha256(stimulus)) {
            ++generated.kept;
            progress.step(stimulus.file() + " (kept)");
            continue;
        }
        const renderer::Frame frame = renderer.render(stimulus);
        const std::string bytes = encode_png(image_of(frame));
        ManifestImage entry = renderer.describe(stimulus, frame);
        entry.sha256 = base::sha256_hex(bytes);
        base::write_file_atomically(folder / entry.file, bytes);
        finished.insert_or_assign(entry.file, entry);
        save_manifest(list, manifest_of(study, renderer, finished));
        ++generated.made;
        progress.step(title_of(stimulus));
    }
    // Other parts may have finished meanwhile.
    const Manifest all = manifest_of(study, renderer, finished_images(folder));
    generated.complete = all.images.size() == stimuli_of(study).size();
    if (generated.complete || selection.shards == 1) save_manifest(folder / "manifest.json", all);
    return generated;
}

std::vector<std::string> verify(const Study& study, const Selection& selection,
                                const fs::path& folder, bool quiet,
                                const std::vector<BuiltinScene>& catalogue) {
    const std::vector<Stimulus> wanted = select(study, selection);
    const Manifest manifest = load_manifest(folder / "manifest.json");
    const renderer::HeadlessContext context;
    StimulusRenderer renderer(study, catalogue);
    std::vector<std::string> problems;
    base::Progress progress("verify", wanted.size(), quiet);
    for (const Stimulus& stimulus : wanted) {
        const fs::path file = folder / stimulus.file();
        const ManifestImage* entry =
            manifest.find(stimulus.condition->id, std::string(1, stimulus.side));
        if (entry == nullptr) {
            problems.push_back(fmt::format("{}: the manifest does not list it", file.string()));
        } else if (!fs::is_regular_file(file)) {
            problems.push_back(fmt::format("{}: the file is missing", file.string()));
        } else {
            const std::string stored = base::sha256_hex(base::read_file(file));
            const std::string made =
                base::sha256_hex(encode_png(image_of(renderer.render(stimulus))));
            if (stored != entry->sha256) {
                problems.push_back(
                    fmt::format("{}: its SHA-256 is {}, the manifest has {}: the file was changed",
                                file.string(), stored, entry->sha256));
            } else if (made != stored) {
                problems.push_back(fmt::format(
                    "{}: rendered again its SHA-256 is {}, the file has {} (made on \"{}\", now on "
                    "\"{}\")",
                    file.string(), made, stored, manifest.gpu_renderer, renderer::gpu_renderer()));
            }
        }
        progress.step(title_of(stimulus));
    }
    return problems;
}

std::string explain(const Study& study, const Selection& selection, bool quiet,
                    const std::vector<BuiltinScene>& catalogue) {
    const std::vector<Stimulus> wanted = select(study, selection);
    const renderer::HeadlessContext context;
    StimulusRenderer renderer(study, catalogue);
    std::string text = fmt::format("{}\n", renderer::gpu_description());
    base::Progress progress("explain", wanted.size(), quiet);
    for (const Stimulus& stimulus : wanted) {
        { const renderer::Frame warm_up = renderer.render(stimulus); }
        text += explanation_of(study, stimulus, renderer.render(stimulus));
        progress.step(title_of(stimulus));
    }
    return text;
}

}  // namespace obscura::stimuli
