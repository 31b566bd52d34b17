// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "renderer/base/progress.h"
#include "renderer/frame/explain.h"
#include "renderer/frame/steps_by.h"
#include "renderer/gl/context.h"

namespace obscura::stimuli {
namespace {

using Json = nlohmann::ordered_json;

// A graphics card's clock goes up with work, so that its first frames say little.
constexpr int kDiscardedOnCard = 3;
// Runs end early where they take so long that their number says less than the wait costs.
constexpr double kEnough_ms = 300.0;
constexpr int kMostTimed = 4;
constexpr int kLeastTimed = 2;

/// What the numbers are, before them.
std::string how_measured() {
    std::string text =
        fmt::format("{}; techniques and filters as {}\n", renderer::gpu_description(),
                    in_words(renderer::steps_by_device()));
    if (renderer::is_software_renderer()) {
        text += "A software renderer: these times say nothing of a graphics card's.\n";
    }
    return text + fmt::format(
                      "Milliseconds are of the middle one of up to {} runs, after those that "
                      "compile shaders. Surfaces,\nshadow maps and light, which images of one view "
                      "share, are measured once a view; equal images are one.\n",
                      kMostTimed);
}

/// A frame that was drawn several times, with the passes' times of the middle run.
struct Timed {
    renderer::Frame frame;
    std::vector<double> runs_ms;  ///< rising; of the passes that were not taken over
};

/// Of the images of one view: what they share, and the image that it was measured with.
struct KnownView {
    std::string scene = {};
    std::string file = {};
    std::vector<double> runs_ms = {};  ///< of that image with all that the others share
    renderer::ViewBuffers planned = {};
    renderer::ViewBuffers everything = {};
};

/// An image, or several that are the same, as planned, the sums of its passes that no other image
/// of the view shares (ms, rising), and the same with nothing left out.
struct Explained {
    const std::vector<Stimulus>& images;
    const KnownView& view;
    renderer::Frame planned;
    std::vector<double> own_runs_ms;
    renderer::Frame everything;

