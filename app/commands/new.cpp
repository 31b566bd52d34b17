// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "app/commands/list.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/starter_study.h"
#include "stimuli/study_reader.h"

namespace obscura::app {
namespace {

struct NewOptions {
    std::string name;
    std::vector<std::string> scenes;
};

base::ExitCode make(const NewOptions& options) {
    if (options.name.find('/') != std::string::npos || options.name.ends_with(".toml")) {
        throw base::bad_input(
            "NAME: \"{}\" is no name of a study; the file NAME.toml is written into this folder",
            options.name);
    }
    if (const std::string wrong = stimuli::problem_of_id(options.name); !wrong.empty()) {
        throw base::bad_input("NAME: {}", wrong);
    }
    const std::filesystem::path file = options.name + ".toml";
    if (std::filesystem::exists(file)) {
        throw base::bad_input("{} is there already, and is left as it is", file.string());
    }
    const std::vector<std::string> scenes =
        options.scenes.empty() ? std::vector<std::string>{"atrium"} : options.scenes;
    const std::string text = stimuli::starter_study(options.name, scenes);
    const stimuli::StudyReading read = stimuli::read_study(text, stimuli::builtin_scenes(), {});
    if (!read.problems.empty()) {
        throw base::bad_input("{}: no study can be made of that:\n{}", options.name,
                              stimuli::to_lines(read.problems, file.string()));
    }
    base::write_file_atomically(file, text);
    base::log::info("{}: {} pairs over {}; next: obscura check {}", file.string(),
                    read.study.conditions.size(), fmt::join(scenes, ", "), file.string());
    return base::ExitCode::kDone;
}

}  // namespace

Command new_command() {
    return {
        "new", "Write a commented study file that runs at once, to start from",
        [](const Options& app, const Globals&) -> std::function<base::ExitCode()> {
            const auto options = std::make_shared<NewOptions>();
            app.add("NAME", options->name, "Of the study; NAME.toml is written here").required();
            app.add("--scene", options->scenes,
                    "Built-in scene, or a file that ends in .gltf, .glb or .obj; repeatable "
                    "(default: atrium)")
                .type("SCENE")
                .repeatable();
            return [options] { return make(*options); };
        }};
}

}  // namespace obscura::app
