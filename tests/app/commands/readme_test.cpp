// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// What the READMEs tell people to type.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "app/commands/program.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"
#include "tests/app/commands/readme_commands.h"

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
