// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/own_folder.h"
#include "renderer/base/progress.h"
#include "renderer/gl/context.h"
#include "stimuli/finishing.h"
#include "stimuli/pairs.h"
#include "stimuli/png.h"
#include "stimuli/stimulus.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;

/// Throws bad input where the folder holds the images of a study of another name, whose list would
/// be lost, or files that are no study's.
void refuse_another_study(const Study& study, const fs::path& folder) {
    const fs::path file = folder / "manifest.json";
    if (!fs::exists(file)) {
        std::set<std::string> own;
        for (const Stimulus& stimulus : stimuli_of(study)) {
            own.insert(stimulus.file());
            own.insert(fs::path(stimulus.file()).replace_extension(".exr").string());
        }
        return base::require_own_folder(folder, "--out", [&](const std::string& name) {
            return own.contains(name) || is_part_manifest(name);
        });
    }
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

/// The pairs that were selected.
std::vector<ManifestPair> of_selected(const Selection& selection, std::vector<ManifestPair> pairs) {
    std::erase_if(pairs, [&](const ManifestPair& pair) {
        return !selection.condition.empty() && pair.condition != selection.condition;
    });
    return pairs;
}

/// The warnings that concern the selected pairs.
std::vector<std::string> warnings_of_selected(const Study& study, const Selection& selection,
                                              const Manifest& manifest,
                                              const std::vector<ManifestPair>& pairs) {
    std::vector<std::string> warnings = warnings_of(study, of_selected(selection, pairs));
    Manifest selected = manifest;
    std::erase_if(selected.images, [&](const ManifestImage& image) {
        return !selection.condition.empty() && image.condition != selection.condition;
    });
    for (std::string& claim : disordered_claims(study, selected)) {
        warnings.push_back(std::move(claim));
    }
    return warnings;
}

/// Whether it is another driver that rendered it otherwise, or another image, and how far apart.
std::string difference_in_words(const fs::path& file, const std::string& stored_bytes,
                                const RgbImage& again, const Manifest& manifest) {
    const ImageDifference difference =
        difference_of(decode_png(stored_bytes, file.string()), again);
    const std::string now = renderer::gpu_renderer();
    const std::string why =
        manifest.gpu_renderer == now
            ? fmt::format("made on this GPU by {}: the program or its driver has changed",
                          manifest.program.empty() ? "another version" : manifest.program)
            : fmt::format("made on another GPU, \"{}\", this one is \"{}\"", manifest.gpu_renderer,
                          now);
    return fmt::format(
        "{}: rendered again {:.3g} % of its pixels differ, {:.3g} % visibly, the most by {:.3g} in "
        "CIELAB; {}",
        file.string(), 100.0 * difference.differing, 100.0 * difference.over_threshold,
        difference.largest_delta_e, why);
}

}  // namespace

Generated generate(const Study& study, const Selection& selection, const fs::path& folder,
                   bool quiet, const std::vector<BuiltinScene>& catalogue) {
    const std::vector<Stimulus> wanted = selected(study, selection);
    base::require_writable_folder(folder, "--out");
    refuse_another_study(study, folder);
    const renderer::HeadlessContext context;
    fs::create_directories(folder);
    StimulusRenderer renderer(study, catalogue);
    FinishedImages finished = finished_images(study, renderer, folder);
    const fs::path list =
        folder / (selection.shards == 1
                      ? std::string("manifest.json")
                      : fmt::format("manifest-{}-of-{}.json", selection.shard, selection.shards));
    Twins twins;
    add_twins(finished, folder, twins);
    if (fs::is_directory(selection.known)) {
        add_twins(finished_images(study, renderer, selection.known), selection.known, twins);
    }
    Generated generated;
    std::set<std::string> kept;
    std::set<std::string> drawn;  // the inputs of images that are finished, or will be
    for (const Stimulus& stimulus : wanted) {
        if (is_current(finished, stimulus.file())) kept.insert(stimulus.file());
    }
    for (const auto& [inputs, twin] : twins) drawn.insert(inputs);
    base::Progress progress("render", wanted.size(), quiet);
    Finishing finishing(study, folder, list, finished, twins, progress);
    for (const Stimulus& stimulus : wanted) {
        if (selection.buffers) {
            base::write_file_atomically((folder / stimulus.file()).replace_extension(".exr"),
                                        renderer::encode_exr(renderer.render_buffers(stimulus)));
        }
        if (kept.contains(stimulus.file())) {
            finishing.keep(stimulus);
            ++generated.kept;
            continue;
        }
        ++generated.made;
        const std::string inputs = renderer.inputs_sha256(stimulus);
        if (!drawn.insert(inputs).second) {
            finishing.copy(stimulus, inputs);
            ++generated.copied;
            continue;
        }
        const renderer::Frame frame = renderer.render_next(stimulus);
        ManifestImage entry = renderer.describe(stimulus, frame);
        entry.accuracy = renderer.accuracy(stimulus, frame);
        finishing.begin(stimulus, std::move(entry), image_of(frame));
    }
    const std::vector<ManifestPair> made = finishing.end();
    // Other parts may have finished meanwhile.
    finished = finished_images(study, renderer, folder);
    const std::vector<Stimulus> all = stimuli_of(study);
    generated.complete = std::all_of(all.begin(), all.end(), [&](const Stimulus& stimulus) {
        return is_current(finished, stimulus.file());
    });
    Manifest manifest = manifest_of(study, finished, renderer::gpu_renderer());
    const std::vector<ManifestPair> known = known_pairs(folder);
    manifest.pairs = known;
    manifest.pairs.insert(manifest.pairs.end(), made.begin(), made.end());
    manifest.pairs = pairs_with_reasons(study, manifest, folder, renderer);
    generated.pairs = of_selected(selection, manifest.pairs);
    generated.warnings = warnings_of_selected(study, selection, manifest, generated.pairs);
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
    const std::vector<Stimulus> wanted = selected(study, selection);
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
            const std::string stored_bytes = base::read_file(file);
            const std::string stored = base::sha256_hex(stored_bytes);
            const RgbImage again = image_of(renderer.render(stimulus));
            const std::string made = base::sha256_hex(encode_png(again));
            if (!shows_what_is_asked(study, *entry)) {
                problems.push_back(fmt::format(
                    "{}: the manifest's entry is not of what the study asks for", file.string()));
            } else if (stored != entry->sha256) {
                problems.push_back(
                    fmt::format("{}: its SHA-256 is {}, the manifest has {}: the file was changed",
                                file.string(), stored, entry->sha256));
            } else if (made != stored) {
                problems.push_back(difference_in_words(file, stored_bytes, again, manifest));
            }
        }
        ++verified.checked;
        progress.step(title_of(stimulus));
    }
    verified.warnings = warnings_of_selected(study, selection, manifest,
                                             pairs_with_reasons(study, manifest, folder, renderer));
    return verified;
}

}  // namespace obscura::stimuli
