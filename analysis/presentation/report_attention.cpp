// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"

namespace obscura::analysis {
namespace {

constexpr std::size_t kMostListed = 50;

std::string quartile_cell(const Possible<Quartiles>& share) {
    if (!share.has_value()) return share.reason;
    return fmt::format("{} ({} to {})", percent(share->median), percent(share->first),
                       percent(share->third));
}

std::string share_cell(const Successes& trials) {
    if (trials.n == 0) return "none";
    return fmt::format(
        "{} of {} ({})", trials.successes, trials.n,
        percent(static_cast<double>(trials.successes) / static_cast<double>(trials.n)));
}

PageTable left_out_table(const Analysis& analysis) {
    PageTable table{{"Participant", "Left out for"}, {}};
    for (const ParticipantResult& person : analysis.attention->participants) {
        if (person.left_out.empty() || table.rows.size() == kMostListed) continue;
        table.rows.push_back({person.id, fmt::format("{}", fmt::join(person.left_out, "; "))});
    }
    return table;
}

std::string share_words(const ConditionResult& result) {
    const Preference& preference = result.preference;
    if (!preference.share_b.has_value()) return kNoValue;
    return fmt::format("{:.1f}", 100.0 * *preference.share_b);
}

PageTable with_and_without(const Analysis& analysis, const Analysis& everybody) {
    PageTable table{
        {"Condition", "With all: A : B", "B (%)", "p, Holm", "Without: A : B", "B (%)", "p, Holm"},
        {}};
    for (const ConditionResult& all : everybody.conditions) {
        for (const ConditionResult& kept : analysis.conditions) {
            if (kept.condition.id != all.condition.id) continue;
            const Votes& before = all.condition.votes;
            const Votes& after = kept.condition.votes;
            table.rows.push_back({all.condition.id, fmt::format("{} : {}", before.a, before.b),
                                  share_words(all), p_cell(all.p_holm),
                                  fmt::format("{} : {}", after.a, after.b), share_words(kept),
                                  p_cell(kept.p_holm)});
        }
    }
    return table;
}

void add_exclusions(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("Who was left out", 3);
    if (!analysis.exclusions.has_value()) {
        draft.page.paragraph(fmt::format("Nobody: {}.", analysis.exclusions.reason));
        return;
    }
    const Exclusions& exclusions = *analysis.exclusions;
    draft.page.paragraph(fmt::format(
        "The study's rule, fixed before the data, leaves out who has {}. It leaves out {} of {}; "
        "everything on this page is of those who stay.",
        rule_words(exclusions.rule), exclusions.left_out, exclusions.participants));
    if (exclusions.everybody == nullptr) return;
    draft.page.table(with_and_without(analysis, *exclusions.everybody),
                     "The same tests with everybody and without those left out.");
    if (exclusions.changes.empty()) {
        draft.page.paragraph("No conclusion changes when those left out are counted.");
    } else {
        draft.page.paragraph("What would be concluded otherwise if nobody were left out:");
        draft.page.list(exclusions.changes);
    }
    if (!analysis.attention.has_value()) return;
    const PageTable table = left_out_table(analysis);
    draft.page.table(table, table.rows.size() == kMostListed
                                ? fmt::format("The first {} left out, and why.", kMostListed)
                                : "Those left out, and why.");
}

}  // namespace

void add_attention(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("Did the participants pay attention?");
    if (!analysis.attention.has_value()) {
        draft.page.paragraph(fmt::format("Not known: {}.", analysis.attention.reason));
        if (analysis.exclusions.has_value()) add_exclusions(draft);
        return;
    }
    const Attention& attention = *analysis.attention;
    draft.page.table(
        {{"", "All together", "Participants: median (quartiles)"},
         {{"Catch trials answered as expected", share_cell(attention.catch_trials),
           quartile_cell(attention.catch_share)},
          {"Repeated pairs answered alike", share_cell(attention.repeats),
           quartile_cell(attention.repeat_share)},
          {"Votes with the majority of the others", kNoValue,
           quartile_cell(attention.majority_share)}}},
        "Who guesses answers repeated pairs alike, and with the majority, half of the time.");
    add_exclusions(draft);
}

}  // namespace obscura::analysis
