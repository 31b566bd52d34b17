// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/manual.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"

namespace obscura::app {
namespace {

/// The words that may follow: options and commands.
std::vector<std::string> words_after(const DescribedCommand& command) {
    std::vector<std::string> words;
    for (const DescribedCommand& sub : command.commands) words.push_back(sub.name);
    for (const DescribedOption& option : command.options) {
        if (!option.by_place) words.insert(words.end(), option.names.begin(), option.names.end());
    }
    return words;
}

/// A shell's case branches, one for each command and command of a command: "scene/export".
std::string branches(const DescribedCommand& program) {
    std::string text;
    for (const DescribedCommand& command : program.commands) {
        text += fmt::format("        {}) words=\"{}\" ;;\n", command.name,
                            fmt::join(words_after(command), " "));
        for (const DescribedCommand& sub : command.commands) {
            text += fmt::format("        {}/{}) words=\"{}\" ;;\n", command.name, sub.name,
                                fmt::join(words_after(sub), " "));
        }
    }
    return text;
}

std::string bash(const DescribedCommand& program) {
    std::string groups;  // commands that have commands of their own
    for (const DescribedCommand& command : program.commands) {
        if (!command.commands.empty()) groups += (groups.empty() ? "" : "|") + command.name;
    }
    return fmt::format(R"(_obscura() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} place="" word words
    for word in "${{COMP_WORDS[@]:1:COMP_CWORD-1}}"; do
        case $word in
        -*) ;;
        *) case $place in
            "") place=$word ;;
            {0}) place=$place/$word ;;
            esac ;;
        esac
    done
    case $place in
        "") words="{1}" ;;
{2}        *) words="" ;;
    esac
    COMPREPLY=($(compgen -W "$words {3}" -- "$current"))
    [[ $current == -* ]] || COMPREPLY+=($(compgen -f -- "$current"))
}}
complete -o filenames -F _obscura obscura
)",
                       groups, fmt::join(words_after(program), " "), branches(program),
                       "--data --allow --quiet --help");
}

std::string zsh(const DescribedCommand& program) {
    return "#compdef obscura\nautoload -U +X bashcompinit && bashcompinit\n" + bash(program);
}

/// Within single quotes of fish.
std::string quoted(const std::string& text) {
    std::string quoted;
    for (const char c : text) {
        if (c == '\\' || c == '\'') quoted += '\\';
        quoted += c == '\n' ? ' ' : c;
    }
    return "'" + quoted + "'";
}

void add_fish(std::string& text, const DescribedCommand& command, const std::string& when) {
    for (const DescribedOption& option : command.options) {
        if (option.by_place) continue;
        std::string line = "complete -c obscura -n " + quoted(when);
        for (const std::string& name : option.names) {
            line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
        }
        text += line + (option.value.empty() ? "" : " -r") + " -d " + quoted(option.what) + "\n";
    }
    for (const DescribedCommand& sub : command.commands) {
        text += fmt::format("complete -c obscura -n {} -a {} -d {}\n", quoted(when), sub.name,
                            quoted(sub.what));
    }
}

std::string fish(const DescribedCommand& program) {
    std::string text;
    add_fish(text, program, "__fish_use_subcommand");
    for (const DescribedCommand& command : program.commands) {
        add_fish(text, command, "__fish_seen_subcommand_from " + command.name);
        for (const DescribedCommand& sub : command.commands) {
            add_fish(
                text, sub,
                fmt::format("__fish_seen_subcommand_from {}; and __fish_seen_subcommand_from {}",
                            command.name, sub.name));
        }
    }
    return text;
}

/// Text of a manual page: nothing in it is read as a request.
std::string troff(const std::string& text) {
    std::string result;
    bool at_start = true;
    for (const char c : text) {
        if (at_start && (c == '.' || c == '\'')) result += "\\&";
        if (c == '-') {
            result += "\\-";
        } else if (c == '\\') {
            result += "\\e";
        } else {
            result += c;
        }
        at_start = c == '\n';
    }
    return result;
}

void add_options(std::string& text, const DescribedCommand& command) {
    for (const DescribedOption& option : command.options) {
        text += fmt::format(
            ".TP\n\\fB{}\\fR{}\n{}\n", troff(fmt::format("{}", fmt::join(option.names, ", "))),
            option.value.empty() ? "" : " \\fI" + troff(option.value) + "\\fR", troff(option.what));
    }
}

void add_manual(std::string& text, const DescribedCommand& command, const std::string& name) {
    text += fmt::format(".SS {}\n{}.\n", troff(name), troff(command.what));
    add_options(text, command);
    if (!command.footer.empty()) text += fmt::format(".PP\n.nf\n{}\n.fi\n", troff(command.footer));
    for (const DescribedCommand& sub : command.commands) {
        add_manual(text, sub, name + " " + sub.name);
    }
}

std::string manual(const DescribedCommand& program) {
    std::string text = fmt::format(
        ".TH OBSCURA 1 \"\" \"obscura {}\" \"User Commands\"\n.SH NAME\nobscura \\- {}\n.SH "
        "SYNOPSIS\n"
        "\\fBobscura\\fR [\\fIOPTIONS\\fR] \\fICOMMAND\\fR ...\n.SH OPTIONS\n",
        OBSCURA_VERSION, troff(program.what));
    add_options(text, program);
    text += ".SH COMMANDS\n";
    for (const DescribedCommand& command : program.commands) {
        add_manual(text, command, command.name);
    }
    text +=
        ".SH EXIT STATUS\n0 done, 1 the work failed, 2 the command line or an input file is wrong, "
        "3 "
        "a check ran and did not hold.\n";
    return text;
}

struct Shell {
    std::string name;
    std::string (*completion)(const DescribedCommand&);
};
const std::vector<Shell>& shells() {
    static const std::vector<Shell> list{{"bash", bash}, {"zsh", zsh}, {"fish", fish}};
    return list;
}

}  // namespace

const std::vector<std::string>& known_shells() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> list;
        for (const Shell& shell : shells()) list.push_back(shell.name);
        return list;
    }();
    return names;
}

std::string manual_or_completion(const std::vector<std::string>& words,
                                 const DescribedCommand& program) {
    if (words.size() == 1 && words[0] == "--manual") return manual(program);
    if (words.empty() || !words[0].starts_with("--completion")) return {};
    const std::string name = words.size() == 2 && words[0] == "--completion" ? words[1]
                             : words.size() == 1 && words[0].starts_with("--completion=")
                                 ? words[0].substr(std::string("--completion=").size())
                                 : "";
    for (const Shell& shell : shells()) {
        if (shell.name == name) return shell.completion(program);
    }
    throw base::bad_input("--completion: \"{}\" is no shell that is known; there are {}", name,
                          fmt::join(known_shells(), ", "));
}

}  // namespace obscura::app
