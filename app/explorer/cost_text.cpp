// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/cost_text.h"

#include <fmt/format.h>

#include "renderer/frame/explain.h"

namespace obscura::app::explorer {

std::string cost_text(const Model& model, const std::string& device) {
    const Choices& choices = model.choices();
    std::string text = fmt::format("{}\n{}, {}, {}x{}, supersampling {}\n", device,
                                   choices.scene.source, to_string(choices.scene.validity),
                                   choices.width, choices.height, choices.supersampling);
    for (const char side : {'a', 'b'}) {
        text += fmt::format("{}: {}\n", side == 'a' ? 'A' : 'B', choices.side(side).in_words());
        double sum = 0.0;
        for (const Model::PassCost& cost : model.costs(side)) {
            sum += cost.median_ms;
            text += fmt::format("  pass    {:14} {:9.2f} ms, median of {}\n", cost.name,
                                cost.median_ms, cost.history_ms.size());
        }
        text += fmt::format("  passes  {:14} {:9.2f} ms\n", "in all", sum);
        const auto shot = model.buffers(side);
        if (!shot) continue;
        text += fmt::format("  fetches {:14} {:9} a pixel\n", "", shot->fetches);
        for (const renderer::PlannedTarget& target : shot->buffers_planned) {
            text += fmt::format("  buffer  {:14} {:9} bytes  {}\n", target.name, target.bytes,
                                renderer::form_of(target));
        }
        text += fmt::format("  buffers {:14} {:9} bytes\n", "in all", shot->bytes);
        for (const renderer::LeftOut& one : shot->left_out) {
            text += fmt::format("  without {}: {}\n", one.what, one.why);
        }
    }
    return text;
}

}  // namespace obscura::app::explorer
