// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// One vocabulary over all commands.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "app/commands/program.h"
#include "renderer/base/error.h"
#include "tests/app/commands/run_program.h"

namespace obscura::app {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Program made_program() {
    return Program([] { return std::string("version"); });
}

void each_option(const DescribedCommand& command, const std::string& path,
                 const std::function<void(const std::string&, const DescribedOption&)>& act) {
    for (const DescribedOption& option : command.options) act(path, option);
    for (const DescribedCommand& sub : command.commands) {
        each_option(sub, path + " " + sub.name, act);
    }
}

TEST(Vocabulary, HasOneKindOfValueForOneOptionWhereverItIs) {
    const std::set<std::string> words{
        "",      "FILE",  "FOLDER", "NUMBER", "N",   "NAME",           "WxH",   "KEY=VALUE", "URL",
        "X,Y,Z", "SCENE", "ID",     "K/N",    "[N]", "FROM:TO[:STEP]", "REASON"};
    // A file or a folder; a share for one condition or for all.
    const std::set<std::string> differ{"--out", "--share"};
    std::map<std::string, std::string> kinds;
    each_option(made_program().described(), "obscura", [&](const auto& path, const auto& option) {
        EXPECT_FALSE(option.what.empty()) << path;
        EXPECT_THAT(option.what, Not(HasSubstr(" ["))) << path << ": a default in brackets";
        EXPECT_THAT(option.what, Not(HasSubstr("; default"))) << path;
        EXPECT_THAT(option.what, Not(HasSubstr("truth"))) << path << ": elsewhere the reference";
        const bool is_choice = option.value.find('|') != std::string::npos;
        const bool is_own = option.value.find('=') != std::string::npos;
        EXPECT_TRUE(is_choice || is_own || words.contains(option.value))
            << path << ": " << option.value;
        for (const std::string& name : option.names) {
            if (option.by_place || differ.contains(name)) continue;
            const auto [known, fresh] = kinds.try_emplace(name, option.value);
            EXPECT_TRUE(fresh || known->second == option.value)
                << path << " " << name << ": " << option.value << ", elsewhere " << known->second;
        }
    });
}

TEST(Vocabulary, TakesTheNamesOfTheVersionBeforeAndSaysTheNewOnes) {
    const tests::TemporaryFolder folder;
    const ProgramRun measured = run_program(folder, "measure --techniques magic --filters=none");
    EXPECT_EQ(measured.exit_code, 2);
    EXPECT_THAT(measured.err, AllOf(HasSubstr("note: --techniques is now --technique"),
                                    HasSubstr("note: --filters is now --denoise"),
                                    HasSubstr("--technique: \"magic\" is unknown")));
    EXPECT_THAT(run_program(folder, "render --pair none --out made").err,
                AllOf(HasSubstr("note: --pair is now --condition"),
                      HasSubstr("--condition: study jakobsen2010 has no condition \"none\"")));
    const ProgramRun analysed = run_program(folder, "analyze --study-file nowhere.toml --json");
    EXPECT_EQ(analysed.exit_code, 2);
    EXPECT_THAT(analysed.err, AllOf(HasSubstr("note: --study-file is now STUDY"),
                                    HasSubstr("there is no study file nowhere.toml")));
}

TEST(Vocabulary, NamesWhatWasMeantByAnOptionOrACommandThatIsNotThere) {
    const tests::TemporaryFolder folder;
    const auto said = [&](const std::string& words) {
        const ProgramRun run = run_program(folder, words);
        EXPECT_EQ(run.exit_code, 2) << words;
        return run.err;
    };
    EXPECT_THAT(said("ao --techniqe blizzard"),
                AllOf(HasSubstr("there is no option --techniqe; did you mean --technique?"),
                      HasSubstr("See obscura ao --help.")));
    EXPECT_THAT(said("scene export atrium --outt x"), HasSubstr("did you mean --out?"));
    EXPECT_THAT(said("scene export atrium"), HasSubstr("--out is missing"));
    EXPECT_THAT(said("chek"),
                AllOf(HasSubstr("there is no command \"chek\""), HasSubstr("did you mean check?")));
    EXPECT_THAT(said("scene camera atrium"), AllOf(HasSubstr("scene has no command \"camera\""),
                                                   HasSubstr("did you mean cameras?")));
    EXPECT_THAT(said("scene inspect atriun"), HasSubstr("did you mean atrium?"));
    EXPECT_THAT(said("scene inspect atrium --technique gtoa"), HasSubstr("did you mean gtao?"));
    EXPECT_THAT(said("ao --scene relic --technique blizard --out x.exr"),
                HasSubstr("did you mean blizzard?"));
    EXPECT_THAT(said("measure --technique blizard"), HasSubstr("did you mean blizzard?"));
    base::write_file_atomically(folder / "mine.toml", "");
    EXPECT_THAT(said("check mine"), HasSubstr("did you mean mine.toml?"));
    EXPECT_THAT(said("ao --radius 50cm"), HasSubstr("--radius: \"50cm\" is no number"));
    EXPECT_THAT(said("new 'a b'"),
                AllOf(HasSubstr("NAME: \"a b\" cannot be"), Not(HasSubstr(".toml:"))));
    EXPECT_THAT(said("check a b"), HasSubstr("\"b\" is one value too many"));
    EXPECT_THAT(said("plan --participants many"), HasSubstr("--participants"));
}

TEST(Vocabulary, EveryHelpNamesWhatAllCommandsTakeAndTheProgramsSaysHowToAskForOne) {
    const tests::TemporaryFolder folder;
    EXPECT_THAT(run_program(folder, "--help").out, HasSubstr("obscura help COMMAND"));
    EXPECT_EQ(run_program(folder, "help help").out, run_program(folder, "--help").out);
    for (const char* command : {"check", "scene preview", "ao"}) {
        EXPECT_THAT(run_program(folder, std::string("help ") + command).out,
                    HasSubstr("Every command also takes --data, --allow and --quiet"));
    }
}

TEST(Vocabulary, NeverColoursWhatIsNoTerminal) {
    const tests::TemporaryFolder folder;
    EXPECT_THAT(run_program(folder, "check nowhere.toml").err, Not(HasSubstr("\x1b")));
}

TEST(Outputs, AreNotBegunWhereTheCommandThenRefuses) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "bad.toml", "[study]\n");
    for (const char* words :
         {"analyze --out made/report", "measure --technique magic --out made",
          "demo bad.toml --out made", "render --condition none --out made", "export --out made",
          "ao --scene castle --technique none --out made/ao.exr",
          "pack bad.toml --out made/study.zip", "rehearse bad.toml --participants 2 --store made/s",
          "plan bad.toml --participants 2 --preregister made",
          "scene preview nowhere.glb --out made/p.png"}) {
        const ProgramRun run = run_program(folder, std::string(words) + " --data data");
        EXPECT_EQ(run.exit_code, 2) << words << run.err;
        EXPECT_FALSE(std::filesystem::exists(folder / "made")) << words;
        EXPECT_FALSE(std::filesystem::exists(folder / "data")) << words;
    }
}

TEST(Outputs, AreNeverPutAmongSomebodysOtherFiles) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "mine/thesis.txt", "mine");
    base::write_file_atomically(folder / "votes.csv",
                                "variant_a,variant_b,count_a,count_b\nnone,blizzard,14,22\n");
    for (const char* words : {"analyze --counts votes.csv --out mine", "render --out mine",
                              "measure --quick --out mine", "demo --out mine"}) {
        const ProgramRun run = run_program(folder, words);
        EXPECT_EQ(run.exit_code, 2) << words;
        EXPECT_THAT(run.err, HasSubstr("mine holds other files (thesis.txt)")) << words;
    }
    EXPECT_EQ(run_program(folder, "analyze --counts votes.csv --out report").exit_code, 0);
    EXPECT_EQ(run_program(folder, "analyze --counts votes.csv --out report").exit_code, 0)
        << "its own is replaced";
}

}  // namespace
}  // namespace obscura::app
