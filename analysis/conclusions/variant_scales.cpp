// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/variant_scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "analysis/conclusions/participants.h"
#include "analysis/direction.h"

namespace obscura::analysis {
namespace {

/// The variants of all conditions, and the votes of each pair of them together, parted by the order
/// of showing where that is known.
struct Pairs {
    std::vector<std::string> variants;
    std::vector<PairVotes> votes;
    /// Of each condition: the pair when its B is shown first, and second; whether its A is `one`.
    struct Place {
        std::size_t pair[2] = {0, 0};
        bool a_is_one = true;
        bool is_known = false;  ///< not for a variant against itself
    };
    std::vector<Place> places;
};

class PairList {
  public:
    explicit PairList(bool knows_order) : knows_order_(knows_order) {}

    void add(const ConditionVotes& condition) {
        Pairs::Place& place = pairs_.places.emplace_back();
        const std::size_t a = variant(condition.variant_a);
        const std::size_t b = variant(condition.variant_b);
        if (a == b) return;  // a variant against itself says nothing about the scale
        place.is_known = true;
        place.a_is_one = a < b;
        const auto [one, other] = std::minmax(a, b);
        if (!knows_order_ || condition.answers.empty()) {
            place.pair[0] = place.pair[1] = pair(one, other, 0);
            count(place, 0, false, condition.votes.a);
            count(place, 0, true, condition.votes.b);
            return;
        }
        for (const bool b_second : {false, true}) {
            place.pair[b_second ? 1 : 0] = pair(one, other, b_second == place.a_is_one ? -1 : 1);
        }
        for (const Answer& answer : condition.answers) {
            count(place, answer.b_second ? 1 : 0, answer.chose_b, 1);
        }
    }
    [[nodiscard]] Pairs take() { return std::move(pairs_); }

  private:
    std::size_t variant(const std::string& name) {
        const auto [entry, is_new] = variants_.emplace(name, pairs_.variants.size());
        if (is_new) pairs_.variants.push_back(name);
        return entry->second;
    }
    std::size_t pair(std::size_t one, std::size_t other, int order_side) {
        const auto [entry, is_new] =
            places_.emplace(std::tuple(one, other, order_side), pairs_.votes.size());
        if (is_new) pairs_.votes.push_back({one, other, 0, 0, order_side});
        return entry->second;
    }
    void count(const Pairs::Place& place, std::size_t order, bool chose_b, std::int64_t votes) {
        PairVotes& sum = pairs_.votes[place.pair[order]];
        (chose_b != place.a_is_one ? sum.one_chosen : sum.other_chosen) += votes;
    }

