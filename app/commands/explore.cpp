// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <memory>

#include "app/commands/image_size.h"
#include "app/commands/list.h"
#include "app/commands/study_argument.h"
#include "app/explorer/explorer.h"

namespace obscura::app {
namespace {

struct ExploreArguments {
    std::string what;
    std::string size;
    std::string window;
    bool reset = false;
};

std::optional<explorer::WindowSize> size_from(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const ImageSize size = parse_size(text);
    return explorer::WindowSize{size.width, size.height};
}

base::ExitCode explore(const ExploreArguments& arguments, const Globals& globals) {
    explorer::ExploreOptions options;
    options.what = study_named(arguments.what, globals);
    options.data = globals.data;
    options.reset = arguments.reset;
    options.image = size_from(arguments.size);
    options.window = size_from(arguments.window);
    explorer::run_explorer(std::move(options));
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_explore(const Options& command, const Globals& globals) {
    auto arguments = std::make_shared<ExploreArguments>();
    command.add(
        "STUDY-OR-SCENE", arguments->what,
        "Study file or built-in study; or built-in scene, or a file that ends in .gltf, .glb "
        "or .obj (default: what was open last, or the atrium)");
    command
        .add("--size", arguments->size,
             "Of the image, in pixels (default: the study's, else 1280x720)")
        .type("WxH");
    command
        .add("--window", arguments->window, "Of the window, in pixels (default: as the last time)")
        .type("WxH");
    command.add_flag("--reset", arguments->reset,
                     "Forget the window, scene and layout of the last time");
    command.footer(
        "Fly with W A S D and the mouse, compare two techniques A and B, move their parameters, "
        "see "
        "image, error and cost change, and save what was found into a study. F1 lists all keys.");
    return [arguments, &globals] { return explore(*arguments, globals); };
}

}  // namespace

Command explore_command() {
    return {"explore", "See, compare and choose: fly, switch techniques, move parameters",
            &attach_explore};
}

}  // namespace obscura::app
