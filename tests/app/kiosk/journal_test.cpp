// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/journal.h"

#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <functional>

#include "analysis/store/store.h"
#include "app/kiosk/clock.h"
#include "app/kiosk/recording.h"
#include "app/kiosk/store_lock.h"
#include "renderer/base/error.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

analysis::TrialRecord trial(int index) {
    analysis::TrialRecord row;
    row.session_id = "s-1";
    row.trial_index = index;
    row.condition = index == 0 ? "C2" : "C1";
    return row;
}

TEST(Journal, KeepsAnAnswerThatCannotBeSavedAndAllAfterItForTheNextTry) {
    bool full = false;
    std::vector<int> saved;
    Journal journal([&](const Row& row) {
        if (full) throw base::failure("the disk is full");
        saved.push_back(std::get<analysis::TrialRecord>(row).trial_index);
    });
    journal.add({trial(0)});
    EXPECT_EQ(journal.flush(), std::nullopt);
    full = true;
    journal.add({trial(1), trial(2)});
    EXPECT_EQ(journal.flush(), "the disk is full");
    EXPECT_EQ(journal.flush(), "the disk is full");
    EXPECT_EQ(journal.waiting().size(), 2U);
    full = false;
    EXPECT_EQ(journal.flush(), std::nullopt);
    EXPECT_EQ(saved, (std::vector<int>{0, 1, 2}));
    EXPECT_TRUE(journal.waiting().empty());
}

TEST(Journal, SaysAllOfAnAnswerThatCouldNotBeSaved) {
    analysis::TrialRecord row = trial(1);
    row.first_shown = 'B';
    row.is_A_selected = true;
    row.response_time_s = 1.25;
    const std::string text = describe(row);
    EXPECT_NE(text.find("pair 2 of session s-1"), std::string::npos) << text;
    EXPECT_NE(text.find("B shown first, A chosen"), std::string::npos) << text;
    EXPECT_NE(text.find("1.250 s"), std::string::npos) << text;
}

/// A store in a folder of its own with one session open.
class Recording : public testing::Test {
  protected:
    void SetUp() override {
        store_.emplace("sqlite3://" + (folder_ / "responses.sqlite").string(),
                       analysis::Store::Access::kReadWrite);
        study_ = small_study(2);
        procedure_.emplace(study_, small_plan(study_));
        journal_.emplace(journal_to(*store_));
    }

    void step(double time_s, const Event& event) {
        last_ = procedure_->step(event, {time_s, utc_text(time_s)});
        journal_->add(last_);
        EXPECT_EQ(journal_->flush(), std::nullopt);
        if (after_step_) after_step_();
    }
    /// What the form gives when it is sent, not yet saved.
    std::vector<Row> rows_of_beginning() {
        std::vector<Row> rows;
        int time_s = 0;
        for (const Event& event :
             std::initializer_list<Event>{ScreenPresented{}, StartPressed{}, ScreenPresented{},
                                          FormSubmitted{{.age_years = 30,
                                          .gender = "",
                                          .normal_vision = {},
                                          .naive = true,
                                          .consent = true}}}) {
            ++time_s;
            rows = procedure_->step(event, {static_cast<double>(time_s), utc_text(time_s)});
        }
        return rows;
    }
    void begin() {
        step(0, ScreenPresented{});
        step(1, StartPressed{});
        step(2, ScreenPresented{});
        step(3, FormSubmitted{{.age_years = 30,
                               .gender = "",
                               .normal_vision = {},
                               .naive = true,
                               .consent = true}});
        step(4, ScreenPresented{});
        step(5, InstructionsRead{});
        step(6, ScreenPresented{});
    }
    void answer(double t) {
        step(t, PairPressed{procedure_->pair()});
        step(t + 1, ScreenPresented{});
        step(t + 2, SpacePressed{});
        step(t + 3, ScreenPresented{});
        step(t + 5, Tick{t + 5});
        step(t + 5, ScreenPresented{});
        step(t + 6, SpacePressed{});
        step(t + 7, ScreenPresented{});
        step(t + 8, Answered{true});
        answer_rows_ = last_;
        step(t + 9, ScreenPresented{});
    }

    tests::TemporaryFolder folder_;
    std::optional<analysis::Store> store_;
    stimuli::Study study_;
    std::optional<Procedure> procedure_;
    std::optional<Journal> journal_;
    std::vector<Row> last_;
    std::vector<Row> answer_rows_;
    std::function<void()> after_step_;
};

TEST_F(Recording, EveryAnswerIsInTheStoreBeforeTheNextScreenIsDue) {
    begin();
    EXPECT_EQ(store_->sessions().size(), 1U);
    answer(10);
    EXPECT_EQ(store_->trials_of("s-1").size(), 1U);
    EXPECT_EQ(store_->sessions()[0].state, analysis::SessionState::kOpen);
    answer(30);
    EXPECT_EQ(store_->trials_of("s-1").size(), 2U);
    EXPECT_EQ(store_->sessions()[0].state, analysis::SessionState::kCompleted);
}

