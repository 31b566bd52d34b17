// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/power_of_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "analysis/conclusions/analysis.h"
#include "app/commands/planned_tally.h"
#include "renderer/base/progress.h"

namespace obscura::app {
namespace {

using analysis::Conclusion;
using analysis::Tally;
using analysis::Verdict;
using kiosk::ChoiceModel;

/// Studies for each number of participants that is only looked at on the way.
constexpr int kOnTheWay = 400;

/// Something true of a study, and a verdict.
struct Scenario {
    VerdictPower result;
    ChoiceModel choices;
    std::function<bool(Conclusion)> is_reached;
};

class StudySimulator {
  public:
    StudySimulator(const stimuli::Study& study, std::uint64_t seed)
        : study_(study), seed_(seed), planned_(planned_tally(study)) {
        for (std::size_t i = 0; i < planned_.conditions.size(); ++i) {
            place_[planned_.conditions[i].id] = i;
        }
        for (const stimuli::Condition& condition : study.conditions) {
            const auto place = place_.find(condition.id);
            place_of_.push_back(place == place_.end() ? -1 : static_cast<int>(place->second));
        }
        if (!study.exclusion.to_json().empty()) {
            planned_.exclusion = analysis::exclusion_rule(study.exclusion.to_json(), study.name);
        }
    }

    [[nodiscard]] const Tally& planned() const { return planned_; }

    /// The verdicts on so many simulated studies, each of other observers.
    [[nodiscard]] Frequency run(const Scenario& scenario, int participants, int studies) {
        order_up_to(participants);
        Frequency frequency{participants, studies, 0};
        for (int number = 0; number < studies; ++number) {
            base::Random random(kiosk::observer_seed(seed_, static_cast<std::uint64_t>(number)));
            const auto verdicts = analysis::verdicts_on(answers(scenario, participants, random));
            const auto own =
                std::find_if(verdicts.begin(), verdicts.end(), [&](const Verdict& verdict) {
                    return verdict.hypothesis == scenario.result.hypothesis;
                });
            if (own != verdicts.end() && scenario.is_reached(own->conclusion)) ++frequency.reached;
        }
        return frequency;
    }

  private:
    void order_up_to(int participants) {
        if (orders_.size() >= static_cast<std::size_t>(participants)) return;
        orders_ = stimuli::session_orders(study_.order, study_.pair_count(), study_.seed,
                                          static_cast<std::uint64_t>(participants), study_.sides);
    }

    Tally answers(const Scenario& scenario, int participants, base::Random& random) const {
        Tally tally = planned_;
        tally.kind = analysis::Kind::kSimulated;
        tally.n_participants = participants;
        for (int number = 0; number < participants; ++number) {
            tally.participants.push_back({std::to_string(number), {}, {}});
            kiosk::Observer observer(scenario.choices, random);
            answer_all(observer, orders_[static_cast<std::size_t>(number)], number, tally);
        }
        return tally;
    }

    void answer_all(kiosk::Observer& observer, const stimuli::SessionOrder& order, int number,
                    Tally& tally) const {
        std::map<std::string, bool> chosen;
        for (std::size_t i = 0; i < order.conditions.size(); ++i) {
            const auto index = static_cast<std::size_t>(order.conditions[i]);
            const stimuli::Condition& condition = study_.conditions[index];
            const bool b_second = !order.b_first(i);
            const bool chose_b = observer.chooses_b(index, b_second);
            auto& own = tally.participants.back();
            if (condition.expected != '\0') {
                ++own.catch_trials.n;
                if ((condition.expected == 'B') == chose_b) ++own.catch_trials.successes;
                continue;
            }
            const std::string& shown = condition.repeats.empty() ? condition.id : condition.repeats;
            const auto [first, is_new] = chosen.emplace(shown, chose_b);
            if (!is_new) {
                ++own.repeats.n;
                if (first->second == chose_b) ++own.repeats.successes;
            }
            const int place = place_of_[index];
            if (place < 0) continue;
            analysis::ConditionVotes& votes = tally.conditions[static_cast<std::size_t>(place)];
            ++(chose_b ? votes.votes.b : votes.votes.a);
            votes.answers.push_back({number, chose_b, b_second, static_cast<std::int32_t>(i)});
        }
    }