    bool knows_order_;
    Pairs pairs_;
    std::unordered_map<std::string, std::size_t> variants_;
    std::map<std::tuple<std::size_t, std::size_t, int>, std::size_t> places_;
};

/// The variants and votes of one group, by their places in it.
struct Group {
    std::vector<std::string> variants;  ///< the reference first
    std::vector<PairVotes> votes;
    std::vector<std::size_t> pair_of;  ///< of each pair of all: its place in `votes`; size(): none
    bool is_too_large = false;
};

Group group_of(const Pairs& pairs, std::vector<std::size_t> members) {
    const auto reference = std::find_if(members.begin(), members.end(), [&](std::size_t variant) {
        return assumed_rank(pairs.variants[variant]) == 0;
    });
    if (reference != members.end()) std::rotate(members.begin(), reference, reference + 1);
    Group group;
    std::unordered_map<std::size_t, std::size_t> place;
    for (const std::size_t variant : members) {
        place.emplace(variant, group.variants.size());
        group.variants.push_back(pairs.variants[variant]);
    }
    group.is_too_large = members.size() > kMaxScaled;
    group.pair_of.assign(pairs.votes.size(), pairs.votes.size());
    for (std::size_t i = 0; i < pairs.votes.size(); ++i) {
        const PairVotes& pair = pairs.votes[i];
        // A pair without votes may lie between groups.
        if (!place.contains(pair.one) || !place.contains(pair.other)) continue;
        group.pair_of[i] = group.votes.size();
        group.votes.push_back({place.at(pair.one), place.at(pair.other), pair.one_chosen,
                               pair.other_chosen, pair.order_side});
        group.is_too_large |= std::max(pair.one_chosen, pair.other_chosen) > kMaxCount;
    }
    return group;
}

VotesOfEach votes_of(const Tally& tally, const VotesByParticipant& by_participant,
                     const Pairs& pairs, const Group& group) {
    VotesOfEach each;
    for (std::size_t who = 0; who < tally.participants.size(); ++who) {
        for (const auto& vote : by_participant.of(who)) {
            const Pairs::Place& place = pairs.places[vote.condition];
            if (!place.is_known) continue;
            const Answer& answer = by_participant.answer(vote);
            const std::size_t pair = group.pair_of[place.pair[answer.b_second ? 1 : 0]];
            if (pair == pairs.votes.size()) continue;
            each.votes.push_back({pair, answer.chose_b != place.a_is_one});
        }
        if (each.begin.back() < each.votes.size()) each.begin.push_back(each.votes.size());
    }
    return each;
}

/// The prior of kScalePriorJod on the link's own unit.
double prior_sd(ScaleLink link) {
    return kScalePriorJod * (link == ScaleLink::kJod ? 1.0 : std::log(3.0));
}

/// The fits with one way of looking at the votes; nothing but reasons where one of them fails.
bool fit(VariantScale& scale, const Group& group, bool order_term, bool has_prior,
         const VotesOfEach* each) {
    for (const ScaleLink link : {ScaleLink::kLogistic, ScaleLink::kJod}) {
        const ScaleOptions options{link, 0, order_term, has_prior ? prior_sd(link) : 0.0};
        Possible<Scale>& own = link == ScaleLink::kJod ? scale.thurstone : scale.bradley_terry;
        own = fit_scale(group.variants, group.votes, options);
        if (!own.has_value()) return false;
        if (each == nullptr || has_prior) continue;
        const Possible<Scale> robust = with_participants_errors(*own, group.votes, options, *each);
        if (robust.has_value()) own = robust;
    }
    scale.has_order_term = order_term;
    return true;
}

std::vector<Interval> intervals_of(const Scale& jod, double quantile) {
    std::vector<Interval> intervals;
    for (std::size_t i = 0; i < jod.values.size(); ++i) {
        const double reach = quantile * jod.standard_errors[i];
        intervals.push_back({jod.values[i] - reach, jod.values[i] + reach});
    }
    return intervals;
}

VariantScale scale_of(const Group& group, const VotesOfEach* each) {
    VariantScale scale;
    scale.variants = group.variants;
    if (group.is_too_large) {
        const std::string why =
            fmt::format("more than {} variants or {} votes of a pair", kMaxScaled, kMaxCount);
        scale.bradley_terry = scale.thurstone = Possible<Scale>::none(why);
        return scale;
    }
    const bool knows_order =
        std::any_of(group.votes.begin(), group.votes.end(),
                    [](const PairVotes& pair) { return pair.order_side != 0; });
    const auto participants =
        each == nullptr ? 0 : static_cast<std::int64_t>(each->begin.size()) - 1;
    const bool are_few = each != nullptr && participants < kFewestForMeans;
    const VotesOfEach* const robust = are_few ? nullptr : each;
    scale.errors = each == nullptr ? ScaleErrors::kVotes : ScaleErrors::kParticipants;
    bool is_fitted = knows_order && fit(scale, group, true, false, robust);
    if (!is_fitted) is_fitted = fit(scale, group, false, false, robust);
    if (!is_fitted) {
        const std::string why =
            scale.bradley_terry.has_value() ? scale.thurstone.reason : scale.bradley_terry.reason;
        if (!fit(scale, group, false, true, nullptr)) return scale;
        scale.separated = why;
        scale.errors = ScaleErrors::kPrior;
    }
    using Intervals = Possible<std::vector<Interval>>;
    if (are_few && scale.errors != ScaleErrors::kPrior) {
        scale.jod_intervals =
            Intervals::none(fmt::format("fewer than {} participants", kFewestForMeans));
        return scale;
    }
    const double tail = (1.0 - kConfidence) / 2.0;
    const double quantile =
        scale.errors == ScaleErrors::kParticipants
            ? boost::math::quantile(boost::math::complement(
                  boost::math::students_t(static_cast<double>(participants) - 1.0), tail))
            : boost::math::quantile(boost::math::complement(boost::math::normal(), tail));
    scale.jod_intervals = intervals_of(*scale.thurstone, quantile);
    return scale;
}

}  // namespace

std::vector<VariantScale> variant_scales(const Tally& tally) {
    PairList list(tally.order.has_value());
    for (const ConditionVotes& condition : tally.conditions) list.add(condition);
    const Pairs pairs = list.take();
    std::vector<VariantScale> scales;
    const VotesByParticipant by_participant(tally);
    for (std::vector<std::size_t>& members : connected_groups(pairs.variants.size(), pairs.votes)) {
        if (members.size() < 2) continue;
        const Group group = group_of(pairs, std::move(members));
        if (tally.participants.empty()) {
            scales.push_back(scale_of(group, nullptr));
        } else {
            const VotesOfEach each = votes_of(tally, by_participant, pairs, group);
            scales.push_back(scale_of(group, &each));
        }
    }
    return scales;
}

}  // namespace obscura::analysis
