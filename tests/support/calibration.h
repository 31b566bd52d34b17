// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/tally.h"
#include "renderer/base/random.h"

namespace obscura::tests {

/// How simulated people answer the study of Jakobsen 2010.
struct People {
    std::string name;
    double sd = 0.0;          ///< of a liking for B, log odds, shared over conditions
    double level_sd = 0.0;    ///< the same for each level of validity apart
    double scene_sd = 0.0;    ///< the same for each scene apart
    double pull = 0.0;        ///< log odds of the image shown second
    double careless = 0.0;    ///< share of people who choose the first image always
    bool sides_vary = false;  ///< within a session
    /// Of B in I to VII, for somebody in the middle.
    std::array<double, 7> shares{.5, .5, .5, .5, .5, .5, .5};
};

inline double normal(base::Random& random) {
    // G. E. P. Box and M. E. Muller 1958.
    return std::sqrt(-2.0 * std::log(1.0 - random.uniform())) *
           std::cos(2.0 * 3.14159265358979323846 * random.uniform());
}

/// Of choosing B, for somebody who likes it so much, log odds.
inline double chance_of_b(const People& people, std::size_t condition, bool b_second,
                          double liking) {
    const double share = people.shares[condition];
    const double odds =
        std::log(share / (1.0 - share)) + liking + (b_second ? people.pull : -people.pull);
    return 1.0 / (1.0 + std::exp(-odds));
}

/// The share of B in a condition over all people.
inline double share_of_b(const People& people, std::size_t condition, bool b_second) {
    const double sd = std::sqrt(people.sd * people.sd + people.level_sd * people.level_sd +
                                people.scene_sd * people.scene_sd);
    constexpr double kReach = 8.0;
    constexpr int kSteps = 400;
    double sum = 0.0;
    double weights = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double z = kReach * (2.0 * i / kSteps - 1.0);
        const double weight = std::exp(-z * z / 2.0);
        sum += weight * chance_of_b(people, condition, b_second, sd * z);
        weights += weight;
    }
    return (1.0 - people.careless) * sum / weights + (b_second ? 0.0 : people.careless);
}

/// One study of so many people, as its answers come to the analysis.
inline analysis::Tally study_of(const People& people, int participants, base::Random& random) {
    struct Shown {
        const char *id, *hypothesis, *validity, *a, *b, *view;
    };
    static constexpr std::array<Shown, 7> kShown{
        {{"I", "H2", "low", "Crytek24", "Blizzard24", "relic"},
         {"II", "H1", "moderate", "None", "Blizzard24", "atrium"},
         {"III", "H2", "moderate", "Crytek24", "Blizzard24", "atrium"},
         {"IV", "H2", "moderate", "Blizzard8", "RayMarching30", "figures"},
         {"V", "H1", "high", "None", "Blizzard24", "atrium"},
         {"VI", "H2", "high", "Crytek24", "Blizzard24", "atrium"},
         {"VII", "H1", "high", "None", "Blizzard24", "figures"}}};
    analysis::Tally tally;
    tally.source = "simulated";
    tally.study = "jakobsen2010";
    tally.kind = analysis::Kind::kSimulated;
    tally.n_participants = static_cast<std::int64_t>(participants);
    tally.exclusion = analysis::Possible<analysis::ExclusionRule>::none("the study has no rule");
    for (const Shown& shown : kShown) {
        analysis::ConditionVotes& condition = tally.conditions.emplace_back();
        condition.id = shown.id;
        condition.hypothesis = shown.hypothesis;
        condition.validity = shown.validity;
        condition.variant_a = shown.a;
        condition.variant_b = shown.b;
        condition.view = shown.view;
    }
    analysis::OrderVotes order;
    for (int who = 0; who < participants; ++who) {
        tally.participants.push_back({fmt::format("p{}", who), {}, {}});
        const double liking = people.sd * normal(random);
        const std::array<double, 3> by_level{people.level_sd * normal(random),
                                             people.level_sd * normal(random),
                                             people.level_sd * normal(random)};
        const std::array<double, 3> by_scene{people.scene_sd * normal(random),
                                             people.scene_sd * normal(random),
                                             people.scene_sd * normal(random)};
        const bool is_careless = random.uniform() < people.careless;
        for (std::size_t i = 0; i < kShown.size(); ++i) {
            // Sides are swapped after seven participants, or alternate within a session.
            const bool b_second =
                people.sides_vary ? (static_cast<std::size_t>(who) + i) % 2 == 0 : who / 7 % 2 == 0;
            const std::size_t level = kShown[i].validity[0] == 'l'   ? 0
                                      : kShown[i].validity[0] == 'm' ? 1
                                                                     : 2;
            const std::size_t scene = kShown[i].view[0] == 'r'   ? 0
                                      : kShown[i].view[0] == 'a' ? 1
                                                                 : 2;
            const double own = liking + by_level[level] + by_scene[scene];
            const bool likes_b = random.uniform() < chance_of_b(people, i, b_second, own);
            const bool chose_b = is_careless ? !b_second : likes_b;
            analysis::ConditionVotes& condition = tally.conditions[i];
            condition.answers.push_back({who, chose_b, b_second, static_cast<int>(i), 0.0});
            ++(chose_b ? condition.votes.b : condition.votes.a);
            ++order.n;
            order.second_chosen += chose_b == b_second ? 1 : 0;
        }
    }
    tally.order = order;
    return tally;
}

/// Ways of answering in which no image is preferred over all people, nor at any level.
inline std::vector<People> nobody_prefers() {
    return {{.name = "a"},
            {.name = "b1", .sd = 1.0},
            {.name = "b2", .sd = 2.0},
            {.name = "bl", .level_sd = 2.0},
            {.name = "bs", .scene_sd = 2.0},
            {.name = "order", .sd = 1.0, .pull = .405},
            {.name = "careless", .sd = 1.0, .careless = .2}};
}

/// Preferences that differ between scenes and not between levels.
inline People scenes_differ() {
    return {.name = "scenes", .sd = 1.0, .shares = {.5, .61, .69, .5, .61, .69, .42}};
}

}  // namespace obscura::tests
