// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "analysis/tally.h"
#include "renderer/base/random.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// How simulated observers choose: wherever one is simulated, by this.
struct ChoiceModel {
    /// By condition index, 0 to 1: the share of B among observers to whom nothing else matters.
    std::vector<double> probability_of_b;
    std::vector<std::string> unpublished;  ///< conditions without votes, which get 1/2
    /// By condition index: that of the condition whose images it shows, another one where it is a
    /// repeat. Empty: each shows its own.
    std::vector<std::size_t> shown = {};
    /// By condition index: whether it is an attention check, in which only the careless differ.
    /// Empty: none is.
    std::vector<bool> is_check = {};
    /// By condition index: whether an observer who likes B elsewhere likes A there. Empty: nowhere.
    std::vector<bool> turned = {};
    /// Standard deviation of an observer's own liking of B, in log odds, the same in all
    /// conditions; from 0.
    double sd = 0.0;
    /// How often the second image is chosen of two that are alike, more than 0 and less than 1.
    double order_bias = 0.5;
    /// Share of observers who answer by chance whatever they see, 0 to 1.
    double careless = 0.0;
};

/// Probabilities from votes: count_b / (count_a + count_b) for a condition of the same id and the
/// same two variants, else 1/2. An attention check is mostly answered as expected; a
/// repeat has the probability of what it repeats.
[[nodiscard]] ChoiceModel choices_from(const stimuli::Study& study, const analysis::Tally& votes);

/// Gives that share of B to a condition and to what repeats it; to all but attention checks where
/// `id` is empty.
void set_share(ChoiceModel& model, const stimuli::Study& study, const std::string& id,
               double share);

/// One observer: what he likes, and what he remembers.
class Observer {
  public:
    /// Both must outlive him. Draws what is his own.
    Observer(const ChoiceModel& model, base::Random& random);

    /// Whether he chooses B. Of a pair seen before he often remembers his answer.
    [[nodiscard]] bool chooses_b(std::size_t condition, bool b_second);

  private:
    [[nodiscard]] double probability_of_b(std::size_t condition, bool b_second) const;

    const ChoiceModel& model_;
    base::Random& random_;
    double liking_ = 0.0;  ///< in standard deviations
    bool is_careless_ = false;
    std::map<std::size_t, bool> chosen_;  ///< by the condition shown: whether it was B
};

/// A draw from the standard normal distribution.
[[nodiscard]] double draw_normal(base::Random& random);

/// The seed of the observer of that number, from the study's.
[[nodiscard]] std::uint64_t observer_seed(std::uint64_t study_seed, std::uint64_t number);

}  // namespace obscura::app::kiosk
