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

/// A line of a README that begins with ./obscura, without that and without its comment.
struct ReadmeCommand {
    std::string words;
};

/// The commands of a page of the house in its blocks of sh, from a heading to the next one of its
/// level (empty: of the whole page), of the first `most_blocks` blocks (0: of all).
inline std::vector<ReadmeCommand> readme_commands(const std::string& page,
                                                  const std::string& heading = "",
                                                  int most_blocks = 0) {
    std::istringstream lines(base::read_file(std::string(OBSCURA_SOURCE_DIR "/") + page));
    std::vector<ReadmeCommand> commands;
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
        constexpr std::string_view kProgram = "./obscura ";
        if (!wanted || !line.starts_with(kProgram)) continue;
        line = line.substr(kProgram.size(), line.find("  #") - kProgram.size());
        if (const std::size_t comment = line.find(" #"); comment != std::string::npos) {
            line.resize(comment);
        }
        while (line.ends_with(' ')) line.pop_back();
        commands.push_back({line});
    }
    return commands;
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
