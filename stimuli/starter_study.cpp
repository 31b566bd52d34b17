// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/starter_study.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "stimuli/scenes/good_views.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/study_text.h"

namespace obscura::stimuli {
namespace {

constexpr std::string_view kHead = R"(# {name}: a study to start from. It runs as it is:
#
#   obscura check {name}.toml       says everything that is wrong with this file
#   obscura render {name}.toml      makes the images
#   obscura rehearse {name}.toml    simulated observers through all of it, to see the analysis
#   obscura run {name}.toml         the kiosk, for people
#   obscura analyze {name}.toml     what they answered
#
# Lines that begin with # are comments. stimuli/README.md of the program lists every key.

[study]
name = {quoted}                      # also the folder of its images
title = "Ambient occlusion and perceived realism"
question = "Which image looked the most realistic?"
instructions = """
You will see pairs of images, one image after the other. For each pair, decide which of the two \
looked more realistic to you. Look at each image as long as you like, then press the space bar.

No answer is right or wrong. If you hesitate, trust your first impression.
"""
resolution = [{width}, {height}]             # pixels, shown one to one
supersampling = {supersampling}                    # samples along each side of a pixel: smooth edges
grey_ms = 2000                       # the grey interval between two images; it cannot be skipped
grey_level = 128                     # sRGB code value of the interval and around the images
{order}
seed = {seed}                      # of every random choice

)";

constexpr std::string_view kTail = R"(
# Shown like any other pair, but everyone who looks can tell: not counted, used to exclude.
[[condition]]
id = "check"
scene = "{scene}"
catch = "a"                          # the side that an attentive observer picks
a = {{ technique = "blizzard", samples = 24, {radius} }}
b = {{ technique = "alchemy", samples = 1, denoise = "none", {speckled} }}

# A pair that comes again: how far people agree with themselves.
[[condition]]
id = "again"
repeats = "{repeated}"

# Whom the analysis leaves out, fixed before there are data.
[exclusion]
min_catch_correct = 1.0              # share of attention checks answered as expected
min_response_time_s = 0.3            # of the median answer
)";

/// A scene at one level, as the file names it.
struct Part {
    std::string id;
    std::string source;
    Validity level = Validity::kLow;
    std::string camera;  ///< the line
    double radius_m = 0.0;
};

/// Blizzard's thresholds in the proportion to its radius that its fit to the truth has.
std::string radius_of(double radius_m) {
    return fmt::format(
        "radius_m = {:.3g}, full_threshold_m = {:.2g}, no_threshold_m = {:.3g}, power = {:.0f}",
        radius_m, 0.06 * radius_m, 2.0 * radius_m, std::min(1e4, 122.5 / (radius_m * radius_m)));
}

/// Black dots wherever anything is occluded: no eye takes them for light, whatever the scene.
std::string speckled_of(double radius_m) {
    return fmt::format("radius_m = {:.3g}, strength = 20, bias = 0", radius_m);
}

std::vector<Part> parts_of(const std::string& source) {
    const OpenedScene opened = open_scene(source);
    const bool has_own = opened.has_own_camera();
    const renderer::Camera camera =
        has_own ? opened.camera() : find_views(*opened.scene, 1).front().camera;
    std::vector<Validity> levels = opened.levels;
    if (levels.size() > 2) levels = {Validity::kModerate, Validity::kHigh};
    std::vector<Part> parts;
    for (const Validity level : levels) {
        parts.push_back({fmt::format("{}-{}", opened.id, to_string(level)), source, level,
                         has_own ? fmt::format("camera = \"{}\"", camera.name) : study_line(camera),
                         fitting_radius_m(camera)});
    }
    return parts;
}

std::string scene_table(const Part& part) {
    return fmt::format(
        "[[scene]]\nid = \"{}\"\nsource = \"{}\"\n{}\nvalidity = \"{}\"\n{}\n", part.id,
        part.source, part.camera, to_string(part.level),
        is_file_source(part.source)
            ? "# licence = \"CC BY 4.0\"              # of its files, for obscura pack\n"
            : "");
}

