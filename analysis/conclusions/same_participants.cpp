// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/same_participants.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

#include "analysis/conclusions/words.h"
#include "analysis/statistics/cochran_q.h"

namespace obscura::analysis {
namespace {

using Conditions = std::vector<const ConditionVotes*>;

/// Why the conditions cannot be compared within participants; empty where they can.
std::string obstacle(const Conditions& conditions) {
    std::set<std::string> levels;
    for (const ConditionVotes* condition : conditions) {
        if (condition->answers.empty()) return "the answers of each participant are not known";
        if (!levels.insert(condition->validity).second) {
            return fmt::format("more than one condition is at level {}", condition->validity);
        }
    }
    return "";
}

/// The answers of each participant who gave any, in the conditions' order.
struct Rows {
    std::size_t conditions = 0;
    std::vector<signed char> answers;  ///< row after row: 1 for B, 0 for A, -1 for none

    [[nodiscard]] std::size_t size() const { return answers.size() / conditions; }
    [[nodiscard]] std::span<const signed char> row(std::size_t number) const {
        return std::span(answers).subspan(number * conditions, conditions);
    }
};

Possible<Rows> rows_of(const Conditions& conditions) {
    Rows rows;
    rows.conditions = conditions.size();
    std::vector<std::int32_t> place;  // of each participant's row; -1: none yet
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        for (const Answer& answer : conditions[i]->answers) {
            const auto participant = static_cast<std::size_t>(answer.participant);
            if (participant >= place.size()) place.resize(2 * participant + 1, -1);
            if (place[participant] < 0) {
                place[participant] = static_cast<std::int32_t>(rows.size());
                rows.answers.resize(rows.answers.size() + conditions.size(), -1);
            }
            signed char& own =
                rows.answers[static_cast<std::size_t>(place[participant]) * conditions.size() + i];
            if (own >= 0) {
                return Possible<Rows>::none(fmt::format(
                    "a participant answered condition {} more than once", conditions[i]->id));
            }
            own = answer.chose_b ? 1 : 0;
        }
    }
    return rows;
}

std::string who(const SameParticipants& same) {
    std::string text = same.n == 1 ? std::string("on the same 1 participant")
                                   : fmt::format("on the same {} participants", same.n);
    if (same.incomplete > 0) {
        text += fmt::format(" ({} who did not answer all left out)", same.incomplete);
    }
    return text;
}

std::string mcnemar_words(const SameParticipants& same) {
    if (!same.mcnemar.has_value()) {
        return fmt::format("McNemar's exact test {}, nobody changed the answer, {}", who(same),
                           p_words(PValue{}));
    }
    const McNemarTest& test = *same.mcnemar;
    const std::string changes =
        fmt::format("{} changed from B to A, {} from A to B", same.changed.a, same.changed.b);
    return fmt::format("McNemar's exact test {}, {}, {}", who(same), changes, p_words(test.exact));
}

std::string contrast_words(const LevelContrast& contrast, const Comparison& comparison) {
    std::string text = fmt::format(
        "{} test by flipping the signs of each participant's change from {} to {}, {} over {}",
        contrast.is_exact ? "exact" : "large-sample", comparison.levels.front(),
        comparison.levels.back(), counted(contrast.n, "participant"),
        counted(static_cast<std::int64_t>(contrast.scenes), "scene"));
    if (contrast.left_out > 0) {
        text += fmt::format(" ({} who did not answer all left out)", contrast.left_out);
    }
    return text + fmt::format(", {}", p_words(contrast.p));
}

std::string counts_words(const Comparison& comparison) {
    if (!comparison.test.has_value()) return fmt::format("no test, {}", comparison.test.reason);
    std::string text = fmt::format("chi-square {:.4g}, df {}, {}", comparison.test->statistic,
                                   comparison.test->df, p_words(comparison.test->p));
    if (comparison.fisher.has_value()) {
        text = fmt::format("Fisher's exact {}, {}", p_words(*comparison.fisher), text);
    }
    const std::string& why = comparison.conditions.size() > comparison.votes.size()
                                 ? comparison.contrast.reason
                                 : comparison.same_participants.reason;
    return text + fmt::format(" (from counts alone: {})", why);
}

}  // namespace

Possible<SameParticipants> same_participants(const Conditions& conditions) {
    using None = Possible<SameParticipants>;
    if (const std::string why = obstacle(conditions); !why.empty()) return None::none(why);
    const auto rows = rows_of(conditions);
    if (!rows.has_value()) return None::none(rows.reason);
    SameParticipants same;
    CochranSums sums(conditions.size());
    for (std::size_t number = 0; number < rows->size(); ++number) {
        const auto row = rows->row(number);
        if (std::find(row.begin(), row.end(), -1) != row.end()) {
            ++same.incomplete;
            continue;
        }
        ++same.n;
        sums.add(row);
        if (row.front() > row.back()) ++same.changed.a;
        if (row.front() < row.back()) ++same.changed.b;
    }
    if (same.n == 0) return None::none("no participant answered all of the conditions");
    same.cochran_q = cochran_q(sums);
    if (conditions.size() == 2) {
        same.mcnemar = mcnemar(same.changed);
    } else {
        same.changed = {};
    }
    return same;
}

Possible<PValue> p_of(const Comparison& comparison) {
    if (comparison.contrast.has_value()) return comparison.contrast->p;
    if (!comparison.same_participants.has_value()) {
        if (comparison.fisher.has_value()) return comparison.fisher;
        if (!comparison.test.has_value()) return Possible<PValue>::none(comparison.test.reason);
        return comparison.test->p;
    }
    const SameParticipants& same = *comparison.same_participants;
    if (comparison.votes.size() == 2)
        return same.mcnemar.has_value() ? same.mcnemar->exact : PValue{};
    return same.cochran_q.has_value() ? same.cochran_q->p : PValue{};
}

std::string test_words(const Comparison& comparison) {
    if (comparison.contrast.has_value()) return contrast_words(*comparison.contrast, comparison);
    if (!comparison.same_participants.has_value()) return counts_words(comparison);
    const SameParticipants& same = *comparison.same_participants;
    if (comparison.votes.size() == 2) return mcnemar_words(same);
    if (!same.cochran_q.has_value()) {
        return fmt::format("Cochran's Q {}, each answered alike at every level, {}", who(same),
                           p_words(PValue{}));
    }
    return fmt::format("Cochran's Q {}, Q {:.4g}, df {}, {}", who(same), same.cochran_q->statistic,
                       same.cochran_q->df, p_words(same.cochran_q->p));
}

}  // namespace obscura::analysis
