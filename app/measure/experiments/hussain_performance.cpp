// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "app/measure/experiment.h"
#include "stimuli/paper_configurations.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_performance(const std::vector<Outcome>& outcomes) {
    const Outcome& crytek = outcome_of(outcomes, "crytek");
    const Outcome& hbao = outcome_of(outcomes, "hbao");
    const Outcome& alchemy = outcome_of(outcomes, "alchemy");
    const std::string times = "ms: " + in_order(outcomes, &Outcome::ao_ms);
    const std::string errors = "RMSE: " + in_order(outcomes, &Outcome::rmse);
    return {{"Crytek's over-occludes and is the farthest from the reference",
             crytek.bias < 0.0 && crytek.rmse >= std::max(hbao.rmse, alchemy.rmse),
             fmt::format("{}; Crytek's bias {:+.3f}", errors, crytek.bias)},
            {"HBAO is nearest to the reference", hbao.rmse <= std::min(crytek.rmse, alchemy.rmse),
             errors},
            {"Alchemy is the fastest and HBAO the slowest",
             alchemy.ao_ms <= std::min(crytek.ao_ms, hbao.ao_ms) &&
                 hbao.ao_ms >= std::max(crytek.ao_ms, alchemy.ao_ms),
             times}};
}

}  // namespace

Experiment hussain_performance() {
    const auto performance = [](const char* technique) {
        return stimuli::paper_variant("Hussain 2021, performance", technique);
    };
    return {"hussain-5.2",
            "Hussain 2021, 5.2: performance configurations against the ray-traced reference",
            {{"crytek", performance("crytek")},
             {"hbao", performance("hbao")},
             {"alchemy", performance("alchemy")}},
            judge_performance,
            "radii are each scene's own here, not the paper's, so that the reference has them too"};
}

}  // namespace obscura::app
