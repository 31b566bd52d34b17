// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/variant_scales.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>
#include <utility>

#include "analysis/direction.h"
#include "analysis/statistics/bradley_terry.h"
#include "analysis/statistics/thurstone.h"

namespace obscura::analysis {
namespace {

/// The variants of all conditions, and the votes of each pair of them together.
struct Pairs {
    std::vector<std::string> variants;
    std::vector<PairVotes> votes;
};

Pairs pairs_of(const Tally& tally) {
    Pairs pairs;
    std::unordered_map<std::string, std::size_t> place;
    std::map<std::pair<std::size_t, std::size_t>, Votes> votes;
    const auto place_of = [&](const std::string& variant) {
        const auto [entry, is_new] = place.emplace(variant, pairs.variants.size());
        if (is_new) pairs.variants.push_back(variant);
        return entry->second;
    };
    for (const ConditionVotes& condition : tally.conditions) {
        const std::size_t a = place_of(condition.variant_a);
        const std::size_t b = place_of(condition.variant_b);
        if (a == b) continue;  // a variant against itself says nothing about the scale
        Votes& sum = votes[std::minmax(a, b)];
        sum.a += a < b ? condition.votes.a : condition.votes.b;
        sum.b += a < b ? condition.votes.b : condition.votes.a;
    }
    for (const auto& [pair, sum] : votes) {
        pairs.votes.push_back({pair.first, pair.second, sum.a, sum.b});
    }
    return pairs;
}

VariantScale scale_of(const Pairs& pairs, const std::vector<const PairVotes*>& own,
                      std::vector<std::size_t> group, ScaleParts parts) {
    const auto reference = std::find_if(group.begin(), group.end(), [&](std::size_t variant) {
        return assumed_rank(pairs.variants[variant]) == 0;
    });
    if (reference != group.end()) std::rotate(group.begin(), reference, reference + 1);
    VariantScale scale;
    std::unordered_map<std::size_t, std::size_t> place;
    for (const std::size_t variant : group) {
        place.emplace(variant, scale.variants.size());
        scale.variants.push_back(pairs.variants[variant]);
    }
    std::vector<PairVotes> votes;
    bool is_too_large = group.size() > kMaxScaled;
    for (const PairVotes* one_of : own) {
        const PairVotes& pair = *one_of;
        votes.push_back(
            {place.at(pair.one), place.at(pair.other), pair.one_chosen, pair.other_chosen});
        is_too_large |= std::max(pair.one_chosen, pair.other_chosen) > kMaxCount;
    }
    if (is_too_large) {
        const std::string why =
            fmt::format("more than {} variants or {} votes of a pair", kMaxScaled, kMaxCount);
        scale.bradley_terry = scale.thurstone = Possible<Scale>::none(why);
        return scale;
    }
    if (parts == ScaleParts::kBoth) scale.bradley_terry = bradley_terry(scale.variants, votes);
    scale.thurstone = thurstone_jod(scale.variants, votes);
    return scale;
}

}  // namespace

std::vector<VariantScale> variant_scales(const Tally& tally, ScaleParts parts) {
    const Pairs pairs = pairs_of(tally);
    const auto groups = connected_groups(pairs.variants.size(), pairs.votes);
    std::vector<std::size_t> group_of(pairs.variants.size());
    for (std::size_t i = 0; i < groups.size(); ++i) {
        for (const std::size_t variant : groups[i]) group_of[variant] = i;
    }
    std::vector<std::vector<const PairVotes*>> votes(groups.size());
    for (const PairVotes& pair : pairs.votes) {
        // A pair without votes may lie between groups.
        if (group_of[pair.one] == group_of[pair.other]) votes[group_of[pair.one]].push_back(&pair);
    }
    std::vector<VariantScale> scales;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i].size() > 1) scales.push_back(scale_of(pairs, votes[i], groups[i], parts));
    }
    return scales;
}

}  // namespace obscura::analysis
