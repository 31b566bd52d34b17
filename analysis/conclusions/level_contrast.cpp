// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/level_contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "analysis/statistics/mean_test.h"
#include "analysis/statistics/sign_flip.h"

namespace obscura::analysis {
namespace {

using Conditions = std::vector<const ConditionVotes*>;

/// The votes of one participant in one condition.
struct Own {
    std::uint16_t n = 0;
    std::uint16_t b = 0;
};

/// Where a condition stands.
struct Place {
    std::size_t scene = 0;
    bool is_second = false;  ///< of the two levels
};

class Answered {
  public:
    Answered(const Conditions& conditions, const std::string& first)
        : conditions_(conditions.size()) {
        std::vector<std::string> scenes;
        std::int64_t participants = 0;
        for (const ConditionVotes* condition : conditions) {
            const auto known = std::find(scenes.begin(), scenes.end(), condition->view);
            const auto scene = static_cast<std::size_t>(known - scenes.begin());
            if (known == scenes.end()) scenes.push_back(condition->view);
            places_.push_back({scene, condition->validity != first});
            for (const Answer& answer : condition->answers) {
                participants = std::max<std::int64_t>(participants, answer.participant + 1);
            }
        }
        shown_.resize(scenes.size());
        for (const Place& place : places_) ++shown_[place.scene][place.is_second ? 1 : 0];
        votes_.resize(static_cast<std::size_t>(participants) * conditions_);
        for (std::size_t i = 0; i < conditions_; ++i) {
            for (const Answer& answer : conditions[i]->answers) {
                Own& own = votes_[static_cast<std::size_t>(answer.participant) * conditions_ + i];
                ++own.n;
                if (answer.chose_b) ++own.b;
            }
        }
    }

    [[nodiscard]] std::size_t participants() const { return votes_.size() / conditions_; }
    [[nodiscard]] std::size_t scenes() const { return shown_.size(); }
    [[nodiscard]] bool answered_any(std::size_t who) const {
        return any_of(who, [](const Own& own) { return own.n > 0; });
    }
    [[nodiscard]] bool answered_all_once(std::size_t who) const {
        return !any_of(who, [](const Own& own) { return own.n != 1; });
    }
    [[nodiscard]] bool repeated(std::size_t who) const {
        return any_of(who, [](const Own& own) { return own.n > 1; });
    }

    /// The factor that makes the differences of those who answered all whole numbers.
    [[nodiscard]] std::int64_t factor() const {
        std::int64_t factor = 1;
        for (const auto& levels : shown_) {
            for (const std::int64_t conditions : levels) factor = std::lcm(factor, conditions);
        }
        return factor;
    }

    /// factor() times the sum of the differences over scenes.
    [[nodiscard]] std::int64_t whole_difference(std::size_t who) const {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < conditions_; ++i) {
            const std::int64_t weight =
                factor() / shown_[places_[i].scene][places_[i].is_second ? 1 : 0];
            sum += (places_[i].is_second ? weight : -weight) * votes_[who * conditions_ + i].b;
        }
        return sum;
    }

    /// The mean difference over the scenes that he saw at both levels; nothing where he saw none.
    [[nodiscard]] std::optional<double> difference(std::size_t who) const {
        std::vector<std::array<Votes, 2>> votes(scenes());
        for (std::size_t i = 0; i < conditions_; ++i) {
            const Own& own = votes_[who * conditions_ + i];
            Votes& sum = votes[places_[i].scene][places_[i].is_second ? 1 : 0];
            sum.a += own.n - own.b;
            sum.b += own.b;
        }
        double sum = 0.0;
        int both = 0;
        for (const auto& [first, second] : votes) {
            if (first.n() == 0 || second.n() == 0) continue;
            ++both;
            sum += static_cast<double>(second.b) / static_cast<double>(second.n()) -
                   static_cast<double>(first.b) / static_cast<double>(first.n());
        }
        if (both == 0) return std::nullopt;
        return sum / both;
    }

  private:
    template <typename Holds>
    [[nodiscard]] bool any_of(std::size_t who, Holds holds) const {
        const auto begin = votes_.begin() + static_cast<std::ptrdiff_t>(who * conditions_);
        return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(conditions_), holds);
    }

    std::size_t conditions_;
    std::vector<Place> places_;
    std::vector<std::array<std::int64_t, 2>> shown_;  ///< of each scene: conditions at each level
    std::vector<Own> votes_;
};

/// By t; where all differ alike, by what a participant who differs from them may add: with this
/// confidence no more than that share of people does.
Interval interval_of(const std::vector<double>& differences, double confidence) {
    const auto test = mean_test(differences, confidence);
    if (test.has_value()) {
        return {std::max(-1.0, test->interval.low), std::min(1.0, test->interval.high)};
    }
    const double all = differences.front();
    const double others =
        1.0 - std::pow((1.0 - confidence) / 2.0, 1.0 / static_cast<double>(differences.size()));
    return {all - others * (1.0 + all), all + others * (1.0 - all)};
}

}  // namespace

Possible<LevelContrast> level_contrast(const Conditions& conditions, const std::string& first) {
    using None = Possible<LevelContrast>;
    for (const ConditionVotes* condition : conditions) {
        if (condition->answers.empty())
            return None::none("the answers of each participant are not known");
    }
    const Answered answered(conditions, first);
    std::int64_t some = 0;
    std::int64_t complete = 0;
    bool repeated = false;
    for (std::size_t who = 0; who < answered.participants(); ++who) {
        if (answered.answered_any(who)) ++some;
        if (answered.answered_all_once(who)) ++complete;
        repeated |= answered.repeated(who);
    }
    constexpr std::int64_t kMostFactor = 10'000;
    const bool is_whole = !repeated && 2 * complete >= some && answered.factor() <= kMostFactor;
    const double unit =
        static_cast<double>(answered.factor()) * static_cast<double>(answered.scenes());
    std::vector<std::int64_t> whole;
    std::vector<double> differences;
    for (std::size_t who = 0; who < answered.participants(); ++who) {
        if (is_whole) {
            if (!answered.answered_all_once(who)) continue;
            whole.push_back(answered.whole_difference(who));
            differences.push_back(static_cast<double>(whole.back()) / unit);
        } else if (const auto difference = answered.difference(who)) {
            differences.push_back(*difference);
        }
    }
    if (differences.empty()) return None::none("nobody answered at both levels of a scene");
    LevelContrast contrast;
    contrast.n = static_cast<std::int64_t>(differences.size());
    contrast.left_out = some - contrast.n;
    contrast.scenes = answered.scenes();
    const auto test = is_whole ? sign_flip(whole) : sign_flip_nearly(differences);
    contrast.is_exact = test.has_value() ? test->is_exact : is_whole;
    if (test.has_value()) contrast.p = test->p;
    contrast.difference = std::accumulate(differences.begin(), differences.end(), 0.0) /
                          static_cast<double>(differences.size());
    contrast.interval = interval_of(differences, kConfidence);
    contrast.equality = interval_of(differences, kEqualityConfidence);
    return contrast;
}

}  // namespace obscura::analysis
