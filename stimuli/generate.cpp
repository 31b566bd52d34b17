// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/generate.h"

#include <fmt/format.h>

#include <algorithm>
#include <future>
#include <map>
#include <set>
#include <string_view>

#include "renderer/base/check.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/base/own_folder.h"
#include "renderer/base/progress.h"
#include "renderer/base/version.h"
#include "renderer/gl/context.h"
#include "stimuli/pairs.h"
#include "stimuli/png.h"
#include "stimuli/stimulus.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;

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

/// The finished images in the study's order.
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

/// An image that is finished already, wherever: another one of the same inputs is not rendered.
struct Twin {
    fs::path file;
    ManifestImage image;
};
using Twins = std::map<std::string, Twin>;  ///< by the hash of their inputs

void add_twins(const FinishedImages& finished, const fs::path& folder, Twins& twins) {
    for (const auto& [file, one] : finished) {
        if (one.current) twins.try_emplace(one.image.inputs_sha256, Twin{folder / file, one.image});
    }
}

/// What the manifest says of an image that is the copy of another.
ManifestImage as_copy(const Study& study, const Stimulus& stimulus, ManifestImage image) {
    image.file = stimulus.file();
    image.condition = stimulus.condition->id;
    image.side = std::string(1, stimulus.side);
    image.scene = study.scene_of(*stimulus.condition).id;
    return image;
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
    const std::string gpu = renderer::gpu_renderer();
    Twins twins;
    add_twins(finished, folder, twins);
    if (fs::is_directory(selection.known)) {
        add_twins(finished_images(study, renderer, selection.known), selection.known, twins);
    }
    Generated generated;
    PairsInTheMaking made;
    base::Progress progress("render", wanted.size(), quiet);
    const auto finish = [&](const Stimulus& stimulus, const ManifestImage& entry, RgbImage image,
                            const std::string& bytes, const std::string& told) {
        if (is_of_one_colour(image)) {
            base::log::warn("warning: {}: the whole image has one colour", stimulus.file());
        }
        base::write_file_atomically(folder / entry.file, bytes);
        made.add(entry, std::move(image));
        finished.insert_or_assign(entry.file, Finished{entry, true});
        twins.try_emplace(entry.inputs_sha256, Twin{folder / entry.file, entry});
        save_manifest(list, manifest_of(study, finished, gpu));
        ++generated.made;
        progress.step(told);
    };
    // An image is compressed, written and compared while the next one is drawn. What `finish` uses
    // is left alone until it is done.
    std::future<void> last;
    const auto await_last = [&last] {
        if (last.valid()) last.get();
    };
    std::set<std::string> drawn;  // the inputs of images that are finished, or will be
    for (const auto& [inputs, twin] : twins) drawn.insert(inputs);
    std::set<std::string> kept;
    for (const Stimulus& stimulus : wanted) {
        if (is_current(finished, stimulus.file())) kept.insert(stimulus.file());
    }
    for (const Stimulus& stimulus : wanted) {
        if (selection.buffers) {
            base::write_file_atomically((folder / stimulus.file()).replace_extension(".exr"),
                                        renderer::encode_exr(renderer.render_buffers(stimulus)));
        }
        if (kept.contains(stimulus.file())) {
            await_last();
            ++generated.kept;
            progress.step(stimulus.file() + " (kept)");
            continue;
        }
        const std::string inputs = renderer.inputs_sha256(stimulus);
        if (drawn.contains(inputs)) {
            await_last();
            const Twin& twin = twins.at(inputs);
            const std::string bytes = base::read_file(twin.file);
            finish(stimulus, as_copy(study, stimulus, twin.image),
                   decode_png(bytes, twin.file.string()), bytes, stimulus.file() + " (copied)");
            ++generated.copied;
            continue;
        }
        const renderer::Frame frame = renderer.render_next(stimulus);
        ManifestImage entry = renderer.describe(stimulus, frame);
        entry.accuracy = renderer.accuracy(stimulus, frame);
        RgbImage image = image_of(frame);
        drawn.insert(inputs);
        await_last();
        last = std::async(std::launch::async, [&finish, &stimulus, entry = std::move(entry),
                                               image = std::move(image)]() mutable {
            const std::string bytes = encode_png(image);
            entry.sha256 = base::sha256_hex(bytes);
            const Brightness brightness = brightness_of(image);
            entry.mean_luminance = brightness.mean;
            entry.contrast = brightness.contrast;
            finish(stimulus, entry, std::move(image), bytes, title_of(stimulus));
        });
    }
    await_last();
    // Other parts may have finished meanwhile.
    finished = finished_images(study, renderer, folder);
    const std::vector<Stimulus> all = stimuli_of(study);
    generated.complete = std::all_of(all.begin(), all.end(), [&](const Stimulus& stimulus) {
        return is_current(finished, stimulus.file());
    });
    Manifest manifest = manifest_of(study, finished, gpu);
    const std::vector<ManifestPair> known = known_pairs(folder);
    manifest.pairs = known;
    manifest.pairs.insert(manifest.pairs.end(), made.pairs().begin(), made.pairs().end());
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