/// Opens a copy of the store's file alone.
class CopiedStore {
  public:
    explicit CopiedStore(const tests::TemporaryFolder& folder) {
        const auto copy = folder / "copy.sqlite";
        std::filesystem::copy_file(folder / "responses.sqlite", copy,
                                   std::filesystem::copy_options::overwrite_existing);
        store_.emplace("sqlite3://" + copy.string(), analysis::Store::Access::kReadOnly);
    }
    analysis::Store* operator->() { return &*store_; }

  private:
    std::optional<analysis::Store> store_;
};

TEST_F(Recording, ACopyOfTheOneFileHasAllThatIsSavedAtEveryPage) {
    std::size_t rows = 0;
    std::size_t answers = 0;
    after_step_ = [&] {
        rows += last_.size();
        for (const Row& row : last_)
            answers += std::holds_alternative<analysis::TrialRecord>(row) ? 1 : 0;
        CopiedStore copy(folder_);
        ASSERT_EQ(copy->trials().size(), answers);
        ASSERT_EQ(copy->trials(), store_->trials());
        ASSERT_EQ(copy->sessions(), store_->sessions());
        ASSERT_EQ(copy->events(), store_->events());
    };
    begin();
    answer(10);
    EXPECT_EQ(answers, 1U);
    answer(30);
    EXPECT_EQ(answers, 2U);
    EXPECT_EQ(CopiedStore(folder_)->sessions().at(0).state, analysis::SessionState::kCompleted);
    EXPECT_EQ(rows, 5U) << "the session, that the instructions were read, two answers, the end";
    EXPECT_EQ(CopiedStore(folder_)->events().size(), 3U);
}

TEST_F(Recording, ACopyOfTheOneFileHasEveryAnswerAfterTheProgramWasKilled) {
    store_.reset();  // no connection passes a fork
    for (int answers = 0; answers <= 2; ++answers) {
        std::filesystem::remove(folder_ / "responses.sqlite");
        const pid_t child = ::fork();
        if (child == 0) {
            SetUp();
            begin();
            for (int i = 0; i < answers; ++i) answer(10 + 20 * i);
            ::kill(::getpid(), SIGKILL);
        }
        ::waitpid(child, nullptr, 0);
        CopiedStore copy(folder_);
        EXPECT_EQ(copy->trials().size(), static_cast<std::size_t>(answers));
        ASSERT_EQ(copy->sessions().size(), 1U);
        EXPECT_EQ(copy->sessions()[0].state == analysis::SessionState::kCompleted, answers == 2);
    }
}

TEST_F(Recording, ASessionAndTheDigestOfItsImagesAreOneTransaction) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder_ / "responses.sqlite").c_str(), &database), SQLITE_OK);
    const auto execute = [&](const char* sql) {
        EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(database);
    };
    execute(
        "CREATE TRIGGER no_digest BEFORE INSERT ON events WHEN NEW.name = 'stimuli digest' "
        "BEGIN SELECT RAISE(ABORT, 'there is no room'); END");
    const std::vector<Row> rows = rows_of_beginning();
    journal_->add(rows);
    EXPECT_NE(journal_->flush(), std::nullopt);
    EXPECT_TRUE(store_->sessions().empty());
    EXPECT_TRUE(store_->events().empty());
    execute("DROP TRIGGER no_digest");
    sqlite3_close(database);
    EXPECT_EQ(journal_->flush(), std::nullopt);
    ASSERT_EQ(store_->events().size(), 2U);
    EXPECT_EQ(store_->events()[1].name, kStimuliEvent);
}

TEST_F(Recording, AStoreThatIsGoneIsNoticedThoughNothingWaitsToBeSaved) {
    begin();
    EXPECT_EQ(journal_->flush(), std::nullopt);
    std::filesystem::rename(folder_ / "responses.sqlite", folder_ / "elsewhere.sqlite");
    EXPECT_NE(journal_->flush().value_or("").find("was moved or deleted"), std::string::npos);
    std::filesystem::rename(folder_ / "elsewhere.sqlite", folder_ / "responses.sqlite");
    EXPECT_EQ(journal_->flush(), std::nullopt);
}

TEST_F(Recording, ARowThatAnEarlierTryBroughtToTheDiskMayBeTriedAgain) {
    begin();
    answer(10);
    EXPECT_NO_THROW(commit(*store_, answer_rows_.at(0)));
    EXPECT_EQ(store_->trials_of("s-1").size(), 1U);
    auto other = std::get<analysis::TrialRecord>(answer_rows_.at(0));
    other.answered_utc = utc_text(1000);
    EXPECT_THROW(commit(*store_, other), base::Error);
}

