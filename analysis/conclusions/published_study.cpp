// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/published_study.h"

#include <algorithm>
#include <map>

#include "analysis/published_votes.h"

namespace obscura::analysis {

bool is_published_votes(const Tally& tally) {
    // Answers of a store are never these, whatever their counts.
    if (tally.kind.has_value()) return false;
    static const Tally published = published_votes();
    return std::equal(
        tally.conditions.begin(), tally.conditions.end(), published.conditions.begin(),
        published.conditions.end(), [](const ConditionVotes& one, const ConditionVotes& other) {
            return one.id == other.id && one.variant_a == other.variant_a &&
                   one.variant_b == other.variant_b && one.validity == other.validity &&
                   one.votes.a == other.votes.a && one.votes.b == other.votes.b;
        });
}

void add_published_views(Tally& tally) {
    // Chapter 5 of the thesis: the Stanford dragon, Sponza and two characters, one view of each.
    static const std::map<std::string, std::string> views{
        {"I", "the dragon"}, {"II", "Sponza"}, {"III", "Sponza"},        {"IV", "the characters"},
        {"V", "Sponza"},     {"VI", "Sponza"}, {"VII", "the characters"}};
    for (ConditionVotes& condition : tally.conditions) condition.view = views.at(condition.id);
}

const std::vector<PrintedTest>& printed_table_4() {
    static const std::vector<PrintedTest> table{
        {"I", "0", "1"},          {"II", "1.778", "0.182"},      {"III", "5.445", "0.019", true},
        {"IV", "0.445", "0.505"}, {"V", "5.445", "0.019", true}, {"VI", "0", "1"},
        {"VII", "1", "0.317"}};
    return table;
}

const std::vector<PlannedHypothesis>& published_hypotheses() {
    static const std::vector<PlannedHypothesis> hypotheses{
        {.id = "H1",
         .statement = "Ambient occlusion raises perceived realism.",
         .conditions = {"II", "V", "VII"}},
        {.id = "H2",
         .statement = "More accurate ambient occlusion raises perceived realism.",
         .conditions = {"I", "III", "VI"}},
        {.id = "H2-IV",
         .statement = "More accurate ambient occlusion raises perceived realism, between two other "
                      "techniques.",
         .conditions = {"IV"},
         .is_primary = false},
        {.id = "H3",
         .statement = "The effect of ambient occlusion depends on ecological validity.",
         .is_interaction = true,
         .pairs = {{"II", "V"}, {"III", "VI"}}}};
    return hypotheses;
}

bool is_built_in(const Tally& tally) {
    return tally.study == kPublishedStudy || is_published_votes(tally);
}

std::string published_participants() {
    return "The thesis (section 5.4) reports 36 people aged 18 to 56, 26 men and 10 women, most of "
           "them students of one programme, all with normal or corrected vision and none aware of "
           "the purpose. Each judged all seven pairs, but only the sums were published: who chose "
           "what, in which order and how fast is not known.";
}

}  // namespace obscura::analysis
