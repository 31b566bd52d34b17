// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <signal.h>

#include <atomic>
#include <cstring>
#include <memory>
#include <optional>

#include "app/commands/closed_forms_table.h"
#include "app/commands/image_size.h"
#include "app/commands/list.h"
#include "app/commands/variant_arguments.h"
#include "app/commands/variants_help.h"
#include "renderer/base/check.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/base/progress.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "renderer/reference/exr.h"
#include "renderer/technique/reference.h"
#include "stimuli/scenes/scene_source.h"

namespace obscura::app {
namespace {

using renderer::FloatImage;
using renderer::Variant;

struct AoOptions {
    std::string scene;
    std::string camera;
    std::string validity;
    VariantArguments variant;
    std::string size = "1280x720";
    std::string out;
    bool closed_forms = false;
};

/// What one run is to make.
struct Wanted {
    const stimuli::SceneSource& source;
    const renderer::Scene& scene;
    const renderer::Camera& camera;
    stimuli::Validity validity;
    const Variant& choice;
    int width;
    int height;
};

std::atomic<bool> g_interrupted = false;  // set by a signal handler, which has no other way

/// While it lives, the first Ctrl-C asks the work to stop; the second ends the program.
class StopOnInterrupt {
  public:
    StopOnInterrupt() {
        struct sigaction action = {};
        action.sa_handler = [](int) { g_interrupted = true; };
        action.sa_flags = SA_RESETHAND;
        ::sigaction(SIGINT, &action, &before_);
    }
    ~StopOnInterrupt() { ::sigaction(SIGINT, &before_, nullptr); }
    StopOnInterrupt(const StopOnInterrupt&) = delete;
    StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

