// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/renamed.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "renderer/base/log.h"

namespace obscura::app {
namespace {

struct Renamed {
    std::string_view command;
    std::string_view before;
    std::string_view now;  ///< one without dashes is of a value by its place
};

constexpr std::array kRenamed{
    Renamed{"analyze", "--study", "STUDY"},       Renamed{"analyze", "--study-file", "STUDY"},
    Renamed{"export", "--study", "STUDY"},        Renamed{"measure", "--techniques", "--technique"},
    Renamed{"measure", "--filters", "--denoise"}, Renamed{"rehearse", "--store", "--db"},
    Renamed{"render", "--pair", "--condition"},   Renamed{"analyze", "--validity", "--by-validity"},
};

}  // namespace

std::vector<std::string> with_new_names(const std::vector<std::string>& words) {
    std::vector<std::string> renamed;
    for (const std::string& word : words) {
        const std::string name = word.substr(0, word.find('='));
        const auto found = std::find_if(kRenamed.begin(), kRenamed.end(), [&](const Renamed& one) {
            return one.before == name &&
                   std::find(words.begin(), words.end(), one.command) != words.end();
        });
        if (found == kRenamed.end()) {
            renamed.push_back(word);
            continue;
        }
        base::log::warn("note: {} is now {}; the old name goes with the next version",
                        found->before, found->now);
        const bool by_place = !found->now.starts_with("--");
        if (!by_place) {
            renamed.push_back(std::string(found->now) + word.substr(name.size()));
        } else if (word.size() > name.size()) {
            renamed.push_back(word.substr(name.size() + 1));
        }
    }
    return renamed;
}

}  // namespace obscura::app
