// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/verdicts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/conclusions/corrected_tests.h"
#include "analysis/conclusions/hypotheses.h"
#include "analysis/conclusions/pooled_share.h"
#include "analysis/conclusions/validity_verdict.h"
#include "analysis/conclusions/words.h"
#include "analysis/text/natural_order.h"

namespace obscura::analysis {
namespace {

std::string kind_words(ShareIntervalKind kind) {
    switch (kind) {
        case ShareIntervalKind::kMeans:
            return "t over participants";
        case ShareIntervalKind::kEachOnce:
            return "Clopper-Pearson, each participant counted once";
        case ShareIntervalKind::kCounts:
            return "Clopper-Pearson, each participant counted once because the votes of one may be "
                   "alike";
    }
    return "";
}

std::string bounds_words(const Interval& interval) {
    return fmt::format("{:.1f} to {:.1f} %", 100.0 * interval.low, 100.0 * interval.high);
}

/// The intervals, and what the narrower one says of shares that a study cares about.
std::string interval_words(const HypothesisResult& result, bool is_tested) {
    const ShareInterval& interval = *result.interval;
    const ShareInterval& equality = *result.equality_interval;
    std::string text = fmt::format("; the 95 % interval is {} ({}), the 90 % interval {}",
                                   bounds_words(interval.bounds), kind_words(interval.kind),
                                   bounds_words(equality.bounds));
    if (equality.kind != interval.kind) text += fmt::format(" ({})", kind_words(equality.kind));
    const ShareReach reach = reach_of(equality.bounds, result.margin);
    const double relevant = 100.0 * (0.5 + result.margin);
    if (!reach.for_a && !reach.for_b) {
        return text +
               fmt::format(", which excludes shares of {:g} % or more of either image", relevant);
    }
    if (is_tested) return text;
    return text + fmt::format(", which leaves a share of {} of {:g} % or more possible",
                              reach.for_a && reach.for_b ? "either image"
                              : reach.for_b              ? "B"
                                                         : "A",
                              relevant);
}

Verdict verdict_on(const HypothesisResult& result, const Possible<double>& p_holm,
                   const CorrectedTests& family) {
    Verdict verdict;
    verdict.hypothesis = result.name;
    verdict.statement = result.statement;
    verdict.is_primary = result.is_primary;
    verdict.margin = result.margin;
    verdict.p = p_of(result);
    verdict.p_holm = p_holm;
    verdict.tests = family.size();
    const Votes& votes = result.pooled.votes;
    if (!result.pooling.has_value() || votes.n() == 0) {
        verdict.sentence = fmt::format("{}: {}. {}.", result.name, verdict_words(verdict),
                                       result.pooling.has_value() ? "Nobody answered its conditions"
                                                                  : capital(result.pooling.reason));
        return verdict;
    }
    verdict.interval = result.interval->bounds;
    verdict.equality = result.equality_interval->bounds;
    const bool is_tested = verdict.is_primary ? is_significant(p_holm) : is_significant(verdict.p);
    const ShareReach reach = reach_of(*verdict.equality, result.margin);
    const bool is_within = !reach.for_a && !reach.for_b;
    if (is_tested) {
        verdict.conclusion = votes.b > votes.a ? Conclusion::kBPreferred : Conclusion::kAPreferred;
        verdict.is_small = is_within;
    } else {
        verdict.conclusion = is_within ? Conclusion::kEqual : Conclusion::kUndecided;
    }
    verdict.sentence = fmt::format(
        "{}: {}. B was chosen in {} of {} ({:.1f} %), {}{}{}. {}.", result.name,
        verdict_words(verdict), votes.b, counted(votes.n(), "vote"), 100.0 * *result.pooled.share_b,
        test_words(result), family.words(p_holm, verdict.is_primary),
        interval_words(result, is_tested), capital(result.pooling->words));
    if (!result.unanswered.empty()) {
        verdict.sentence +=
            fmt::format(" Nobody answered {}, which it takes too.", listed(result.unanswered));
    }
    return verdict;
}

/// More participants will come: that nothing matters is not concluded before.
void take_back_equality(Verdict& verdict) {
    if (verdict.conclusion != Conclusion::kEqual && verdict.conclusion != Conclusion::kSame) return;
    const std::string before = verdict_words(verdict);
    verdict.conclusion = Conclusion::kUndecided;
    const std::size_t place = verdict.sentence.find(before);
    if (place != std::string::npos) {
        verdict.sentence.replace(place, before.size(),
                                 verdict_words(verdict) + " as long as participants are to come");
    }
}

std::string change_words(std::string_view what, std::string_view with, std::string_view without) {
    return fmt::format("{}: {} without those left out, {} with everybody.", what, with, without);
}

}  // namespace

std::string to_string(Conclusion conclusion, double margin) {
    switch (conclusion) {
        case Conclusion::kUndecided:
            return "undecided";
        case Conclusion::kBPreferred:
            return "B preferred over A";
        case Conclusion::kAPreferred:
            return "A preferred over B";
        case Conclusion::kEqual:
            return fmt::format("practically equal (within {})", points_words(margin));
        case Conclusion::kDiffers:
            return "the effect differs with lighting";
        case Conclusion::kSame:
            return fmt::format("equal within {}", points_words(margin));
        case Conclusion::kNotTested:
            return "not tested";
    }
    return "";
}

std::string verdict_words(const Verdict& verdict) {
    std::string words = to_string(verdict.conclusion, verdict.margin);
    if (!verdict.direction.empty()) words += ", " + verdict.direction;
    if (verdict.is_small) {
        words += fmt::format("{} by less than the relevant {}",
                             verdict.direction.empty() ? "" : ",", points_words(verdict.margin));
    }
    return words;
}

std::string verdict_rule() {
    return fmt::format(
        "Verdicts: each hypothesis has one test of its pooled votes (by flipping the signs of the "
        "participants' preferences where every answer is known; the exact binomial test, each "
        "participant counted once, where only counts are). Votes are pooled where B means the same "
        "in each condition. Where the study "
        "asks "
        "whether the preference depends on validity, that has one test for every two variants "
        "shown in the same scene at several levels: McNemar's exact test over two, Cochran's Q "
        "over more, and where several conditions show a level the test by flipping the signs of "
        "the participants' changes between every two levels. Holm's correction is over all of "
        "these, whoever answered: a test that could not be computed counts as p = 1. Secondary "
        "hypotheses are no part of it: their p stands alone, and so what they say is a hint. The "
        "margin is {1} around one half, or between two levels, where the study fixes no other. "
        "Corrected p below {0:g}: one image is preferred, by less than the relevant {1} where the "
        "90 % interval lies within {2:g} to {3:g} %; for validity, the effect differs. Otherwise, "
        "where the 90 % interval lies within {2:g} to {3:g} % (validity: every difference between "
        "levels within {1}): practically equal, by two one-sided tests at {0:g}, "
        "uncorrected; else undecided. "
        "Not tested: nothing could be compared. Intervals are t's over participants, whose votes "
        "hang together; Clopper-Pearson's with each participant counted once where each voted "
        "once, where nobody differs from the others, where fewer than {4} answered, and from "
        "counts alone. Those of a difference between levels are t's of the participants' own "
        "changes, of one pair of conditions from the exact limits of how many changed their "
        "answer; from counts, Newcombe's.",
        kSignificance, points_words(kRelevantDifference), 100.0 * (1.0 - kRelevantShare),
        100.0 * kRelevantShare, kFewestForMeans);
}

ShareReach reach_of(const Interval& interval, double margin) {
    constexpr double kShown = 0.0005;  // half of what the last digit shown stands for
    return {interval.high + kShown >= 0.5 + margin, interval.low - kShown <= 0.5 - margin};
}

bool reaches_difference(const Interval& interval, double margin) {
    constexpr double kShown = 0.0005;
    return std::max(std::abs(interval.low), std::abs(interval.high)) + kShown >= margin;
}

std::vector<Verdict> verdicts_of(const Analysis& analysis) {
    CorrectedTests family(analysis.look);
    std::vector<std::size_t> pooled_places;
    for (const HypothesisResult& result : analysis.hypotheses) {
        pooled_places.push_back(result.is_primary ? family.add(p_of(result)) : 0);
    }
    std::vector<std::size_t> level_places;
    if (analysis.validity.has_value()) {
        const ValidityResult& validity = *analysis.validity;
        for (const Comparison& comparison : validity.by_level) {
            level_places.push_back(validity.is_primary ? family.add(p_of(comparison)) : 0);
        }
        // What could not be compared is a test all the same.
        for (std::size_t i = level_places.size();
             validity.is_primary && i < std::max<std::size_t>(validity.planned, 1); ++i) {
            (void)family.add(Possible<PValue>::none("nothing to compare"));
        }
    }
    family.correct();
    std::vector<Verdict> verdicts;
    for (std::size_t i = 0; i < analysis.hypotheses.size(); ++i) {
        const HypothesisResult& result = analysis.hypotheses[i];
        verdicts.push_back(verdict_on(
            result,
            result.is_primary ? family.at(pooled_places[i]) : Possible<double>::none(kSecondary),
            family));
    }
    if (analysis.validity.has_value()) {
        verdicts.push_back(verdict_on_validity(*analysis.validity, family, level_places));
    }
    if (analysis.look.has_value() && analysis.look->spending != Spending::kNone &&
        analysis.look->is_interim) {
        for (Verdict& verdict : verdicts) take_back_equality(verdict);
    }
    std::stable_sort(verdicts.begin(), verdicts.end(),
                     [](const Verdict& one, const Verdict& other) {
                         return naturally_before(one.hypothesis, other.hypothesis);
                     });
    return verdicts;
}

std::vector<std::string> changed_conclusions(const Analysis& analysis, const Analysis& everybody) {
    std::vector<std::string> changes;
    for (std::size_t i = 0; i < analysis.verdicts.size(); ++i) {
        const Verdict& one = analysis.verdicts[i];
        const Verdict& other = everybody.verdicts[i];
        const std::string with = verdict_words(one);
        const std::string without = verdict_words(other);
        if (with != without) changes.push_back(change_words(one.hypothesis, with, without));
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
