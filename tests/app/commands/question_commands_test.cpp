// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// A study with several questions through the commands: check, rehearse, analyze, export, merge.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "analysis/store/store.h"
#include "analysis/table/csv.h"
#include "tests/app/commands/run_program.h"
#include "tests/app/commands/study_text.h"

namespace obscura::app {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

/// Without a question of its own and with four of [[question]].
std::string asking_study() {
    std::string head = study_head("asking", "williams", "language = \"de\"\nties = \"split\"\n");
    const std::string own = "question = \"Which?\"\n";
    head.replace(head.find(own), own.size(), "");
    return head + scene_text("day", "atrium", "high") +
           condition_text("one", "day", "\"none\"", "\"blizzard\"") +
           condition_text("two", "day", "\"none\"", "\"crytek\"") + R"(
[[question]]
id = "real"
kind = "choice-or-none"
text = "Welches Bild wirkte echter?"
labels = ["Das erste", "Das zweite", "Kein Unterschied"]
[[question]]
id = "depth"
kind = "choice"
text = "Welches Bild wirkte tiefer?"
[[question]]
id = "like"
kind = "rating"
of = "images"
text = "Wie echt wirkte es?"
labels = ["gar nicht", "ganz"]
[[question]]
id = "sure"
kind = "confidence"
text = "Wie sicher sind Sie?"
labels = ["unsicher", "sicher"]
max = 5
)";
}

class QuestionCommands : public testing::Test {
  protected:
    void SetUp() override {
        base::write_file_atomically(folder_ / "asking.toml", asking_study());
        const ProgramRun run =
            run_program(folder_, "rehearse asking.toml --participants 24 --quiet");
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }
    [[nodiscard]] ProgramRun analyze(const std::string& options = "") const {
        return run_program(folder_,
                           "analyze --db sqlite3://" + kStore + " --kind simulated " + options);
    }
    [[nodiscard]] std::vector<std::map<std::string, std::string>> rows_of(
        const std::string& name) const {
        const auto records = analysis::parse_csv(base::read_file(folder_ / name), name);
        std::vector<std::map<std::string, std::string>> rows;
        for (std::size_t i = 1; i < records.size(); ++i) {
            for (std::size_t k = 0; k < records[i].fields.size(); ++k) {
                if (k == 0) rows.emplace_back();
                rows.back()[records[0].fields.at(k)] = records[i].fields[k];
            }
        }
        return rows;
    }

    const std::string kStore = "obscura-data/rehearsal/asking.sqlite";
    tests::TemporaryFolder folder_;
};

TEST_F(QuestionCommands, EveryQuestionIsAnalysedInTextJsonAndReport) {
    const ProgramRun text = analyze();
    ASSERT_EQ(text.exit_code, 0) << text.err;
    EXPECT_THAT(text.out, HasSubstr("answers to the pairs saw no difference"));
    EXPECT_THAT(text.out, HasSubstr("depth (choice): Welches Bild wirkte tiefer?"));
    EXPECT_THAT(text.out, HasSubstr("Wilcoxon's signed-rank test of B - A"));
    EXPECT_THAT(text.out, HasSubstr("4 tests")) << "two conditions, depth and like";
    const ProgramRun run = analyze("--json --out report");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const Json result = Json::parse(run.out);
    const Json& questions = result.at("questions");
    EXPECT_EQ(questions.at("ties"), "split");
    ASSERT_THAT(questions.at("questions"), SizeIs(4));
    const Json& real = questions["questions"][0]["conditions"][0];
    EXPECT_EQ(real.at("count_a").get<int>() + real.at("count_b").get<int>() +
                  real.at("count_none").get<int>(),
              24);
    EXPECT_GT(questions.at("no_difference_by_coin").get<int>(), 0);
    EXPECT_TRUE(questions["questions"][3].contains("against_agreement"));
    EXPECT_THAT(base::read_file(folder_ / "report/report.html"),
                HasSubstr("What else was asked of each pair"));
    EXPECT_EQ(Json::parse(base::read_file(folder_ / "report/analysis.json")).at("questions"),
              questions);
}

