// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/program.h"

#include <cstdio>
#include <string_view>

#include "app/commands/list.h"
#include "app/commands/manual.h"
#include "app/commands/renamed.h"
#include "renderer/base/error.h"
#include "renderer/base/nearest.h"

namespace obscura::app {
namespace {

/// An empty value is most often a script's unset variable: it must not mean "the default".
void refuse_empty_values(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string_view word = words[i];
        if (word.empty()) {
            throw base::bad_input("the value after \"{}\" is empty",
                                  i > 0 ? words[i - 1] : "obscura");
        }
        if (word.starts_with("--") && word.ends_with("=")) {
            throw base::bad_input("{}: its value is empty", word);
        }
    }
}

/// The first word that is neither an option nor a command is most often a command misspelt.
void name_unknown_command(const std::vector<std::string>& words) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--data" || words[i] == "--allow") {
            ++i;
        } else if (!words[i].starts_with("-")) {
            std::string known;
            std::vector<std::string> names;
            for (const Command& command : commands()) {
                if (command.name == words[i]) return;
                known += (known.empty() ? "" : ", ") + command.name;
                names.push_back(command.name);
            }
            throw base::bad_input("there is no command \"{}\"; there are {}{}", words[i], known,
                                  base::did_you_mean(words[i], names));
        }
    }
}

/// `help` and `help COMMAND` as `--help` and `COMMAND --help`.
std::vector<std::string> without_help(std::vector<std::string> words) {
    if (!words.empty() && words.front() == "help") {
        words.erase(words.begin());
        if (!words.empty() && words.front() == "help") words.erase(words.begin());
        words.emplace_back("--help");
    }
    return words;
}

}  // namespace

Program::Program(std::function<std::string()> version)
    : line_(
          "Obscura: can people see the difference between ways of approximating ambient "
          "occlusion?",
          "obscura", std::move(version)) {
    const Options program = line_.options();
    program.require_command();
    program.add("--data", globals_.data, "Folder that holds a study's life")
        .folder()
        .shows_default();
    program
        .add("--allow", globals_.allowed,
             "A folder from which files that a scene names may be read, beside the scene's own; "
             "repeatable")
        .existing_folder()
        .repeatable();
    program.add_flag("--quiet", globals_.quiet, "Say only warnings and errors");
    program.add("--completion", shell_, "Print what a shell needs to complete words, and exit")
        .one_of(known_shells());
    program.add_flag("--manual", wants_manual_, "Print the manual page (troff), and exit");
    program.footer("obscura help COMMAND, or obscura COMMAND --help: what a command takes.");
    for (const Command& command : commands()) {
        const Options options = program.add_command(command.name, command.summary);
        options.when_given([this, act = command.attach(options, globals_)] { chosen_ = act; });
    }
}

std::function<base::ExitCode()> Program::parse(std::vector<std::string> words) {
    refuse_empty_values(words);
    words = with_new_names(without_help(std::move(words)));
    // These two need no command, which all else does.
    if (const std::string text = manual_or_completion(words, line_.described()); !text.empty()) {
        std::fputs(text.c_str(), stdout);
        return {};
    }
    name_unknown_command(words);
    if (!line_.parse(words)) return {};
    return chosen_;
}

}  // namespace obscura::app
