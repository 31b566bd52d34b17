// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "app/explorer/explorer.h"
#include "app/explorer/study_entry.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "stimuli/png.h"

namespace obscura::app::explorer {

std::filesystem::path Explorer::file_for(char side, const char* ending) const {
    const std::string scene = std::filesystem::path(model_.choices().scene.id).filename().string();
    const std::string& camera = model_.view().name;
    const std::string stem = fmt::format("{}-{}-{}-{}", scene, camera.empty() ? "own" : camera,
                                         model_.choices().side(side).variant_name(), side);
    std::filesystem::path file = options_.data / "explore" / (stem + ending);
    // Nothing that was saved before is replaced.
    for (int i = 2; std::filesystem::exists(file); ++i) {
        file = options_.data / "explore" / fmt::format("{}-{}{}", stem, i, ending);
    }
    return file;
}

void Explorer::save_when_ready() {
    if (!waiting_image_ && !waiting_buffers_) return;
    const bool fine = model_.choices().supersampling > 1;
    for (const char side : {'a', 'b'}) {
        const auto image = model_.image(side);
        const bool image_ready = image && image->look == model_.look() &&
                                 image->quality == (fine ? Quality::kFine : Quality::kStill);
        if (waiting_image_ && !image_ready) return;
        if (waiting_buffers_ && !model_.buffers(side)) return;
    }
    try {
        for (const char side : {'a', 'b'}) {
            if (waiting_image_) {
                const Shot& shot = *model_.image(side);
                const auto file = file_for(side, ".png");
                base::write_file_atomically(
                    file, stimuli::encode_png({shot.width, shot.height, shot.rgb}));
                say(fmt::format("Saved {}", file.string()));
            }
            if (waiting_buffers_) {
                const auto file = file_for(side, ".exr");
                base::write_file_atomically(file,
                                            renderer::encode_exr(model_.buffers(side)->buffers));
                say(fmt::format("Saved {}", file.string()));
            }
        }
    } catch (const std::exception& error) {
        say(fmt::format("Not saved: {}", error.what()), true);
    }
    waiting_image_ = false;
    waiting_buffers_ = false;
}

void Explorer::save_to_study() {
    StudyDialog& dialog = state_.study_dialog;
    StudyEntry entry;
    entry.file = dialog.file;
    entry.scene_id = dialog.scene_id;
    if (!dialog.camera_only) entry.condition_id = dialog.condition_id;
    entry.replaces = dialog.replaces;
    entry.takes_changed_file = dialog.takes_changed_file;
    const auto& study = model_.study();
    std::error_code error;
    if (study && std::filesystem::equivalent(study->file, entry.file, error)) {
        entry.known_sha256 = study->text_sha256;
    }
    try {
        const StudyWritten written = write_into_study(model_, entry);
        say(fmt::format("Saved into {}", entry.file.string()));
        for (const std::string& note : written.notes) say(note);
        model_.set_study(open_study(entry.file.string()));
        dialog.problem.clear();
        dialog.done = true;
    } catch (const std::exception& problem) {
        dialog.problem = problem.what();
        say(fmt::format("Not saved: {}", problem.what()), true);
    }
}

void Explorer::end_without_driver() {
    constexpr const char* kWhat = "the graphics driver was reset, and the window with it";
    if (!model_.scene()) throw base::failure("{}", kWhat);
    StudyEntry entry;
    entry.file = options_.data / "explore" / "kept.toml";
    for (int i = 2; std::filesystem::exists(entry.file); ++i) {
        entry.file = options_.data / "explore" / fmt::format("kept-{}.toml", i);
    }
    entry.scene_id = free_scene_id(std::nullopt, model_.choices().scene.id);
    entry.condition_id = free_condition_id(std::nullopt);
    std::string kept;
    try {
        (void)write_into_study(model_, entry);
        kept = fmt::format("camera and pair are kept: `obscura explore {}` goes on with them",
                           entry.file.string());
    } catch (const std::exception& error) {
        kept = fmt::format("camera and pair could not be kept: {}", error.what());
    }
    throw base::failure("{}; {}", kWhat, kept);
}

}  // namespace obscura::app::explorer
