// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/simulated_observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/kiosk/clock.h"
#include "app/kiosk/machine.h"
#include "renderer/base/error.h"
#include "renderer/base/hash.h"

namespace obscura::app::kiosk {
namespace {

constexpr double kBegin_s = 946684800.0;  // 2000-01-01T00:00:00Z

/// A log-normal distribution of durations. The numbers are plausible, not measured: the thesis
/// gives no times.
struct Duration {
    double median_s;
    double sigma;  ///< standard deviation of the logarithm
};
constexpr Duration kPage{4.0, 0.3};
constexpr Duration kForm{20.0, 0.3};
constexpr Duration kReading{45.0, 0.3};
constexpr Duration kLooking{7.0, 0.5};
constexpr Duration kAnswering{1.6, 0.4};

/// Jakobsen 2010, 5.4: 26 men and 10 women between 18 and 56.
constexpr int kYoungest = 18;
constexpr int kOldest = 56;
constexpr double kShareOfWomen = 10.0 / 36.0;

/// How often an attention check is answered as expected, and how often an answer to a pair seen
/// before is the same because it is remembered. Plausible as well.
constexpr double kAttentive = 0.95;
constexpr double kRemembered = 0.6;

/// Box and Muller 1958.
[[nodiscard]] double draw(base::Random& random, const Duration& duration) {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
    const double normal = radius * std::cos(2.0 * std::numbers::pi * random.uniform());
    return duration.median_s * std::exp(duration.sigma * normal);
}

[[nodiscard]] Form draw_form(base::Random& random) {
    return {.age_years = kYoungest + static_cast<int>(random.below(kOldest - kYoungest + 1)),
            .gender = random.uniform() < kShareOfWomen ? "female" : "male",
            .normal_vision = true,
            .naive = true,
            .consent = true};
}

/// What an observer does on a screen, and how long it takes to.
struct Action {
    double after_s = 0.0;
    Event event;
};

/// What an observer chose of a pair: the condition, or the one that it repeats, to whether B was
/// it.
using Memory = std::map<std::size_t, bool>;

[[nodiscard]] bool chooses_b(std::size_t condition, const ChoiceModel& choices,
                             base::Random& random, Memory& memory) {
    const bool drawn = random.uniform() < choices.probability_of_b.at(condition);
    const std::size_t shown = choices.shown.empty() ? condition : choices.shown.at(condition);
    const auto [seen, is_new] = memory.emplace(shown, drawn);
    return !is_new && random.uniform() < kRemembered ? seen->second : drawn;
}

[[nodiscard]] Action next_action(const Procedure& procedure, const ChoiceModel& choices,
                                 base::Random& random, Memory& memory) {
    switch (procedure.screen()) {
        case Screen::kStart:
            return {draw(random, kPage), StartPressed{}};
        case Screen::kForm:
            return {draw(random, kForm), FormSubmitted{draw_form(random)}};
        case Screen::kInstructions:
            return {draw(random, kReading), InstructionsRead{}};
        case Screen::kPairs:
            return {draw(random, kPage), PairPressed{procedure.pair()}};
        case Screen::kFirstImage:
        case Screen::kSecondImage:
            return {draw(random, kLooking), SpacePressed{}};
        case Screen::kQuestion: {
            const stimuli::SessionOrder& order = procedure.plan().order;
            const auto condition = static_cast<std::size_t>(order.conditions.at(procedure.pair()));
            const double after_s = draw(random, kAnswering);
            const bool b = chooses_b(condition, choices, random, memory);
            return {after_s,
                    Answered{b == order.b_first(static_cast<std::size_t>(procedure.pair()))}};
        }
        default:
            return {draw(random, kPage), NextParticipant{}};
    }
}

void feed(Procedure& procedure, Journal& journal, const Event& event, const Moment& now) {
    journal.add(procedure.step(event, now));
    if (const auto reason = journal.flush()) {
        throw base::failure("cannot save {}: {}", describe(journal.waiting().front()), *reason);
    }
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
            if (original == nullptr) model.unpublished.push_back(condition.id);
        } else {
            const auto a = static_cast<double>(published->votes.a);
            const auto b = static_cast<double>(published->votes.b);
            model.probability_of_b.push_back(b / (a + b));
        }
    }
    return model;
}

std::uint64_t observer_seed(std::uint64_t study_seed, std::uint64_t number) {
    const std::string hash = base::sha256_hex(fmt::format("observer {} {}", study_seed, number));
    return std::stoull(hash.substr(0, 16), nullptr, 16);
}

void VirtualClock::pass_to_refresh(double earliest_s) {
    // A refresh that only rounding puts before `earliest_s` is the one.
    constexpr double kRounding = 1e-6;
    const double wanted_s = std::max(now_s_, earliest_s);
    now_s_ = std::max(wanted_s, std::ceil(wanted_s * kRefresh_hz - kRounding) / kRefresh_hz);
}

Moment VirtualClock::now() const { return {now_s_, utc_text(kBegin_s + now_s_)}; }

Machine simulated_machine() {
    return {software_version(), operating_system(), "none: simulated",
            fmt::format("none: simulated, {} Hz", VirtualClock::kRefresh_hz),
            VirtualClock::kRefresh_hz};
}

void simulate_observer(Procedure& procedure, const ChoiceModel& choices, base::Random& random,
                       VirtualClock& clock, Journal& journal) {
    Memory memory;
    while (procedure.screen() != Screen::kDone) {
        clock.pass_to_refresh(0.0);
        feed(procedure, journal, ScreenPresented{}, clock.now());
        if (const auto due_s = procedure.second_image_due_s()) {
            clock.pass_to_refresh(*due_s);
            feed(procedure, journal, Tick{clock.now().time_s}, clock.now());
            continue;
        }
        const Action action = next_action(procedure, choices, random, memory);
        // A page takes nothing at first, however quick the observer.
        clock.pass(std::max(action.after_s, procedure.takes_presses_from_s() - clock.now().time_s));
        feed(procedure, journal, action.event, clock.now());
    }
}

}  // namespace obscura::app::kiosk