/// The two pairs of a part.
std::string conditions_of(const Part& part) {
    return fmt::format(
        "[[condition]]\nid = \"{0}-ao\"\nscene = \"{0}\"\nhypothesis = \"H1\"\n"
        "a = {{ technique = \"none\" }}\n"
        "b = {{ technique = \"blizzard\", samples = 24, {1} }}\n\n"
        "[[condition]]\nid = \"{0}-accuracy\"\nscene = \"{0}\"\nhypothesis = \"H2\"\n"
        "a = {{ technique = \"crytek\", samples = 24 }}\n"
        "b = {{ technique = \"blizzard\", samples = 24, {1} }}\n\n",
        part.id, radius_of(part.radius_m));
}

std::string hypothesis(const std::string& id, const std::string& statement,
                       const std::vector<std::string>& conditions) {
    return fmt::format(
        "[[hypothesis]]\nid = \"{}\"\nstatement = \"{}\"\nkind = \"preference\"\n"
        "conditions = [\"{}\"]\nmargin = 0.15                        "
        "# of a share: the smallest effect that matters\n\n",
        id, statement, fmt::join(conditions, "\", \""));
}

std::string hypotheses_of(const std::vector<std::vector<Part>>& scenes) {
    std::vector<std::string> with;
    std::vector<std::string> accurate;
    std::vector<std::string> pairs;
    for (const std::vector<Part>& parts : scenes) {
        for (const Part& part : parts) {
            with.push_back(part.id + "-ao");
            accurate.push_back(part.id + "-accuracy");
        }
        if (parts.size() < 2) continue;
        for (const char* kind : {"-ao", "-accuracy"}) {
            pairs.push_back(
                fmt::format("[\"{}{}\", \"{}{}\"]", parts[0].id, kind, parts[1].id, kind));
        }
    }
    std::string text =
        "# What is tested, fixed before there are data; Holm's correction is over these.\n\n" +
        hypothesis("H1", "Ambient occlusion raises perceived realism.", with) +
        hypothesis("H2", "More accurate ambient occlusion raises it.", accurate);
    if (!pairs.empty()) {
        text += fmt::format(
            "[[hypothesis]]\nid = \"H3\"\nstatement = \"The effect depends on the lighting.\"\n"
            "kind = \"interaction\"                 # the same pair at two levels of light\n"
            "pairs = [{}]\nmargin = 0.15\n",
            fmt::join(pairs, ", "));
    }
    return text;
}

}  // namespace

std::string beginning_of(const StudyBeginning& study) {
    constexpr std::string_view kMany =
        "order = \"williams\"                   # each pair follows each other one equally often\n"
        "sides = \"trial\"                      # which image is first changes within a session";
    constexpr std::string_view kOne =
        "order = \"fixed\"                      # williams or latin-square, once there are two "
        "pairs";
    return fmt::format(
        fmt::runtime(kHead), fmt::arg("name", study.name), fmt::arg("quoted", quoted(study.name)),
        fmt::arg("width", study.width), fmt::arg("height", study.height),
        fmt::arg("supersampling", study.supersampling),
        fmt::arg("order", study.one_pair ? kOne : kMany), fmt::arg("seed", study.seed));
}

std::string starter_study(const std::string& name, const std::vector<std::string>& sources) {
    std::vector<std::vector<Part>> scenes;
    for (const std::string& source : sources) scenes.push_back(parts_of(source));
    const Part& first = scenes.front().front();
    std::string text = beginning_of({.name = name, .seed = 20260000 + sources.size()});
    text +=
        "# A scene at a level of light: low (ambient only), moderate (an environment), high (that "
        "and a\n"
        "# light with shadows). obscura scene cameras SCENE finds other views.\n\n";
    for (const std::vector<Part>& parts : scenes) {
        for (const Part& part : parts) text += scene_table(part);
    }
    text +=
        "# The pairs: two images that differ in their ambient occlusion only. Technique, samples "
        "and\n"
        "# parameters are listed by: obscura render --help. Lengths are in metres.\n\n";
    for (const std::vector<Part>& parts : scenes) {
        for (const Part& part : parts) text += conditions_of(part);
    }
    text += hypotheses_of(scenes);
    text += fmt::format(fmt::runtime(kTail), fmt::arg("scene", first.id),
                        fmt::arg("radius", radius_of(first.radius_m)),
                        fmt::arg("speckled", speckled_of(first.radius_m)),
                        fmt::arg("repeated", first.id + "-ao"));
    return text;
}

}  // namespace obscura::stimuli
