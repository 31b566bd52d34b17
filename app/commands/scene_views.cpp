// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/scene_views.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/commands/image_size.h"
#include "app/commands/scene_argument.h"
#include "app/commands/variant_arguments.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "renderer/technique/reference.h"
#include "stimuli/png.h"
#include "stimuli/scenes/good_views.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/stimulus.h"

namespace obscura::app {
namespace {

using Json = nlohmann::ordered_json;

struct ViewOptions {
    SceneArgument scene;
    CameraArguments cameras;
    std::string out;
    std::string validity;
    std::string technique = "blizzard";
    std::string size = "1280x720";
    int count = 6;
    bool json = false;
};

/// One opened scene on the GPU, of which images are made.
class Painter {
  public:
    explicit Painter(const ViewOptions& options) {
        technique_ = &technique_named(options.technique);
        opened_ = options.scene.open();
        say_notes(opened_);
        // Where nothing is said, light that shows shapes.
        const bool has_moderate = std::find(opened_.levels.begin(), opened_.levels.end(),
                                            stimuli::Validity::kModerate) != opened_.levels.end();
        validity_ =
            opened_.level(options.validity.empty() && has_moderate ? "moderate" : options.validity);
    }

    [[nodiscard]] const stimuli::OpenedScene& opened() const { return opened_; }

    [[nodiscard]] stimuli::RgbImage paint(const renderer::Camera& camera, int width, int height) {
        if (!gpu_) gpu_ = std::make_unique<renderer::GpuScene>(*opened_.scene);
        renderer::Variant variant = renderer::standard_variant(*technique_);
        variant.denoise = renderer::standard_denoise(*technique_);
        if (!technique_->reach.empty()) {
            const renderer::Parameter& reach = *technique_->find_parameter(technique_->reach);
            variant.parameters[reach.name] =
                std::clamp(stimuli::fitting_radius_m(camera), reach.low, reach.high);
        }
        const renderer::Lighting lighting = opened_.lighting(validity_);
        const auto rays = [this]() -> const renderer::ReferenceScene& {
            if (!rays_) rays_ = std::make_unique<renderer::ReferenceScene>(*opened_.scene);
            return *rays_;
        };
        const auto traced = [&](const renderer::Camera& from, int w, int h,
                                const renderer::Variant& choice) {
            return rays().trace(from, w, h, renderer::reference_options(choice)).accessibility;
        };
        return stimuli::image_of(renderer_.render(
            {*gpu_, lighting, camera, {.supersampling = 2}, traced, rays}, variant, width, height));
    }