TEST_F(QuestionCommands, EveryAnswerIsExportedOnceWithItsLabelAndEnglishId) {
    const ProgramRun run =
        run_program(folder_, "export --db sqlite3://" + kStore + " --out tables --quiet");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto rows = rows_of("tables/answers.csv");
    // Two pairs, five pages.
    ASSERT_THAT(rows, SizeIs(24U * 2U * 5U));
    std::map<std::string, int> counts;
    for (const auto& row : rows) {
        ++counts[row.at("question") + ' ' + row.at("about")];
        if (row.at("answer") == "none") {
            EXPECT_EQ(row.at("label"), "Kein Unterschied");
        }
        if (row.at("question") == "sure" && row.at("answer") == "5") {
            EXPECT_EQ(row.at("label"), "sicher");
        }
    }
    EXPECT_EQ(counts["like A"], 48);
    EXPECT_EQ(counts["like B"], 48);
    const Json dictionary = Json::parse(base::read_file(folder_ / "tables/data_dictionary.json"));
    EXPECT_EQ(dictionary.at("answers.csv").at("question").at("Levels").at("depth"),
              "Welches Bild wirkte tiefer?");
    // A trial says where a coin spoke.
    std::map<std::string, std::string> none;
    for (const auto& row : rows) {
        if (row.at("question") != "real") continue;
        none[row.at("session_id") + row.at("trial_index")] = row.at("answer") == "none" ? "1" : "0";
    }
    for (const auto& row : rows_of("tables/trials.csv")) {
        EXPECT_EQ(row.at("no_difference"), none.at(row.at("session_id") + row.at("trial_index")));
    }
    EXPECT_THAT(base::read_file(folder_ / "tables/events.csv"), Not(HasSubstr("trial_index")));
}

TEST_F(QuestionCommands, TheOtherFormatsHaveThemToo) {
    for (const char* format : {"bids", "psych-ds", "json"}) {
        const ProgramRun run = run_program(
            folder_, fmt::format("export --db sqlite3://{0} --out {1} --format {1} --anonymous "
                                 "--quiet",
                                 kStore, format));
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }
    const std::string bids = base::read_file(folder_ / "bids/sourcedata/answers.tsv");
    EXPECT_EQ(std::count(bids.begin(), bids.end(), '\n'), 1 + 24 * 2 * 5);
    EXPECT_THAT(bids, HasSubstr("sub-p01"));
    EXPECT_THAT(bids, Not(HasSubstr("simulated-p")));
    EXPECT_TRUE(Json::parse(base::read_file(folder_ / "bids/sourcedata/answers.json"))
                    .contains("question_kind"));
    const std::string psych =
        base::read_file(folder_ / "psych-ds/data/description-answers_data.csv");
    EXPECT_THAT(psych, HasSubstr("row_id,participant_id"));
    EXPECT_THAT(base::read_file(folder_ / "json/answers.jsonl"), HasSubstr("\"about\": \"pair\""));
}

TEST_F(QuestionCommands, AStudyWithoutThemIsExportedAndAnalysedAsItAlwaysWas) {
    base::write_file_atomically(folder_ / "plain.toml",
                                study_head("plain", "williams") +
                                    scene_text("day", "atrium", "high") +
                                    condition_text("one", "day", "\"none\"", "\"blizzard\"") +
                                    condition_text("two", "day", "\"none\"", "\"crytek\""));
    ASSERT_EQ(run_program(folder_, "rehearse plain.toml --participants 4 --quiet").exit_code, 0);
    const std::string store = "--db sqlite3://obscura-data/rehearsal/plain.sqlite ";
    ASSERT_EQ(run_program(folder_, "export --out plain --quiet " + store).exit_code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_ / "plain/answers.csv"));
    EXPECT_THAT(base::read_file(folder_ / "plain/trials.csv"), Not(HasSubstr("no_difference")));
    const ProgramRun run = run_program(folder_, "analyze --kind simulated --json " + store);
    EXPECT_FALSE(Json::parse(run.out).contains("questions"));
}

TEST_F(QuestionCommands, MergingStoresTwiceBringsEachAnswerOnce) {
    for (int time = 0; time < 2; ++time) {
        const ProgramRun run = run_program(folder_, "merge --into sqlite3://all.sqlite " + kStore);
        ASSERT_EQ(run.exit_code, 0) << run.err;
    }
    analysis::Store one("sqlite3://" + (folder_ / kStore).string(),
                        analysis::Store::Access::kReadOnly);
    analysis::Store all("sqlite3://" + (folder_ / "all.sqlite").string(),
                        analysis::Store::Access::kReadOnly);
    EXPECT_EQ(all.events(), one.events());
}

}  // namespace
}  // namespace obscura::app
