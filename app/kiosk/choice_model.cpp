// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/choice_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/base/hash.h"

namespace obscura::app::kiosk {
namespace {

/// How often an attention check is answered as expected, and how often an answer to a pair seen
/// before is the same because it is remembered. Plausible, not measured.
constexpr double kAttentive = 0.95;
constexpr double kRemembered = 0.6;

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

/// The mean of logistic(centre + sd z) over a standard normal z, by the trapezium rule, which is
/// exact to rounding for so smooth a function.
double mean_share(double centre, double sd) {
    constexpr double kReach = 8.0;
    constexpr int kSteps = 160;
    double sum = 0.0;
    double weights = 0.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double z = kReach * (2.0 * i / kSteps - 1.0);
        const double weight = std::exp(-z * z / 2.0);
        sum += weight * logistic(centre + sd * z);
        weights += weight;
    }
    return sum / weights;
}

/// The log odds of an observer in the middle where the share among all of them is that.
double centre_of(double share, double sd) {
    if (share <= 0.0 || share >= 1.0) return share <= 0.0 ? -HUGE_VAL : HUGE_VAL;
    double low = -40.0 * (1.0 + sd);
    double high = -low;
    for (int i = 0; i < 80; ++i) {
        const double middle = (low + high) / 2.0;
        (mean_share(middle, sd) < share ? low : high) = middle;
    }
    return (low + high) / 2.0;
}

/// The same, each pair of numbers looked up once: whoever simulates asks for the same again.
double known_centre(double share, double sd) {
    thread_local std::map<std::pair<double, double>, double> known;
    const auto [place, is_new] = known.emplace(std::pair(share, sd), 0.0);
    if (is_new) place->second = centre_of(share, sd);
    return place->second;
}

bool holds(const std::vector<bool>& flags, std::size_t place) {
    return !flags.empty() && flags.at(place);
}

}  // namespace

ChoiceModel choices_from(const stimuli::Study& study, const analysis::Tally& votes) {
    ChoiceModel model;
    const auto& conditions = study.conditions;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        const stimuli::Condition& condition = conditions[i];
        const stimuli::Condition* original = study.find_condition(condition.repeats);
        model.shown.push_back(
            original == nullptr ? i : static_cast<std::size_t>(original - conditions.data()));
        model.is_check.push_back(condition.expected != '\0');
        if (condition.expected != '\0') {
            model.probability_of_b.push_back(condition.expected == 'B' ? kAttentive
                                                                       : 1.0 - kAttentive);
            continue;
        }
        const std::string& id = original == nullptr ? condition.id : original->id;
        const auto published =
            std::find_if(votes.conditions.begin(), votes.conditions.end(), [&](const auto& row) {
                return row.id == id && row.variant_a == condition.a.variant_name() &&
                       row.variant_b == condition.b.variant_name() && row.votes.a + row.votes.b > 0;
            });
        if (published == votes.conditions.end()) {
            model.probability_of_b.push_back(0.5);
            if (original == nullptr && !condition.practice)
                model.unpublished.push_back(condition.id);
        } else {
            const auto a = static_cast<double>(published->votes.a);
            const auto b = static_cast<double>(published->votes.b);
            model.probability_of_b.push_back(b / (a + b));
        }
    }
    return model;
}

void set_share(ChoiceModel& model, const stimuli::Study& study, const std::string& id,
               double share) {
    for (std::size_t i = 0; i < study.conditions.size(); ++i) {
        const stimuli::Condition& condition = study.conditions[i];
        if (condition.expected != '\0') continue;
        const std::string& shown = condition.repeats.empty() ? condition.id : condition.repeats;
        if (id.empty() || shown == id) model.probability_of_b[i] = share;
    }
}

Observer::Observer(const ChoiceModel& model, base::Random& random)
    : model_(model), random_(random) {
    // What is not asked for draws nothing, so that it changes no other answer.
    if (model.careless > 0.0) is_careless_ = random.uniform() < model.careless;
    if (model.sd > 0.0) liking_ = draw_normal(random);
}

double Observer::probability_of_b(std::size_t condition, bool b_second) const {
    if (is_careless_) return 0.5;
    const double share = model_.probability_of_b.at(condition);
    if (holds(model_.is_check, condition)) return share;
    if (model_.sd == 0.0 && model_.order_bias == 0.5) return share;
    const double bias = std::log(model_.order_bias / (1.0 - model_.order_bias));
    const double liking = model_.sd * (holds(model_.turned, condition) ? -liking_ : liking_);
    return logistic(known_centre(share, model_.sd) + liking + (b_second ? bias : -bias));
}

bool Observer::chooses_b(std::size_t condition, bool b_second) {
    const bool drawn = random_.uniform() < probability_of_b(condition, b_second);
    const std::size_t shown = model_.shown.empty() ? condition : model_.shown.at(condition);
    const auto [seen, is_new] = chosen_.emplace(shown, drawn);
    if (is_new || is_careless_) return drawn;
    return random_.uniform() < kRemembered ? seen->second : drawn;
}

/// Box and Muller 1958.
double draw_normal(base::Random& random) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * random.uniform());
}

std::uint64_t observer_seed(std::uint64_t study_seed, std::uint64_t number) {
    const std::string hash = base::sha256_hex(fmt::format("observer {} {}", study_seed, number));
    return std::stoull(hash.substr(0, 16), nullptr, 16);
}

}  // namespace obscura::app::kiosk
