// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

#include "renderer/base/check.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/base/progress.h"
#include "renderer/frame/explain.h"
#include "renderer/gl/context.h"
#include "stimuli/pairs.h"
#include "stimuli/png.h"
#include "stimuli/stimulus.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;

/// The selected images, those of one scene together so that it is built once, and of those the ones
/// of one view, so that their surfaces and light are made once.
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
        const StudyScene& a = study.scene_of(*left.condition);
        const StudyScene& b = study.scene_of(*right.condition);
        // Last, what asks for the fewest buffers: it takes them over from the images before.
        const bool few = left.choice().technique == "none";
        const bool other_few = right.choice().technique == "none";
        return std::tie(a.source, a.settings.scale, a.id, few) <
               std::tie(b.source, b.settings.scale, b.id, other_few);
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

/// manifest.json, or the list of a part, manifest-K-of-N.json; nothing else that may lie there.
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
bool is_manifest(const std::string& name) {
    return name == "manifest.json" || is_part_manifest(name);
}

/// A finished image, and whether this program would make it from the same inputs today.
struct Finished {
    ManifestImage image;
    bool current = false;
};
using FinishedImages = std::map<std::string, Finished>;  ///< by file

/// Every image that some manifest in the folder calls finished, whose bytes are as it says and
/// which shows what the study asks. Where several do, a current one wins.
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

/// Throws bad input where the folder holds the images of a study of another name: their list would
/// be lost.
void refuse_another_study(const Study& study, const fs::path& folder) {
    const fs::path file = folder / "manifest.json";
    if (!fs::exists(file)) return;
    std::string other;
    try {
        other = load_manifest(file).study;
    } catch (const base::Error&) {
        return;  // a damaged list is made again
    }
    if (other != study.name) {
        throw base::bad_input(
            "--out: {} holds the images of the study {}, not of {}; name another "
            "folder",
            folder.string(), other, study.name);
    }
}

/// The finished images in the study's order.
Manifest manifest_of(const Study& study, const FinishedImages& finished) {
    Manifest manifest{study.name, study.seed, renderer::gpu_renderer(), {}, {}};
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

/// The finished pairs with their differences, and of those that nobody can tell apart why.
std::vector<ManifestPair> pairs_with_reasons(const Study& study, const Manifest& manifest,
                                             const fs::path& folder, StimulusRenderer& renderer) {
    std::vector<ManifestPair> pairs = compared_pairs(study, manifest, folder);
    for (ManifestPair& pair : pairs) {
        const Condition& condition = *study.find_condition(pair.condition);
        if (pair.difference.can_be_seen() || condition.identical || !pair.reason.empty()) continue;
        pair.reason = renderer.reason_of_likeness(condition);
    }
    return pairs;
}

/// The differences that a manifest of the folder knows already.
std::vector<ManifestPair> known_pairs(const fs::path& folder) {
    try {
        return load_manifest(folder / "manifest.json").pairs;
    } catch (const base::Error&) {
        return {};
    }
}

/// The warnings that concern the selected pairs.
std::vector<std::string> warnings_of_selected(const Study& study, const Selection& selection,
                                              const Manifest& manifest,
                                              std::vector<ManifestPair> pairs) {
    std::erase_if(pairs, [&](const ManifestPair& pair) {
        return !selection.pair.empty() && pair.condition != selection.pair;
    });
    std::vector<std::string> warnings = warnings_of(study, pairs);
    Manifest selected = manifest;
    std::erase_if(selected.images, [&](const ManifestImage& image) {
        return !selection.pair.empty() && image.condition != selection.pair;
    });
    for (std::string& claim : disordered_claims(study, selected)) {
        warnings.push_back(std::move(claim));
    }
    return warnings;
}

/// The lists of parts, which manifest.json replaces once it lists everything.
void remove_part_manifests(const fs::path& folder) {
    std::vector<fs::path> parts;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (is_part_manifest(name)) parts.push_back(entry.path());
    }
    std::error_code ignored;
    for (const fs::path& part : parts) fs::remove(part, ignored);
}

std::string title_of(const Stimulus& stimulus) {
    return fmt::format("{} ({})", stimulus.file(), stimulus.choice().variant_name());
}

/// Nothing can be seen in it: a scene as bright as its background, or a camera that misses it.
bool is_of_one_colour(const RgbImage& image) {
    for (std::size_t i = 3; i < image.rgb.size(); ++i) {
        if (image.rgb[i] != image.rgb[i - 3]) return false;
    }
    return true;
}

/// The passes, buffers and omissions of one image.
std::string explanation_of(const Study& study, const Stimulus& stimulus,
                           const renderer::Frame& frame) {
    const renderer::FramePlan& plan = frame.plan();
    const StudyScene& scene = study.scene_of(*stimulus.condition);
    return fmt::format("\n{}: {} over {} ({}, camera {}), {}x{}\n{}", stimulus.file(),
                       stimulus.choice().variant_name(), scene.source, to_string(scene.validity),
                       scene.camera, plan.image_width, plan.image_height,
                       renderer::explanation_of(frame));
}

/// A line of the table of what leaving out saves.
std::string savings_of(const Stimulus& stimulus, const renderer::Frame& planned,
                       const renderer::Frame& everything) {
    constexpr double kMega = 1e6;
    return fmt::format("{:14} {:10.1f} {:10.1f} {:10.1f} {:10.1f}\n", stimulus.file(),
                       planned.milliseconds(), everything.milliseconds(),
                       static_cast<double>(planned.plan().bytes()) / kMega,
                       static_cast<double>(everything.plan().bytes()) / kMega);
}

}  // namespace