  private:
    struct sigaction before_ = {};
};

void require_writable_file(const std::filesystem::path& file) {
    if (file.extension() != ".exr") {
        throw base::bad_input("--out: \"{}\" does not end in .exr", file.string());
    }
    if (std::filesystem::is_directory(file)) {
        throw base::bad_input("--out: {} is a directory", file.string());
    }
    base::require_writable_folder(file.has_parent_path() ? file.parent_path() : ".", "--out");
}

renderer::ReferenceImage traced(const renderer::Scene& scene, const renderer::Camera& camera,
                                int width, int height, const Variant& choice,
                                const Globals& globals) {
    const StopOnInterrupt stop;
    base::Progress progress("trace", 100, globals.quiet);
    int percent = 0;
    const auto tell = [&](double share) {
        for (; percent < static_cast<int>(100.0 * share); ++percent) progress.step("%");
        return !g_interrupted;
    };
    return renderer::cached_reference(globals.data / "cache" / "reference",
                                      renderer::ReferenceScene(scene), camera, width, height,
                                      renderer::reference_options(choice), tell);
}

/// By the passes of a frame, as an image of a study has it.
std::vector<float> rendered(const Wanted& wanted, const Globals& globals) {
    const renderer::HeadlessContext context;
    const renderer::GpuScene gpu(wanted.scene);
    const renderer::Lighting lighting = wanted.source.lighting(wanted.validity);
    const auto trace = [&](const renderer::Camera& camera, int width, int height,
                           const Variant& choice) {
        return traced(wanted.scene, camera, width, height, choice, globals).accessibility;
    };
    std::optional<renderer::ReferenceScene> made;
    const auto rays = [&]() -> const renderer::ReferenceScene& {
        if (!made) made.emplace(wanted.scene);
        return *made;
    };
    renderer::Renderer renderer;
    return renderer
        .render({gpu, lighting, wanted.camera, {}, trace, rays}, wanted.choice, wanted.width,
                wanted.height)
        .read_accessibility();
}

std::array<float, 16> flat(const glm::mat4& matrix) {
    std::array<float, 16> values{};
    std::memcpy(values.data(), &matrix[0][0], sizeof values);
    return values;
}

/// Says of the image what it is of.
void describe(const Wanted& wanted, FloatImage& image) {
    const Variant& choice = wanted.choice;
    image.texts = {{"obscura:scene", wanted.source.id},
                   {"obscura:camera", wanted.camera.name},
                   {"obscura:validity", std::string(to_string(wanted.validity))},
                   {"obscura:technique", choice.technique},
                   {"obscura:samples", std::to_string(choice.samples)},
                   {"obscura:denoise", choice.denoise}};
    for (const auto& [name, value] : choice.all_parameters()) {
        image.texts["obscura:" + name] = fmt::format("{}", value);
    }
    for (const renderer::VariantOption& option : renderer::variant_options()) {
        const std::string& value = choice.*option.value;
        if (value != option.standard()) image.texts["obscura:" + option.name] = value;
    }
    const renderer::CameraMatrices matrices =
        renderer::matrices_of(wanted.camera, wanted.width, wanted.height);
    image.matrices = {{"obscura:view", flat(matrices.view_from_world)},
                      {"obscura:projection", flat(matrices.clip_from_view)}};
}

base::ExitCode ao(const AoOptions& options, const Globals& globals) {
    if (options.closed_forms) {
        print_closed_forms(options.variant.samples.value_or(4096), 1);
        return base::ExitCode::kDone;
    }
    for (const auto& [name, value] : {std::pair("--scene", &options.scene),
                                      {"--technique", &options.variant.technique},
                                      {"--out", &options.out}}) {
        if (value->empty()) throw base::bad_input("{} is missing", name);
    }
    FloatImage image;
    const ImageSize size = parse_size(options.size);
    image.width = size.width;
    image.height = size.height;

    const Variant choice = variant_from(options.variant);
    if (renderer::find_technique(choice.technique)->output == renderer::Output::kColour) {
        throw base::bad_input("--technique: {} makes colour and no accessibility",
                              choice.technique);
    }
    require_writable_file(options.out);
    const stimuli::SceneSource source = stimuli::find_scene_source(options.scene);
    for (const std::string& note : source.notes) base::log::warn("{}: {}", source.source, note);
    const std::string camera = source.camera_for(options.camera);
    const stimuli::Validity validity = source.level_for(options.validity);
    const renderer::Scene scene = source.build();
    const Wanted wanted{source,      scene,       *scene.find_camera(camera), validity, choice,
                        image.width, image.height};
    describe(wanted, image);
    const bool as_traced =
        renderer::find_technique(choice.technique)->is_truth() && choice.denoise == "none";
    if (as_traced) {
        renderer::ReferenceImage truth =
            traced(scene, wanted.camera, image.width, image.height, choice, globals);
        image.channels = {{"ao.Y", std::move(truth.accessibility)},
                          {"ao.stderr", std::move(truth.standard_error)}};
    } else {
        image.channels = {{"ao.Y", rendered(wanted, globals)}};
    }
    base::write_file_atomically(options.out, renderer::encode_exr(image));
    base::log::info("{}: accessibility by {} of scene {} from camera {}, {}x{}", options.out,
                    choice.variant_name(), source.id, wanted.camera.name, image.width,
                    image.height);
    return base::ExitCode::kDone;
}

}  // namespace

Command ao_command() {
    return {"ao", "One accessibility buffer by any technique, the ray-traced reference included",
            [](const Options& app, const Globals& globals) -> std::function<base::ExitCode()> {
                const auto options = std::make_shared<AoOptions>();
                app.add("--scene", options->scene,
                        "Built-in scene, or a file that ends in .gltf, .glb or .obj");
                app.add("--camera", options->camera, "Its camera (default: the first)");
                app.add("--validity", options->validity,
                        "low, moderate or high: the level of the scene's light (default: "
                        "its first)");
                add_variant_options(app, options->variant);
                app.add("--size", options->size, "WxH in pixels").shows_default();
                app.add("--out", options->out,
                        "OpenEXR file: channel ao.Y, of the unfiltered reference also "
                        "ao.stderr, its standard error");
                app.add_flag("--closed-forms", options->closed_forms,
                             "Instead: hold the reference against every scene whose accessibility "
                             "is known, and print the table (exit code 3 if one does not hold)");
                app.footer(variants_help());
                return [options, &globals] { return ao(*options, globals); };
            }};
}

}  // namespace obscura::app
