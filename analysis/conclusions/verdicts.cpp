// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/verdicts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/conclusions/hypotheses.h"
#include "analysis/conclusions/words.h"
#include "analysis/statistics/holm.h"
#include "analysis/statistics/resampling.h"

namespace obscura::analysis {
namespace {

/// Tests of all verdicts, corrected together.
class Family {
  public:
    /// The place of the test in the family; nothing where there is no p-value.
    std::optional<std::size_t> add(const Possible<PValue>& p) {
        if (!p.has_value()) return std::nullopt;
        p_values_.push_back(p->p);
        return p_values_.size() - 1;
    }
    void correct() { corrected_ = holm(p_values_); }
    [[nodiscard]] std::size_t size() const { return p_values_.size(); }
    [[nodiscard]] Possible<double> at(const std::optional<std::size_t>& place) const {
        if (!place) return Possible<double>::none("no test");
        return corrected_[*place];
    }

  private:
    std::vector<double> p_values_;
    std::vector<double> corrected_;
};

std::string corrected_words(const Possible<double>& p_holm, std::size_t tests) {
    if (!p_holm.has_value()) return "";
    constexpr double kSmallest = 1e-290;  // a corrected p carries no logarithm
    return fmt::format(
        " ({} after Holm's correction for {})",
        *p_holm < kSmallest ? fmt::format("<{:g}", kSmallest) : p_text({*p_holm, 0.0}),
        counted(static_cast<std::int64_t>(tests), "test"));
}

bool is_significant(const Possible<double>& p) { return p.has_value() && *p < kSignificance; }

std::string needed_words(const Analysis& analysis, const std::string& name) {
    if (!analysis.power.has_value()) return "";
    for (const RunPower::Needed& needed : analysis.power->hypotheses) {
        if (needed.name != name || !needed.exact.has_value()) continue;
        return fmt::format(
            " To detect the observed share with {:g} % power, {} with "
            "one vote each would have been needed.",
            100.0 * kAskedPower, counted(*needed.exact, "participant"));
    }
    return "";
}

std::string kind_words(ShareIntervalKind kind) {
    switch (kind) {
        case ShareIntervalKind::kResampled:
            return "participants drawn anew";
        case ShareIntervalKind::kEachOnce:
            return "Clopper-Pearson, each participant counted once";
        case ShareIntervalKind::kCounts:
            return "Wilson, each participant counted once because his votes may be alike";
    }
    return "";
}

/// The interval, and, where the test says nothing, what it leaves possible.
std::string interval_words(const ShareInterval& interval, bool is_tested) {
    const std::string text =
        fmt::format("; the 95 % interval is {:.1f} to {:.1f} % ({})", 100.0 * interval.bounds.low,
                    100.0 * interval.bounds.high, kind_words(interval.kind));
    if (is_tested) return text;
    const ShareReach reach = reach_of(interval.bounds);
    if (!reach.for_a && !reach.for_b) {
        return text + fmt::format(", which excludes shares of {:g} % or more of either image",
                                  100.0 * kRelevantShare);
    }
    return text + fmt::format(", which leaves a share of {} of {:g} % or more possible",
                              reach.for_a && reach.for_b ? "either image"
                              : reach.for_b              ? "B"
                                                         : "A",
                              100.0 * kRelevantShare);
}

Conclusion conclusion_on(const Votes& votes, const Interval& interval, bool is_significant) {
    if (is_significant) {
        return votes.b > votes.a ? Conclusion::kEvidenceFor : Conclusion::kEvidenceAgainst;
    }
    const ShareReach reach = reach_of(interval);
    return reach.for_a || reach.for_b ? Conclusion::kTooFew : Conclusion::kNoEvidence;
}

Verdict verdict_on(const HypothesisResult& result, const Analysis& analysis,
                   const Possible<double>& p_holm, std::size_t tests) {
    Verdict verdict;
    verdict.hypothesis = result.name;
    verdict.p = p_of(result);
    verdict.p_holm = p_holm;
    verdict.tests = tests;
    const Votes& votes = result.pooled.votes;
    if (!result.pooling.has_value() || votes.n() == 0) {
        verdict.sentence = fmt::format("{}: {}. {}.", result.name, to_string(verdict.conclusion),
                                       result.pooling.has_value() ? "Nobody answered its conditions"
                                                                  : capital(result.pooling.reason));
        return verdict;
    }
    verdict.interval = result.interval->bounds;
    const bool is_tested = is_significant(p_holm);
    verdict.conclusion = conclusion_on(votes, result.interval->bounds, is_tested);
    verdict.sentence = fmt::format(
        "{}: {}. B was chosen in {} of {} ({:.1f} %), {}{}{}. {}.{}", result.name,
        to_string(verdict.conclusion), votes.b, counted(votes.n(), "vote"),
        100.0 * *result.pooled.share_b, test_words(result), corrected_words(p_holm, tests),
        interval_words(*result.interval, is_tested), capital(result.pooling->words),
        is_tested ? "" : needed_words(analysis, result.name));
    return verdict;
}

/// The two levels that may still differ most; nothing where none were compared.
struct Widest {
    const Comparison* comparison = nullptr;
    const LevelDifference* difference = nullptr;
    double reach = 0.0;
};

Widest widest_of(const ValidityResult& validity) {
    Widest widest;
    for (const Comparison& comparison : validity.by_level) {
        for (const LevelDifference& difference : comparison.differences) {
            const double reach =
                std::max(std::abs(difference.interval.low), std::abs(difference.interval.high));
            if (widest.comparison == nullptr || reach > widest.reach) {
                widest = {&comparison, &difference, reach};
            }
        }
    }
    return widest;
}

std::string difference_words(const Widest& widest) {
    const LevelDifference& difference = *widest.difference;
    return fmt::format(
        " The share of B of {} against {}{}{} changes by {:+.1f} points from {} to {} (95 % "
        "interval {:+.1f} to {:+.1f}), which {}.",
        widest.comparison->variant_a, widest.comparison->variant_b,
        widest.comparison->view.empty() ? "" : " in ", widest.comparison->view,
        100.0 * difference.difference, widest.comparison->levels[difference.from],
        widest.comparison->levels[difference.to], 100.0 * difference.interval.low,
        100.0 * difference.interval.high,
        reaches_relevant_difference(difference.interval)
            ? fmt::format("leaves a difference of {:g} points or more possible",
                          100.0 * kRelevantDifference)
            : fmt::format("excludes a difference of {:g} points or more",
                          100.0 * kRelevantDifference));
}

Verdict not_tested(const ValidityResult& validity, const std::string& why) {
    Verdict verdict;
    verdict.hypothesis = validity.name;
    verdict.is_on_validity = true;
    verdict.p = Possible<PValue>::none(why);
    verdict.p_holm = Possible<double>::none(why);
    verdict.interval = Possible<Interval>::none(why);
    verdict.sentence =
        fmt::format("{}: {}. {}.", validity.name, to_string(verdict.conclusion), capital(why));
    return verdict;
}

Verdict verdict_on_validity(const ValidityResult& validity, const Family& family,
                            const std::vector<std::optional<std::size_t>>& places) {
    const Widest widest = widest_of(validity);
    if (validity.by_level.empty()) return not_tested(validity, validity.no_comparison);
    if (widest.comparison == nullptr) {
        return not_tested(validity, "nobody answered two of the conditions that are compared");
    }
    Verdict verdict;
    verdict.hypothesis = validity.name;
    verdict.is_on_validity = true;
    verdict.tests = family.size();
    verdict.interval = widest.difference->interval;
    std::string tests;
    for (std::size_t i = 0; i < validity.by_level.size(); ++i) {
        const Comparison& comparison = validity.by_level[i];
        const auto p = p_of(comparison);
        const Possible<double> p_holm = family.at(places[i]);
        tests += fmt::format(" {}: {}{}.", what_is_compared(comparison), test_words(comparison),
                             corrected_words(p_holm, family.size()));
        if (!p.has_value() || (verdict.p.has_value() && verdict.p->p <= p->p)) continue;
        verdict.p = *p;
        verdict.p_holm = p_holm;
    }
    if (is_significant(verdict.p_holm)) {
        verdict.conclusion = Conclusion::kEvidenceFor;
    } else {
        verdict.conclusion = reaches_relevant_difference(widest.difference->interval)
                                 ? Conclusion::kTooFew
                                 : Conclusion::kNoEvidence;
    }
    verdict.sentence =
        fmt::format("{}: {}.{}", validity.name, to_string(verdict.conclusion), tests);
    if (verdict.conclusion != Conclusion::kEvidenceFor) {
        verdict.sentence += difference_words(widest);
    }
    if (!validity.without_partner.empty()) {
        verdict.sentence += ' ' + partner_words(validity.without_partner);
    }
    return verdict;
}

std::string change_words(std::string_view what, std::string_view with, std::string_view without) {
    return fmt::format("{}: {} without those left out, {} with everybody.", what, with, without);
}

}  // namespace

std::string_view to_string(Conclusion conclusion) {
    switch (conclusion) {
        case Conclusion::kNoEvidence:
            return "no evidence";
        case Conclusion::kEvidenceFor:
            return "evidence for";
        case Conclusion::kEvidenceAgainst:
            return "evidence against";
        case Conclusion::kTooFew:
            return "too few participants to say";
        case Conclusion::kNotTested:
            return "not tested";
    }
    return "";
}

std::string verdict_rule() {
    return fmt::format(
        "Verdicts: each hypothesis has one test of its pooled votes (by flipping the signs of the "
        "participants' preferences where every answer is known, chi-square where only counts "
        "are). Votes are pooled where B means the same in each condition. Where the study asks "
        "whether the preference depends on validity, that has one test for every two variants "
        "shown in the same scene at several levels. Holm's correction is over all of these. "
        "Corrected p below {:g}: evidence for where B was chosen more often, against where A was; "
        "for validity, evidence for. Otherwise: too few participants to say where the 95 % "
        "interval holds a share of {:g} % or more of either image (validity: a difference of {:g} "
        "points or more between two levels), no evidence where it does not. Not tested: nothing "
        "could be compared. The interval is of participants drawn anew, and no narrower than if "
        "all votes were independent; where fewer than {} answered or nobody varies, "
        "Clopper-Pearson's with each participant counted once; from counts, Wilson's in the same "
        "way. That of a difference between levels is from the exact limits of how many changed "
        "their answer; from counts, Newcombe's.",
        kSignificance, 100.0 * kRelevantShare, 100.0 * kRelevantDifference, kFewestResampled);
}

ShareReach reach_of(const Interval& interval) {
    constexpr double kShown = 0.0005;  // half of what the last digit shown stands for
    return {interval.high + kShown >= kRelevantShare,
            interval.low - kShown <= 1.0 - kRelevantShare};
}

bool reaches_relevant_difference(const Interval& interval) {
    constexpr double kShown = 0.0005;
    return std::max(std::abs(interval.low), std::abs(interval.high)) + kShown >=
           kRelevantDifference;
}

std::vector<Verdict> verdicts_of(const Analysis& analysis) {
    Family family;
    std::vector<const HypothesisResult*> pooled;
    std::vector<std::optional<std::size_t>> pooled_places;
    for (const HypothesisResult& result : analysis.hypotheses) {
        pooled.push_back(&result);
        pooled_places.push_back(family.add(p_of(result)));
    }
    std::vector<std::optional<std::size_t>> level_places;
    if (analysis.validity.has_value()) {
        for (const Comparison& comparison : analysis.validity->by_level) {
            level_places.push_back(family.add(p_of(comparison)));
        }
    }
    family.correct();
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < pooled.size(); ++i) {
        verdicts.push_back(
            verdict_on(*pooled[i], analysis, family.at(pooled_places[i]), family.size()));
    }
    if (analysis.validity.has_value()) {
        verdicts.push_back(verdict_on_validity(*analysis.validity, family, level_places));
    }
    std::stable_sort(
        verdicts.begin(), verdicts.end(),
        [](const Verdict& one, const Verdict& other) { return one.hypothesis < other.hypothesis; });
    return verdicts;
}

std::vector<std::string> changed_conclusions(const Analysis& analysis, const Analysis& everybody) {
    std::vector<std::string> changes;
    for (std::size_t i = 0; i < analysis.verdicts.size(); ++i) {
        const Verdict& one = analysis.verdicts[i];
        const Verdict& other = everybody.verdicts[i];
        if (one.conclusion == other.conclusion) continue;
        changes.push_back(
            change_words(one.hypothesis, to_string(one.conclusion), to_string(other.conclusion)));
    }
    const auto words = [](const ConditionResult& result) {
        return is_significant(result.p_holm) ? "significant after Holm's correction"
                                             : "not significant";
    };
    for (std::size_t i = 0; i < analysis.conditions.size(); ++i) {
        const std::string_view one = words(analysis.conditions[i]);
        const std::string_view other = words(everybody.conditions[i]);
        if (one == other) continue;
        changes.push_back(
            change_words("condition " + analysis.conditions[i].condition.id, one, other));
    }
    return changes;
}

}  // namespace obscura::analysis
