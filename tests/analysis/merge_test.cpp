// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "analysis/export/export.h"
#include "analysis/store/store.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/postgres.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;

/// Into a store of either kind.
class Merge : public testing::TestWithParam<const char*> {
  protected:
    Store open(const std::string& name) {
        return {"sqlite3://" + (folder_ / name).string(), Store::Access::kReadWrite};
    }
    /// The store of a kiosk with these sessions, whose slots it counted for itself.
    Store kiosk(const std::string& name, const std::vector<int>& numbers) {
        Store store = open(name);
        std::uint64_t slot = 0;
        for (const int number : numbers) {
            auto session = tests::a_session(number);
            session.slot = slot++;
            store.begin_session(tests::a_participant(number), session,
                                {{session.session_id, tests::kUtc, kStimuliDigestEvent, "d1"}});
            for (int index = 0; index < 7; ++index) {
                store.add_trial(tests::a_trial(number, index));
            }
            store.complete_session(session.session_id, tests::kUtc);
        }
        return store;
    }
    Store target() {
        if (GetParam() == std::string("SQLite")) return open("into");
        return {tests::PostgresServer::shared().new_database(), Store::Access::kReadWrite};
    }
    void expect_refused(Store& into, Store& from, const std::string& text) {
        const auto before = into.trials();
        const auto sessions = into.sessions();
        const auto events = into.events();
        try {
            into.take_in(from);
            ADD_FAILURE() << "merged";
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            EXPECT_THAT(error.what(), HasSubstr(text));
        }
        EXPECT_EQ(into.trials(), before);
        EXPECT_EQ(into.sessions(), sessions);
        EXPECT_EQ(into.events(), events);
    }

  private:
    tests::TemporaryFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Both, Merge, testing::Values("SQLite", "PostgreSQL"),
                         [](const auto& given) { return std::string(given.param); });

TEST_P(Merge, JoinsTheAnswersOfKiosksThatCountedTheirSlotsForThemselves) {
    Store one = kiosk("one", {0, 1});
    Store two = kiosk("two", {10, 11, 12});
    Store into = target();
    EXPECT_EQ(into.take_in(one).sessions, 2);
    const MergedRows merged = into.take_in(two);
    EXPECT_EQ(merged.sessions, 3);
    EXPECT_EQ(merged.trials, 21);
    EXPECT_EQ(merged.shared_slots, 2);
    EXPECT_EQ(into.trials().size(), 35U);
    EXPECT_EQ(into.participants().size(), 5U);
    EXPECT_EQ(into.trials_of("s11"), two.trials_of("s11"));
    const auto taken = into.taken_slots("jakobsen2010", 20100501, Kind::kParticipant);
    EXPECT_THAT(taken, testing::UnorderedElementsAre(0, 0, 1, 1, 2));
}

TEST_P(Merge, ASecondTimeAddsNothing) {
    Store one = kiosk("one", {0, 1});
    Store into = target();
    (void)into.take_in(one);
    const auto sessions = into.sessions();
    const auto events = into.events();
    const MergedRows again = into.take_in(one);
    EXPECT_EQ(again.sessions, 0);
    EXPECT_EQ(again.sessions_there, 2);
    EXPECT_EQ(again.trials + again.events, 0);
    EXPECT_EQ(into.sessions(), sessions);
    EXPECT_EQ(into.events(), events);
}

TEST_P(Merge, ASessionThatWentOnSinceItWasMergedIsCompletedByMergingAgain) {
    Store one = open("one");
    one.begin_session(tests::a_participant(0), tests::a_session(0));
    for (int index = 0; index < 3; ++index) one.add_trial(tests::a_trial(0, index));
    Store into = target();
    EXPECT_EQ(into.take_in(one).trials, 3);
    EXPECT_EQ(into.sessions().front().state, SessionState::kOpen);
    for (int index = 3; index < 7; ++index) one.add_trial(tests::a_trial(0, index));
    one.complete_session("s0", tests::kUtc);
    EXPECT_EQ(into.take_in(one).trials, 4);
    EXPECT_EQ(into.sessions().front().state, SessionState::kCompleted);
    EXPECT_EQ(into.trials(), one.trials());
}

TEST_P(Merge, AnotherStudyFileOtherImagesOrAnotherAnswerUnderTheSameNameIsRefusedWhole) {
    Store one = kiosk("one", {0});
    Store into = target();
    (void)into.take_in(one);
    Store other_study = open("study");
    auto session = tests::a_session(5);
    session.study_sha256 = std::string(64, 'e');
    other_study.begin_session(tests::a_participant(5), session);
    expect_refused(into, other_study, "the study file of jakobsen2010 (eeee");
    Store other_images = open("images");
    other_images.begin_session(tests::a_participant(6), tests::a_session(6),
                               {{"s6", tests::kUtc, kStimuliDigestEvent, "d2"}});
    expect_refused(into, other_images, "digest of the images");
    Store other_answer = open("answer");
    auto same = tests::a_session(0);
    other_answer.begin_session(tests::a_participant(0), same);
    auto trial = tests::a_trial(0, 0);
    trial.response_time_s = 9.0;
    other_answer.add_trial(trial);
    other_answer.begin_session(tests::a_participant(7), tests::a_session(7));
    expect_refused(into, other_answer, "answer 1 of session s0");
}

TEST(StoredForm, AnswersToAStudysOwnFormAreExportedWithWhatTheyMean) {
    const tests::TemporaryFolder folder;
    Store store("sqlite3://" + (folder / "a.sqlite").string(), Store::Access::kReadWrite);
    auto participant = tests::a_participant(0);
    participant.code = "K7";
    participant.consent_version = "2026-11";
    participant.consent_items = R"(["I agree"])";
    participant.consent_utc = tests::kUtc;
    participant.form = R"([{"field":"hours","kind":"number","label":"Hours of play","unit":"h",)"
                       R"("value":2.5},{"field":"games","kind":"choices","label":"Plays",)"
                       R"("choices":["chess","go"],"value":["chess","go"]}])";
    store.begin_session(participant, tests::a_session(0));
    auto silent = tests::a_participant(1);
    store.begin_session(silent, tests::a_session(1));
    EXPECT_EQ(store.participants().front(), participant);
    ExportOptions options;
    options.folder = folder / "out";
    (void)export_store(store, options);
    const std::string table = base::read_file(folder / "out" / "participants.csv");
    EXPECT_THAT(table, HasSubstr("form_hours,form_games"));
    EXPECT_THAT(table, HasSubstr("2.5,chess; go"));
    EXPECT_THAT(table, HasSubstr("K7,2026-11"));
    const std::string dictionary = base::read_file(folder / "out" / "data_dictionary.json");
    EXPECT_THAT(dictionary, HasSubstr("Hours of play"));
    EXPECT_THAT(dictionary, HasSubstr("\"Units\": \"h\""));
}

}  // namespace
}  // namespace obscura::analysis
