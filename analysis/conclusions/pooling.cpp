// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/pooling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/direction.h"

namespace obscura::analysis {
namespace {

using Conditions = std::vector<const ConditionVotes*>;

bool is_none(const std::string& variant) { return assumed_rank(variant) == 0; }

/// Each different text once, in the order of the conditions.
template <typename Text>
std::string each_once(const Conditions& conditions, Text text_of) {
    std::vector<std::string> texts;
    for (const ConditionVotes* condition : conditions) {
        std::string text = text_of(*condition);
        if (std::find(texts.begin(), texts.end(), text) == texts.end()) {
            texts.push_back(std::move(text));
        }
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

Possible<Pooling> same_variants(const Conditions& conditions) {
    const ConditionVotes& first = *conditions.front();
    Pooling pooling;
    for (const ConditionVotes* condition : conditions) {
        const bool is_turned = condition->variant_a != first.variant_a;
        const std::string& a = is_turned ? condition->variant_b : condition->variant_a;
        const std::string& b = is_turned ? condition->variant_a : condition->variant_b;
        if (a != first.variant_a || b != first.variant_b) {
            return Possible<Pooling>::none("other variants");
        }
        pooling.turned.push_back(is_turned);
    }
    pooling.words = fmt::format("A is {} and B is {}", first.variant_a, first.variant_b);
    return pooling;
}

Possible<Pooling> with_and_without(const Conditions& conditions) {
    Pooling pooling;
    for (const ConditionVotes* condition : conditions) {
        if (is_none(condition->variant_a) == is_none(condition->variant_b)) {
            return Possible<Pooling>::none("not against None");
        }
        pooling.turned.push_back(is_none(condition->variant_b));
    }
    pooling.words = fmt::format(
        "A is the image without ambient occlusion and B the one with it: {}",
        each_once(conditions, [](const ConditionVotes& condition) {
            return is_none(condition.variant_a) ? condition.variant_b : condition.variant_a;
        }));
    return pooling;
}

Possible<Pooling> by_accuracy(const Conditions& conditions) {
    Pooling pooling;
    for (const ConditionVotes* condition : conditions) {
        const auto a = assumed_rank(condition->variant_a);
        const auto b = assumed_rank(condition->variant_b);
        const int samples_a = samples_in_name(condition->variant_a);
        const int samples_b = samples_in_name(condition->variant_b);
        if (!a || !b || (*a == *b && samples_a == samples_b)) {
            return Possible<Pooling>::none("not ranked");
        }
        pooling.turned.push_back(*a != *b ? *b < *a : samples_b < samples_a);
    }
    std::size_t place = 0;
    pooling.words = fmt::format(
        "B is the more accurate and A the less accurate in the order that the thesis assumes "
        "(None, "
        "Crytek, Blizzard, ray marching, reference; of one technique more samples): {}",
        each_once(conditions, [&](const ConditionVotes& condition) {
            const bool is_turned = pooling.turned[place++];
            return fmt::format("{} over {}", is_turned ? condition.variant_a : condition.variant_b,
                               is_turned ? condition.variant_b : condition.variant_a);
        }));
    return pooling;
}

}  // namespace

Possible<Pooling> pooling_of(const Conditions& conditions) {
    for (const auto pool : {same_variants, with_and_without, by_accuracy}) {
        Possible<Pooling> pooling = pool(conditions);
        if (pooling.has_value()) return pooling;
    }
    return Possible<Pooling>::none(fmt::format(
        "its conditions compare different variants ({}), and nothing says which of each is the "
        "same thing, so their votes are not added up",
        each_once(conditions, [](const ConditionVotes& condition) {
            return fmt::format("{} against {}", condition.variant_a, condition.variant_b);
        })));
}

}  // namespace obscura::analysis