  private:
    renderer::HeadlessContext context_;
    renderer::Renderer renderer_;
    stimuli::OpenedScene opened_;
    const renderer::Technique* technique_ = nullptr;
    stimuli::Validity validity_ = stimuli::Validity::kLow;
    std::unique_ptr<renderer::GpuScene> gpu_;
    std::unique_ptr<renderer::ReferenceScene> rays_;
};

void require_png(const std::string& file) {
    if (!file.ends_with(".png")) {
        throw base::bad_input("--out: \"{}\" does not end in .png, which is what is written", file);
    }
}

base::ExitCode preview(const ViewOptions& options) {
    require_png(options.out);
    const ImageSize size = parse_size(options.size);
    Painter painter(options);
    const std::vector<renderer::Camera> named = cameras_of(options.cameras, painter.opened());
    if (named.size() > 1) {
        throw base::bad_input("--camera: one is shown, {} are named; scene cameras shows several",
                              named.size());
    }
    const renderer::Camera& camera = named.front();
    base::write_file_atomically(
        options.out, stimuli::encode_png(painter.paint(camera, size.width, size.height)));
    base::log::info("{}: {}x{}, {} within {:g} m", options.out, size.width, size.height,
                    options.technique, stimuli::fitting_radius_m(camera));
    if (options.json) {
        fmt::print("{}\n", Json{{"file", options.out}, {"line", line_of(camera)}}.dump());
    } else {
        fmt::print("{}\n", line_of(camera));
    }
    return base::ExitCode::kDone;
}

/// Images of one size side by side, three in a row.
stimuli::RgbImage sheet_of(const std::vector<stimuli::RgbImage>& images) {
    constexpr int kColumns = 3;
    constexpr int kGap = 4;
    const int width = images.front().width + kGap;
    const int height = images.front().height + kGap;
    const int columns = std::min(kColumns, static_cast<int>(images.size()));
    const int rows = (static_cast<int>(images.size()) + kColumns - 1) / kColumns;
    stimuli::RgbImage sheet{columns * width - kGap, rows * height - kGap, {}};
    sheet.rgb.assign(
        3 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height), 255);
    for (std::size_t i = 0; i < images.size(); ++i) {
        const int left = static_cast<int>(i) % kColumns * width;
        const int top = static_cast<int>(i) / kColumns * height;
        const auto bytes = static_cast<std::ptrdiff_t>(3 * images[i].width);
        for (int y = 0; y < images[i].height; ++y) {
            std::copy_n(images[i].rgb.begin() + y * bytes, bytes,
                        sheet.rgb.begin() +
                            3 * (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left));
        }
    }
    return sheet;
}

void print_views(const std::vector<stimuli::FoundView>& views,
                 const std::vector<renderer::Camera>& own) {
    int number = 0;
    for (const stimuli::FoundView& view : views) {
        fmt::print(
            "# {}: surfaces in {:.0f} % of the image, {:.0f} % of the light around them kept "
            "off, varying by {:.0f} %\n{}\n",
            ++number, 100.0 * view.seen, 100.0 * view.occluded, 100.0 * view.spread,
            line_of(view.camera));
    }
    for (const renderer::Camera& camera : own) {
        fmt::print("# the scene's own\n{}\n", line_of(camera));
    }
}

void print_views_as_json(const std::vector<stimuli::FoundView>& views,
                         const std::vector<renderer::Camera>& own) {
    Json found = Json::array();
    for (const stimuli::FoundView& view : views) {
        found.push_back({{"line", line_of(view.camera)},
                         {"seen", view.seen},
                         {"occluded", view.occluded},
                         {"spread", view.spread}});
    }
    Json names = Json::array();
    for (const renderer::Camera& camera : own) names.push_back(camera.name);
    fmt::print("{}\n", Json{{"found", found}, {"own", names}}.dump(2));
}

base::ExitCode cameras(const ViewOptions& options) {
    if (!options.out.empty()) require_png(options.out);
    Painter painter(options);
    const std::vector<stimuli::FoundView> views =
        stimuli::find_views(*painter.opened().scene, options.count);
    std::vector<stimuli::RgbImage> images;
    for (const stimuli::FoundView& view : views) {
        if (!options.out.empty()) images.push_back(painter.paint(view.camera, 480, 270));
    }
    const std::vector<renderer::Camera>& own = painter.opened().scene->cameras;
    options.json ? print_views_as_json(views, own) : print_views(views, own);
    if (!images.empty()) {
        base::write_file_atomically(options.out, stimuli::encode_png(sheet_of(images)));
        base::log::info("{}: the {} views that were found, from left to right, three in a row",
                        options.out, images.size());
    }
    return base::ExitCode::kDone;
}

void add_view_options(const Options& app, ViewOptions& options) {
    add_scene(app, options.scene);
    add_validity(app, options.validity, "moderate, else the scene's first");
    app.add_flag("--json", options.json, "Print JSON");
    app.add("--technique", options.technique, "Technique of the images").shows_default();
}

}  // namespace

void attach_cameras(const Options& scene, const ChosenAct& chosen) {
    const auto options = std::make_shared<ViewOptions>();
    const Options app = scene.add_command(
        "cameras", "Find good views of a scene, as lines for a study file and as a contact sheet");
    add_view_options(app, *options);
    app.add("--count", options->count, "How many views").between(1, 12).shows_default();
    app.add("--out", options->out, "Contact sheet to write, ends in .png (default: none)")
        .type("FILE");
    app.when_given([chosen, options] { *chosen = [options] { return cameras(*options); }; });
}

void attach_preview(const Options& scene, const ChosenAct& chosen) {
    const auto options = std::make_shared<ViewOptions>();
    const Options app = scene.add_command(
        "preview", "Render one image of a scene, and print its camera's line for a study file");
    add_view_options(app, *options);
    add_cameras(app, options->cameras);
    app.add("--size", options->size, "Of the image, in pixels").type("WxH").shows_default();
    app.add("--out", options->out, "Image to write, ends in .png").type("FILE").required();
    app.when_given([chosen, options] { *chosen = [options] { return preview(*options); }; });
}

}  // namespace obscura::app
