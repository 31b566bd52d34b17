// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/validity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <tuple>

#include "analysis/conclusions/level_contrast.h"
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
        std::map<std::pair<std::string, std::string>, std::string> as_a;
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
            // Of every scene the same variant is A: that of the first condition with the two.
            const auto called_a = as_a.emplace(std::minmax(a, b), a).first;
            families_[entry->second].push_back(called_a->second == a ? &condition
                                                                     : turned(condition));
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

    /// The same, with those of the same two variants beside each other, in order of their first.
    [[nodiscard]] std::vector<std::vector<SamePair>> by_variants() const {
        std::vector<std::vector<SamePair>> groups;
        for (const SamePair& family : at_several_levels()) {
            const auto is_same = [&](const std::vector<SamePair>& group) {
                return is_of_variants(family, *group.front().front());
            };
            const auto known = std::find_if(groups.begin(), groups.end(), is_same);
            if (known == groups.end()) {
                groups.push_back({family});
            } else {
                known->push_back(family);
            }
        }
        return groups;
    }

    [[nodiscard]] bool is_turned(const ConditionVotes* condition) const {
        return std::any_of(turned_.begin(), turned_.end(),
                           [&](const ConditionVotes& own) { return &own == condition; });
    }

  private:
    static constexpr std::size_t kLevels = 3;

    static bool is_of_variants(const SamePair& family, const ConditionVotes& other) {
        return family.front()->variant_a == other.variant_a &&
               family.front()->variant_b == other.variant_b;
    }

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
    if (comparison.contrast.has_value()) {
        const LevelContrast& contrast = *comparison.contrast;
        differences.push_back({0, 1, contrast.difference, contrast.interval, contrast.equality,
                               DifferenceKind::kContrast});
        return differences;
    }
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
    if (comparison.votes.size() == 2 && family.size() > 2) {
        comparison.contrast = level_contrast(family, comparison.levels.front());
    }
    comparison.differences = differences_of(comparison, family);
    return comparison;
}

/// Every two conditions of a scene at different levels.
std::vector<Comparison> pairs_of(const SamePair& family, const Families& families) {
    std::vector<Comparison> pairs;
    if (family.size() > kMostPairedConditions) return pairs;
    for (std::size_t i = 0; i < family.size(); ++i) {
        for (std::size_t j = i + 1; j < family.size(); ++j) {
            if (family[i]->validity == family[j]->validity || family[i]->view != family[j]->view) {
                continue;
            }
            pairs.push_back(comparison_of({family[i], family[j]}, families));
        }
    }
    return pairs;
}

bool is_once_a_level(const SamePair& family) {
    return std::adjacent_find(family.begin(), family.end(), [](const auto* one, const auto* other) {
               return one->validity == other->validity;
           }) == family.end();
}

/// The names of what is seen, each once.
std::string views_of(const SamePair& family) {
    std::vector<std::string> views;
    for (const ConditionVotes* condition : family) {
        if (std::find(views.begin(), views.end(), condition->view) == views.end()) {
            views.push_back(condition->view);
        }
    }
    return listed(views);
}

/// Of one scene that shows each level once, all levels together; else every two levels, over the
/// scenes that show both. `scenes`: the conditions of each, all with the same two variants.
std::vector<SamePair> compared(const std::vector<SamePair>& scenes) {
    if (scenes.size() == 1 && is_once_a_level(scenes.front())) return scenes;
    std::vector<SamePair> compared;
    constexpr std::array<std::pair<const char*, const char*>, 3> kTwo{
        std::pair{"low", "moderate"}, {"low", "high"}, {"moderate", "high"}};
    for (const auto& [one, other] : kTwo) {
        SamePair both;
        for (const SamePair& scene : scenes) {
            const SamePair own = at_levels(scene, one, other);
            if (own.empty() || own.front()->validity == own.back()->validity) continue;
            both.insert(both.end(), own.begin(), own.end());
        }
        std::stable_partition(both.begin(), both.end(),
                              [first = std::string_view(one)](const ConditionVotes* condition) {
                                  return condition->validity == first;
                              });
        if (!both.empty()) compared.push_back(both);
    }
    return compared;
}

/// Whatever a study shows that can be compared.
std::vector<SamePair> all_compared(const Families& families) {
    std::vector<SamePair> all;
    for (const std::vector<SamePair>& scenes : families.by_variants()) {
        for (SamePair& family : compared(scenes)) all.push_back(std::move(family));
    }
    return all;
}

/// The pairs that a study fixed, as far as somebody answered them.
std::vector<SamePair> planned_pairs(const PlannedHypothesis& planned, const Families& families) {
    std::vector<SamePair> pairs;
    for (const auto& ids : planned.pairs) {
        if (SamePair own = families.of(ids); !own.empty()) pairs.push_back(std::move(own));
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
        case DifferenceKind::kContrast:
            return "t of the same participants' differences";
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
    for (const SamePair& pair :
         planned == nullptr ? all_compared(families) : planned_pairs(*planned, families)) {
        result.by_level.push_back(comparison_of(pair, families));
        if (planned == nullptr) result.by_level.back().view = views_of(pair);
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
