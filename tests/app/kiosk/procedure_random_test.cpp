// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "renderer/base/random.h"
#include "tests/app/kiosk/script.h"

namespace obscura::app::kiosk {
namespace {

using analysis::TrialRecord;

Event random_event(base::Random& random, int pairs, double time_s) {
    switch (random.below(18)) {
        case 14:
            return InformationRead{};
        case 15:
            return ConsentGiven{};
        case 16:
            return random.below(2) == 0 ? Event(CodeTakenBack{}) : Event(CodeConfirmed{});
        case 0:
            return StartPressed{};
        case 1: {
            Form form = Script::filled_form();
            form.consent = random.below(2) == 0;
            form.age_years = static_cast<int>(random.below(140)) - 10;
            form.fields = {{random.below(2) == 0 ? "known" : "", {}}};
            return FormSubmitted{form};
        }
        case 2:
            return InstructionsRead{};
        case 3:
        case 4:
            return PairPressed{static_cast<int>(random.below(pairs + 2)) - 1};
        case 5:
            return SpacePressed{};
        case 6:
            return Answered{random.below(2) == 0};
        case 7:
            return NextParticipant{};
        case 8:
            return Tick{time_s + random.uniform(-1.0, 1.0)};
        case 9:
            return random.below(20) == 0 ? Event(LeaveRequested{}) : Event(SpacePressed{});
        case 10:
            return random.below(20) == 0 ? Event(LeaveConfirmed{}) : Event(LeaveCancelled{});
        case 11:
            return random.below(8) == 0 ? Event(ScreenHidden{"lost focus"}) : Event(SpacePressed{});
        case 12:
            return ScreenSeen{};
        default:
            return ScreenPresented{static_cast<int>(random.below(3))};
    }
}

void expect_sound(const TrialRecord& row, int index, const stimuli::Study& study) {
    EXPECT_EQ(row.trial_index, index);
    EXPECT_GE(row.first_view_ms, 0.0);
    EXPECT_GE(row.second_view_ms, 0.0);
    EXPECT_GE(row.response_time_s, 0.0);
    EXPECT_GE(row.dropped_frames, 0);
    EXPECT_GE(row.hidden_ms.value(), 0.0);
    EXPECT_GE(row.first_onset_s, 0.0);
    EXPECT_GT(row.second_onset_s, row.first_onset_s);
    EXPECT_GE(row.question_onset_s, row.second_onset_s);
    EXPECT_GE(row.grey_ms_measured,
              study.presentation.grey_ms - 1000.0);  // a tick may expect 1 s ahead
}

TEST(Procedure, RandomEventsNeverGiveARowOutOfOrderADuplicateANegativeTimeOrAWayBack) {
    const stimuli::Study plain = small_study(4);
    stimuli::Study asking = small_study(4);
    asking.information = "What this is about.";
    asking.consent = stimuli::Consent{"1", "", {"I agree"}};
    asking.form = {{.id = "code", .kind = stimuli::FieldKind::kCode, .label = "Code"}};
    std::set<Screen> seen;
    int completed = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        base::Random random(seed);
        const stimuli::Study& study = seed % 3 == 0 ? asking : plain;
        SessionPlan plan = small_plan(study, seed % 2 == 1);
        plan.known_codes = {"KNOWN"};
        Script script(study, std::move(plan));
        double time_s = 0.0;
        std::set<std::pair<int, int>> images_left;  // pair and position no longer to be seen
        Screen last = Screen::kStart;
        int last_pair = 0;
        for (int i = 0; i < 1500; ++i) {
            time_s += random.uniform(0.0, 0.5);
            const double stamped = random.below(10) == 0 ? time_s - 1.0 : time_s;
            script.at(stamped, random_event(random, 4, stamped));
            const Screen now = script.procedure.screen();
            seen.insert(now);
            const int pair = script.procedure.pair();
            EXPECT_GE(pair, last_pair);
            if (last == Screen::kFirstImage && now == Screen::kInterval)
                images_left.insert({pair, 0});
            if (last == Screen::kSecondImage && now == Screen::kQuestion) {
                images_left.insert({pair, 1});
            }
            if (now == Screen::kFirstImage) {
                EXPECT_FALSE(images_left.contains({pair, 0}));
            }
            if (now == Screen::kSecondImage) {
                EXPECT_FALSE(images_left.contains({pair, 1}));
            }
            last = now;
            last_pair = pair;
        }
        const auto trials = script.rows_of<TrialRecord>();
        for (std::size_t i = 0; i < trials.size(); ++i) {
            expect_sound(trials[i], static_cast<int>(i), study);
        }
        EXPECT_LE(script.rows_of<BeginSession>().size(), 1U);
        const std::size_t ends = script.rows_of<CompleteSession>().size();
        EXPECT_EQ(ends, trials.size() == 4 ? 1U : 0U);
        completed += static_cast<int>(ends);
    }
    EXPECT_GT(completed, 5);
    EXPECT_EQ(seen.size(), 15U) << "every screen is reached";
}

}  // namespace
}  // namespace obscura::app::kiosk
