// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/hard_cases/hard_case.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/base/check.h"
#include "renderer/hard_cases/bench.h"

namespace obscura::renderer {
namespace {

std::vector<const Technique*> chosen_techniques(const HardCaseOptions& options) {
    for (const std::string& name : options.techniques) {
        if (find_technique(name) == nullptr) {
            throw base::bad_input("hard cases: \"{}\" is no technique", name);
        }
    }
    std::vector<const Technique*> chosen;
    for (const Technique& technique : techniques()) {
        const bool asked = options.techniques.empty() ||
                           std::find(options.techniques.begin(), options.techniques.end(),
                                     technique.name) != options.techniques.end();
        if (asked && technique.makes_accessibility()) chosen.push_back(&technique);
    }
    return chosen;
}

std::vector<HardCase> chosen_cases(const HardCaseOptions& options) {
    std::vector<HardCase> chosen;
    for (const HardCase& hard_case : hard_cases()) {
        const bool asked =
            options.cases.empty() || std::find(options.cases.begin(), options.cases.end(),
                                               hard_case.number) != options.cases.end();
        if (asked) chosen.push_back(hard_case);
    }
    return chosen;
}

}  // namespace

const std::vector<HardCase>& hard_cases() {
    static const std::vector<HardCase> list = {
        planes_case(),    separated_cube_case(), thin_occluder_case(), border_case(),
        close_up_case(),  not_a_number_case(),   rotations_case(),     background_case(),
        units_case(),     projections_case(),    denoise_case(),       quantisation_case(),
        odd_sizes_case(), degenerate_case(),
    };
    return list;
}

std::size_t hard_case_steps(const HardCaseOptions& options) {
    const std::size_t techniques = chosen_techniques(options).size();
    std::size_t steps = 0;
    for (const HardCase& hard_case : chosen_cases(options)) {
        steps += hard_case.run_once != nullptr ? 1 : techniques;
    }
    return steps;
}

std::vector<HardCaseResult> run_hard_cases(const HardCaseOptions& options) {
    base::check_range("hard cases", "size", options.size_px, 32, 1024);
    base::check_range("hard cases", "vectors", options.vectors, 1, 10'000'000);
    const std::vector<const Technique*> chosen = chosen_techniques(options);
    std::vector<HardCaseResult> rows;
    Bench bench(options, rows);
    for (const HardCase& hard_case : chosen_cases(options)) {
        const bool once = hard_case.run_once != nullptr;
        for (const Technique* technique : once ? std::vector<const Technique*>{nullptr} : chosen) {
            bench.run(hard_case, technique);
            if (options.progress) {
                options.progress(fmt::format("{} {}", hard_case.title,
                                             technique != nullptr ? technique->name : "all"));
            }
        }
    }
    return rows;
}

}  // namespace obscura::renderer
