// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// A study registered before its data, and what an analysis says of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/commands/run_program.h"
#include "tests/app/commands/study_text.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kFixed = R"([[hypothesis]]
id = "P"
statement = "It looks better."
kind = "preference"
conditions = ["one"]
[stopping]
looks = [6, 12]
spending = "pocock"
)";

TEST(Preregistration, FixesAllOfAStudyAndItsAnalysisSaysWhatDeviates) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "reg.toml", tiny_study("reg") + kFixed);
    const std::string plan = "plan reg.toml --participants 12 --preregister reg --quiet";
    const ProgramRun early = run_program(folder, plan);
    EXPECT_EQ(early.exit_code, 2);
    EXPECT_THAT(early.err, HasSubstr("obscura render makes it"));
    ASSERT_EQ(run_program(folder, "render reg.toml --quiet").exit_code, 0);
    const ProgramRun written = run_program(folder, plan);
    ASSERT_EQ(written.exit_code, 0) << written.err;
    const std::string document = base::read_file(folder / "reg/preregistration.md");
    for (const char* part : {"It looks better.", "margin 15 points", "12 participants", "pocock",
                             "one-a.png", "Power of the verdicts", "Holm's correction"}) {
        EXPECT_THAT(document, HasSubstr(part));
    }
    EXPECT_EQ(run_program(folder, plan).exit_code, 2) << "what was registered is not replaced";
    EXPECT_EQ(run_program(folder, "plan reg.toml --participants 10 --preregister r2").exit_code, 2)
        << "the last look is at 12";

    const auto deviations = [&](const std::string& participants) {
        const ProgramRun rehearsed = run_program(
            folder, "rehearse reg.toml --store s.sqlite --quiet --participants " + participants);
        EXPECT_EQ(rehearsed.exit_code, 0) << rehearsed.err;
        const ProgramRun run =
            run_program(folder,
                        "analyze --db sqlite3://s.sqlite --kind simulated --json --preregistered "
                        "reg/preregistration.md");
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return nlohmann::json::parse(run.out)["registration"]["deviations"];
    };
    EXPECT_THAT(deviations("12"), IsEmpty());
    EXPECT_THAT(deviations("6"), IsEmpty()) << "a planned look";
    const auto other_number = deviations("9");
    ASSERT_EQ(other_number.size(), 1U);
    EXPECT_EQ(other_number[0], "9 participants completed the study, registered are 12.");
    std::string changed = tiny_study("reg") + kFixed;
    changed.replace(changed.find("It looks better."), 16, "It looks worse..");
    base::write_file_atomically(folder / "reg.toml", changed);
    const auto other_file = deviations("12");
    ASSERT_EQ(other_file.size(), 2U) << other_file;
    EXPECT_THAT(other_file[0].get<std::string>(), HasSubstr("study file other than"));
    EXPECT_THAT(other_file[1].get<std::string>(), HasSubstr("are not the registered ones"));
}

TEST(Preregistration, ThatIsNoneIsRefused) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "reg.toml", tiny_study("reg") + kFixed);
    base::write_file_atomically(folder / "none.md", "# Nothing\n");
    base::write_file_atomically(folder / "bad.md", "```json\n{\"format\": 2}\n```\n");
    ASSERT_EQ(run_program(folder, "rehearse reg.toml --store s.sqlite --participants 4 --quiet")
                  .exit_code,
              0);
    for (const char* file : {"none.md", "bad.md", "missing.md"}) {
        const ProgramRun run =
            run_program(folder, std::string("analyze --db sqlite3://s.sqlite --kind simulated "
                                            "--preregistered ") +
                                    file);
        EXPECT_NE(run.exit_code, 0) << file;
        EXPECT_THAT(run.err, HasSubstr(file));
    }
}

}  // namespace
}  // namespace obscura::app
