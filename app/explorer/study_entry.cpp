// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/study_entry.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "app/explorer/flight.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "stimuli/starter_study.h"
#include "stimuli/study_writer.h"

namespace obscura::app::explorer {
namespace {

namespace fs = std::filesystem;

[[nodiscard]] const stimuli::StudyScene* find_scene(const stimuli::Study& study,
                                                    const std::string& id) {
    const auto found = std::find_if(study.scenes.begin(), study.scenes.end(),
                                    [&](const auto& scene) { return scene.id == id; });
    return found != study.scenes.end() ? &*found : nullptr;
}

/// Whether both show the same of the same scene in the same light.
[[nodiscard]] bool show_the_same(stimuli::StudyScene one, stimuli::StudyScene other) {
    const auto& first = one.settings.camera;
    const auto& second = other.settings.camera;
    if (first.has_value() != second.has_value()) return false;
    if (first ? !same_view(*first, *second) : one.camera != other.camera) return false;
    one.settings.camera.reset();
    other.settings.camera.reset();
    return one.source == other.source && one.validity == other.validity &&
           stimuli::to_json(one.settings) == stimuli::to_json(other.settings);
}

void require_writable(const fs::path& file) {
    std::error_code error;
    if (!fs::exists(file, error)) return;
    if (!fs::is_regular_file(file, error)) {
        throw base::bad_input("{} is no file; allowed is a study file (.toml)", file.string());
    }
    constexpr auto kAnybody =
        fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
    const bool read_only = (fs::status(file, error).permissions() & kAnybody) == fs::perms::none;
    if (read_only || ::access(file.c_str(), W_OK) != 0) {
        throw base::bad_input(
            "{} is read-only; allowed is a file that may be written, or a new one", file.string());
    }
}

/// What there is of the parsed text, or nothing: an unfinished study has no conditions yet.
[[nodiscard]] std::optional<stimuli::Study> parsed(const std::string& text, const fs::path& file) {
    try {
        return stimuli::parse_study(text, file.string(), file.parent_path(),
                                    stimuli::SceneFiles::kTrusted);
    } catch (const base::Error&) {
        return std::nullopt;
    }
}

void require_same(const Model& model, const StudyEntry& entry, const stimuli::StudyScene& wanted,
                  const stimuli::Study& written) {
    const stimuli::StudyScene* scene = find_scene(written, entry.scene_id);
    if (scene == nullptr || !show_the_same(*scene, wanted)) {
        throw base::failure("{}: scene \"{}\" would not show what is seen; nothing is written",
                            entry.file.string(), entry.scene_id);
    }
    if (entry.condition_id.empty()) return;
    const stimuli::Condition* condition = written.find_condition(entry.condition_id);
    const Choices& choices = model.choices();
    if (condition == nullptr || condition->a != choices.a || condition->b != choices.b ||
        condition->scene != entry.scene_id) {
        throw base::failure(
            "{}: condition \"{}\" would not be the pair that is seen; nothing is "
            "written",
            entry.file.string(), entry.condition_id);
    }
}

}  // namespace

stimuli::StudyScene scene_of(const Model& model, const StudyEntry& entry) {
    const Choices& choices = model.choices();
    stimuli::StudyScene scene = choices.scene;
    scene.id = entry.scene_id;
    const fs::path folder = entry.file.parent_path();
    if (stimuli::is_file_source(scene.source)) {
        scene.source = stimuli::path_from(folder, choices.folder / scene.source);
        // A bare name would be taken for a built-in scene's.
        if (!stimuli::is_file_source(scene.source)) scene.source = "./" + scene.source;
    }
    if (!scene.settings.environment.empty()) {
        scene.settings.environment =
            stimuli::path_from(folder, choices.folder / scene.settings.environment);
    }
    const Visit& view = model.view();
    scene.camera = view.name.empty() ? std::string(stimuli::kStudyCamera) : view.name;
    scene.settings.camera.reset();
    if (view.name.empty()) {
        const renderer::Camera& camera = view.camera;
        if (camera.lens_shift != glm::vec2(0.0F)) {
            throw base::bad_input(
                "a study file has no words for a camera with a lens shift; allowed are the scene's "
                "own cameras and views that were flown to");
        }
        scene.settings.camera = camera;
    }
    return scene;
}

std::string study_with(const Model& model, const StudyEntry& entry, const std::string& text) {
    const std::string name = entry.file.string();
    const stimuli::StudyScene scene = scene_of(model, entry);
    const std::optional<stimuli::Study> before = parsed(text, entry.file);
    std::string changed = text;
    const stimuli::StudyScene* there = before ? find_scene(*before, entry.scene_id) : nullptr;
    if (there != nullptr && !show_the_same(*there, scene)) {
        throw base::bad_input(
            "{}: there is a scene \"{}\" that shows something else; allowed is an id that no scene "
            "has",
            name, entry.scene_id);
    }
    if (there == nullptr) changed = stimuli::with_scene(changed, scene);
    if (!entry.condition_id.empty()) {
        stimuli::Condition condition;
        condition.id = entry.condition_id;
        condition.scene = entry.scene_id;
        condition.a = model.choices().a;
        condition.b = model.choices().b;
        const bool exists = before && before->find_condition(entry.condition_id) != nullptr;
        if (exists && !entry.replaces) {
            throw base::bad_input(
                "{}: there is a condition \"{}\"; allowed is an id that no condition has, or to "
                "replace its pair",
                name, entry.condition_id);
        }
        changed = exists ? stimuli::with_sides(changed, name, entry.condition_id, condition.a,
                                               condition.b)
                         : stimuli::with_condition(changed, condition);
    }
    const stimuli::Study written =
        stimuli::parse_study(changed, name, entry.file.parent_path(), stimuli::SceneFiles::kOpened);
    require_same(model, entry, scene, written);
    return changed;
}

StudyWritten write_into_study(const Model& model, const StudyEntry& entry) {
    StudyEntry real = entry;
    if (entry.file.extension() != ".toml") {
        throw base::bad_input("\"{}\" does not end in .toml, as a study file does",
                              entry.file.string());
    }
    std::error_code error;
    real.file = fs::weakly_canonical(fs::absolute(entry.file), error);
    require_writable(real.file);
    const Choices& choices = model.choices();
    const bool exists = fs::exists(real.file, error);
    const std::string text = exists ? base::read_file(real.file)
                                    : stimuli::beginning_of({.name = real.file.stem().string(),
                                                             .width = choices.width,
                                                             .height = choices.height,
                                                             .supersampling = choices.supersampling,
                                                             .one_pair = true});
    const bool seen =
        !exists || (entry.known_sha256 && *entry.known_sha256 == base::sha256_hex(text));
    if (!seen && !entry.takes_changed_file) {
        throw base::bad_input(
            "{} {}; allowed is to take it as it is now, or another file", entry.file.string(),
            entry.known_sha256 ? "has changed on disk since it was read" : "is there already");
    }
    // What the study names is looked for from its folder, which has to be there.
    fs::create_directories(real.file.parent_path(), error);
    const std::string changed = study_with(model, real, text);
    const fs::perms mode = exists ? fs::status(real.file).permissions() : fs::perms::unknown;
    // Once more, as shortly before as can be.
    if (exists && base::read_file(real.file) != text) {
        throw base::bad_input("{} has changed on disk just now; nothing is written",
                              entry.file.string());
    }
    try {
        base::write_file_atomically(real.file, changed);
    } catch (const base::Error& refused) {
        throw base::failure(
            "{}; nothing is changed, and allowed is a folder that may be written and has room",
            refused.what());
    }
    if (mode != fs::perms::unknown) fs::permissions(real.file, mode, error);
    StudyWritten written;
    written.text_sha256 = base::sha256_hex(changed);
    if (const auto study = parsed(changed, real.file)) {
        const bool same = study->width == choices.width && study->height == choices.height &&
                          study->supersampling == choices.supersampling;
        if (!same) {
            written.notes.push_back(
                fmt::format("The study's images are {}x{} with supersampling {}, what is seen is "
                            "{}x{} with {}.",
                            study->width, study->height, study->supersampling, choices.width,
                            choices.height, choices.supersampling));
        }
    }
    return written;
}

std::string free_scene_id(const std::optional<OpenStudy>& study, std::string stem) {
    // As ids are allowed to be: they become file names.
    std::replace_if(
        stem.begin(), stem.end(),
        [](unsigned char c) { return std::isalnum(c) == 0 && c != '-' && c != '_'; }, '-');
    stem = stem.substr(0, 48);
    if (stem.empty() || stem.front() == '-') stem = "view" + stem;
    for (int i = 1;; ++i) {
        std::string id = fmt::format("{}-{}", stem, i);
        if (!study || find_scene(study->study, id) == nullptr) return id;
    }
}

std::string free_condition_id(const std::optional<OpenStudy>& study) {
    for (int i = 1;; ++i) {
        std::string id = fmt::format("pair-{}", i);
        if (!study || study->study.find_condition(id) == nullptr) return id;
    }
}

}  // namespace obscura::app::explorer
