// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "app/measure/experiment.h"
#include "stimuli/paper_configurations.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_quality(const std::vector<Outcome>& outcomes) {
    const Outcome& crytek = outcome_of(outcomes, "crytek");
    const Outcome& hbao = outcome_of(outcomes, "hbao");
    const Outcome& alchemy = outcome_of(outcomes, "alchemy");
    const std::string times = "ms: " + in_order(outcomes, &Outcome::ao_ms);
    const std::string errors = "RMSE: " + in_order(outcomes, &Outcome::rmse);
    return {{"more samples do not bring Crytek's near the reference",
             crytek.rmse >= std::max(hbao.rmse, alchemy.rmse), errors},
            {"HBAO pays for its quality with by far the most time",
             hbao.ao_ms > 1.5 * std::max(crytek.ao_ms, alchemy.ao_ms), times},
            {"Alchemy is the fastest of the three",
             alchemy.ao_ms <= std::min(crytek.ao_ms, hbao.ao_ms), times}};
}

}  // namespace

Experiment hussain_quality() {
    const auto quality = [](const char* technique) {
        return stimuli::paper_variant("Hussain 2021, quality", technique);
    };
    return {
        "hussain-5.3",
        "Hussain 2021, 5.3: quality configurations without a filter",
        {{"crytek", quality("crytek")}, {"hbao", quality("hbao")}, {"alchemy", quality("alchemy")}},
        judge_quality,
        "the paper's HBAO marches 20 steps, the most here are 16; radii are each scene's own"};
}

}  // namespace obscura::app
