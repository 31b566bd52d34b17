// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What an export says beyond the store's rows: who is left out, what was looked at, which tests the
// analysis makes; and that the scripts beside it repeat those tests.
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "analysis/conclusions/exported_conclusions.h"
#include "analysis/conclusions/pooled_share.h"
#include "analysis/presentation/json_report.h"
#include "analysis/table/csv.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/random.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

struct ShownCondition {
    const char* id;
    const char* hypothesis;
    const char* scene;
    const char* validity;
    const char* a;
    const char* b;
    double share_b;
};
constexpr ShownCondition kShown[]{
    {"I", "H2", "relic-low", "low", "Crytek24", "Blizzard24", .6},
    {"II", "H1", "atrium-moderate", "moderate", "None", "Blizzard24", .8},
    {"III", "H2", "atrium-moderate", "moderate", "Crytek24", "Blizzard24", .5},
    {"V", "H1", "atrium-high", "high", "None", "Blizzard24", .3},
    {"VI", "H2", "atrium-high", "high", "Crytek24", "Blizzard24", .6},
};

/// Fourteen observers who answered five pairs, a catch trial and a repeat; the rule leaves out the
/// last one. One more session was broken off.
class ExportedTests : public testing::Test {
  protected:
    void SetUp() override {
        for (int number = 0; number < 15; ++number) add(number);
        ExportedStudy study;
        study.name = "jakobsen2010";
        study.sha256 = std::string(64, 'a');
        study.views = {{"relic-low", {"relic", "plinth", "relic, camera plinth"}},
                       {"atrium-moderate", {"atrium", "nave", "atrium, camera nave"}},
                       {"atrium-high", {"atrium", "nave", "atrium, camera nave"}}};
        options_.studies = {study};
        options_.overwrite = true;
        options_.folder = out_;
        EXPECT_THAT(add_conclusions(options_, store_, url_), IsEmpty());
    }

    static TrialRecord trial_of(int number, int index, const ShownCondition& shown) {
        auto trial = tests::a_trial(number, index);
        trial.condition = shown.id;
        trial.hypothesis = shown.hypothesis;
        trial.scene = shown.scene;
        trial.validity = shown.validity;
        trial.condition_A = shown.a;
        trial.condition_B = shown.b;
        return trial;
    }

    static void answer(TrialRecord& trial, bool chose_b) {
        trial.is_A_selected = !chose_b;
        trial.response_first = trial.is_A_selected == (trial.first_shown == 'A');
    }

    void add(int number) {
        auto session = tests::a_session(number);
        session.exclusion = R"({"min_catch_correct":0.5})";
        store_.begin_session(tests::a_participant(number), session);
        int index = 0;
        for (const ShownCondition& shown : kShown) {
            auto trial = trial_of(number, index++, shown);
            trial.first_shown = random_.below(2) == 0 ? 'A' : 'B';
            answer(trial, random_.below(100) < static_cast<unsigned>(100 * shown.share_b));
            store_.add_trial(trial);
        }
        auto repeat = trial_of(number, index++, kShown[1]);
        repeat.condition = "II again";
        repeat.repeats = "II";
        store_.add_trial(repeat);
        if (number == 14) return store_.abandon_session("s14", tests::kUtc, "went home");
        auto caught = trial_of(number, index++, kShown[0]);
        caught.condition = "look";
        caught.kind = Kind::kCatch;
        caught.expected = 'B';
        answer(caught, number != 13);
        store_.add_trial(caught);
        store_.complete_session(session.session_id, tests::kUtc);
    }

    [[nodiscard]] std::vector<std::map<std::string, std::string>> rows(const fs::path& file) const {
        const auto records = parse_csv(base::read_file(file), file.string());
        std::vector<std::map<std::string, std::string>> rows;
        for (std::size_t i = 1; i < records.size(); ++i) {
            auto& row = rows.emplace_back();
            for (std::size_t k = 0; k < records[0].fields.size(); ++k) {
                row[records[0].fields[k]] = records[i].fields[k];
            }
        }
        return rows;
    }

