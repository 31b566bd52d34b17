// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/validity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <map>
#include <tuple>

#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/same_participants.h"
#include "analysis/conclusions/words.h"
#include "analysis/direction.h"
#include "analysis/statistics/fisher_exact.h"
#include "analysis/statistics/paired_difference.h"
#include "analysis/statistics/share_difference.h"

namespace obscura::analysis {
namespace {

/// Conditions that show the same two variants in the same view, in order of the levels.
using SamePair = std::vector<const ConditionVotes*>;

/// Conditions grouped by what they compare, all of a group with the same variant called A.
class Families {
  public:
    /// `by_view`: whether different views are different things.
    Families(const Tally& tally, bool by_view) {
        std::map<std::tuple<std::string, std::string, std::string>, std::size_t> place;
        for (const ConditionVotes& condition : tally.conditions) {
            if (level_number(condition.validity) == kLevels || (by_view && condition.view.empty()))
                continue;
            auto [a, b] = std::tie(condition.variant_a, condition.variant_b);
            const bool is_turned = is_a_of(b, a);
            const auto [entry, is_new] =
                place.emplace(std::tuple(is_turned ? b : a, is_turned ? a : b,
                                         by_view ? condition.view : std::string()),
                              families_.size());
            if (is_new) families_.emplace_back();
            SamePair& family = families_[entry->second];
            const bool as_first = family.empty() || family.front()->variant_a == a;
            family.push_back(as_first ? &condition : turned(condition));
        }
        for (SamePair& family : families_) {
            std::stable_sort(family.begin(), family.end(), [](const auto* one, const auto* other) {
                return level_number(one->validity) < level_number(other->validity);
            });
        }
    }

    /// Those that show two levels or more.
    [[nodiscard]] std::vector<SamePair> at_several_levels() const {
        std::vector<SamePair> several;
        for (const SamePair& family : families_) {
            if (family.front()->validity != family.back()->validity) several.push_back(family);
        }
        return several;
    }

    /// The conditions of those ids, where they are all of one group.
    [[nodiscard]] SamePair of(const std::vector<std::string>& ids) const {
        for (const SamePair& family : families_) {
            SamePair own;
            for (const ConditionVotes* condition : family) {
                if (std::find(ids.begin(), ids.end(), condition->id) != ids.end()) {
                    own.push_back(condition);
                }
            }
            if (own.size() == ids.size()) return own;
        }
        return {};
    }

    [[nodiscard]] bool is_turned(const ConditionVotes* condition) const {
        return std::any_of(turned_.begin(), turned_.end(),
                           [&](const ConditionVotes& own) { return &own == condition; });
    }

  private:
    static constexpr std::size_t kLevels = 3;

    const ConditionVotes* turned(const ConditionVotes& condition) {
        ConditionVotes& copy = turned_.emplace_back(condition);
        std::swap(copy.variant_a, copy.variant_b);
        std::swap(copy.votes.a, copy.votes.b);
        for (Answer& answer : copy.answers) {
            answer.chose_b = !answer.chose_b;
            answer.b_second = !answer.b_second;
        }
        return &copy;
    }

