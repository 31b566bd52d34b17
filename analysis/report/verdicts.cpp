// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/report/verdicts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/statistics/holm.h"
#include "analysis/statistics/resampling.h"

namespace obscura::analysis {
namespace {

/// The test that the verdict on pooled votes rests on.
Possible<PValue> p_of(const HypothesisResult& result) {
    if (result.by_participant.has_value()) return result.by_participant->p;
    if (!result.pooled.chi_square.has_value()) {
        return Possible<PValue>::none(result.pooled.chi_square.reason);
    }
    return result.pooled.chi_square->p;
}

std::string pooled_test_words(const HypothesisResult& result) {
    if (result.by_participant.has_value()) {
        const SignFlipTest& test = *result.by_participant;
        return fmt::format(
            "{} test over participants by flipping signs, {} of them with a "
            "preference, p {}",
            test.is_exact ? "exact" : "large-sample", test.participants, p_text(test.p));
    }
    if (!result.pooled.chi_square.has_value()) return result.pooled.chi_square.reason;
    return fmt::format(
        "chi-square {:.4g}, df 1, p {}, with votes of the same participants taken "
        "as independent",
        result.pooled.chi_square->statistic, p_text(result.pooled.chi_square->p));
}

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
    return fmt::format(" ({} after Holm's correction for {} test{})", p_text({*p_holm, -300.0}),
                       tests, tests == 1 ? "" : "s");
}

bool is_significant(const Possible<double>& p) { return p.has_value() && *p < kSignificance; }

std::string needed_words(const Analysis& analysis, const std::string& name) {
    if (!analysis.power.has_value()) return "";
    for (const RunPower::Needed& needed : analysis.power->hypotheses) {
        if (needed.name != name || !needed.exact.has_value()) continue;
        return fmt::format(
            " To detect the observed share with {:g} % power, {} participants with "
            "one vote each would have been needed.",
            100.0 * kAskedPower, *needed.exact);
    }
    return "";
}

/// What an interval says where the test says nothing.
std::string interval_words(const Possible<Bounds>& interval) {
    if (!interval.has_value()) return fmt::format("; no interval, {}", interval.reason);
    const bool is_open = interval->high >= kRelevantShare || interval->low <= 1.0 - kRelevantShare;
    return fmt::format("; the 95 % interval {:.1f} to {:.1f} % {} a share of {:g} %",
                       100.0 * interval->low, 100.0 * interval->high,
                       is_open ? "does not exclude" : "excludes", 100.0 * kRelevantShare);
}

Verdict verdict_on(const HypothesisResult& result, const Analysis& analysis,
                   const Possible<double>& p_holm, std::size_t tests) {
    Verdict verdict;
    verdict.hypothesis = result.name;
    verdict.p = p_of(result);
    verdict.p_holm = p_holm;
    const Votes& votes = result.pooled.votes;
    const Possible<Bounds> interval = verdict_interval(result, analysis.tally);
    const bool excludes = interval.has_value() && interval->high < kRelevantShare &&
                          interval->low > 1.0 - kRelevantShare;
    if (is_significant(p_holm)) {
        verdict.conclusion =
            votes.b > votes.a ? Conclusion::kEvidenceFor : Conclusion::kEvidenceAgainst;
    } else {
        verdict.conclusion = excludes ? Conclusion::kNoEvidence : Conclusion::kTooFew;
    }
    if (votes.n() == 0) {
        verdict.sentence =
            fmt::format("{}: {}, there are no votes.", result.name, to_string(verdict.conclusion));
        return verdict;
    }
    verdict.sentence = fmt::format(
        "{}: {}. B was chosen in {} of {} votes ({:.1f} %), {}{}{}.{}", result.name,
        to_string(verdict.conclusion), votes.b, votes.n(), 100.0 * *result.pooled.share_b,
        pooled_test_words(result), corrected_words(p_holm, tests), interval_words(interval),
        is_significant(p_holm) ? "" : needed_words(analysis, result.name));
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
        " The share of B of {} against {} changes by {:+.1f} points from {} to {} (95 % interval "
        "{:+.1f} to {:+.1f}), which {} a difference of {:g} points.",
        widest.comparison->variant_a, widest.comparison->variant_b, 100.0 * difference.difference,
        widest.comparison->levels[difference.from], widest.comparison->levels[difference.to],
        100.0 * difference.interval.low, 100.0 * difference.interval.high,
        widest.reach < kRelevantDifference ? "excludes" : "does not exclude",
        100.0 * kRelevantDifference);
}

