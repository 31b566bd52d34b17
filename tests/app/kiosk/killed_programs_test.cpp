// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Whole sessions in a process of their own that is killed at random moments, and begun again each
// time. OBSCURA_KILLS says how often, where it is given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <map>
#include <set>

#include "analysis/questions/answers.h"
#include "analysis/store/store.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/simulated_observer.h"
#include "tests/app/kiosk/asking_study.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using analysis::Store;

/// What a row answers, in words; empty: nothing.
std::string said(const Row& row) {
    if (const auto* trial = std::get_if<analysis::TrialRecord>(&row)) {
        return fmt::format("trial {} {}: {}", trial->session_id, trial->trial_index,
                           trial->is_A_selected ? 'A' : 'B');
    }
    const auto* event = std::get_if<analysis::EventRecord>(&row);
    if (event == nullptr || event->name != analysis::kAnswerEvent) return "";
    const auto answer = analysis::answers_among({*event}).front();
    return fmt::format("answer {} {} {} {}: {}", answer.session_id, answer.trial_index,
                       answer.question, answer.about, answer.answer);
}

class KilledPrograms : public testing::Test {
  protected:
    /// Plays sessions for ever; what was saved is written to `acknowledged`, a line each.
    [[noreturn]] void play(int run, int acknowledged) const {
        Store store(url_, Store::Access::kReadWrite);
        base::Random random(static_cast<std::uint64_t>(run) + 1);
        Journal journal([&](const Row& row) {
            commit(store, row);
            const std::string line = said(row) + '\n';
            if (line.size() > 1 && ::write(acknowledged, line.data(), line.size()) < 0) ::_exit(1);
        });
        VirtualClock clock;
        clock.pass(1000.0 * (run + 1));
        while (true) {
            const auto open = store.open_sessions(study_.name, analysis::Kind::kSimulated);
            const auto taken =
                store.taken_slots(study_.name, study_.seed, analysis::Kind::kSimulated);
            Procedure procedure(study_,
                                plan(open.empty() ? stimuli::next_slot(taken) : open.front().slot));
            if (!open.empty()) {
                const std::string& id = open.front().session_id;
                journal.add(procedure.resume(store.trials_of(id), true, 1000.0 * run, clock.now(),
                                             store.events_of(id)));
            }
            simulate_observer(procedure, choices_from(study_, {}), random, clock, journal);
        }
    }

    [[nodiscard]] SessionPlan plan(std::uint64_t slot) const {
        SessionPlan plan = asking_plan(study_);
        plan.kind = analysis::Kind::kSimulated;
        plan.order = study_.session_order(slot);
        plan.session_id = fmt::format("s-{}", slot);
        plan.participant_id = fmt::format("p-{}", slot);
        plan.questions.list[0].kind = stimuli::QuestionKind::kChoiceOrNone;
        return plan;
    }

    /// Lets a program answer about so often, and kills it in the middle of whatever it does then.
    void kill_after(int run, std::uint64_t answers) {
        int ends[2] = {-1, -1};
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            ::close(ends[0]);
            play(run, ends[1]);
        }
        ::close(ends[1]);
        std::string lines;
        char byte = 0;
        std::uint64_t seen = 0;
        while (seen < answers && ::read(ends[0], &byte, 1) == 1) {
            lines += byte;
            if (byte == '\n') ++seen;
        }
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
        while (::read(ends[0], &byte, 1) == 1) lines += byte;
        ::close(ends[0]);
        for (std::size_t from = 0; from < lines.size();) {
            const std::size_t to = lines.find('\n', from);
            if (to == std::string::npos) break;
            const std::string line = lines.substr(from, to - from);
            const std::string place = line.substr(0, line.rfind(':'));
            acknowledged_[place] = line;
            from = to + 1;
        }
    }

    tests::TemporaryFolder folder_;
    std::string url_ = "sqlite3://" + (folder_ / "killed.sqlite").string();
    stimuli::Study study_ = small_study(3);
    std::map<std::string, std::string> acknowledged_;  ///< by what was asked; the last one
};

TEST_F(KilledPrograms, KeepEachAnswerThatWasSavedOnceAndEverySessionGoesOn) {
    const char* const asked = std::getenv("OBSCURA_KILLS");
    const int kills = asked == nullptr ? 200 : std::atoi(asked);
    base::Random random(5);
    for (int run = 0; run < kills; ++run) {
        kill_after(run, random.below(20));
        if (HasFatalFailure()) return;
    }
    Store store(url_, Store::Access::kReadWrite);
    std::map<std::string, std::string> found;
    const auto note = [&](const Row& row) {
        const std::string line = said(row);
        if (line.empty()) return;
        EXPECT_TRUE(found.emplace(line.substr(0, line.rfind(':')), line).second) << line;
    };
    for (const auto& trial : store.trials()) note(trial);
    for (const auto& answer : analysis::answers_among(store.events())) note(to_event(answer));
    for (const auto& [place, line] : acknowledged_) {
        // What comes before its trial is asked again where that is not there.
        const auto first = place.find(" real ");
        const bool before_trial = place.starts_with("answer") && first != std::string::npos;
        if (before_trial && !found.contains("trial" + place.substr(6, first - 6))) continue;
        EXPECT_EQ(found[place], line);
    }
    // Each session but the last one has every answer to every question.
    std::map<std::string, int> answers;
    for (const auto& answer : analysis::answers_among(store.events())) ++answers[answer.session_id];
    int completed = 0;
    for (const auto& session : store.sessions()) {
        if (session.state != analysis::SessionState::kCompleted) continue;
        ++completed;
        EXPECT_EQ(store.trials_of(session.session_id).size(), 3U);
        EXPECT_EQ(answers[session.session_id], 3 * 4);
    }
    EXPECT_GE(completed + 1, static_cast<int>(store.sessions().size()));
    RecordProperty("kills", kills);
    RecordProperty("answers", static_cast<int>(found.size()));
}

}  // namespace
}  // namespace obscura::app::kiosk
