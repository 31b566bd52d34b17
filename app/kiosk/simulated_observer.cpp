// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/simulated_observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/kiosk/clock.h"
#include "app/kiosk/machine.h"
#include "renderer/base/error.h"
#include "renderer/base/version.h"

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

[[nodiscard]] double draw(base::Random& random, const Duration& duration) {
    return duration.median_s * std::exp(duration.sigma * draw_normal(random));
}

[[nodiscard]] Form draw_form(base::Random& random) {
    return {.age_years = kYoungest + static_cast<int>(random.below(kOldest - kYoungest + 1)),
            .gender = random.uniform() < kShareOfWomen ? "female" : "male",
            .normal_vision = true,
            .naive = true,
            .consent = true};
}

/// Something that each field takes.
[[nodiscard]] std::vector<FieldAnswer> draw_fields(const std::vector<stimuli::FormField>& fields,
                                                   base::Random& random) {
    std::vector<FieldAnswer> answers;
    for (const stimuli::FormField& field : fields) {
        FieldAnswer& answer = answers.emplace_back();
        const double low = field.min.value_or(field.max.value_or(100.0) - 100.0);
        const double high = field.max.value_or(low + 100.0);
        switch (field.kind) {
            case stimuli::FieldKind::kNumber:
            case stimuli::FieldKind::kScale: {
                // Whole where the range has a whole number.
                const double drawn = low + random.uniform() * (high - low);
                const double whole = std::round(drawn);
                answer.text = fmt::format("{}", whole >= low && whole <= high ? whole : drawn);
                break;
            }
            case stimuli::FieldKind::kChoice:
                answer.text = field.choices[random.below(field.choices.size())];
                break;
            case stimuli::FieldKind::kChoices:
                answer.chosen = {field.choices[random.below(field.choices.size())]};
                break;
            case stimuli::FieldKind::kText:
                answer.text = "simulated";
                break;
            case stimuli::FieldKind::kCode:
                answer.text = fmt::format("sim-{:08x}", random.below(std::uint64_t{1} << 32U));
                break;
        }
    }
    return answers;
}

/// What an observer does on a screen, and how long it takes to.
struct Action {
    double after_s = 0.0;
    Event event;
};

/// The answer to a question that is no plain choice; nothing: it is one.
[[nodiscard]] std::optional<Action> other_answer(const Procedure& procedure, base::Random& random) {
    using stimuli::QuestionKind;
    const AskedPage page = procedure.asked();
    if (page.question == nullptr || page.question->kind == QuestionKind::kChoice) {
        if (page.question == nullptr || procedure.page() == 0) return std::nullopt;
        // Mostly as the pairs are compared.
        constexpr double kAlike = 0.8;
        const double after_s = draw(random, kAnswering);
        const bool first = procedure.chose_first().value_or(random.uniform() < 0.5);
        const bool alike = random.uniform() < kAlike;
        return Action{after_s, AnswerPressed{first == alike ? 0 : 1}};
    }
    if (page.question->kind == QuestionKind::kChoiceOrNone) {
        constexpr double kNoDifference = 0.15;
        if (random.uniform() < kNoDifference) {
            return Action{draw(random, kAnswering), AnswerPressed{2}};
        }
        if (procedure.page() == 0) return std::nullopt;
        return Action{draw(random, kAnswering), AnswerPressed{random.uniform() < 0.5 ? 0 : 1}};
    }
    // A step about the middle; of one image higher where that was chosen.
    const auto last = static_cast<double>(page.answer_count() - 1);
    double step = 0.5 * last + 0.2 * last * draw_normal(random);
    if (page.image != 0 && procedure.chose_first()) {
        constexpr double kLiking = 0.1;
        step += (*procedure.chose_first() == (page.image == 1) ? kLiking : -kLiking) * last;
    }
    const double after_s = draw(random, kAnswering);
    return Action{after_s,
                  AnswerPressed{static_cast<int>(std::lround(std::clamp(step, 0.0, last)))}};
}

[[nodiscard]] Action next_action(const Procedure& procedure, Observer& observer,
                                 base::Random& random) {
    switch (procedure.screen()) {
        case Screen::kStart:
            return {draw(random, kPage), StartPressed{}};
        case Screen::kInformation:
            return {draw(random, kReading), InformationRead{}};
        case Screen::kConsent:
            return {draw(random, kForm), ConsentGiven{}};
        case Screen::kForm: {
            const double after_s = draw(random, kForm);
            Form form = draw_form(random);
            form.fields = draw_fields(procedure.fields(), random);
            return {after_s, FormSubmitted{std::move(form)}};
        }
        case Screen::kInstructions:
            return {draw(random, kReading), InstructionsRead{}};
        case Screen::kPairs:
            return {draw(random, kPage), PairPressed{procedure.progress().pair}};
        case Screen::kFirstImage:
        case Screen::kSecondImage:
        case Screen::kBothImages:
            return {draw(random, kLooking), SpacePressed{}};
        case Screen::kQuestion: {
            if (const auto other = other_answer(procedure, random)) return *other;
            const SessionPlan& plan = procedure.plan();
            const std::size_t condition = plan.condition_of(procedure.pair());
            const double after_s = draw(random, kAnswering);
            const bool b_first = plan.b_first(procedure.pair());
            const bool b = observer.chooses_b(condition, !b_first);
            return {after_s, Answered{b == b_first}};
        }
        case Screen::kFeedback:
        case Screen::kPracticeOver:
        case Screen::kBreak:
            return {draw(random, kPage), WentOn{}};
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

void VirtualClock::pass_to_refresh(double earliest_s) {
    // A refresh that only rounding puts before `earliest_s` is the one.
    constexpr double kRounding = 1e-6;
    const double wanted_s = std::max(now_s_, earliest_s);
    now_s_ = std::max(wanted_s, std::ceil(wanted_s * kRefresh_hz - kRounding) / kRefresh_hz);
}

Moment VirtualClock::now() const { return {now_s_, utc_text(kBegin_s + now_s_)}; }

Machine simulated_machine() {
    return {base::program_version(), operating_system(), "none: simulated",
            fmt::format("none: simulated, {} Hz", VirtualClock::kRefresh_hz),
            VirtualClock::kRefresh_hz};
}

void simulate_observer(Procedure& procedure, const ChoiceModel& choices, base::Random& random,
                       VirtualClock& clock, Journal& journal) {
    Observer observer(choices, random);
    while (procedure.screen() != Screen::kDone) {
        clock.pass_to_refresh(0.0);
        feed(procedure, journal, ScreenPresented{}, clock.now());
        if (const auto due_s = procedure.next_due_s()) {
            clock.pass_to_refresh(*due_s);
            feed(procedure, journal, Tick{clock.now().time_s}, clock.now());
            continue;
        }
        const Action action = next_action(procedure, observer, random);
        // A page takes nothing at first, however quick the observer.
        clock.pass(std::max(action.after_s, procedure.takes_presses_from_s() - clock.now().time_s));
        feed(procedure, journal, action.event, clock.now());
    }
}

}  // namespace obscura::app::kiosk
