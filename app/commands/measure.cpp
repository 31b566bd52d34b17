// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <memory>

#include "app/commands/image_size.h"
#include "app/commands/list.h"
#include "app/commands/study_argument.h"
#include "app/measure/experiment.h"
#include "app/measure/measure.h"
#include "app/measure/sweep_views.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/base/own_folder.h"
#include "renderer/denoise/denoise.h"
#include "renderer/technique/technique.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;

struct MeasureOptions {
    MeasureRequest request;
    std::string size;
    bool lists_experiments = false;
};

base::ExitCode run(MeasureOptions options, const Globals& globals) {
    MeasureRequest& request = options.request;
    request.quiet = globals.quiet;
    request.study = study_named(request.study, globals);
    if (options.lists_experiments) {
        fmt::print("{}", experiments_text());
        return base::ExitCode::kDone;
    }
    if (!options.size.empty()) {
        const ImageSize size = parse_size(options.size);
        request.width = size.width;
        request.height = size.height;
    }
    if (request.out.empty()) request.out = globals.data / "reports" / "measure";
    request.cache = globals.data / "cache" / "reference";
    request.kept_views = globals.data / "cache" / "measure";
    if (!request.study.empty() && !request.scenes.empty()) {
        throw base::bad_input("--scene measures scenes without a study: leave out {}",
                              request.study);
    }
    base::require_writable_folder(request.out, "--out");
    if (!fs::exists(request.out / "measure.html")) {
        base::require_own_folder(request.out, "--out", [](const std::string&) { return false; });
    }
    if (!request.write_study.empty()) {
        const fs::path parent = request.write_study.parent_path();
        base::require_writable_folder(parent.empty() ? fs::path(".") : parent, "--write-study");
    }
    const Measured measured = measure(request);
    for (const std::string& note : measured.notes) base::log::warn("{}", note);
    fmt::print("{}", analysis::report_text(measured.report));
    const std::vector<fs::path> written = analysis::write_report(measured.report, request.out);
    if (!measured.fitted_study.empty()) {
        base::write_file_atomically(request.write_study, measured.fitted_study);
        base::log::info("{}: the study with fitted values", request.write_study.string());
    }
    base::log::info("{}: {} files; look at {}", request.out.string(), written.size(),
                    written.back().string());
    if (measured.interrupted) {
        throw base::failure("{}; what they gave is in {}, {}", measured.notes.back(),
                            request.out.string(), kGoesOn);
    }
    const std::size_t unexplained = analysis::count_of(measured.report.hard_cases).no;
    if (unexplained > 0) {
        throw base::check_failed("{} hard case{} without a reason; they are in {}", unexplained,
                                 unexplained == 1 ? " fails" : "s fail",
                                 (request.out / "hard-cases.csv").string());
    }
    return base::ExitCode::kDone;
}

template <typename List>
std::string names_of(const List& list) {
    std::vector<std::string> names;
    for (const auto& item : list) names.push_back(item.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

std::function<base::ExitCode()> attach_measure(const Options& app, const Globals& globals) {
    const auto options = std::make_shared<MeasureOptions>();
    MeasureRequest& request = options->request;
    add_study(app, request.study);
    app.add("--scene", request.scenes,
            "Scenes in place of a study: built-in ones, or files that end in .gltf, .glb or .obj; "
            "each by all of its cameras")
        .type("SCENE");
    app.add("--scale", request.scale, "Metres of one unit of the file (1e-6 to 1e6)")
        .shows_default();
    app.add("--camera", request.cameras, "Only views by these cameras (default: all)")
        .type("NAME")
        .comma_separated();
    app.add("--technique", request.techniques,
            "Of " + names_of(renderer::techniques()) +
                " (default: all that compute accessibility, but for the reference)")
        .comma_separated();
    app.add("--samples", request.samples,
            "Samples, or rays, a pixel: one number or several (default: 8,16,24,32,64 and what the "
            "papers use)")
        .comma_separated();
    app.add("--set", request.settings,
            "A parameter or option of every technique that has it, see obscura ao --help; several "
            "with commas or blanks between, or --set again")
        .type("KEY=VALUE")
        .comma_separated();
    app.add(
        "--radius", request.radius_m,
        "How far every technique that has a radius looks, and the reference, in metres (default: "
        "the study's)");
    app.add("--denoise", request.filters,
            "Of " + names_of(renderer::denoise_filters()) +
                " (default: separable, and a technique's own)")
        .comma_separated();
    app.add("--size", options->size,
            fmt::format("Of the images, in pixels (default: {}x{})", kUsualSize.width,
                        kUsualSize.height))
        .type("WxH");
    app.add("--rays", request.rays,
            fmt::format("Rays a pixel of the ray-traced reference (default: {})", kUsualSize.rays));
    app.add("--runs", request.runs,
            fmt::format("Timed runs of each setting, after {} that are thrown away (default: {})",
                        kDiscardedRuns, kUsualSize.runs));
    app.add_flag(
        "--quick", request.quick,
        fmt::format("{}x{}, {} rays, {} runs, one filter, 8, 24 and 64 samples, each where "
                    "no other is asked for",
                    kQuickSize.width, kQuickSize.height, kQuickSize.rays, kQuickSize.runs));
    app.add_flag(
        "--fit", request.fit,
        "Also with the parameters that bring each technique nearest to the reference, found on "
        "other cameras");
    app.add("--write-study", request.write_study,
            "With --fit: write a copy of the study with the fitted values, checked, and with "
            "its files named from where it is written");
    app.add_flag("--growth", request.growth,
                 "Instead: how the time of each technique grows with pixels and samples");
    app.add_flag("--hard-cases", request.hard_cases,
                 "Instead: numerical stability on hard cases, and every technique against its own "
                 "definition (exit code 3 where one fails without a reason)");
    app.add("--experiment", request.experiment,
            "Instead: a paper's experiment, and what its outcome says of the paper's conclusion; "
            "front: all techniques in one table and chart");
    app.add_flag("--experiments", options->lists_experiments,
                 "Instead: list the papers' experiments");
    app.add("--out", request.out, "Folder of the results (default: DATA/reports/measure)").folder();
    return [options, &globals] { return run(*options, globals); };
}

}  // namespace

Command measure_command() {
    return {"measure", "Measure speed against error, and numerical stability", attach_measure};
}

}  // namespace obscura::app