/// The pair of single conditions that differ most clearly, each for itself.
std::string pair_words(const ValidityResult& validity) {
    const Comparison* clearest = nullptr;
    for (const Comparison& pair : validity.by_pair) {
        const auto p = p_of(pair);
        if (p.has_value() && (clearest == nullptr || p->p < p_of(*clearest)->p)) clearest = &pair;
    }
    if (clearest == nullptr) return "";
    return fmt::format(
        " Of single pairs, {} ({}) and {} ({}) differ most clearly: p {}, not "
        "corrected.",
        clearest->conditions[0], clearest->levels[0], clearest->conditions[1], clearest->levels[1],
        p_text(*p_of(*clearest)));
}

Verdict verdict_on_validity(const ValidityResult& validity, const Family& family,
                            const std::vector<std::optional<std::size_t>>& places) {
    Verdict verdict;
    verdict.hypothesis = std::string(kValidityHypothesis);
    std::string tests;
    for (std::size_t i = 0; i < validity.by_level.size(); ++i) {
        const Comparison& comparison = validity.by_level[i];
        const auto p = p_of(comparison);
        const Possible<double> p_holm = family.at(places[i]);
        tests += fmt::format(" {} against {} over {}: {}{}.", comparison.variant_a,
                             comparison.variant_b, fmt::join(comparison.levels, ", "),
                             test_words(comparison), corrected_words(p_holm, family.size()));
        if (!p.has_value() || (verdict.p.has_value() && verdict.p->p <= p->p)) continue;
        verdict.p = *p;
        verdict.p_holm = p_holm;
    }
    const Widest widest = widest_of(validity);
    if (is_significant(verdict.p_holm)) {
        verdict.conclusion = Conclusion::kEvidenceFor;
    } else if (widest.comparison != nullptr && widest.reach < kRelevantDifference) {
        verdict.conclusion = Conclusion::kNoEvidence;
    }
    verdict.sentence = fmt::format("{}: {}.", kValidityHypothesis, to_string(verdict.conclusion));
    if (validity.by_level.empty()) {
        verdict.sentence += " No two variants were shown at more than one level of validity.";
        return verdict;
    }
    verdict.sentence += tests;
    if (widest.comparison != nullptr) verdict.sentence += difference_words(widest);
    verdict.sentence += pair_words(validity);
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
    }
    return "";
}

std::string verdict_rule() {
    return fmt::format(
        "Verdicts: each hypothesis has one test of its pooled votes (by flipping the signs of the "
        "participants' preferences where every answer is known, chi-square where only counts "
        "are), and H3 one for every two variants shown at several levels of validity; Holm's "
        "correction is over all of these. Corrected p below {:g}: evidence for where B was chosen "
        "more often, against where A was; for H3, evidence for. Otherwise: too few participants "
        "to say where the 95 % interval does not exclude a share of B of {:g} or more, or of {:g} "
        "or less (H3: a difference of {:g} between two levels), or fewer than {} participants "
        "answered; no evidence where it excludes them.",
        kSignificance, kRelevantShare, 1.0 - kRelevantShare, kRelevantDifference, kFewestResampled);
}

Possible<Bounds> verdict_interval(const HypothesisResult& result, const Tally& tally) {
    if (result.resampled.has_value()) return result.resampled;
    const bool knows_participants = !tally.participants.empty();
    if (knows_participants && *tally.n_participants < kFewestResampled) return result.resampled;
    if (!result.pooled.wilson.has_value()) {
        return Possible<Bounds>::none(result.pooled.wilson.reason);
    }
    return Bounds{result.pooled.wilson->low, result.pooled.wilson->high};
}

std::vector<Verdict> verdicts_of(const Analysis& analysis) {
    Family family;
    std::vector<const HypothesisResult*> pooled;
    std::vector<std::optional<std::size_t>> pooled_places;
    for (const HypothesisResult& result : analysis.hypotheses) {
        if (result.name == kValidityHypothesis) continue;
        pooled.push_back(&result);
        pooled_places.push_back(family.add(p_of(result)));
    }
    std::vector<std::optional<std::size_t>> level_places;
    for (const Comparison& comparison : analysis.validity.by_level) {
        level_places.push_back(family.add(p_of(comparison)));
    }
    family.correct();
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < pooled.size(); ++i) {
        verdicts.push_back(
            verdict_on(*pooled[i], analysis, family.at(pooled_places[i]), family.size()));
    }
    verdicts.push_back(verdict_on_validity(analysis.validity, family, level_places));
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
