// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/fitted_study.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/base/error.h"
#include "stimuli/study_writer.h"

namespace obscura::app {
namespace {

using renderer::Variant;

const MeasuredView& view_of(const std::vector<MeasuredView>& views, const std::string& scene_id) {
    return *std::find_if(views.begin(), views.end(),
                         [&](const MeasuredView& view) { return view.scene_id == scene_id; });
}

/// A side as the fit makes it; itself where there is none.
Variant fitted_side(const Variant& shown, const MeasuredView& view,
                    const std::vector<FittedChoice>& fitted) {
    Variant changed = shown;
    for (const FittedChoice& fit : fitted) {
        if (!fit.is_for(*view.scene, shown)) continue;
        for (const auto& [name, value] : fit.record.after) changed.parameters[name] = value;
    }
    return changed;
}

/// The parameters of a side that a fit gave another value.
void add_change(std::vector<stimuli::VariantChange>& changes, const std::string& condition,
                char side, const Variant& before, const Variant& after) {
    if (after == before) return;
    stimuli::VariantChange change{condition, side, {}};
    for (const auto& [name, value] : after.parameters) {
        const auto held = before.parameters.find(name);
        if (held == before.parameters.end() || held->second != value) {
            change.parameters[name] = value;
        }
    }
    changes.push_back(std::move(change));
}

}  // namespace

FittedStudy fitted_study(const MeasureRequest& request, const stimuli::Study& study,
                         const std::vector<MeasuredView>& views,
                         const std::vector<FittedChoice>& fitted) {
    FittedStudy made;
    std::vector<stimuli::VariantChange> changes;
    stimuli::Study wanted = study;
    for (stimuli::Condition& condition : wanted.conditions) {
        if (!condition.repeats.empty()) continue;  // it has no sides of its own
        const MeasuredView& view = view_of(views, condition.scene);
        const Variant a = fitted_side(condition.a, view, fitted);
        const Variant b = fitted_side(condition.b, view, fitted);
        if (a == b && condition.a != condition.b) {
            made.notes.push_back(fmt::format(
                "condition {}: with fitted values both sides would be the same {}; it is "
                "left as it was",
                condition.id, a.variant_name()));
            continue;
        }
        add_change(changes, condition.id, 'a', condition.a, a);
        add_change(changes, condition.id, 'b', condition.b, b);
        condition.a = a;
        condition.b = b;
    }
    const stimuli::StudySource source = stimuli::study_source(request.study);
    const std::filesystem::path folder = request.write_study.parent_path();
    const std::string text =
        stimuli::with_paths_from(stimuli::with_variants(source.text, source.name, changes),
                                 source.name, source.folder, folder);
    const std::string name = request.write_study.string();
    const stimuli::Study written = stimuli::parse_study(text, name, folder);
    for (const stimuli::Condition& condition : wanted.conditions) {
        const stimuli::Condition* found = written.find_condition(condition.id);
        if (!condition.repeats.empty()) continue;
        if (found == nullptr || found->a != condition.a || found->b != condition.b) {
            throw base::failure(
                "{}: condition {} would not be written as it was fitted; nothing is "
                "written",
                name, condition.id);
        }
    }
    made.text = text;
    return made;
}

}  // namespace obscura::app