    const stimuli::Study& study_;
    std::uint64_t seed_;
    Tally planned_;
    std::map<std::string, std::size_t> place_;  ///< of the planned conditions
    std::vector<int> place_of_;                 ///< of the study's conditions; -1: no vote
    std::vector<stimuli::SessionOrder> orders_;
};

bool holds(const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// Nothing is preferred by people at large; what each likes is the same where B is the same.
ChoiceModel nothing_preferred(const stimuli::Study& study, const Tally& planned,
                              const PowerRequest& request) {
    ChoiceModel choices = kiosk::choices_from(study, {});
    choices.sd = request.sd;
    choices.order_bias = request.order_bias;
    choices.careless = request.careless;
    choices.turned.assign(study.conditions.size(), false);
    const analysis::Family family = analysis::family_of(planned);
    for (const auto& hypothesis : family.hypotheses) {
        std::vector<std::string> turned = turned_in(planned, hypothesis.conditions);
        for (const auto& pair : hypothesis.pairs) {
            for (std::string& id : turned_in(planned, pair)) turned.push_back(std::move(id));
        }
        for (std::size_t i = 0; i < study.conditions.size(); ++i) {
            const stimuli::Condition& condition = study.conditions[i];
            const std::string& shown = condition.repeats.empty() ? condition.id : condition.repeats;
            if (holds(turned, shown)) choices.turned[i] = true;
        }
    }
    return choices;
}

bool is_preferred(Conclusion conclusion) {
    return conclusion == Conclusion::kBPreferred || conclusion == Conclusion::kAPreferred;
}

std::string truth_words(const analysis::PlannedHypothesis& hypothesis, double share) {
    return hypothesis.is_interaction
               ? fmt::format("a share that changes from 50 to {:g} %", 100.0 * share)
               : fmt::format("a share of {:g} %", 100.0 * share);
}

/// What is asked of one hypothesis.
std::vector<Scenario> scenarios_of(const analysis::PlannedHypothesis& hypothesis,
                                   const stimuli::Study& study, const Tally& planned,
                                   const PowerRequest& request) {
    Scenario scenario;
    scenario.result.hypothesis = hypothesis.id;
    scenario.result.is_primary = hypothesis.is_primary;
    scenario.choices = nothing_preferred(study, planned, request);
    std::vector<Scenario> scenarios;
    for (const double share : request.shares) {
        Scenario& with = scenarios.emplace_back(scenario);
        with.result.truth = truth_words(hypothesis, share);
        const std::vector<std::string> turned = turned_in(planned, hypothesis.conditions);
        for (const std::string& id : hypothesis.conditions) {
            kiosk::set_share(with.choices, study, id, holds(turned, id) ? 1.0 - share : share);
        }
        for (const auto& pair : hypothesis.pairs) {
            kiosk::set_share(with.choices, study, pair.back(),
                             holds(turned_in(planned, pair), pair.back()) ? 1.0 - share : share);
        }
        if (hypothesis.is_interaction) {
            with.result.verdict = "the effect differs";
            with.is_reached = [](Conclusion own) { return own == Conclusion::kDiffers; };
        } else {
            with.result.verdict = "that image is preferred";
            with.is_reached = [](Conclusion own) { return own == Conclusion::kBPreferred; };
        }
    }
    scenario.result.truth = hypothesis.is_interaction ? "no change" : "a share of 50 %";
    Scenario& equal = scenarios.emplace_back(scenario);
    equal.result.verdict = fmt::format("equal within {:g} points", 100.0 * hypothesis.margin);
    equal.is_reached = [](Conclusion own) {
        return own == Conclusion::kEqual || own == Conclusion::kSame;
    };
    Scenario& wrong = scenarios.emplace_back(scenario);
    wrong.result.is_true = false;
    wrong.result.verdict = hypothesis.is_interaction ? "the effect differs, wrongly"
                                                     : "an image is preferred, wrongly";
    wrong.is_reached = [](Conclusion own) {
        return is_preferred(own) || own == Conclusion::kDiffers;
    };
    return scenarios;
}

/// The fewest whole blocks that reach what is asked: doubled, then halved between.
analysis::Possible<Frequency> needed_for(StudySimulator& simulator, const Scenario& scenario,
                                         int block, const PowerRequest& request) {
    using Needed = analysis::Possible<Frequency>;
    const int studies = std::min(kOnTheWay, request.studies);
    const auto is_enough = [&](int blocks) {
        return simulator.run(scenario, blocks * block, studies).share() >= request.power;
    };
    const int most = std::max(1, kMostSimulated / block);
    int enough = 1;
    while (enough < most && !is_enough(enough)) enough = std::min(most, 2 * enough);
    int few = enough / 2;
    if (enough == most && !is_enough(most)) {
        return Needed::none(fmt::format("more than {}", most * block));
    }
    while (enough - few > 1) {
        const int middle = (few + enough) / 2;
        (is_enough(middle) ? enough : few) = middle;
    }
    return simulator.run(scenario, enough * block, request.studies);
}

}  // namespace

double Frequency::error() const { return std::sqrt(share() * (1.0 - share()) / studies); }

std::vector<VerdictPower> power_of_study(const stimuli::Study& study, const PowerRequest& request) {
    StudySimulator simulator(study, request.seed);
    const int block = static_cast<int>(stimuli::block_size(study.order, study.pair_count()));
    std::vector<Scenario> scenarios;
    const analysis::Family family = analysis::family_of(simulator.planned());
    for (const auto& hypothesis : family.hypotheses) {
        for (Scenario& own : scenarios_of(hypothesis, study, simulator.planned(), request)) {
            scenarios.push_back(std::move(own));
        }
    }
    base::Progress progress("simulate", scenarios.size(), request.quiet);
    std::vector<VerdictPower> results;
    for (Scenario& scenario : scenarios) {
        if (request.participants) {
            scenario.result.at = simulator.run(scenario, *request.participants, request.studies);
        }
        if (scenario.result.is_true && request.asks_needed) {
            scenario.result.needed = needed_for(simulator, scenario, block, request);
        } else if (!scenario.result.is_true) {
            scenario.result.needed = analysis::Possible<Frequency>::none("an error, not power");
        }
        progress.step(scenario.result.hypothesis);
        results.push_back(scenario.result);
    }
    return results;
}

}  // namespace obscura::app
