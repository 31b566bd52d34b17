// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "analysis/store/store.h"
#include "app/commands/list.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;
using base::ExitCode;
using testing::AllOf;
using testing::HasSubstr;

struct Ending {
    ExitCode code = ExitCode::kDone;
    std::string out;      ///< standard output
    std::string message;  ///< of the error
};

class CommandsTest : public testing::Test {
  protected:
    void add_session(analysis::Kind kind) const {
        analysis::Store store("sqlite3://" + file.string(), analysis::Store::Access::kReadWrite);
        tests::add_completed(store, static_cast<int>(store.sessions().size()), kind);
    }

    [[nodiscard]] Ending run(const Command& command, std::vector<std::string> arguments) const {
        Globals globals;
        globals.data = folder.path();
        CommandLine line("", command.name, [] { return std::string(); });
        Ending ending;
        testing::internal::CaptureStdout();
        try {
            const auto act = command.attach(line.options(), globals);
            if (line.parse(arguments)) ending.code = act();
        } catch (const base::Error& error) {
            ending = {error.code(), "", error.what()};
        }
        ending.out = testing::internal::GetCapturedStdout();
        return ending;
    }

    tests::TemporaryFolder folder;
    fs::path file = folder / "responses.sqlite";
};

const std::string kPublished = OBSCURA_SOURCE_DIR "/analysis/data/jakobsen2010.csv";

TEST_F(CommandsTest, AnalyzePrintsATableOrJsonAndWritesBoth) {
    const fs::path out = folder / "reports";
    const Ending table =
        run(analyze_command(), {"--counts", kPublished, "--full", "--out", out.string()});
    EXPECT_EQ(table.code, ExitCode::kDone) << table.message;
    EXPECT_EQ(base::read_file(out / "analysis.txt"), table.out);
    const Ending json = run(analyze_command(), {"--counts", kPublished, "--json"});
    EXPECT_EQ(base::read_file(out / "analysis.json"), json.out);
    EXPECT_NEAR(nlohmann::json::parse(json.out)["conditions"][2]["p_holm"].get<double>(), .201717,
                1e-6);
}

TEST_F(CommandsTest, AnalyzeReadsTheStoreOfTheDataFolder) {
    add_session(analysis::Kind::kParticipant);
    add_session(analysis::Kind::kSimulated);
    add_session(analysis::Kind::kSimulated);
    EXPECT_THAT(run(analyze_command(), {}).out, HasSubstr("1 participant, 7 conditions"));
    EXPECT_THAT(run(analyze_command(), {"--kind", "simulated"}).out,
                AllOf(HasSubstr("2 simulated observers"), HasSubstr("SIMULATED DATA")));
}

TEST_F(CommandsTest, AnalyzePointsToSimulatedAnswersWhereThereAreNoOthers) {
    add_session(analysis::Kind::kSimulated);
    const Ending ending = run(analyze_command(), {});
    EXPECT_EQ(ending.code, ExitCode::kBadInput);
    EXPECT_THAT(ending.message, HasSubstr("--kind simulated analyses those"));
}

TEST_F(CommandsTest, BadInputEndsWithTwoAndWritesNothing) {
    const fs::path votes = folder / "votes.csv";
    base::write_file_atomically(votes, "condition,votes\n");
    const fs::path out = folder / "out";
    fs::create_directory(out);
    const std::string to = out.string();
    for (const auto& arguments : std::vector<std::vector<std::string>>{
             {"--out", to},  // no store in the data folder
             {"--counts", votes.string(), "--out", to},
             {"--counts", "/nowhere.csv", "--out", to},
             {"--counts", kPublished, "--kind", "simulated", "--out", to},
             {"--db", "sqlite3://" + votes.string(), "--out", to},
             {"--kind", "practice", "--out", to},
             {"another", "--out", to},
             {"--counts", kPublished, "--out", votes.string()},
         }) {
        const Ending ending = run(analyze_command(), arguments);
        EXPECT_EQ(ending.code, ExitCode::kBadInput) << testing::PrintToString(arguments);
        EXPECT_FALSE(ending.message.empty());
    }
    EXPECT_TRUE(fs::is_empty(out));
    EXPECT_FALSE(fs::exists(file)) << "reading must make no store";
}

TEST_F(CommandsTest, ExportWritesFilesAndRefusesUnknownFormats) {
    const std::string to = (folder / "export").string();
    EXPECT_EQ(run(export_command(), {"--out", to}).code, ExitCode::kBadInput) << "no store";
    add_session(analysis::Kind::kParticipant);
    const Ending unknown = run(export_command(), {"--out", to, "--format", "xlsx"});
    EXPECT_EQ(unknown.code, ExitCode::kBadInput);
    EXPECT_THAT(unknown.message, AllOf(HasSubstr("--format"), HasSubstr("csv")));
    EXPECT_FALSE(fs::exists(to));
    EXPECT_EQ(run(export_command(), {}).code, ExitCode::kBadInput) << "--out is needed";
    EXPECT_EQ(run(export_command(), {"--out", to}).code, ExitCode::kDone);
    EXPECT_TRUE(fs::exists(fs::path(to) / "data_dictionary.json"));
    EXPECT_EQ(run(export_command(), {"--out", to}).code, ExitCode::kBadInput) << "they are there";
    EXPECT_EQ(run(export_command(), {"--out", to, "--force"}).code, ExitCode::kDone);
}