    [[nodiscard]] Analysis analysis() {
        Tally tally = tally_of(read_answers(store_, url_), "", Kind::kParticipant);
        std::map<std::string, std::string> names;
        for (const auto& [scene, view] : options_.studies[0].views) names[scene] = view.name;
        name_views(tally, names);
        return analyse(std::move(tally));
    }

    tests::TemporaryFolder folder_;
    fs::path out_ = folder_ / "out";
    std::string url_ = "sqlite3://" + (folder_ / "responses.sqlite").string();
    Store store_{url_, Store::Access::kThrowaway};
    ExportOptions options_;
    base::Random random_{7};
};

/// Whether the shell finds that program.
bool is_there(const std::string& program) {
    return std::system(("command -v " + program + " > /dev/null 2>&1").c_str()) == 0;
}

/// By the first three columns, the cells of both of a script's tables.
using Printed = std::map<std::string, std::vector<std::string>>;

Printed printed_by(const std::string& program, const fs::path& script) {
    const fs::path file = script.string() + ".out";
    const std::string command =
        fmt::format("{} '{}' > '{}'", program, script.string(), file.string());
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    Printed printed;
    std::istringstream lines(base::read_file(file));
    for (std::string line; std::getline(lines, line);) {
        std::vector<std::string> cells;
        std::istringstream text(line);
        for (std::string cell; std::getline(text, cell, '\t');) cells.push_back(cell);
        if (cells.size() > 3) {
            printed[fmt::format("{}/{}/{}", cells[0], cells[1], cells[2])] = cells;
        }
    }
    return printed;
}

void expect_number(const std::string& text, double expected, const std::string& what) {
    EXPECT_NEAR(std::strtod(text.c_str(), nullptr), expected, 1e-9) << what;
}

/// The corrected p of a primary hypothesis, and none of a secondary one.
void expect_holm(const std::vector<std::string>& cells, const Verdict& verdict) {
    EXPECT_EQ(cells.at(3), verdict.is_primary ? "primary" : "secondary");
    if (verdict.p_holm.has_value()) {
        expect_number(cells.at(8), *verdict.p_holm, verdict.hypothesis);
    } else {
        EXPECT_EQ(cells.size(), 8U) << verdict.hypothesis << " stands alone";
    }
}

/// Both tables of a script, next to what the program says.
void expect_same_tests(const Printed& printed, const Analysis& analysis) {
    const std::string prefix = "jakobsen2010/participant/";
    for (const ConditionResult& result : analysis.conditions) {
        const std::string& id = result.condition.id;
        ASSERT_TRUE(printed.contains(prefix + id)) << id;
        const auto& cells = printed.at(prefix + id);
        ASSERT_EQ(cells.size(), 7U) << id;
        expect_number(cells[3], static_cast<double>(result.condition.votes.a), id);
        expect_number(cells[4], static_cast<double>(result.condition.votes.b), id);
        expect_number(cells[5], result.preference.exact->p, id);
        expect_number(cells[6], *result.p_holm, id);
    }
    for (const HypothesisResult& result : analysis.hypotheses) {
        ASSERT_TRUE(printed.contains(prefix + result.name)) << result.name;
        expect_number(printed.at(prefix + result.name).at(7), p_of(result)->p, result.name);
    }
    for (const Verdict& verdict : analysis.verdicts) {
        if (!verdict.is_on_validity) expect_holm(printed.at(prefix + verdict.hypothesis), verdict);
    }
    int interactions = 0;
    for (const auto& [name, cells] : printed) {
        if (!name.starts_with(prefix + "H3: ")) continue;
        const std::string pair = name.find("II, V)") != std::string::npos ? "II" : "III";
        for (const Comparison& comparison : analysis.validity->by_level) {
            if (comparison.conditions.front() != pair) continue;
            ++interactions;
            expect_number(cells.at(7), p_of(comparison)->p, name);
            expect_number(cells.at(5), static_cast<double>(comparison.same_participants->n), name);
        }
    }
    EXPECT_EQ(interactions, 2);
}

