// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/study_warnings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "renderer/technique/variant.h"

namespace obscura::stimuli {
namespace {

/// Every setting in which two variants of one technique differ, as `samples (8 : 24)`.
std::vector<std::string> differences_of(const renderer::Variant& a, const renderer::Variant& b) {
    std::vector<std::string> words;
    if (a.samples != b.samples)
        words.push_back(fmt::format("samples ({} : {})", a.samples, b.samples));
    if (a.denoise != b.denoise)
        words.push_back(fmt::format("denoise ({} : {})", a.denoise, b.denoise));
    for (const renderer::VariantOption& option : renderer::variant_options()) {
        if (a.*option.value == b.*option.value) continue;
        words.push_back(fmt::format("{} ({} : {})", option.name, a.*option.value, b.*option.value));
    }
    const auto of_b = b.all_parameters();
    for (const auto& [name, value] : a.all_parameters()) {
        const double other = of_b.at(name);
        if (value != other) words.push_back(fmt::format("{} ({:g} : {:g})", name, value, other));
    }
    return words;
}

/// What is to be said of a file is said once, however many scenes show it.
std::vector<std::string> warnings_of_files(const Study& study) {
    std::vector<std::pair<std::string, std::vector<std::string>>> said;  // and by which scenes
    for (const StudyScene& scene : study.scenes) {
        for (const std::string& note : scene.notes) {
            const std::string what = fmt::format("{}: {}", scene.source, note);
            auto known = std::find_if(said.begin(), said.end(),
                                      [&](const auto& one) { return one.first == what; });
            if (known == said.end()) known = said.insert(known, {what, {}});
            known->second.push_back(scene.id);
        }
    }
    std::vector<std::string> warnings;
    for (const auto& [what, scenes] : said) {
        warnings.push_back(fmt::format("scene{} \"{}\": {}", scenes.size() > 1 ? "s" : "",
                                       fmt::join(scenes, "\", \""), what));
    }
    return warnings;
}

}  // namespace

std::vector<std::string> notes_on(const Study& study) {
    std::vector<std::string> notes;
    for (const Condition& condition : study.conditions) {
        if (!condition.repeats.empty() || condition.a.technique != condition.b.technique) continue;
        const std::vector<std::string> words = differences_of(condition.a, condition.b);
        if (words.size() != 1) continue;
        notes.push_back(fmt::format("condition \"{}\": a and b differ in one setting only, {}",
                                    condition.id, words.front()));
    }
    const auto nobody = [&](const std::optional<double>& least, const char* key) {
        if (least == 0.0) notes.push_back(fmt::format("exclusion: {} = 0 leaves nobody out", key));
    };
    nobody(study.exclusion.min_catch_correct, "min_catch_correct");
    nobody(study.exclusion.min_repeat_agreement, "min_repeat_agreement");
    nobody(study.exclusion.min_response_time_s, "min_response_time_s");
    return notes;
}

std::vector<std::string> warnings_of(const Study& study) {
    std::vector<std::string> warnings = warnings_of_files(study);
    for (const StudyScene& scene : study.scenes) {
        const auto add = [&](const std::string& what) {
            warnings.push_back(fmt::format("scene \"{}\": {}", scene.id, what));
        };
        const auto unused = [&](bool given, const char* what) {
            if (given) {
                add(fmt::format("{} no effect at the validity {}", what,
                                to_string(scene.validity)));
            }
        };
        const SceneSettings& settings = scene.settings;
        const bool low = scene.validity == Validity::kLow;
        unused(low && !settings.environment.empty(), "its environment has");
        unused(scene.validity != Validity::kHigh && settings.has_lights(), "its lights have");
        unused(!low && settings.ambient.has_value(), "its ambient light has");
    }
    return warnings;
}

}  // namespace obscura::stimuli
