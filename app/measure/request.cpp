// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/request.h"

#include <fmt/ranges.h>

#include "app/measure/experiment.h"
#include "app/measure/measured_settings.h"
#include "renderer/base/check.h"
#include "renderer/base/error.h"
#include "renderer/denoise/denoise.h"
#include "renderer/reference/reference.h"
#include "renderer/technique/technique.h"
#include "renderer/technique/variant_setting.h"

namespace obscura::app {
namespace {

template <typename List>
std::string names_of(const List& list) {
    std::vector<std::string> names;
    for (const auto& item : list) names.push_back(item.name);
    return fmt::format("{}", fmt::join(names, ", "));
}

void check_samples(const MeasureRequest& request) {
    for (const int samples : request.samples) {
        base::check_range("measure", "--samples", samples, 1, 65536);
        for (const std::string& name : measured_techniques(request)) {
            const renderer::Technique& technique = *renderer::find_technique(name);
            if (technique.samples.high == 0) continue;
            const renderer::Variant variant{.technique = name, .samples = samples};
            for (const renderer::VariantProblem& problem : renderer::problems_of(variant)) {
                if (problem.key == "samples") {
                    throw base::bad_input("--samples: {}", problem.message);
                }
            }
        }
    }
}

/// Each setting is one that a technique has, with a value that all those that have it take.
void check_settings(const MeasureRequest& request) {
    const bool others = request.fit || request.growth || request.hard_cases;
    if (others && (!request.settings.empty() || request.radius_m)) {
        throw base::bad_input("--set and --radius are of the measurement alone: leave out {}",
                              request.fit      ? "--fit"
                              : request.growth ? "--growth"
                                               : "--hard-cases");
    }
    if (request.radius_m) base::check_range("measure", "--radius", *request.radius_m, 1e-6, 1e6);
    for (const std::string& setting : request.settings) {
        const std::string key = setting.substr(0, setting.find('='));
        bool is_one = false;
        for (const std::string& name : measured_techniques(request)) {
            renderer::Variant variant = renderer::standard_variant(*renderer::find_technique(name));
            if (!has_setting(variant, key)) continue;
            is_one = true;
            if (!renderer::set(variant, setting)) {
                throw base::bad_input("--set: \"{}\" is not KEY=VALUE, such as radius_m=0.5",
                                      setting);
            }
            for (const renderer::VariantProblem& problem : renderer::problems_of(variant)) {
                throw base::bad_input("--set {}: {}", problem.key, problem.message);
            }
        }
        if (!is_one) {
            throw base::bad_input("--set: no technique that is measured has a setting \"{}\"", key);
        }
    }
}

/// An experiment says itself what is measured.
void check_experiment(const MeasureRequest& request) {
    if (find_experiment(request.experiment) == nullptr) {
        throw base::bad_input("--experiment: there is no \"{}\", allowed are {}",
                              request.experiment, names_of(experiments()));
    }
    const std::pair<const char*, bool> others[] = {{"--technique", !request.techniques.empty()},
                                                   {"--samples", !request.samples.empty()},
                                                   {"--denoise", !request.filters.empty()},
                                                   {"--set", !request.settings.empty()},
                                                   {"--radius", request.radius_m.has_value()},
                                                   {"--fit", request.fit},
                                                   {"--growth", request.growth},
                                                   {"--hard-cases", request.hard_cases}};
    for (const auto& [option, asked] : others) {
        if (!asked) continue;
        throw base::bad_input("--experiment: {} says itself what is measured: leave out {}",
                              request.experiment, option);
    }
}

}  // namespace

void check_request(const MeasureRequest& request) {
    for (const std::string& name : request.techniques) {
        const renderer::Technique* technique = renderer::find_technique(name);
        if (technique == nullptr) {
            renderer::Variant unknown;
            unknown.technique = name;
            throw base::bad_input("--technique: {}",
                                  renderer::problems_of(unknown).front().message);
        }
        if (const std::string why = why_unmeasured(*technique); !why.empty()) {
            throw base::bad_input("--technique: {} {}", name, why);
        }
    }
    for (const std::string& name : request.filters) {
        if (renderer::find_denoise(name) == nullptr) {
            throw base::bad_input("--denoise: \"{}\" is unknown; allowed are {}", name,
                                  names_of(renderer::denoise_filters()));
        }
    }
    if (!request.experiment.empty()) check_experiment(request);
    check_samples(request);
    check_settings(request);
    if (request.scale != 1.0 && request.scenes.empty()) {
        throw base::bad_input("--scale: it is of the files of --scene; a study says it itself");
    }
    base::check_range("measure", "--size, width", *request.width, 1, 16384);
    base::check_range("measure", "--size, height", *request.height, 1, 16384);
    base::check_range("measure", "--rays", *request.rays, 1, renderer::kMostReferenceRays);
    base::check_range("measure", "--runs", *request.runs, 1, 1000);
    if (request.growth && request.hard_cases) {
        throw base::bad_input(
            "--growth and --hard-cases exclude each other: each stands in place of "
            "the measurement");
    }
    if (request.fit && (request.growth || request.hard_cases)) {
        throw base::bad_input(
            "--fit: there is nothing to fit with {}, which stands in place of the "
            "measurement",
            request.growth ? "--growth" : "--hard-cases");
    }
    if (!request.write_study.empty() && !request.fit) {
        throw base::bad_input("--write-study: there are fitted values only with --fit");
    }
    if (!request.write_study.empty() && !request.scenes.empty()) {
        throw base::bad_input(
            "--write-study: it writes a copy of the study, and --scene measures "
            "scenes without one");
    }
}

}  // namespace obscura::app
