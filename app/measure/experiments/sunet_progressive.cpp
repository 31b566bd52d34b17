// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

constexpr const char* kSpread[] = {"alchemy", "crytek", "hbao", "homebrewed", "starcraft2"};
constexpr int kFrames = 2;

std::vector<Finding> judge_progressive(const std::vector<Outcome>& outcomes) {
    bool all_faster = true;
    double most_apart = 0.0;
    std::string times;
    std::string errors;
    for (const std::string technique : kSpread) {
        const Outcome& whole = outcome_of(outcomes, technique);
        const Outcome& spread = outcome_of(outcomes, technique + ", 2 frames");
        const double frame_ms = spread.ao_ms / kFrames;
        all_faster &= frame_ms < whole.ao_ms;
        times += fmt::format("{}{} {:.2f} and {:.2f} ms (x{:.2f})", times.empty() ? "" : ", ",
                             technique, whole.ao_ms, frame_ms, frame_ms / whole.ao_ms);
        most_apart = std::max(most_apart, std::abs(whole.rmse - spread.rmse));
        errors += fmt::format("{}{} {:.4f} and {:.4f}", errors.empty() ? "" : ", ", technique,
                              whole.rmse, spread.rmse);
    }
    return {{"half the kernel a frame makes every technique faster, averaging included", all_faster,
             "accessibility of one frame: " + times +
                 "; the paper: x.63, x.63, x.70, x.66, x.65 in this order"},
            {"on a still the two halves come to the whole", most_apart < 0.01, "RMSE " + errors}};
}

}  // namespace

Experiment sunet_progressive() {
    Experiment experiment{"sunet-5.9",
                          "Sunet 2018, 5.9: half of the kernel in each of two frames",
                          {},
                          judge_progressive,
                          "the flicker that the paper sees while the camera moves: images here are "
                          "stills. Times above are of both frames of one"};
    for (const std::string technique : kSpread) {
        experiment.settings.push_back({technique, setting_of(technique, 16, "separable")});
        experiment.settings.push_back(
            {technique + ", 2 frames", setting_of(technique, 16, "separable", {"frames=2"})});
    }
    return experiment;
}

}  // namespace obscura::app
