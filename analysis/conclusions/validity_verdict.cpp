// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/validity_verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "analysis/conclusions/hypotheses.h"
#include "analysis/conclusions/verdicts.h"
#include "analysis/conclusions/words.h"

namespace obscura::analysis {
namespace {

/// The two levels that may still differ most; nothing where none were compared.
struct Widest {
    const Comparison* comparison = nullptr;
    const LevelDifference* difference = nullptr;
    double reach = 0.0;
};

Widest widest_of(std::span<const Comparison> comparisons) {
    Widest widest;
    for (const Comparison& comparison : comparisons) {
        for (const LevelDifference& difference : comparison.differences) {
            const double reach =
                std::max(std::abs(difference.equality.low), std::abs(difference.equality.high));
            if (widest.comparison == nullptr || reach > widest.reach) {
                widest = {&comparison, &difference, reach};
            }
        }
    }
    return widest;
}

ComparedVerdict compared_verdict(const Comparison& comparison, const Possible<double>& p_holm) {
    const Widest widest = widest_of({&comparison, 1});
    return {comparison.conditions, p_of(comparison), p_holm,
            widest.difference == nullptr ? Possible<Interval>::none("nobody answered both")
                                         : widest.difference->interval};
}

/// The two levels that differ most.
const LevelDifference* largest_of(const Comparison& comparison) {
    const auto largest =
        std::max_element(comparison.differences.begin(), comparison.differences.end(),
                         [](const LevelDifference& one, const LevelDifference& other) {
                             return std::abs(one.difference) < std::abs(other.difference);
                         });
    return largest == comparison.differences.end() ? nullptr : &*largest;
}

std::string difference_words(const Widest& widest, double margin) {
    const LevelDifference& difference = *widest.difference;
    const bool reaches = reaches_difference(difference.equality, margin);
    return fmt::format(
        " The share of B of {} against {}{}{} changes by {:+.1f} points from {} to {} (95 % "
        "interval {:+.1f} to {:+.1f}, 90 % interval {:+.1f} to {:+.1f}), which {}.",
        widest.comparison->variant_a, widest.comparison->variant_b,
        widest.comparison->view.empty() ? "" : " in ", widest.comparison->view,
        100.0 * difference.difference, widest.comparison->levels[difference.from],
        widest.comparison->levels[difference.to], 100.0 * difference.interval.low,
        100.0 * difference.interval.high, 100.0 * difference.equality.low,
        100.0 * difference.equality.high,
        fmt::format("{} a difference of {} or more{}", reaches ? "leaves" : "excludes",
                    points_words(margin), reaches ? " possible" : ""));
}

Verdict not_tested(const ValidityResult& validity, const std::string& why) {
    Verdict verdict;
    verdict.hypothesis = validity.name;
    verdict.statement = validity.statement;
    verdict.is_on_validity = true;
    verdict.is_primary = validity.is_primary;
    verdict.margin = validity.margin;
    verdict.p = Possible<PValue>::none(why);
    verdict.p_holm = Possible<double>::none(why);
    verdict.interval = Possible<Interval>::none(why);
    verdict.equality = Possible<Interval>::none(why);
    verdict.sentence =
        fmt::format("{}: {}. {}.", validity.name, verdict_words(verdict), capital(why));
    return verdict;
}

/// What follows from the test with the smallest p and from the difference that may be largest.
void conclude_on_validity(Verdict& verdict, const Comparison* clearest, Widest& shown) {
    if (verdict.is_primary ? is_significant(verdict.p_holm) : is_significant(verdict.p)) {
        verdict.conclusion = Conclusion::kDiffers;
        const LevelDifference* difference = largest_of(*clearest);
        if (difference == nullptr) return;
        shown = {clearest, difference, 0.0};
        verdict.is_small = !reaches_difference(difference->equality, verdict.margin);
        const bool is_more = difference->difference > 0.0;
        verdict.direction =
            fmt::format("B more often at {} than at {}",
                        clearest->levels[is_more ? difference->to : difference->from],
                        clearest->levels[is_more ? difference->from : difference->to]);
    } else {
        verdict.conclusion = reaches_difference(shown.difference->equality, verdict.margin)
                                 ? Conclusion::kUndecided
                                 : Conclusion::kSame;
    }
}

}  // namespace

Verdict verdict_on_validity(const ValidityResult& validity, const CorrectedTests& family,
                            const std::vector<std::size_t>& places) {
    Widest shown = widest_of(validity.by_level);
    if (validity.by_level.empty()) return not_tested(validity, validity.no_comparison);
    if (shown.comparison == nullptr) {
        return not_tested(validity, "nobody answered two of the conditions that are compared");
    }
    Verdict verdict;
    verdict.hypothesis = validity.name;
    verdict.statement = validity.statement;
    verdict.is_on_validity = true;
    verdict.is_primary = validity.is_primary;
    verdict.margin = validity.margin;
    verdict.tests = family.size();
    std::string tests;
    const Comparison* clearest = nullptr;
    for (std::size_t i = 0; i < validity.by_level.size(); ++i) {
        const Comparison& comparison = validity.by_level[i];
        const auto p = p_of(comparison);
        const Possible<double> p_holm =
            verdict.is_primary ? family.at(places[i]) : Possible<double>::none(kSecondary);
        tests += fmt::format(" {}: {}{}.", what_is_compared(comparison), test_words(comparison),
                             family.words(p_holm, verdict.is_primary));
        verdict.compared.push_back(compared_verdict(comparison, p_holm));
        if (!p.has_value() || (verdict.p.has_value() && verdict.p->p <= p->p)) continue;
        verdict.p = *p;
        verdict.p_holm = p_holm;
        clearest = &comparison;
    }
    conclude_on_validity(verdict, clearest, shown);
    verdict.interval = shown.difference->interval;
    verdict.equality = shown.difference->equality;
    verdict.sentence = fmt::format("{}: {}.{}{}", validity.name, verdict_words(verdict), tests,
                                   difference_words(shown, verdict.margin));
    if (!validity.without_partner.empty()) {
        verdict.sentence += ' ' + partner_words(validity.without_partner);
    }
    return verdict;
}

}  // namespace obscura::analysis
