// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/answers.h"
#include "analysis/store/address.h"
#include "analysis/store/store.h"

namespace obscura::analysis {

AnswerTable read_answers(Store& store, const std::string& url) {
    AnswerTable table;
    table.source = without_password(url);
    store.each_answer([&](const SessionRecord& session) { table.add(session); },
                      [&](const TrialRecord& trial) { table.add(trial); });
    return table;
}

}  // namespace obscura::analysis
