// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/selection.h"

#include <algorithm>
#include <tuple>

#include "renderer/base/check.h"

namespace obscura::stimuli {

std::vector<Stimulus> selected(const Study& study, const Selection& selection) {
    base::check_range("--shard", "N", selection.shards, 1, 1000000);
    base::check_range("--shard", "K", selection.shard, 1, selection.shards);
    if (!selection.condition.empty() && study.find_condition(selection.condition) == nullptr) {
        std::string known;
        for (const Condition& condition : study.conditions) {
            known += (known.empty() ? "" : ", ") + condition.id;
        }
        throw base::bad_input("--condition: study {} has no condition \"{}\"; it has {}",
                              study.name, selection.condition, known);
    }
    std::vector<Stimulus> wanted;
    for (const Stimulus& stimulus : stimuli_of(study)) {
        if (selection.condition.empty() || stimulus.condition->id == selection.condition) {
            wanted.push_back(stimulus);
        }
    }
    std::stable_sort(wanted.begin(), wanted.end(), [&study](const auto& left, const auto& right) {
        const StudyScene& a = study.scene_of(*left.condition);
        const StudyScene& b = study.scene_of(*right.condition);
        // Last, what asks for the fewest buffers: it takes them over from the images before.
        const bool few = left.choice().technique == "none";
        const bool other_few = right.choice().technique == "none";
        return std::tie(a.source, a.settings.scale, a.id, few) <
               std::tie(b.source, b.settings.scale, b.id, other_few);
    });
    // Neighbouring images go to the same part, so that few parts need the same scene.
    const std::size_t count = wanted.size();
    const auto shards = static_cast<std::size_t>(selection.shards);
    const auto shard = static_cast<std::size_t>(selection.shard);
    const std::size_t first = count * (shard - 1) / shards;
    const std::size_t last = count * shard / shards;
    return {wanted.begin() + static_cast<std::ptrdiff_t>(first),
            wanted.begin() + static_cast<std::ptrdiff_t>(last)};
}

}  // namespace obscura::stimuli
