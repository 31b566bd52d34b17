// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/exported_study.h"

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "stimuli/manifest.h"
#include "stimuli/view_names.h"

namespace obscura::app {

analysis::ExportedStudy exported_study(const stimuli::StudySource& source,
                                       const stimuli::Study& study,
                                       const std::filesystem::path& images) {
    analysis::ExportedStudy exported = exported_study(study.name, images);
    exported.title = study.title;
    exported.question = study.question;
    exported.instructions = study.instructions;
    exported.file_text = source.text;
    exported.sha256 = study.sha256;
    const auto names = stimuli::view_names(study);
    for (const stimuli::StudyScene& scene : study.scenes) {
        exported.views[scene.id] = {scene.source, scene.camera, names.at(scene.id)};
    }
    return exported;
}

analysis::ExportedStudy exported_study(const std::string& name,
                                       const std::filesystem::path& images) {
    analysis::ExportedStudy exported;
    exported.name = name;
    exported.image_folder = images;
    const std::filesystem::path file = images / "manifest.json";
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) return exported;
    const stimuli::Manifest manifest = stimuli::load_manifest(file);
    if (manifest.study != name) {
        throw base::bad_input("{}: it is of the study {}, not of {}", file.string(), manifest.study,
                              name);
    }
    exported.manifest_text = base::read_file(file);
    for (const stimuli::ManifestImage& image : manifest.images) {
        if (std::filesystem::is_regular_file(images / image.file, ignored)) {
            exported.images.push_back({image.condition, image.side == "a" ? 'A' : 'B', image.file,
                                       image.sha256, image.source, image.camera});
        }
    }
    return exported;
}

}  // namespace obscura::app