TEST_F(Recording, WhereTheStoreCannotBeReadEitherTheFirstReasonIsGiven) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open((folder_ / "responses.sqlite").c_str(), &database), SQLITE_OK);
    EXPECT_EQ(sqlite3_exec(database,
                           "CREATE TRIGGER no_room BEFORE INSERT ON participants "
                           "BEGIN SELECT RAISE(ABORT, 'there is no room'); END;"
                           "ALTER TABLE sessions RENAME COLUMN software TO hardware",
                           nullptr, nullptr, nullptr),
              SQLITE_OK)
        << sqlite3_errmsg(database);
    sqlite3_close(database);
    EXPECT_THROW((void)store_->sessions(), base::Error);
    BeginSession row;
    row.participant.participant_id = row.session.participant_id = "p-9";
    row.participant.age_years = 30;
    row.participant.consent = true;
    row.participant.created_utc = row.session.started_utc = utc_text(1);
    row.session.session_id = "s-9";
    row.session.study = "small";
    row.session.study_sha256 = std::string(64, '5');
    row.session.order = "latin-square";
    row.session.condition_count = 2;
    try {
        commit(*store_, row);
        ADD_FAILURE() << "nothing was thrown";
    } catch (const base::Error& error) {
        EXPECT_NE(std::string_view(error.what()).find("there is no room"), std::string_view::npos)
            << error.what();
    }
}

TEST_F(Recording, ASlotTakenMeanwhileGivesWayToTheNextFreeOneAndItsOrder) {
    const auto plan_of = [&](const std::string& number, std::uint64_t slot) {
        SessionPlan plan = small_plan(study_);
        plan.participant_id = "p-" + number;
        plan.session_id = "s-" + number;
        plan.order = stimuli::session_order(study_.order, 2, study_.seed, slot);
        return plan;
    };
    const auto start = [&](const SessionPlan& plan) {
        procedure_.emplace(study_, plan);
        journal_.emplace(journal_to(*store_, study_, *procedure_));
        begin();
    };
    start(plan_of("1", 0));
    start(plan_of("2", 0));  // planned before the first one began
    const auto order = stimuli::session_order(study_.order, 2, study_.seed, 1);
    EXPECT_EQ(procedure_->plan().order.conditions, order.conditions);
    answer(10);
    const auto sessions = store_->sessions();
    ASSERT_EQ(sessions.size(), 2U);
    EXPECT_EQ(sessions[1].slot, 1U);
    EXPECT_EQ(sessions[1].latin_row, order.latin_row);
    EXPECT_EQ(sessions[1].swapped, order.swapped);
    const auto first = static_cast<std::size_t>(order.conditions[0]);
    EXPECT_EQ(store_->trials_of("s-2").at(0).condition, study_.conditions[first].id);
}

TEST_F(Recording, AStoreIsOneKiosksUntilThatEnds) {
    const std::string url = "sqlite3://" + (folder_ / "responses.sqlite").string();
    {
        const StoreLock lock(url);
        std::filesystem::create_symlink(folder_ / "responses.sqlite", folder_ / "link.sqlite");
        for (const std::string& same : {url, "sqlite3://" + (folder_ / "link.sqlite").string()}) {
            try {
                const StoreLock second(same);
                ADD_FAILURE() << same;
            } catch (const base::Error& error) {
                EXPECT_EQ(error.code(), base::ExitCode::kFailed);
                EXPECT_NE(std::string_view(error.what()).find("another kiosk"),
                          std::string_view::npos);
            }
        }
        EXPECT_NO_THROW(StoreLock("sqlite3://" + (folder_ / "other.sqlite").string()));
        EXPECT_NO_THROW(StoreLock("postgresql://nowhere/answers"));
    }
    EXPECT_NO_THROW(StoreLock{url});
}

TEST_F(Recording, AnOpenSessionIsPlannedAgainAsItBegan) {
    // The order that the study itself draws, not that of small_plan.
    SessionPlan plan = small_plan(study_);
    plan.order = stimuli::session_order(study_.order, 2, study_.seed, 0);
    procedure_.emplace(study_, plan);
    begin();
    answer(10);
    const stimuli::Manifest manifest = small_manifest(study_);
    const auto session = store_->open_sessions("small", analysis::Kind::kParticipant).at(0);
    const auto trials = store_->trials_of("s-1");
    const SessionPlan again = plan_to_resume(study_, manifest, session, trials, store_->events());
    EXPECT_EQ(again.order.conditions, plan.order.conditions);
    EXPECT_EQ(again.participant_id, plan.participant_id);

    stimuli::Study other_study = study_;
    other_study.sha256 = std::string(64, '6');
    EXPECT_THROW((void)plan_to_resume(other_study, manifest, session, trials, store_->events()),
                 base::Error);
    for (std::size_t i = 0; i < manifest.images.size(); ++i) {  // shown or still to come
        stimuli::Manifest other = manifest;
        other.images[i].sha256[0] = '9';
        EXPECT_THROW((void)plan_to_resume(study_, other, session, trials, store_->events()),
                     base::Error);
    }
}

TEST(Clock, UtcTextsGoForthAndBack) {
    EXPECT_EQ(utc_text(0.0), "1970-01-01T00:00:00.000Z");
    EXPECT_EQ(utc_text(946684800.25), "2000-01-01T00:00:00.250Z");
    EXPECT_NEAR(seconds_between("2000-01-01T00:00:00.250Z", "2000-01-02T00:00:01.500Z"), 86401.25,
                1e-6);
    EXPECT_EQ(seconds_between("no time", "2000-01-01T00:00:00Z"), 0.0);
}

}  // namespace
}  // namespace obscura::app::kiosk