Generated generate(const Study& study, const Selection& selection, const fs::path& folder,
                   bool quiet, const std::vector<BuiltinScene>& catalogue) {
    const std::vector<Stimulus> wanted = select(study, selection);
    base::require_writable_folder(folder, "--out");
    refuse_another_study(study, folder);
    const renderer::HeadlessContext context;
    StimulusRenderer renderer(study, catalogue);
    FinishedImages finished = finished_images(study, renderer, folder);
    const fs::path list =
        folder / (selection.shards == 1
                      ? std::string("manifest.json")
                      : fmt::format("manifest-{}-of-{}.json", selection.shard, selection.shards));
    Generated generated;
    PairsInTheMaking made;
    base::Progress progress("render", wanted.size(), quiet);
    for (const Stimulus& stimulus : wanted) {
        if (selection.buffers) {
            base::write_file_atomically((folder / stimulus.file()).replace_extension(".exr"),
                                        renderer::encode_exr(renderer.render_buffers(stimulus)));
        }
        if (is_current(finished, stimulus.file())) {
            ++generated.kept;
            progress.step(stimulus.file() + " (kept)");
            continue;
        }
        const renderer::Frame frame = renderer.render_next(stimulus);
        RgbImage image = image_of(frame);
        if (is_of_one_colour(image)) {
            base::log::warn("warning: {}: the whole image has one colour", stimulus.file());
        }
        const std::string bytes = encode_png(image);
        ManifestImage entry = renderer.describe(stimulus, frame);
        entry.sha256 = base::sha256_hex(bytes);
        const Brightness brightness = brightness_of(image);
        entry.mean_luminance = brightness.mean;
        entry.contrast = brightness.contrast;
        entry.accuracy = renderer.accuracy(stimulus, frame);
        base::write_file_atomically(folder / entry.file, bytes);
        made.add(entry, std::move(image));
        finished.insert_or_assign(entry.file, Finished{entry, true});
        save_manifest(list, manifest_of(study, finished));
        ++generated.made;
        progress.step(title_of(stimulus));
    }
    // Other parts may have finished meanwhile.
    finished = finished_images(study, renderer, folder);
    const std::vector<Stimulus> all = stimuli_of(study);
    generated.complete = std::all_of(all.begin(), all.end(), [&](const Stimulus& stimulus) {
        return is_current(finished, stimulus.file());
    });
    Manifest manifest = manifest_of(study, finished);
    const std::vector<ManifestPair> known = known_pairs(folder);
    manifest.pairs = known;
    manifest.pairs.insert(manifest.pairs.end(), made.pairs().begin(), made.pairs().end());
    manifest.pairs = pairs_with_reasons(study, manifest, folder, renderer);
    generated.warnings = warnings_of_selected(study, selection, manifest, manifest.pairs);
    const bool up_to_date = generated.made == 0 && known == manifest.pairs &&
                            problems_of_stimuli(study, folder).empty();
    if (!up_to_date && (generated.complete || selection.shards == 1)) {
        save_manifest(folder / "manifest.json", manifest);
    }
    if (generated.complete) remove_part_manifests(folder);
    return generated;
}

Verified verify(const Study& study, const Selection& selection, const fs::path& folder, bool quiet,
                const std::vector<BuiltinScene>& catalogue) {
    const std::vector<Stimulus> wanted = select(study, selection);
    const Manifest manifest = load_manifest(folder / "manifest.json");
    const renderer::HeadlessContext context;
    StimulusRenderer renderer(study, catalogue);
    Verified verified;
    std::vector<std::string>& problems = verified.problems;
    if (manifest.study != study.name || manifest.seed != study.seed) {
        problems.push_back(fmt::format("{}: it is of the study {} with seed {}, not of {} with {}",
                                       (folder / "manifest.json").string(), manifest.study,
                                       manifest.seed, study.name, study.seed));
    }
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
            if (!shows_what_is_asked(study, *entry)) {
                problems.push_back(fmt::format(
                    "{}: the manifest's entry is not of what the study asks for", file.string()));
            } else if (stored != entry->sha256) {
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
        ++verified.checked;
        progress.step(title_of(stimulus));
    }
    verified.warnings = warnings_of_selected(study, selection, manifest,
                                             pairs_with_reasons(study, manifest, folder, renderer));
    return verified;
}

std::string explain(const Study& study, const Selection& selection, bool quiet,
                    const std::vector<BuiltinScene>& catalogue) {
    const std::vector<Stimulus> wanted = select(study, selection);
    const renderer::HeadlessContext context;
    StimulusRenderer renderer(study, catalogue);
    std::string text = fmt::format("{}\n", renderer::gpu_description());
    std::string savings =
        fmt::format("\n{:14} {:>10} {:>10} {:>10} {:>10}\n", "", "ms", "ms, all", "MB", "MB, all");
    base::Progress progress("explain", wanted.size(), quiet);
    for (const Stimulus& stimulus : wanted) {
        for (int warm_up = 0; warm_up < 3; ++warm_up) {
            (void)renderer.render(stimulus);
            (void)renderer.render_everything(stimulus);
        }
        const renderer::Frame frame = renderer.render(stimulus);
        text += explanation_of(study, stimulus, frame);
        savings += savings_of(stimulus, frame, renderer.render_everything(stimulus));
        progress.step(title_of(stimulus));
    }
    return text + savings;
}

}  // namespace obscura::stimuli