    [[nodiscard]] const Stimulus& first() const { return images.front(); }
    [[nodiscard]] bool is_first_of_view() const { return first().file() == view.file; }
    /// The image that its shared passes were measured with, where that is another one.
    [[nodiscard]] std::string known_from() const { return is_first_of_view() ? "" : view.file; }
    [[nodiscard]] std::string files() const {
        std::string files;
        for (const Stimulus& one : images) files += (files.empty() ? "" : ", ") + one.file();
        return files;
    }
};

/// In the order of the first of each: images of equal inputs are one.
std::vector<std::vector<Stimulus>> equal_ones_together(const std::vector<Stimulus>& wanted,
                                                       const StimulusRenderer& renderer) {
    std::vector<std::vector<Stimulus>> together;
    std::map<std::string, std::size_t> known;
    for (const Stimulus& stimulus : wanted) {
        const auto [entry, is_new] =
            known.emplace(renderer.inputs_sha256(stimulus), together.size());
        if (is_new) together.emplace_back();
        together[entry->second].push_back(stimulus);
    }
    return together;
}

/// Renders the image until the time of what is not known yet is.
Timed timed(StimulusRenderer& renderer, const Stimulus& stimulus,
            const renderer::ViewBuffers& known, int least) {
    std::vector<std::pair<double, std::vector<renderer::PassTime>>> runs;
    for (double spent_ms = 0.0;;) {
        renderer::Frame frame = renderer.render(stimulus, known);
        double own_ms = frame.milliseconds();
        for (const renderer::PassTime& time : frame.taken_over()) own_ms -= time.milliseconds;
        spent_ms += own_ms;
        runs.emplace_back(own_ms, frame.times);
        const int count = static_cast<int>(runs.size());
        if (count < least || (count < kMostTimed && spent_ms < kEnough_ms)) continue;
        std::sort(runs.begin(), runs.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        frame.times = runs[(runs.size() - 1) / 2].second;
        std::vector<double> runs_ms;
        for (const auto& [ms, times] : runs) runs_ms.push_back(ms);
        return {std::move(frame), std::move(runs_ms)};
    }
}

/// What the image's view shares, by rendering all of the image.
KnownView measure_view(StimulusRenderer& renderer, const Stimulus& stimulus) {
    const Timed all = timed(renderer, stimulus, {}, 1);
    return {stimulus.condition->scene, stimulus.file(), all.runs_ms, all.frame.view_buffers()};
}

void each_explained(const Study& study, const Selection& selection, bool quiet,
                    const std::vector<BuiltinScene>& catalogue,
                    const std::function<void(const Explained&)>& act) {
    StimulusRenderer renderer(study, catalogue);
    const auto distinct = equal_ones_together(selected(study, selection), renderer);
    base::Progress progress("explain", distinct.size(), quiet);
    KnownView view;
    for (const std::vector<Stimulus>& images : distinct) {
        const Stimulus& stimulus = images.front();
        renderer.compile(stimulus);
        const int discarded = renderer::is_software_renderer() ? 0 : kDiscardedOnCard;
        for (int run = 0; run < discarded; ++run) (void)renderer.render(stimulus);
        if (view.scene != stimulus.condition->scene) view = measure_view(renderer, stimulus);
        Timed own = timed(renderer, stimulus, view.planned, kLeastTimed);
        renderer::Frame everything = renderer.render_everything(stimulus, view.everything);
        if (view.file == stimulus.file()) view.everything = everything.view_buffers();
        act({images, view, std::move(own.frame), std::move(own.runs_ms), std::move(everything)});
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

/// A line of how far apart the runs are.
std::string spread_of(const char* what, const std::vector<double>& runs_ms) {
    if (runs_ms.size() == 1) {
        return fmt::format("  runs    {:14} {:9.2f} ms in one run\n", what, runs_ms.front());
    }
    return fmt::format("  runs    {:14} {:9.2f} to {:.2f} ms in {} runs\n", what, runs_ms.front(),
                       runs_ms.back(), runs_ms.size());
}

/// How sure the times are, and why the technique costs what it does.
std::string reasons_of(const Explained& one) {
    const renderer::Variant& choice = one.first().choice();
    const int fetches = renderer::fetches_per_pixel(choice);
    std::string text = one.is_first_of_view() ? spread_of("in all", one.view.runs_ms) : "";
    text += spread_of("not shared", one.own_runs_ms);
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
    const StudyScene& scene = study.scene_of(*one.first().condition);
    return fmt::format("\n{}: {} over {} ({}, camera {}), {}x{}\n{}{}", one.files(),
                       one.first().choice().variant_name(), scene.source, to_string(scene.validity),
                       scene.camera, plan.image_width, plan.image_height,
                       renderer::explanation_of(one.planned, one.known_from()), reasons_of(one));
}

/// A line of the table of what leaving out saves.
std::string savings_of(const Explained& one) {
    constexpr double kMega = 1e6;
    return fmt::format("{:10.1f} {:10.1f} {:10.1f} {:10.1f}  {}\n", one.planned.milliseconds(),
                       one.everything.milliseconds(),
                       static_cast<double>(one.planned.plan().bytes()) / kMega,
                       static_cast<double>(one.everything.plan().bytes()) / kMega, one.files());
}

Json json_of_explained(const Study& study, const Explained& one) {
    const renderer::FramePlan& plan = one.planned.plan();
    Json passes = Json::array();
    for (const renderer::PassTime& time : renderer::by_name(one.planned.times)) {
        passes.push_back({{"name", time.name}, {"ms", time.milliseconds}});
        if (renderer::is_taken_over(one.planned, time.phase)) {
            passes.back()["measured_with"] = one.view.file;
        }
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
    Json files = Json::array();
    for (const Stimulus& image : one.images) files.push_back(image.file());
    return {{"file", one.first().file()},
            {"files", files},
            {"variant", one.first().choice().variant_name()},
            {"scene", study.scene_of(*one.first().condition).id},
            {"device", renderer::gpu_description()},
            {"software_renderer", renderer::is_software_renderer()},
            {"passes", passes},
            {"buffers", buffers},
            {"left_out", left_out},
            {"fetches_per_px", renderer::fetches_per_pixel(one.first().choice())},
            {"ms", one.planned.milliseconds()},
            {"own_runs_ms", one.own_runs_ms},
            {"view_runs_ms", one.view.runs_ms},
            {"bytes", plan.bytes()},
            {"everything_ms", one.everything.milliseconds()},
            {"everything_bytes", one.everything.plan().bytes()}};
}

}  // namespace

std::string explain(const Study& study, const Selection& selection, bool quiet,
                    const std::vector<BuiltinScene>& catalogue) {
    const renderer::HeadlessContext context;
    std::string text = how_measured();
    std::string savings = fmt::format(
        "\nAs planned, and \"all\" with nothing left out (one run):\n"
        "{:>10} {:>10} {:>10} {:>10}\n",
        "ms", "ms, all", "MB", "MB, all");
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
