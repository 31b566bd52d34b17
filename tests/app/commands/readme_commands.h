// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <sstream>
#include <string>
#include <vector>

#include "renderer/base/files.h"

namespace obscura::app {

/// Every page that tells people what to type.
inline constexpr std::array kReadmes{"README.md",          "app/README.md",
                                     "stimuli/README.md",  "analysis/README.md",
                                     "renderer/README.md", "renderer/reference/README.md"};

/// A line of a block of sh that its day's test does not run as it stands, and what stands in for
/// it.
struct RunOtherwise {
    std::string_view line;
    std::string_view by;
};
inline constexpr std::array kRunOtherwise{
    RunOtherwise{"./obscura test", "runs the tests, this one too"},
    RunOtherwise{"./obscura demo", "DemoCommand, on a small study"},
    RunOtherwise{"./obscura power my-study.toml --share .65 --sd 1",
                 "takes a minute; SimulationCommands, on fewer studies"},
    RunOtherwise{"./obscura run my-study.zip --monitor 0", "OperatorsCommands, on a display"},
    RunOtherwise{"./obscura run my-study.zip --windowed", "OperatorsCommands"},
    RunOtherwise{"./obscura run my-study.zip --selftest", "OperatorsCommands"},
    RunOtherwise{"./obscura run my-study.toml --db postgresql://kiosk@server/answers",
                 "OperatorsCommands, on a server"},
    RunOtherwise{"./obscura explore atrium", "OperatorsCommands, on a display"},
    RunOtherwise{"./obscura ao --closed-forms", "ClosedForms, which takes its scenes apart"},
    RunOtherwise{"./obscura measure --hard-cases", "takes minutes; HardCases"},
    RunOtherwise{"./obscura measure --experiment front", "takes minutes; Measure"},
    RunOtherwise{"./obscura measure --experiment sunet-5.7", "takes minutes; Measure"},
    RunOtherwise{
        "./obscura ao --scene atrium --technique cross,blizzard --against reference --out compared",
        "WorkedExample, which builds it"},
    RunOtherwise{"./obscura measure --scene atrium --technique cross --quick",
                 "WorkedExample, which builds it"},
    RunOtherwise{"./obscura measure --technique cross --hard-cases",
                 "WorkedExample, which builds it"},
    RunOtherwise{"./obscura explore atrium", "WorkedExample, which builds it"},
};

/// A line of a README that begins with ./obscura, without that and without its comment.
struct ReadmeCommand {
    std::string words;
};

inline constexpr std::string_view kProgram = "./obscura ";

/// The lines of a page of the house in its blocks of sh without their comments, from a heading to
/// the next one of its level (empty: of the whole page), of the first `most_blocks` blocks (0: of
/// all).
inline std::vector<std::string> readme_lines(const std::string& page,
                                             const std::string& heading = "", int most_blocks = 0) {
    std::istringstream lines(base::read_file(std::string(OBSCURA_SOURCE_DIR "/") + page));
    std::vector<std::string> found;
    bool in_section = heading.empty();
    bool in_block = false;
    int blocks = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!in_block && !heading.empty() && line.starts_with("## ")) in_section = line == heading;
        if (line.starts_with("```")) {
            in_block = !in_block && line == "```sh";
            if (in_block && in_section) ++blocks;
            continue;
        }
        const bool wanted = in_section && in_block && (most_blocks == 0 || blocks <= most_blocks);
        if (!wanted) continue;
        if (const std::size_t comment = line.find(" #"); comment != std::string::npos) {
            line.resize(comment);
        }
        while (line.ends_with(' ')) line.pop_back();
        if (!line.empty()) found.push_back(line);
    }
    return found;
}

/// Those of the program, without its name.
inline std::vector<ReadmeCommand> readme_commands(const std::string& page,
                                                  const std::string& heading = "",
                                                  int most_blocks = 0) {
    std::vector<ReadmeCommand> commands;
    for (const std::string& line : readme_lines(page, heading, most_blocks)) {
        if (line.starts_with(kProgram)) commands.push_back({line.substr(kProgram.size())});
    }
    return commands;
}

/// The blocks of that language on a page, as they stand.
inline std::vector<std::string> readme_blocks(const std::string& page,
                                              const std::string& language) {
    std::istringstream lines(base::read_file(std::string(OBSCURA_SOURCE_DIR "/") + page));
    std::vector<std::string> blocks;
    bool in_block = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            in_block = !in_block && line == "```" + language;
            if (in_block) blocks.emplace_back();
        } else if (in_block) {
            blocks.back() += line + '\n';
        }
    }
    return blocks;
}

/// What a page says in its running text, between `: `obscura ...` or `./obscura ...`, without the
/// program's name.
inline std::vector<ReadmeCommand> readme_mentions(const std::string& page) {
    const std::string text = base::read_file(std::string(OBSCURA_SOURCE_DIR "/") + page);
    std::string prose;
    bool in_block = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```"))
            in_block = !in_block;
        else if (!in_block)
            prose += line + '\n';
    }
    std::vector<ReadmeCommand> mentions;
    bool inside = false;
    std::size_t begin = 0;
    for (std::size_t at = prose.find('`'); at != std::string::npos; at = prose.find('`', at + 1)) {
        const std::string code = prose.substr(begin, at - begin);
        for (const std::string name : {"obscura ", "./obscura "}) {
            if (inside && code.starts_with(name)) mentions.push_back({code.substr(name.size())});
        }
        inside = !inside;
        begin = at + 1;
    }
    return mentions;
}

}  // namespace obscura::app