TEST_F(ExportedTests, TheScriptsBesideEveryExportRepeatTheMainTests) {
    std::vector<std::pair<std::string, std::string>> programs;
    if (is_there("python3")) programs.emplace_back("python3", "main_tests.py");
    if (is_there("Rscript")) programs.emplace_back("Rscript --vanilla", "main_tests.R");
    if (programs.empty()) GTEST_SKIP() << "neither python3 nor Rscript is there";
    const Analysis expected = analysis();
    ASSERT_EQ(expected.tally.n_participants.value, 13);
    for (const ExportFormat format : kExportFormats) {
        options_.format = format;
        (void)export_store(store_, options_);
        for (const auto& [program, script] : programs) {
            // R takes half a second to start, and JSON Lines need a package of its own.
            const bool is_read_by_r = format == ExportFormat::kCsv || format == ExportFormat::kBids;
            if (script.ends_with("R") && !is_read_by_r) continue;
            const fs::path place = format == ExportFormat::kBids      ? out_ / "code"
                                   : format == ExportFormat::kPsychDs ? out_ / "analysis"
                                                                      : out_;
            SCOPED_TRACE(fmt::format("{} of {}", program, to_string(format)));
            expect_same_tests(printed_by(program, place / script), expected);
        }
    }
}

TEST_F(ExportedTests, TheScriptsCorrectOverThePrimaryTestsOfThePlanAndNoOthers) {
    constexpr const char* kPlan =
        R"({"hypotheses":[{"id":"P","kind":"preference","conditions":["II","V"],"role":"primary"},)"
        R"({"id":"R","kind":"preference","conditions":["I"],"role":"secondary"},)"
        R"({"id":"S","kind":"preference","conditions":["III","IX"],"role":"primary"},)"
        R"({"id":"T","kind":"preference","conditions":["IX"],"role":"primary"},)"
        R"({"id":"Q","kind":"interaction","pairs":[["III","VI"],["II","IX"]],"role":"primary"}]})";
    for (int number = 30; number < 44; ++number) {
        auto session = tests::a_session(number);
        session.study = "planned";
        session.study_plan = kPlan;
        session.condition_count = static_cast<int>(std::size(kShown));
        store_.begin_session(tests::a_participant(number), session);
        int index = 0;
        for (const ShownCondition& shown : kShown) {
            auto trial = trial_of(number, index++, shown);
            answer(trial, number % 4 != 0 || index > 2);
            store_.add_trial(trial);
        }
        store_.complete_session(session.session_id, tests::kUtc);
    }
    options_.tests.clear();
    options_.left_out.clear();
    EXPECT_THAT(add_conclusions(options_, store_, url_), IsEmpty());
    (void)export_store(store_, options_);
    const Analysis expected =
        analyse(tally_of(read_answers(store_, url_), "planned", Kind::kParticipant));
    for (const auto& [program, script] :
         {std::pair("python3", "main_tests.py"), std::pair("Rscript --vanilla", "main_tests.R")}) {
        if (!is_there(std::string(program).substr(0, 7))) continue;
        SCOPED_TRACE(program);
        const Printed printed = printed_by(program, out_ / script);
        int corrected = 0;
        for (const Verdict& verdict : expected.verdicts) {
            if (verdict.is_on_validity || !verdict.p.has_value()) continue;
            expect_holm(printed.at("planned/participant/" + verdict.hypothesis), verdict);
            EXPECT_EQ(verdict.tests, 5U);
            ++corrected;
        }
        EXPECT_EQ(corrected, 3) << "nobody answered T";
        EXPECT_TRUE(printed.contains("planned/participant/Q: not compared 2"));
    }
}

