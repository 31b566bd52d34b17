// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "app/measure/experiment.h"

namespace obscura::app {
namespace {

std::vector<Finding> judge_pipelines(const std::vector<Outcome>& outcomes) {
    const Outcome& deferred = outcome_of(outcomes, "g-buffer");
    const Outcome& forward = outcome_of(outcomes, "nd-buffer");
    const auto ms = [](const Outcome& outcome, const char* pass) {
        const auto found = outcome.house_ms.find(pass);
        return found != outcome.house_ms.end() ? found->second : 0.0;
    };
    // Where pixels take several samples, what the technique reads is drawn as `occluders`.
    const double generated_nd = ms(forward, "geometry") + ms(forward, "occluders");
    const double generated_g = ms(deferred, "geometry") + ms(deferred, "occluders");
    const double lit_forward = ms(forward, "forward");
    // The paper's composite computes the light; here that is a pass of its own.
    const double lit_deferred = ms(deferred, "light") + ms(deferred, "composite");
    const double forward_ms = generated_nd + lit_forward;
    const double deferred_ms = generated_g + lit_deferred;
    return {
        {"an ND-buffer is generated faster than a G-buffer", generated_nd < generated_g,
         fmt::format("{:.2f} and {:.2f} ms (the paper: 4.9 and 8.8)", generated_nd, generated_g),
         share_apart(generated_nd, generated_g)},
        {"its second, forward pass is slower than the G-buffer's compositing",
         lit_forward > lit_deferred,
         fmt::format("{:.2f} and {:.2f} ms (the paper: 13.3 and 6.3)", lit_forward, lit_deferred),
         share_apart(lit_forward, lit_deferred)},
        {"the G-buffer pipeline is faster in all", deferred_ms < forward_ms,
         fmt::format("{:.2f} and {:.2f} ms (the paper: 15.1 and 18.2)", deferred_ms, forward_ms),
         share_apart(deferred_ms, forward_ms)}};
}

}  // namespace

Experiment sunet_pipelines() {
    return {"sunet-5.2",
            "Sunet 2018, 5.2: G-buffer and ND-buffer pipelines, with Alchemy",
            {{"g-buffer", setting_of("alchemy", 16, "separable")},
             {"nd-buffer", setting_of("alchemy", 16, "separable", {"pipeline=nd-buffer"})}},
            judge_pipelines,
            "what the memory of a tile-based GPU gains from fewer render targets, and an ND-buffer "
            "of a quarter of the size, which the paper proposes and does not time"};
}

}  // namespace obscura::app
