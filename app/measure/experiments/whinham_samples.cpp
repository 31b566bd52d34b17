// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "app/measure/experiment.h"
#include "stimuli/paper_configurations.h"

namespace obscura::app {
namespace {

constexpr int kWhinhamSamples[] = {4, 8, 16, 32, 64, 128};

std::vector<Finding> judge_samples(const std::vector<Outcome>& outcomes) {
    const Outcome& fewest = outcomes.front();
    const Outcome& most = outcomes.back();
    // Twice the samples, twice the time: an exponent of 1, less what every pixel costs anyway.
    const double exponent = std::log(most.ao_ms / outcomes[2].ao_ms) / std::log(128.0 / 16.0);
    return {
        {"time grows in proportion to the number of samples", exponent > 0.85 && exponent < 1.15,
         fmt::format("from 16 to 128 samples with their power {:.2f}; ms: {}", exponent,
                     in_order(outcomes, &Outcome::ao_ms))},
        {"at few samples the blur is dear against the rest", fewest.filter_ms > fewest.ao_ms,
         fmt::format("4 samples {:.2f} ms, their blur {:.2f} ms", fewest.ao_ms, fewest.filter_ms)},
        {"beyond 16 samples quality hardly grows",
         outcomes[2].rmse - most.rmse < 0.5 * (fewest.rmse - most.rmse) ||
             outcomes[2].rmse - most.rmse < 0.005,
         "RMSE: " + in_order(outcomes, &Outcome::rmse)}};
}

}  // namespace

Experiment whinham_samples() {
    Experiment experiment{"whinham-4.1",
                          "Whinham 2017, 4.1: what samples and blur of the hemisphere cost",
                          {},
                          judge_samples,
                          "the paper's step at 128 samples, where the bandwidth of its GPU ends"};
    for (const int samples : kWhinhamSamples) {
        experiment.settings.push_back(
            {std::to_string(samples),
             stimuli::paper_variant(fmt::format("Whinham 2017, {} samples", samples),
                                    "hemisphere")});
    }
    return experiment;
}

}  // namespace obscura::app
