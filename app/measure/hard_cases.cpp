// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/hard_cases.h"

#include "analysis/statistics/hard_cases.h"
#include "renderer/base/progress.h"
#include "renderer/hard_cases/hard_case.h"

namespace obscura::app {
namespace {

analysis::Holds holds(renderer::Outcome outcome) {
    switch (outcome) {
        case renderer::Outcome::kHolds:
            return analysis::Holds::kYes;
        case renderer::Outcome::kByNature:
            return analysis::Holds::kByNature;
        case renderer::Outcome::kUndecided:
            return analysis::Holds::kUndecided;
        case renderer::Outcome::kFails:
            return analysis::Holds::kNo;
    }
    return analysis::Holds::kNo;
}

analysis::HeldAgainst against(renderer::Against against) {
    return against == renderer::Against::kTruth ? analysis::HeldAgainst::kTruth
                                                : analysis::HeldAgainst::kDefinition;
}

std::vector<renderer::HardCaseResult> run_told(renderer::HardCaseOptions options, bool quiet) {
    base::Progress progress("hard cases", renderer::hard_case_steps(options), quiet);
    options.progress = [&progress](const std::string& what) { progress.step(what); };
    return renderer::run_hard_cases(options);
}

}  // namespace

std::vector<analysis::HardCaseRow> run_all_hard_cases(const MeasureRequest& request) {
    renderer::HardCaseOptions options;
    options.techniques = request.techniques;
    if (request.quick) options.size_px = 64;
    std::vector<analysis::HardCaseRow> rows;
    for (const renderer::HardCaseResult& result : run_told(options, request.quiet)) {
        rows.push_back({result.name, result.technique, result.quantity, result.expected,
                        result.measured, result.tolerance, holds(result.outcome), result.note,
                        against(result.against), result.definition});
    }
    for (const analysis::StatisticsCase& result : analysis::statistics_hard_cases()) {
        rows.push_back({"statistics: " + result.name, "", result.quantity, result.expected,
                        result.measured, result.tolerance,
                        result.holds ? analysis::Holds::kYes : analysis::Holds::kNo, result.note});
    }
    return rows;
}

std::map<std::string, HardCaseCount> count_hard_cases(const std::vector<std::string>& techniques,
                                                      bool quiet) {
    renderer::HardCaseOptions options;
    options.techniques = techniques;
    options.timing = false;
    std::map<std::string, HardCaseCount> counts;
    for (const renderer::HardCaseResult& result : run_told(options, quiet)) {
        HardCaseCount& count = counts[result.technique];
        ++count.rows;
        if (result.outcome == renderer::Outcome::kHolds) ++count.held;
        if (result.outcome == renderer::Outcome::kByNature) ++count.by_nature;
    }
    return counts;
}

}  // namespace obscura::app