TEST_F(CommandsTest, ExportTakesOnlyTheStudyFileThatTheSessionsBeganWith) {
    const std::string to = (folder / "export").string();
    add_session(analysis::Kind::kParticipant);
    const Ending other = run(export_command(), {"--out", to, "jakobsen2010"});
    EXPECT_EQ(other.code, ExitCode::kBadInput);
    EXPECT_THAT(other.message, AllOf(HasSubstr("STUDY: jakobsen2010: its SHA-256 is"),
                                     HasSubstr(std::string(64, 'a'))));
    EXPECT_EQ(run(export_command(), {"--out", to, "--seed", "3"}).code, ExitCode::kBadInput);
    EXPECT_FALSE(fs::exists(to));
    const Ending bids = run(export_command(), {"--out", to, "--format", "bids", "--anonymous"});
    EXPECT_EQ(bids.code, ExitCode::kDone) << bids.message;
    EXPECT_TRUE(fs::exists(fs::path(to) / "sub-p1"));
}

TEST_F(CommandsTest, AnalyzeOfExportedTrialsGivesTheStoresStatistics) {
    add_session(analysis::Kind::kParticipant);
    add_session(analysis::Kind::kParticipant);
    add_session(analysis::Kind::kSimulated);
    const std::string to = (folder / "export").string();
    ASSERT_EQ(run(export_command(), {"--out", to}).code, ExitCode::kDone);
    const auto without_source = [](const Ending& ending) {
        auto report = nlohmann::json::parse(ending.out);
        report.erase("source");
        return report;
    };
    for (const char* kind : {"participant", "simulated"}) {
        EXPECT_EQ(without_source(run(analyze_command(),
                                     {"--trials", to + "/trials.csv", "--kind", kind, "--json"})),
                  without_source(run(analyze_command(), {"--kind", kind, "--json"})));
    }
    EXPECT_EQ(run(analyze_command(), {"--trials", to + "/sessions.csv"}).code, ExitCode::kBadInput);
    EXPECT_EQ(run(analyze_command(), {"--trials", to + "/trials.csv", "--counts", kPublished}).code,
              ExitCode::kBadInput);
}

TEST_F(CommandsTest, AnalyzeTakesTheColumnsOfATableAsTheCommandLineNamesThem) {
    const fs::path answers = folder / "answers.csv";
    base::write_file_atomically(answers,
                                "Subject;left;right;Response\nann;x;y;left\nbob;x;y;right\n");
    const Ending refused = run(analyze_command(), {"--trials", answers.string()});
    EXPECT_EQ(refused.code, ExitCode::kBadInput);
    EXPECT_THAT(refused.message,
                AllOf(HasSubstr("--map observer=Subject"), HasSubstr("--map condition_A=left"),
                      HasSubstr("--map chosen=Response")));
    const Ending read =
        run(analyze_command(),
            {"--trials", answers.string(), "--map", "observer=Subject", "--map", "condition_A=left",
             "--map", "condition_B=right", "--map", "chosen=Response", "--json"});
    ASSERT_EQ(read.code, ExitCode::kDone) << read.message;
    EXPECT_EQ(nlohmann::json::parse(read.out)["n_participants"], 2);
    EXPECT_EQ(run(analyze_command(), {"--map", "observer=Subject"}).code, ExitCode::kBadInput)
        << "a store has our names";
}

TEST_F(CommandsTest, PowerSaysWhatIsNeededAndWhatANumberAchieves) {
    const Ending table =
        run(power_command(), {"--share", ".65", "--participants", "36", "--conditions", "7"});
    EXPECT_EQ(table.code, ExitCode::kDone) << table.message;
    EXPECT_THAT(table.out, AllOf(HasSubstr("97"), HasSubstr("0.065245"), HasSubstr("Holm")));
    const Ending json =
        run(power_command(), {"--share", ".6", ".75", "--curve", "35:36", "--json"});
    const auto report = nlohmann::json::parse(json.out);
    EXPECT_EQ(report["needed"][0]["exact"], 210);
    EXPECT_EQ(report["needed"][1]["exact"], 35);
    EXPECT_EQ(report["curve"].size(), 4U);
    EXPECT_EQ(report["curve"][3]["n"], 36);
    EXPECT_EQ(report["curve"][3]["share"], .75);
}

TEST_F(CommandsTest, PowerGivesItsCurveAsCsv) {
    const Ending csv = run(power_command(), {"--share", ".75", "--curve", "5:6", "--csv"});
    EXPECT_EQ(csv.code, ExitCode::kDone) << csv.message;
    EXPECT_THAT(csv.out, AllOf(testing::StartsWith("participants,share,exact_power,"),
                               HasSubstr("\n5,0.75,0,0,"), HasSubstr("\n6,0.75,0.178")));
    EXPECT_EQ(run(power_command(), {"--csv"}).code, ExitCode::kBadInput) << "without a curve";
}

TEST_F(CommandsTest, PowerRefusesWhatCannotBe) {
    for (const auto& arguments : std::vector<std::vector<std::string>>{{"--share", "0.5"},
                                                                       {"--share", "1"},
                                                                       {"--level", "0"},
                                                                       {"--power", "nan"},
                                                                       {"--conditions", "0"},
                                                                       {"--participants", "0"},
                                                                       {"--participants", "many"},
                                                                       {"--curve", "5"},
                                                                       {"--curve", "9:5"},
                                                                       {"--curve", "1:9:0"},
                                                                       {"--curve", "1:9:1x"},
                                                                       {"--curve", "1:99999"}}) {
        const Ending ending = run(power_command(), arguments);
        EXPECT_EQ(ending.code, ExitCode::kBadInput) << testing::PrintToString(arguments);
        EXPECT_FALSE(ending.message.empty());
    }
}

}  // namespace
}  // namespace obscura::app
