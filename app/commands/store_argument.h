// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/commands/command.h"

namespace obscura::app {

/// The option --db of a command: the store of the answers.
Option add_store(const Options& app, std::string& store);

/// The URL that the word of a command line leads to: a file is a store of SQLite, nothing said is
/// that of the data folder.
[[nodiscard]] std::string store_url_from(const std::string& word, const Globals& globals);

/// Where nothing was said and the data folder has no answers yet: throws bad input naming the
/// command that collects some, and those of rehearsals that lie there.
void refuse_no_answers(const std::string& word, const Globals& globals);

}  // namespace obscura::app
