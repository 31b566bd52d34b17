// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/variant_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "stimuli/table_reader.h"

namespace obscura::stimuli {
namespace {

using Need = TableReader::Need;

/// The keys of a variant whose technique is unknown are not judged: nobody knows what they mean.
void report_unknown_technique(TableReader& reader, const renderer::TechniqueChoice& choice) {
    std::vector<std::string> names;
    for (const renderer::Technique& technique : renderer::techniques()) {
        names.push_back(technique.name);
    }
    reader.add("technique",
               fmt::format("{} is unknown, allowed are {}{}", in_quotes(choice.technique),
                           listed(names), did_you_mean(choice.technique, names)));
}

/// Without a technique any setting of any technique may be meant; only the rest is reported.
void allow_any_setting(TableReader& reader) {
    reader.allow("samples");
    reader.allow("denoise");
    for (const renderer::Technique& technique : renderer::techniques()) {
        for (const renderer::Parameter& parameter : technique.parameters) {
            reader.allow(parameter.name);
        }
    }
}

void read_settings(TableReader& reader, const renderer::Technique& technique,
                   renderer::TechniqueChoice& choice) {
    constexpr std::int64_t kMost = std::numeric_limits<int>::max();
    choice.samples = static_cast<int>(reader.integer("samples", Need::kOptional, -kMost, kMost)
                                          .value_or(technique.samples.standard));
    const bool makes_buffer = technique.makes_accessibility();
    // The truth is shown as it is, unless a study asks for a filter.
    const bool filtered = makes_buffer && !technique.ray_traced;
    choice.denoise =
        reader.text("denoise", Need::kOptional).value_or(filtered ? "separable" : "none");
    for (const renderer::Parameter& parameter : technique.parameters) {
        const std::optional<double> value = reader.number(parameter.name, Need::kOptional);
        if (value) choice.parameters[parameter.name] = *value;
    }
    for (const renderer::ChoiceProblem& problem : renderer::problems_of(choice)) {
        reader.add(problem.key, problem.message);
    }
    if (!makes_buffer && choice.denoise != "none") {
        reader.add("denoise", fmt::format("{} is not allowed: {} has no buffer to smooth",
                                          in_quotes(choice.denoise), technique.name));
    }
}

}  // namespace

renderer::TechniqueChoice read_variant(const toml::table& table, const std::string& where,
                                       std::vector<StudyProblem>& problems) {
    TableReader reader(table, where, problems);
    renderer::TechniqueChoice choice;
    const std::optional<std::string> name = reader.text("technique", Need::kRequired);
    if (name) {
        choice.technique = *name;
        const renderer::Technique* technique = renderer::find_technique(*name);
        if (technique == nullptr) {
            report_unknown_technique(reader, choice);
            return choice;
        }
        read_settings(reader, *technique, choice);
    } else {
        allow_any_setting(reader);
    }
    reader.finish();
    return choice;
}

bool same_variant(const renderer::TechniqueChoice& a, const renderer::TechniqueChoice& b) {
    if (a.technique != b.technique || a.samples != b.samples || a.denoise != b.denoise) {
        return false;
    }
    const renderer::Technique* technique = renderer::find_technique(a.technique);
    return technique == nullptr ||
           std::all_of(technique->parameters.begin(), technique->parameters.end(),
                       [&](const renderer::Parameter& parameter) {
                           return a.value_of(parameter) == b.value_of(parameter);
                       });
}

}  // namespace obscura::stimuli
