// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/variants_help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/denoise/denoise.h"
#include "renderer/technique/technique.h"

namespace obscura::app {

namespace {

std::string multiples_of(const renderer::SampleRange& range) {
    std::string factor = range.multiple_of > 1 ? std::to_string(range.multiple_of) : "";
    if (!range.times.empty()) factor += (factor.empty() ? "" : " x ") + range.times;
    return factor.empty() ? "" : ", multiples of " + factor;
}

}  // namespace

std::string variants_help() {
    std::string text = "Techniques:\n";
    for (const renderer::Technique& technique : renderer::techniques()) {
        text += fmt::format("  {} ({})\n", technique.name, technique.citation);
        if (technique.samples.high > 0) {
            text += fmt::format("    samples: {} to {}, default {}{}\n", technique.samples.low,
                                technique.samples.high, technique.samples.standard,
                                multiples_of(technique.samples));
        }
        for (const renderer::Parameter& parameter : technique.parameters) {
            text +=
                fmt::format("    {}: {}; {} to {}{}{}, default {}\n", parameter.name,
                            parameter.meaning, parameter.low, parameter.high,
                            parameter.unit.empty() ? "" : " ", parameter.unit, parameter.standard);
        }
        if (technique.fitted.empty()) continue;
        text += "    preset fitted:";
        for (const auto& [name, value] : technique.fitted) {
            text += fmt::format("{} {} {}", text.ends_with(':') ? "" : ",", name, value);
        }
        text += '\n';
    }
    text += "Settings of every technique:\n";
    for (const renderer::VariantOption& option : renderer::variant_options()) {
        text += fmt::format("  {}: {}; {}, default {}\n", option.name, option.meaning,
                            fmt::join(option.allowed, " or "), option.standard());
    }
    text += "Filters:\n";
    for (const renderer::Denoise& denoise : renderer::denoise_filters()) {
        text += fmt::format("  {} ({})\n", denoise.name, denoise.citation);
    }
    return text;
}

}  // namespace obscura::app