TEST_F(ExportedTests, ATrialSaysWhetherItCountsAndWhatWasLookedAt) {
    (void)export_store(store_, options_);
    int votes = 0;
    for (const auto& row : rows(out_ / "trials.csv")) {
        const std::string& session = row.at("session_id");
        EXPECT_NE(row.at("chose_B"), row.at("is_A_selected"));
        const bool is_vote =
            session != "s14" && row.at("repeats").empty() && row.at("kind") == "participant";
        EXPECT_EQ(row.at("is_vote"), is_vote ? "1" : "0") << session << row.at("condition");
        EXPECT_EQ(row.at("excluded"), session == "s14" ? "" : session == "s13" ? "1" : "0");
        EXPECT_EQ(row.at("excluded_reason"),
                  session == "s13" ? "0 of 1 catch trials correct, a share of 0 below 0.5" : "");
        EXPECT_EQ(row.at("scene_source"), row.at("scene") == "relic-low" ? "relic" : "atrium");
        EXPECT_EQ(row.at("camera"), row.at("scene") == "relic-low" ? "plinth" : "nave");
        if (is_vote && row.at("excluded") == "0") ++votes;
    }
    int counted = 0;
    for (const ConditionResult& result : analysis().conditions) {
        counted += static_cast<int>(result.condition.votes.n());
    }
    EXPECT_EQ(votes, counted);
}

TEST_F(ExportedTests, WhatWasLookedAtIsNotKnownOfAnotherVersionOfTheStudy) {
    options_.studies[0].sha256 = std::string(64, 'f');
    (void)export_store(store_, options_);
    EXPECT_EQ(rows(out_ / "trials.csv")[0].at("scene_source"), "");
    // The image that the trial showed says it whatever the study file says now.
    options_.studies[0].images = {
        {"I", 'A', "I-a.png", std::string(64, 'b'), "elsewhere", "corner"}};
    options_.studies[0].images.push_back(options_.studies[0].images[0]);
    options_.studies[0].images[1].side = 'B';
    (void)export_store(store_, options_);
    for (const auto& row : rows(out_ / "trials.csv")) {
        const bool is_known = row.at("condition") == "I";
        EXPECT_EQ(row.at("scene_source"), is_known ? "elsewhere" : "") << row.at("condition");
        EXPECT_EQ(row.at("camera"), is_known ? "corner" : "");
    }
}

TEST_F(ExportedTests, AnAnonymousExportExcludesTheSameNumberUnderNewNames) {
    options_.anonymous_seed = 3;
    (void)export_store(store_, options_);
    std::map<std::string, int> rows_of;
    for (const auto& row : rows(out_ / "trials.csv")) ++rows_of[row.at("excluded")];
    EXPECT_EQ(rows_of["1"], 7);
    EXPECT_EQ(rows_of[""], 6);
    EXPECT_EQ(rows_of["0"], 13 * 7);
}

TEST_F(ExportedTests, AnExportedTableReadsBackToTheSameJsonWithItsExclusions) {
    (void)export_store(store_, options_);
    Tally tally =
        tally_of(parse_trials(base::read_file(out_ / "trials.csv"), url_), "", Kind::kParticipant);
    EXPECT_THAT(tally.notes, IsEmpty());
    std::map<std::string, std::string> names;
    for (const auto& [scene, view] : options_.studies[0].views) names[scene] = view.name;
    name_views(tally, names);
    EXPECT_EQ(json_report(analyse(std::move(tally))), json_report(analysis()));
}

TEST_F(ExportedTests, AnswersThatCannotBeAnalysedAreExportedAndNamed) {
    auto session = tests::a_session(20);
    session.condition_count = 1;
    store_.begin_session(tests::a_participant(20), session);
    auto other = trial_of(20, 0, kShown[0]);
    other.condition_A = "None";  // another pair under a name that is taken
    store_.add_trial(other);
    store_.complete_session("s20", tests::kUtc);
    options_.tests.clear();
    options_.left_out.clear();
    const auto notes = add_conclusions(options_, store_, url_);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0], HasSubstr("tests and exclusions of study jakobsen2010 (participant) are "
                                    "not known: "));
    (void)export_store(store_, options_);
    EXPECT_THAT(rows(out_ / "tests.csv"), IsEmpty());
    for (const auto& row : rows(out_ / "trials.csv")) EXPECT_EQ(row.at("excluded"), "");
}

}  // namespace
}  // namespace obscura::analysis
