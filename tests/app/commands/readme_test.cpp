// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What the READMEs tell people to type.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "app/commands/program.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "tests/app/commands/readme_commands.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app {
namespace {

/// The words of a line, those in quotes as one.
std::vector<std::string> words_of(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

TEST(Readmes, ShowNoCommandThatTheProgramDoesNotTake) {
    base::log::set_up(true);
    std::size_t count = 0;
    for (const char* page : kReadmes) {
        for (const ReadmeCommand& command : readme_commands(page)) {
            if (command.words == "test" || command.words == "demo") continue;  // of the launcher
            Program program([] { return std::string("version"); });
            try {
                EXPECT_TRUE(program.parse(words_of(command.words)))
                    << page << ": " << command.words;
            } catch (const base::Error& error) {
                ADD_FAILURE() << page << ": " << command.words << "\n" << error.what();
            }
            ++count;
        }
    }
    EXPECT_GT(count, 30U);
}

TEST(Readmes, HaveNoLineToTypeThatNoTestRunsOrStandsInFor) {
    const std::set<std::string> days{"## A researcher's day", "## An operator's day",
                                     "## An analyst's day", "## A graphics engineer's day"};
    std::set<std::string> run;  // by ResearchersDay and EngineersDay
    for (const std::string& day : days) {
        for (const std::string& line : readme_lines("README.md", day)) run.insert(line);
    }
    std::set<std::string> lines;
    for (const char* page : kReadmes) {
        // Laboratory runs what it can of the machine's setting up.
        if (page == std::string_view("app/README.md")) continue;
        for (const std::string& line : readme_lines(page)) lines.insert(line);
    }
    for (const RunOtherwise& other : kRunOtherwise) {
        EXPECT_TRUE(lines.contains(std::string(other.line))) << "no page has: " << other.line;
        run.insert(std::string(other.line));
    }
    for (const std::string& line : lines) EXPECT_TRUE(run.contains(line)) << line;
}

TEST(Laboratory, OfThePageIsWrittenAsPastedAndSystemdAndTheShellTakeIt) {
    const tests::TemporaryFolder home;
    const std::vector<std::string> blocks = readme_blocks("app/README.md", "sh");
    ASSERT_EQ(blocks.size(), 2U);  // the first is root's: packages and users
    base::write_file_atomically(home / "root", blocks[0]);
    base::write_file_atomically(home / "lab", blocks[1]);
    const auto shell = [&](const std::string& command) {
        const std::string all = "cd '" + home.path().string() + "' && HOME=$PWD && " + command;
        return std::system(all.c_str());
    };
    EXPECT_EQ(shell("bash -n root && bash -e lab"), 0);
    EXPECT_EQ(shell("bash -n .bash_profile && sh -n .xinitrc"), 0);

    const std::filesystem::path unit = home / ".config/systemd/user/obscura.service";
    std::string text = base::read_file(unit);
    const std::string installed = "/usr/bin/obscura";
    ASSERT_NE(text.find(installed), std::string::npos);
    text.replace(text.find(installed), installed.size(), OBSCURA_PROGRAM);
    base::write_file_atomically(unit, text);
    // It ends with 0 for keys that it ignores, and says so.
    EXPECT_EQ(shell("if command -v systemd-analyze >said; then systemd-analyze verify --man=no '" +
                    unit.string() + "' >said 2>&1 || true; else : >said; fi"),
              0);
    EXPECT_THAT(base::read_file(home / "said"), testing::Not(testing::HasSubstr(unit.string())));
}

/// The names that a command knows, and those that every command takes.
std::set<std::string> known_of(const DescribedCommand& command) {
    std::set<std::string> known;
    for (const DescribedOption& option : command.options) {
        known.insert(option.names.begin(), option.names.end());
    }
    for (const DescribedCommand& sub : command.commands) known.insert(sub.name);
    return known;
}

TEST(Readmes, MentionNoCommandAndNoOptionThatIsNotThere) {
    const DescribedCommand program = Program([] { return std::string("version"); }).described();
    const std::set<std::string> common = known_of(program);
    std::size_t count = 0;
    for (const char* page : kReadmes) {
        for (const ReadmeCommand& mention : readme_mentions(page)) {
            const DescribedCommand* command = &program;
            for (const std::string& word : words_of(mention.words)) {
                const auto sub = std::find_if(command->commands.begin(), command->commands.end(),
                                              [&](const auto& one) { return one.name == word; });
                if (sub != command->commands.end()) {
                    command = &*sub;
                } else if (word.starts_with("--") && word != "--no-install") {  // the launcher's
                    EXPECT_TRUE(known_of(*command).contains(word) || common.contains(word))
                        << page << ": " << mention.words;
                } else if (command == &program) {
                    EXPECT_TRUE(word == "COMMAND" || word == "FOLDER" || word == "--no-install")
                        << page << ": " << mention.words;
                }
            }
            ++count;
        }
    }
    EXPECT_GT(count, 30U);
}

TEST(Readmes, LeadFromNothingToAResultInFiveCommandsOrFewer) {
    for (const char* day :
         {"## A researcher's day", "## An operator's day", "## A graphics engineer's day"}) {
        const std::vector<ReadmeCommand> commands = readme_commands("README.md", day, 1);
        EXPECT_GE(commands.size(), 2U) << day;
        EXPECT_LE(commands.size(), 5U) << day;
    }
}

}  // namespace
}  // namespace obscura::app
