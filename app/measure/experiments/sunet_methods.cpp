// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_methods(const std::vector<Outcome>& outcomes) {
    const auto ms = [&outcomes](const char* name) { return outcome_of(outcomes, name).ao_ms; };
    const double slowest_of_fast = std::max({ms("alchemy"), ms("homebrewed"), ms("crytek")});
    const double fastest_of_slow = std::min({ms("starcraft2"), ms("hbao"), ms("unsharp")});
    const std::string order = "shader ms: " + in_order(outcomes, &Outcome::ao_ms);
    return {{"Alchemy, home-brewed and Crytek are the fastest three",  //
             slowest_of_fast <= fastest_of_slow, order},
            {"the unsharp mask is the slowest",
             ms("unsharp") >= std::max({slowest_of_fast, ms("starcraft2"), ms("hbao")}),
             order + ". Here its blur takes two passes, the paper's gathers a square"}};
}

}  // namespace

Experiment sunet_methods() {
    return {"sunet-5.8",
            "Sunet 2018, 5.8: how fast each technique is",
            {{"alchemy", setting_of("alchemy", 16, "separable")},
             {"homebrewed", setting_of("homebrewed", 16, "separable")},
             {"crytek", setting_of("crytek", 16, "separable")},
             {"starcraft2", setting_of("starcraft2", 16, "separable")},
             {"hbao", setting_of("hbao", 16, "separable")},
             {"unsharp", setting_of("unsharp", 0, "none")}},
            judge_methods,
            "the paper explains its order by coherent reads and by few of them"};
}

}  // namespace obscura::app
