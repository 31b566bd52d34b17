// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// No answer that was acknowledged is lost: not when the program is killed, not when the disk fills.
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "analysis/store/database.h"
#include "analysis/store/store.h"
#include "renderer/base/error.h"
#include "renderer/base/random.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using testing::HasSubstr;

class StoreCrashTest : public testing::Test {
  protected:
    void expect_integrity() const {
        Database database(url, true);
        std::string integrity;
        database.session() << "PRAGMA integrity_check", soci::into(integrity);
        EXPECT_EQ(integrity, "ok");
    }

    /// The file alone has them, unless the kill came between two answers, in the middle of a
    /// commit.
    void expect_in_a_copy(int number, std::size_t acknowledged) const {
        namespace fs = std::filesystem;
        if (fs::exists(folder / "responses.sqlite-journal")) return;
        fs::copy_file(folder / "responses.sqlite", folder / "copy.sqlite",
                      fs::copy_options::overwrite_existing);
        Store copy("sqlite3://" + (folder / "copy.sqlite").string(), Store::Access::kReadOnly);
        EXPECT_GE(copy.trials_of(fmt::format("s{}", number)).size(), acknowledged);
    }

    tests::TemporaryFolder folder;
    std::string url = "sqlite3://" + (folder / "responses.sqlite").string();
};

/// Answers trials 0, 1, 2 ... of session s<number> for ever; writes a byte to `acknowledged` after
/// each call that returned.
[[noreturn]] void answer_for_ever(const std::string& url, int number, int acknowledged) {
    Store store(url, Store::Access::kReadWrite);
    auto session = tests::a_session(number);
    session.condition_count = 1'000'000;
    store.begin_session(tests::a_participant(number), session);
    for (int index = 0;; ++index) {
        store.add_trial(tests::a_trial(number, index));
        if (::write(acknowledged, "+", 1) != 1) ::_exit(1);
    }
}

TEST_F(StoreCrashTest, EveryAcknowledgedAnswerSurvivesSigkill) {
    { const Store store(url, Store::Access::kReadWrite); }
    base::Random random(7);
    std::size_t answers = 0;
    constexpr int kKills = 12;
    for (int number = 0; number < kKills; ++number) {
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t child = ::fork();
        if (child == 0) answer_for_ever(url, number, ends[1]);
        ::close(ends[1]);
        std::size_t acknowledged = 0;
        char byte = 0;
        const std::size_t awaited = random.below(4);
        while (acknowledged < awaited && ::read(ends[0], &byte, 1) == 1) ++acknowledged;
        std::this_thread::sleep_for(std::chrono::microseconds(random.below(30'000)));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        while (::read(ends[0], &byte, 1) == 1) ++acknowledged;
        ::close(ends[0]);
        expect_in_a_copy(number, acknowledged);

        Store store(url, Store::Access::kReadWrite);
        const auto trials = store.trials_of(fmt::format("s{}", number));
        EXPECT_GE(trials.size(), acknowledged);
        EXPECT_LE(trials.size(), acknowledged + 1);  // killed between the commit and the byte
        for (std::size_t index = 0; index < trials.size(); ++index) {
            EXPECT_EQ(trials[index], tests::a_trial(number, static_cast<int>(index)));
        }
        answers += acknowledged;
        expect_integrity();
    }
    EXPECT_GT(answers, 0U) << "no child lived long enough to answer anything";
}

TEST_F(StoreCrashTest, ASessionThatWasCutOffIsFoundAndContinued) {
    const pid_t child = ::fork();
    if (child == 0) {
        Store store(url, Store::Access::kReadWrite);
        store.begin_session(tests::a_participant(0), tests::a_session(0));
        store.add_trial(tests::a_trial(0, 0));
        ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
    Store store(url, Store::Access::kReadWrite);
    const auto open = store.open_sessions("jakobsen2010", Kind::kParticipant);
    ASSERT_EQ(open.size(), 1U);
    EXPECT_EQ(open.front(), tests::a_session(0));
    ASSERT_EQ(store.trials_of("s0").size(), 1U);
    for (int index = 1; index < 7; ++index) store.add_trial(tests::a_trial(0, index));
    store.complete_session("s0", tests::kUtc);
    EXPECT_TRUE(store.open_sessions("jakobsen2010", Kind::kParticipant).empty());
}

constexpr int kProcesses = 4;
constexpr int kSessionsEach = 5;

/// Begins sessions in the first slots that are free; the processes make the store all at once.
bool begin_sessions(const std::string& url, int process) {
    std::uint64_t slot = 0;
    int begun = 0;
    const auto begin = [&] {
        Store store(url, Store::Access::kReadWrite);
        while (begun < kSessionsEach) {
            const int number = process * kSessionsEach + begun;
            auto session = tests::a_session(number);
            session.slot = slot++;
            store.begin_session(tests::a_participant(number), session);
            ++begun;
        }
    };
    while (begun < kSessionsEach) {
        try {
            begin();
        } catch (const base::Error& error) {
            if (std::string_view(error.what()).find("is taken by session") == std::string::npos) {
                fmt::print(stderr, "{}\n", error.what());
                return false;
            }
        }
    }
    return true;
}

TEST_F(StoreCrashTest, ManyProcessesNeverShareASlot) {
    std::vector<pid_t> children;
    for (int process = 0; process < kProcesses; ++process) {
        children.push_back(::fork());
        if (children.back() == 0) ::_exit(begin_sessions(url, process) ? 0 : 1);
    }
    for (const pid_t child : children) {
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0);
    }
    std::vector<std::uint64_t> expected;
    for (std::uint64_t slot = 0; slot < kProcesses * kSessionsEach; ++slot)
        expected.push_back(slot);
    Store store(url, Store::Access::kReadOnly);
    EXPECT_EQ(store.taken_slots("jakobsen2010", 20100501, Kind::kParticipant), expected);
}

/// A limit on the size of files meets the same error path as a full disk, on every machine.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        old_handler_ = std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &old_);
        rlimit limit = old_;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

  private:
    rlimit old_{};
    void (*old_handler_)(int) = nullptr;
};

TEST_F(StoreCrashTest, AFullDiskIsAClearErrorAndEarlierAnswersRemain) {
    Store store(url, Store::Access::kReadWrite);
    auto session = tests::a_session(0);
    session.condition_count = 1000;
    store.begin_session(tests::a_participant(0), session);
    int answered = 0;
    std::string message;
    {
        const FileSizeLimit limit(200'000);
        try {
            for (; answered < 1000; ++answered) store.add_trial(tests::a_trial(0, answered));
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kFailed);
            message = error.what();
        }
        EXPECT_THAT(message, HasSubstr("the disk is full"));
        EXPECT_THAT(message, HasSubstr("responses.sqlite"));
        EXPECT_GT(answered, 0);
        EXPECT_EQ(store.trials().size(), static_cast<std::size_t>(answered));
    }
    store.add_trial(tests::a_trial(0, answered));  // there is room again
    EXPECT_EQ(Store(url, Store::Access::kReadOnly).trials().size(),
              static_cast<std::size_t>(answered) + 1);
    expect_integrity();
}

TEST_F(StoreCrashTest, ADiskThatIsFullFromTheStartIsAClearError) {
    const FileSizeLimit limit(2'000);
    try {
        const Store store(url, Store::Access::kReadWrite);
        ADD_FAILURE() << "opened";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kFailed) << error.what();
        EXPECT_THAT(error.what(), HasSubstr("the disk is full"));
    }
}

}  // namespace
}  // namespace obscura::analysis
