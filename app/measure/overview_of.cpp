// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/overview_of.h"

#include <algorithm>
#include <cmath>

namespace obscura::app {
namespace {

using renderer::Ideal;
using renderer::Technique;

std::string open_planes(const Technique& technique) {
    if (!technique.makes_accessibility()) return "";
    if (!technique.why_not(Ideal::kOpenFacing).empty()) return "none";
    return technique.why_not(Ideal::kOpenTilted).empty() ? "all" : "facing";
}

/// What else it does not have, in the descriptor's words.
std::string fails_of(const Technique& technique) {
    std::string fails;
    for (const Ideal ideal : {Ideal::kWholeScene, Ideal::kAnyImage, Ideal::kAnyFarPlane}) {
        const std::string why = technique.why_not(ideal);
        // One reason may stand for several.
        if (why.empty() || fails.find(why) != std::string::npos) continue;
        fails += (fails.empty() ? "" : "; ") + why;
    }
    return fails;
}

analysis::OverviewRow mean_row(const Experiment::Setting& setting,
                               const std::vector<analysis::MeasurementRow>& rows, std::size_t first,
                               std::size_t every) {
    const Technique& technique = *renderer::find_technique(setting.variant.technique);
    analysis::OverviewRow mean;
    mean.variant = setting.name;
    mean.technique = technique.name;
    mean.values = to_string(setting.values);
    mean.denoise = setting.variant.denoise;
    mean.open_planes = open_planes(technique);
    mean.fails = fails_of(technique);
    mean.fetches_per_px = rows[first].fetches_per_px;
    mean.bytes_per_px = static_cast<double>(rows[first].bytes) /
                        (static_cast<double>(rows[first].width) * rows[first].height);
    double square = 0.0;
    double count = 0.0;
    for (std::size_t i = first; i < rows.size(); i += every) {
        const auto& error = rows[i].error;
        mean.ms += rows[i].cost.median_ms;
        mean.layer_ms += rows[i].layer_ms;
        square += error.has_value() ? error->rmse * error->rmse : NAN;
        mean.bias += error.has_value() ? error->bias : NAN;
        mean.p99 += error.has_value() ? error->p99 : NAN;
        count += 1.0;
    }
    for (double* sum : {&mean.ms, &mean.layer_ms, &mean.bias, &mean.p99}) *sum /= count;
    mean.rmse = std::sqrt(square / count);
    return mean;
}

}  // namespace

std::vector<analysis::OverviewRow> overview_of(
    const std::vector<analysis::MeasurementRow>& rows,
    const std::vector<Experiment::Setting>& settings,
    const std::map<std::string, HardCaseCount>& hard_cases) {
    std::vector<analysis::OverviewRow> overview;
    for (std::size_t i = 0; i < settings.size(); ++i) {
        overview.push_back(mean_row(settings[i], rows, i, settings.size()));
        const auto count = hard_cases.find(settings[i].variant.technique);
        if (count == hard_cases.end()) continue;
        overview.back().hard_held = count->second.held;
        overview.back().hard_by_nature = count->second.by_nature;
        overview.back().hard_rows = count->second.rows;
    }
    analysis::finish_overview(overview);
    return overview;
}

std::vector<std::string> techniques_of(const std::vector<Experiment::Setting>& settings) {
    std::vector<std::string> names;
    for (const Experiment::Setting& setting : settings) {
        const std::string& name = setting.variant.technique;
        if (!renderer::find_technique(name)->makes_accessibility()) continue;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return names;
}

}  // namespace obscura::app
