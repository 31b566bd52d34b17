// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/study_argument.h"

#include <fmt/format.h>

#include "stimuli/package/package.h"

namespace obscura::app {

Option add_study(const Options& app, std::string& study, std::string_view otherwise) {
    return app.add(
        "STUDY", study,
        fmt::format("Study file, package (.zip) or built-in study (default: {})", otherwise));
}

std::string study_named(const std::string& word, const Globals& globals) {
    if (!stimuli::is_package(word)) return word;
    return stimuli::unpack(word, globals.data).study.string();
}

}  // namespace obscura::app