    std::vector<SamePair> families_;
    std::deque<ConditionVotes> turned_;
};

std::vector<const ConditionVotes*> at_levels(const SamePair& family, const std::string& one,
                                             const std::string& other) {
    SamePair both;
    for (const ConditionVotes* condition : family) {
        if (condition->validity == one || condition->validity == other) both.push_back(condition);
    }
    return both;
}

/// Of every two levels: of the same participants where they answered each once, else from counts.
std::vector<LevelDifference> differences_of(const Comparison& comparison, const SamePair& family) {
    std::vector<LevelDifference> differences;
    for (std::size_t from = 0; from < comparison.votes.size(); ++from) {
        for (std::size_t to = from + 1; to < comparison.votes.size(); ++to) {
            const auto same = same_participants(
                at_levels(family, comparison.levels[from], comparison.levels[to]));
            if (same.has_value()) {
                const auto interval = paired_difference(same->changed, same->n, kConfidence);
                const auto equality =
                    paired_difference(same->changed, same->n, kEqualityConfidence);
                const auto n = static_cast<double>(same->n);
                differences.push_back({from, to,
                                       static_cast<double>(same->changed.b - same->changed.a) / n,
                                       *interval, *equality, DifferenceKind::kPaired});
                continue;
            }
            const Votes& one = comparison.votes[from];
            const Votes& other = comparison.votes[to];
            const auto interval = share_difference(one, other, kConfidence);
            if (!interval.has_value()) continue;
            const double difference =
                static_cast<double>(other.b) / static_cast<double>(other.n()) -
                static_cast<double>(one.b) / static_cast<double>(one.n());
            differences.push_back({from, to, difference, *interval,
                                   *share_difference(one, other, kEqualityConfidence),
                                   DifferenceKind::kCounts});
        }
    }
    return differences;
}

Comparison comparison_of(const SamePair& family, const Families& families) {
    Comparison comparison;
    comparison.variant_a = family.front()->variant_a;
    comparison.variant_b = family.front()->variant_b;
    comparison.view = family.front()->view;
    for (const ConditionVotes* condition : family) {
        if (comparison.levels.empty() || comparison.levels.back() != condition->validity) {
            comparison.levels.push_back(condition->validity);
            comparison.votes.emplace_back();
        }
        if (condition->view != comparison.view) comparison.view.clear();
        comparison.conditions.push_back(condition->id);
        comparison.turned.push_back(families.is_turned(condition));
        comparison.votes.back().a += condition->votes.a;
        comparison.votes.back().b += condition->votes.b;
    }
    comparison.test = chi_square_homogeneity(comparison.votes);
    if (comparison.votes.size() == 2) {
        comparison.fisher = fisher_exact(comparison.votes[0], comparison.votes[1]);
    }
    comparison.same_participants = same_participants(family);
    comparison.differences = differences_of(comparison, family);
    return comparison;
}

/// Every two conditions at different levels.
std::vector<Comparison> pairs_of(const SamePair& family, const Families& families) {
    std::vector<Comparison> pairs;
    if (family.size() > kMostPairedConditions) return pairs;
    for (std::size_t i = 0; i < family.size(); ++i) {
        for (std::size_t j = i + 1; j < family.size(); ++j) {
            if (family[i]->validity == family[j]->validity) continue;
            pairs.push_back(comparison_of({family[i], family[j]}, families));
        }
    }
    return pairs;
}

/// With the test that fits what is known.
std::string sentence_of(const Comparison& comparison) {
    const Possible<PValue> p = p_of(comparison);
    if (!p.has_value()) return test_words(comparison);
    return fmt::format("{}: {}", test_words(comparison),
                       p->p < kSignificance ? "the levels differ, taken for itself"
                                            : "no significant difference between the levels");
}

std::string sentence_of(const ValidityResult& result) {
    std::string sentence = "Does the preference depend on validity?";
    if (result.by_level.empty()) sentence += ' ' + capital(result.no_comparison) + '.';
    for (const Comparison& comparison : result.by_level) {
        sentence += fmt::format(" {}: {}.", what_is_compared(comparison), sentence_of(comparison));
    }
    if (!result.by_level.empty() && !result.without_partner.empty()) {
        sentence += ' ' + partner_words(result.without_partner);
    }
    return sentence;
}

std::vector<std::string> without_partner(const Tally& tally,
                                         const std::vector<Comparison>& comparisons) {
    std::vector<std::string> alone;
    for (const ConditionVotes& condition : tally.conditions) {
        const bool has_partner =
            std::any_of(comparisons.begin(), comparisons.end(), [&](const Comparison& comparison) {
                const auto& ids = comparison.conditions;
                return std::find(ids.begin(), ids.end(), condition.id) != ids.end();
            });
        if (!has_partner) alone.push_back(condition.id);
    }
    return alone;
}

std::string why_none(const Tally& tally) {
    const Families whatever_the_view(tally, false);
    const auto several = whatever_the_view.at_several_levels();
    if (several.empty()) return "the study shows no two variants at two levels of validity";
    const bool knows_views =
        std::all_of(several.begin(), several.end(), [](const SamePair& family) {
            return std::none_of(family.begin(), family.end(),
                                [](const auto* condition) { return condition->view.empty(); });
        });
    return knows_views
               ? "the study shows no two variants in the same scene at two levels of validity"
               : "it is not known which conditions show the same scene";
}

/// A name that no hypothesis of the study has.
std::string name_of(const Tally& tally) {
    const auto is_free = [&](std::string_view name) {
        return std::none_of(
            tally.conditions.begin(), tally.conditions.end(),
            [&](const ConditionVotes& condition) { return condition.hypothesis == name; });
    };
    std::string name = is_built_in(tally) && is_free("H3") ? "H3" : kValidityQuestion;
    while (!is_free(name)) name = "the question about " + name;
    return name;
}

}  // namespace

std::string_view to_string(DifferenceKind kind) {
    switch (kind) {
        case DifferenceKind::kPaired:
            return "same participants";
        case DifferenceKind::kResampled:
            return "participants drawn anew";
        case DifferenceKind::kCounts:
            return "counts";
    }
    return "";
}

Possible<ValidityResult> test_validity(const Tally& tally, const Family& family) {
    const PlannedHypothesis* const planned = family.interaction();
    const bool is_fixed = family.origin == FamilyOrigin::kPlan;
    if (planned == nullptr && !tally.asks_validity && (is_fixed || !is_built_in(tally))) {
        return Possible<ValidityResult>::none("the study does not ask it");
    }
    ValidityResult result;
    if (planned != nullptr) {
        result.name = planned->id;
        result.statement = planned->statement;
        result.margin = planned->margin;
        result.is_primary = planned->is_primary;
        result.planned = planned->pairs.size();
    } else {
        result.name = name_of(tally);
        result.is_primary = !is_fixed;
    }
    // The study vouches for its pairs: what an answer says of its scene may hold the light.
    const Families families(tally, planned == nullptr);
    std::vector<SamePair> compared;
    if (planned == nullptr) {
        compared = families.at_several_levels();
    } else {
        for (const auto& pair : planned->pairs) {
            if (SamePair own = families.of(pair); !own.empty()) compared.push_back(std::move(own));
        }
    }
    for (const SamePair& pair : compared) {
        result.by_level.push_back(comparison_of(pair, families));
        if (pair.size() == 2) continue;
        for (Comparison& two : pairs_of(pair, families)) result.by_pair.push_back(two);
    }
    result.without_partner = without_partner(tally, result.by_level);
    if (result.by_level.empty()) {
        result.no_comparison = planned == nullptr
                                   ? why_none(tally)
                                   : "nobody answered both conditions of a pair that it compares";
    }
    if (is_published_votes(tally)) {
        const Families over_scenes(tally, false);
        for (const SamePair& level : over_scenes.at_several_levels()) {
            result.across_scenes.push_back(comparison_of(level, over_scenes));
        }
    }
    result.sentence = sentence_of(result);
    return result;
}

}  // namespace obscura::analysis
