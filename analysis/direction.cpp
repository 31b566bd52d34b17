// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/direction.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>
#include <utility>
#include <vector>

#include "analysis/text/natural_order.h"

namespace obscura::analysis {
namespace {

struct Ranked {
    std::string_view stem;  ///< of a variant's name, in small letters
    int rank;
};
constexpr int kOthers = 4;
constexpr std::array kRanked{
    Ranked{"none", 0},     Ranked{"crytek", 1},    Ranked{"blizzard", 2}, Ranked{"raymarching", 3},
    Ranked{"raymarch", 3}, Ranked{"reference", 5}, Ranked{"raytraced", 5}};

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    for (char& letter : small) {
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    return small;
}

bool is_letter(char character) { return std::isalpha(static_cast<unsigned char>(character)) != 0; }

/// The name's technique, where it is a ranked one and the name goes on with no further letter.
const Ranked* ranked(std::string_view small) {
    const auto found = std::find_if(kRanked.begin(), kRanked.end(), [&](const Ranked& technique) {
        return small.starts_with(technique.stem) &&
               (small.size() == technique.stem.size() || !is_letter(small[technique.stem.size()]));
    });
    return found == kRanked.end() ? nullptr : &*found;
}

int samples_behind(std::string_view small, std::string_view stem) {
    small.remove_prefix(stem.size());
    while (!small.empty() && (small.front() == ' ' || small.front() == '-' || small.front() == '_'))
        small.remove_prefix(1);
    int samples = 0;
    const auto [end, error] = std::from_chars(small.data(), small.data() + small.size(), samples);
    return error == std::errc() && samples > 0 ? samples : 0;
}

/// Whether it names its pair the other way round than the study, or else the rule, does.
bool is_turned(const ConditionEntry& condition, const Names& names) {
    if (condition.study_a != 0) return condition.study_a == condition.variant_b;
    return is_a_of(names[condition.variant_b], names[condition.variant_a]);
}

void exchange_sides(AnswerEntry& answer) {
    const auto other = [](char side) { return side == 'A' ? 'B' : 'A'; };
    answer.a_selected = !answer.a_selected;
    answer.first_shown = other(answer.first_shown);
    if (answer.expected != 0) answer.expected = other(answer.expected);
}

}  // namespace

std::optional<int> assumed_rank(std::string_view variant) {
    const Ranked* technique = ranked(in_small_letters(variant));
    return technique == nullptr ? std::nullopt : std::optional(technique->rank);
}

int samples_in_name(std::string_view variant) {
    const std::string small = in_small_letters(variant);
    const Ranked* technique = ranked(small);
    return technique == nullptr ? 0 : samples_behind(small, technique->stem);
}

bool is_a_of(std::string_view one, std::string_view other) {
    const int rank_of_one = assumed_rank(one).value_or(kOthers);
    const int rank_of_other = assumed_rank(other).value_or(kOthers);
    if (rank_of_one != rank_of_other) return rank_of_one < rank_of_other;
    const int samples_of_one = samples_in_name(one);
    const int samples_of_other = samples_in_name(other);
    if (samples_of_one != samples_of_other) return samples_of_one < samples_of_other;
    const std::string small_one = in_small_letters(one);
    const std::string small_other = in_small_letters(other);
    if (small_one != small_other) return naturally_before(small_one, small_other);
    return naturally_before(one, other);
}

void settle_direction(AnswerTable& table) {
    const std::vector<ConditionEntry> before = table.conditions;
    std::vector<bool> turned(before.size());
    std::vector<std::uint32_t> place(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
        turned[i] = is_turned(before[i], table.names);
        ConditionEntry settled = before[i];
        if (turned[i]) std::swap(settled.variant_a, settled.variant_b);
        place[i] = table.place_of(settled);
    }
    for (AnswerEntry& answer : table.answers) {
        if (turned[answer.condition]) exchange_sides(answer);
        answer.condition = place[answer.condition];
        // What has no meaning must not differ with the way round a row stood.
        if (!table.order_unknown.empty()) answer.first_shown = 'A';
    }
}

}  // namespace obscura::analysis
