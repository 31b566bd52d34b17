// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/commands/ao_comparison.h"
#include "app/commands/closed_forms_table.h"
#include "app/commands/image_size.h"
#include "app/commands/list.h"
#include "app/commands/scene_argument.h"
#include "app/commands/variant_arguments.h"
#include "app/commands/variants_help.h"
#include "renderer/base/check.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "stimuli/scenes/good_views.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;
using renderer::Camera;
using renderer::FloatImage;
using renderer::Variant;

struct AoOptions {
    SceneArgument scene;
    CameraArguments cameras;
    std::string validity;
    VariantArguments variant;
    std::vector<std::string> techniques;
    std::string size = "1280x720";
    fs::path out;
    std::string against;
    int rays = 256;
    bool json = false;
    bool closed_forms = false;
};

void require_all(const AoOptions& options) {
    for (const auto& [name, missing] :
         {std::pair("--scene", options.scene.scene.empty()),
          {"--technique", options.techniques.empty()},
          {"--out", options.out.empty() && options.against.empty()}}) {
        if (missing) throw base::bad_input("{} is missing", name);
    }
    base::check_range("ao", "--rays", options.rays, 1, renderer::kMostReferenceRays);
}

/// The techniques with the settings that all of them have here.
std::vector<Variant> variants_of(const AoOptions& options) {
    std::vector<Variant> variants;
    for (const std::string& technique : options.techniques) {
        VariantArguments arguments = options.variant;
        arguments.technique = technique;
        // Beside others, what takes no samples is not asked for any.
        const renderer::Technique* found = renderer::find_technique(technique);
        if (options.techniques.size() > 1 && found != nullptr && found->samples.high == 0) {
            arguments.samples.reset();
        }
        variants.push_back(variant_from(arguments));
        if (renderer::find_technique(technique)->output == renderer::Output::kColour) {
            throw base::bad_input("--technique: {} makes colour and no accessibility", technique);
        }
    }
    return variants;
}

/// One buffer goes into a file, several into a folder.
void require_place(const AoOptions& options, bool several) {
    if (options.out.empty()) return;
    if (several) {
        if (options.out.extension() == ".exr") {
            throw base::bad_input("--out: there are several buffers: name a folder, not {}",
                                  options.out.string());
        }
        return base::require_writable_folder(options.out, "--out");
    }
    if (options.out.extension() != ".exr") {
        throw base::bad_input("--out: \"{}\" does not end in .exr", options.out.string());
    }
    if (fs::is_directory(options.out)) {
        throw base::bad_input("--out: {} is a directory", options.out.string());
    }
    base::require_writable_folder(options.out.has_parent_path() ? options.out.parent_path() : ".",
                                  "--out");
}

/// What a buffer's files are called without their ending, unlike any other of the call.
std::string stem_of(const AoOptions& options, bool several, const std::string& scene,
                    const std::string& camera, const Variant& variant) {
    if (!several) return fs::path(options.out).replace_extension().string();
    return (options.out / fmt::format("{}-{}-{}", scene, camera, variant.variant_name())).string();
}

base::ExitCode ao(const AoOptions& options, const Globals& globals) {
    if (options.closed_forms) {
        print_closed_forms(options.variant.samples.value_or(4096), 1);
        return base::ExitCode::kDone;
    }
    require_all(options);
    const ImageSize size = parse_size(options.size);
    const std::vector<Variant> variants = variants_of(options);
    const stimuli::OpenedScene opened = options.scene.open();
    say_notes(opened);
    const std::vector<Camera> cameras = cameras_of(options.cameras, opened);
    const bool several = variants.size() * cameras.size() > 1;
    require_place(options, several);
    const AoTruth truth{options.against == "reference" ? "" : options.against, options.rays,
                        options.variant.radius_m.value_or(stimuli::fitting_radius_m(cameras[0]))};
    AoBuffers buffers(
        opened, opened.level(options.validity),
        {globals.data / "cache" / "reference", size.width, size.height, globals.quiet});
    std::vector<AoComparison> comparisons;
    auto made = nlohmann::ordered_json::array();
    for (const Camera& camera : cameras) {
        const std::string name = camera.name.empty() ? "view" : camera.name;
        for (const Variant& variant : variants) {
            const FloatImage image = buffers.make(camera, variant);
            const std::string stem = stem_of(options, several, opened.id, name, variant);
            if (!options.against.empty()) {
                comparisons.push_back(compare_ao(buffers, camera, variant, image, truth));
            }
            if (options.out.empty()) continue;
            base::write_file_atomically(stem + ".exr", renderer::encode_exr(image));
            base::log::info("{}.exr: accessibility by {} of scene {} from camera {}, {}x{}", stem,
                            variant.variant_name(), opened.id, name, size.width, size.height);
            made.push_back({{"file", stem + ".exr"},
                            {"scene", opened.id},
                            {"camera", name},
                            {"variant", variant.variant_name()}});
            if (comparisons.empty()) continue;
            comparisons.back().files.emplace_back(stem + ".exr");
            write_difference(stem, comparisons.back());
        }
    }
    if (options.json) {
        fmt::print("{}",
                   options.against.empty() ? made.dump(2) + "\n" : comparison_json(comparisons));
    } else if (!comparisons.empty()) {
        fmt::print("{}", comparison_table(comparisons));
    }
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_ao(const Options& app, const Globals& globals) {
    const auto options = std::make_shared<AoOptions>();
    add_scene_option(app, options->scene);
    add_cameras(app, options->cameras);
    add_validity(app, options->validity, "the scene's first");
    app.add("--technique", options->techniques, "One or several, see below").comma_separated();
    add_variant_options(app, options->variant);
    app.add("--size", options->size, "Of the image, in pixels").type("WxH").shows_default();
    app.add("--out", options->out,
            "OpenEXR file to write: channel ao.Y, of the unfiltered reference also ao.stderr, its "
            "standard "
            "error; of several techniques or cameras a folder of such files");
    app.add("--against", options->against,
            "Compare with a file of this command, or with the ray-traced reference: RMSE, bias, "
            "mean absolute error and 99th percentile over surfaces, and beside --out the "
            "difference as EXR and PNG")
        .type("FILE|reference");
    app.add("--rays", options->rays, "Rays a pixel of the ray-traced reference").shows_default();
    app.add_flag("--json", options->json, "Print JSON");
    app.add_flag("--closed-forms", options->closed_forms,
                 "Instead: hold the reference against every scene whose accessibility is known, "
                 "and print the table (exit code 3 if one does not hold)");
    app.footer(variants_help());
    return [options, &globals] { return ao(*options, globals); };
}

}  // namespace

Command ao_command() {
    return {"ao", "Write accessibility buffers by any technique, and find their error", attach_ao};
}

}  // namespace obscura::app
