// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/summary.h"

#include <fmt/format.h>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/journal.h"
#include "analysis/presentation/text_layout.h"

namespace obscura::analysis {
namespace {

std::string heading_of(const Tally& tally) {
    const std::string people = tally.n_participants.has_value()
                                   ? who(tally, *tally.n_participants)
                                   : "an unknown number of participants";
    std::string text = fmt::format(
        "{}{}, {}, from {}\n", tally.study.empty() ? "" : fmt::format("Study {}: ", tally.study),
        people, counted(static_cast<std::int64_t>(tally.conditions.size()), "condition"),
        tally.source);
    if (tally.kind == Kind::kSimulated) {
        text += "SIMULATED DATA: these answers were made by simulated observers, not by people.\n";
    }
    return text;
}

TextRow row_of(const ConditionResult& result) {
    const ConditionVotes& condition = result.condition;
    const Preference& tests = result.preference;
    return {condition.id,
            condition.validity,
            condition.variant_a,
            condition.variant_b,
            fmt::format("{} : {}", condition.votes.a, condition.votes.b),
            tests.share_b.has_value() ? journal_share(*tests.share_b) : kNoText,
            tests.wilson.has_value() ? journal_interval(*tests.wilson) : kNoText,
            tests.exact.has_value() ? p_number(*tests.exact) : kNoText,
            result.p_holm.has_value() ? p_number(result.p_holm) : kNoText};
}

std::string exclusion_line(const Possible<Exclusions>& exclusions) {
    if (!exclusions.has_value() || exclusions->left_out == 0) return "";
    return fmt::format(
        "The study's rule leaves out {} of {}, which changes {}.\n", exclusions->left_out,
        counted(exclusions->participants, "participant"),
        exclusions->changes.empty()
            ? "no conclusion"
            : counted(static_cast<std::int64_t>(exclusions->changes.size()), "conclusion"));
}

}  // namespace

std::string summary_text(const Analysis& analysis) {
    std::vector<TextRow> rows{
        {"pair", "validity", "A", "B", "A : B", "B", "95 % interval", "p exact", "p Holm"}};
    for (const ConditionResult& result : analysis.conditions) {
        if (rows.size() > kMostSummarised) break;
        rows.push_back(row_of(result));
    }
    std::string text = heading_of(analysis.tally) + '\n' + aligned(rows, 4);
    const std::size_t shown = rows.size() - 1;
    if (shown < analysis.conditions.size()) {
        text += fmt::format("... and {} more\n", analysis.conditions.size() - shown);
    }
    std::string verdicts = exclusion_line(analysis.exclusions);
    if (analysis.look.has_value()) verdicts += analysis.look->words + '\n';
    for (const Verdict& verdict : analysis.verdicts) {
        verdicts += fmt::format("{}: {}\n", verdict.hypothesis, verdict_line(analysis, verdict));
    }
    if (!verdicts.empty()) text += '\n' + wrapped(verdicts);
    return text;
}

}  // namespace obscura::analysis
