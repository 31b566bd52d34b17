// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "renderer/base/progress.h"
#include "renderer/frame/explain.h"
#include "renderer/gl/context.h"

namespace obscura::stimuli {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDiscarded = 3;  // the first compiles shaders
constexpr int kTimed = 4;

/// An image as planned, the times of its runs, and the same with nothing left out.
struct Explained {
    const Stimulus& stimulus;
    renderer::Frame planned;
    std::vector<double> runs_ms;  ///< rising
    renderer::Frame everything;
};

void each_explained(const Study& study, const Selection& selection, bool quiet,
                    const std::vector<BuiltinScene>& catalogue,
                    const std::function<void(const Explained&)>& act) {
    const std::vector<Stimulus> wanted = selected(study, selection);
    StimulusRenderer renderer(study, catalogue);
    base::Progress progress("explain", wanted.size(), quiet);
    for (const Stimulus& stimulus : wanted) {
        for (int warm_up = 0; warm_up < kDiscarded; ++warm_up) {
            (void)renderer.render(stimulus);
            (void)renderer.render_everything(stimulus);
        }
        std::vector<double> runs_ms;
        for (int run = 1; run < kTimed; ++run) {
            runs_ms.push_back(renderer.render(stimulus).milliseconds());
        }
        renderer::Frame planned = renderer.render(stimulus);
        runs_ms.push_back(planned.milliseconds());
        std::sort(runs_ms.begin(), runs_ms.end());
        act({stimulus, std::move(planned), runs_ms, renderer.render_everything(stimulus)});
        progress.step(stimulus.file());
    }
}

/// The same technique with twice the samples, where it takes them.
std::optional<renderer::Variant> doubled(const renderer::Variant& variant) {
    renderer::Variant more = variant;
    more.samples *= 2;
    if (more.samples == 0 || !renderer::problems_of(more).empty()) return std::nullopt;
    return more;
}

/// Why the technique costs what it does.
std::string reasons_of(const Explained& one) {
    const renderer::Variant& choice = one.stimulus.choice();
    const int fetches = renderer::fetches_per_pixel(choice);
    std::string text = fmt::format("  runs    {:14} {:9.2f} to {:.2f} ms in {} runs\n", "in all",
                                   one.runs_ms.front(), one.runs_ms.back(), one.runs_ms.size());
    if (fetches == 0) return text;
    text += fmt::format("  reads   {:14} {:9} texels a pixel at most", "", fetches);
    if (const auto more = doubled(choice)) {
        text +=
            fmt::format(", {} with {} samples", renderer::fetches_per_pixel(*more), more->samples);
    }
    return text + "; in proportion to the pixels; a larger radius reads as many, further apart\n";
}

/// The passes, buffers and omissions of one image.
std::string explanation_of_image(const Study& study, const Explained& one) {
    const renderer::FramePlan& plan = one.planned.plan();
    const StudyScene& scene = study.scene_of(*one.stimulus.condition);
    return fmt::format("\n{}: {} over {} ({}, camera {}), {}x{}\n{}{}", one.stimulus.file(),
                       one.stimulus.choice().variant_name(), scene.source,
                       to_string(scene.validity), scene.camera, plan.image_width, plan.image_height,
                       renderer::explanation_of(one.planned), reasons_of(one));
}

/// A line of the table of what leaving out saves.
std::string savings_of(const Explained& one) {
    constexpr double kMega = 1e6;
    return fmt::format(
        "{:10.1f} {:10.1f} {:10.1f} {:10.1f}  {}\n", one.planned.milliseconds(),
        one.everything.milliseconds(), static_cast<double>(one.planned.plan().bytes()) / kMega,
        static_cast<double>(one.everything.plan().bytes()) / kMega, one.stimulus.file());
}

Json json_of_explained(const Study& study, const Explained& one) {
    const renderer::FramePlan& plan = one.planned.plan();
    Json passes = Json::array();
    for (const renderer::PassTime& time : renderer::by_name(one.planned.times)) {
        passes.push_back({{"name", time.name}, {"ms", time.milliseconds}});
    }
    Json buffers = Json::array();
    for (const renderer::PlannedTarget& target : plan.targets) {
        buffers.push_back({{"name", target.name},
                           {"format", target.format},
                           {"width", target.width},
                           {"height", target.height},
                           {"layers", target.layers},
                           {"levels", target.levels},
                           {"bytes", target.bytes}});
    }
    Json left_out = Json::array();
    for (const renderer::LeftOut& what : plan.left_out) {
        left_out.push_back({{"what", what.what}, {"why", what.why}});
    }
    return {{"file", one.stimulus.file()},
            {"variant", one.stimulus.choice().variant_name()},
            {"scene", study.scene_of(*one.stimulus.condition).id},
            {"device", renderer::gpu_description()},
            {"software_renderer", renderer::is_software_renderer()},
            {"passes", passes},
            {"buffers", buffers},
            {"left_out", left_out},
            {"fetches_per_px", renderer::fetches_per_pixel(one.stimulus.choice())},
            {"ms", one.planned.milliseconds()},
            {"runs_ms", one.runs_ms},
            {"bytes", plan.bytes()},
            {"everything_ms", one.everything.milliseconds()},
            {"everything_bytes", one.everything.plan().bytes()}};
}

}  // namespace

std::string explain(const Study& study, const Selection& selection, bool quiet,
                    const std::vector<BuiltinScene>& catalogue) {
    const renderer::HeadlessContext context;
    std::string text = fmt::format("{}\n", renderer::gpu_description());
    if (renderer::is_software_renderer()) {
        text += "A software renderer: these times say nothing of a graphics card's.\n";
    }
    std::string savings =
        fmt::format("\n{:>10} {:>10} {:>10} {:>10}\n", "ms", "ms, all", "MB", "MB, all");
    each_explained(study, selection, quiet, catalogue, [&](const Explained& one) {
        text += explanation_of_image(study, one);
        savings += savings_of(one);
    });
    return text + savings;
}

std::string explain_json(const Study& study, const Selection& selection, bool quiet,
                         const std::vector<BuiltinScene>& catalogue) {
    const renderer::HeadlessContext context;
    Json images = Json::array();
    each_explained(study, selection, quiet, catalogue,
                   [&](const Explained& one) { images.push_back(json_of_explained(study, one)); });
    return images.dump(2) + "\n";
}

}  // namespace obscura::stimuli
