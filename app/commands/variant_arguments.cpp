// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/variant_arguments.h"

#include <set>

#include "renderer/base/error.h"
#include "renderer/technique/technique.h"
#include "renderer/technique/variant_setting.h"

namespace obscura::app {
namespace {

bool has_an_option_of_its_own(const std::string& key) {
    return key == "technique" || key == "samples" || key == "denoise";
}

}  // namespace

void add_variant_options(const Options& app, VariantArguments& arguments) {
    app.add("--samples", arguments.samples, "Samples, or rays, a pixel (default: the technique's)");
    app.add("--set", arguments.settings,
            "A parameter, or an option that every technique has; see below. Several with commas or "
            "blanks between, or --set again")
        .type("KEY=VALUE")
        .comma_separated();
    app.add("--radius", arguments.radius_m,
            "How far a technique that has a radius looks, in metres (default: the technique's)");
    app.add("--preset", arguments.preset,
            "Values of the parameters that are not set: published, or fitted to the reference")
        .one_of(renderer::preset_names())
        .shows_default();
    app.add("--denoise", arguments.denoise, "Filter of the buffer, see below").shows_default();
}

const renderer::Technique& technique_named(const std::string& name) {
    if (const renderer::Technique* const found = renderer::find_technique(name)) return *found;
    renderer::Variant unknown;
    unknown.technique = name;
    throw base::bad_input("--technique: {}", renderer::problems_of(unknown).front().message);
}

renderer::Variant variant_from(const VariantArguments& arguments) {
    renderer::Variant variant;
    variant.technique = arguments.technique;
    variant.denoise = arguments.denoise;
    if (const renderer::Technique* technique = renderer::find_technique(arguments.technique)) {
        variant.samples = arguments.samples.value_or(technique->samples.standard);
    }
    std::set<std::string> seen;
    for (const std::string& setting : arguments.settings) {
        const std::string key = setting.substr(0, setting.find('='));
        if (!renderer::set(variant, setting)) {
            throw base::bad_input("--set: \"{}\" is not KEY=VALUE, such as radius_m=0.5", setting);
        }
        if (!seen.insert(key).second) throw base::bad_input("--set: \"{}\" is set twice", key);
    }
    const renderer::Technique* const found = renderer::find_technique(arguments.technique);
    const bool has_radius = found != nullptr && found->find_parameter("radius_m") != nullptr;
    if (arguments.radius_m && has_radius) {
        variant.parameters.emplace("radius_m", *arguments.radius_m);
    }
    std::string all = renderer::apply_preset(arguments.preset, variant);
    if (!all.empty()) all = "--preset: " + all;
    for (const renderer::VariantProblem& problem : renderer::problems_of(variant)) {
        all += fmt::format("{}{}{}: {}", all.empty() ? "" : "\n",
                           has_an_option_of_its_own(problem.key) ? "--" : "--set ", problem.key,
                           problem.message);
    }
    if (!all.empty()) throw base::bad_input("{}", all);
    return variant;
}

}  // namespace obscura::app
