// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_repeats.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string_view>
#include <tuple>
#include <utility>

#include "analysis/table/problems.h"
#include "analysis/text/text.h"

namespace obscura::analysis {

namespace {

template <typename Seen>
void sort_by_key(std::vector<Seen>& seen) {
    const auto before = [](const Seen& one, const Seen& other) {
        return std::tie(one.key, one.line) < std::tie(other.key, other.line);
    };
    if (!std::is_sorted(seen.begin(), seen.end(), before)) {
        std::sort(seen.begin(), seen.end(), before);
    }
}

}  // namespace

void RepeatFinder::add_index(const AnswerEntry& answer, int line) {
    const auto index = static_cast<std::uint32_t>(answer.trial_index);
    indices_.push_back({(std::uint64_t{answer.session} << 32U) | index, line});
}

void RepeatFinder::report_equal_indices(const TrialsColumns& columns, FileProblems& problems) {
    sort_by_key(indices_);
    const TrialsColumn column = columns.has(kTrialIndex) ? kTrialIndex : kOrder;
    for (std::size_t i = 1; i < indices_.size(); ++i) {
        if (indices_[i].key != indices_[i - 1].key) continue;
        columns.report(problems, indices_[i].line, column,
                       std::to_string(static_cast<std::uint32_t>(indices_[i].key)),
                       fmt::format("is each number once in a session, this one is in line {}",
                                   indices_[i - 1].line));
    }
    indices_ = {};
}

void RepeatFinder::add(const CsvRow& row) {
    std::uint64_t hash = 0;
    for (const std::string_view field : row.fields) {
        hash = (hash ^ std::hash<std::string_view>{}(field)) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    rows_.push_back({hash, row.line});
}

std::vector<std::string> RepeatFinder::notes(const AnswerTable& table) {
    std::vector<std::string> notes;
    note_repeated_votes(table, notes);
    note_equal_rows(notes);
    return notes;
}

void RepeatFinder::note_equal_rows(std::vector<std::string>& notes) {
    sort_by_key(rows_);
    std::vector<std::pair<int, int>> repeated;  // line, and that of the row before it
    for (std::size_t i = 1; i < rows_.size(); ++i) {
        if (rows_[i].key == rows_[i - 1].key) {
            repeated.emplace_back(rows_[i].line, rows_[i - 1].line);
        }
    }
    if (repeated.empty()) return;
    std::sort(repeated.begin(), repeated.end());
    Lines lines;
    for (const auto& [line, before] : repeated) lines.add(line);
    notes.push_back(fmt::format(
        "{} equal in every column to one before ({}; the first of them to line {}): each row "
        "counts as an answer of its own",
        repeated.size() == 1 ? "1 row is" : fmt::format("{} rows are", repeated.size()),
        lines.words(), repeated.front().second));
}

void RepeatFinder::note_repeated_votes(const AnswerTable& table,
                                       std::vector<std::string>& notes) const {
    struct Vote {
        std::uint64_t key = 0;  ///< participant, and the condition's id
        std::uint32_t study = 0;
        std::size_t answer = 0;
    };
    std::vector<Vote> votes;
    for (std::size_t i = 0; i < table.answers.size(); ++i) {
        const AnswerEntry& answer = table.answers[i];
        const SessionEntry& session = table.sessions[answer.session];
        if (answer.kind != session.kind || answer.repeats != 0 ||
            session.state != SessionState::kCompleted) {
            continue;
        }
        const std::uint32_t condition = table.conditions[answer.condition].id;
        votes.push_back(
            {(std::uint64_t{session.participant} << 32U) | condition, session.study, i});
    }
    std::sort(votes.begin(), votes.end(), [](const Vote& one, const Vote& other) {
        return std::tie(one.key, one.study, one.answer) <
               std::tie(other.key, other.study, other.answer);
    });
    std::size_t count = 0;
    const Vote* first = nullptr;
    for (std::size_t i = 1; i < votes.size(); ++i) {
        if (votes[i].key != votes[i - 1].key || votes[i].study != votes[i - 1].study) continue;
        ++count;
        if (first == nullptr || votes[i].answer < first->answer) first = &votes[i];
    }
    if (first == nullptr) return;
    const AnswerEntry& answer = table.answers[first->answer];
    notes.push_back(fmt::format(
        "{} more than the first of a participant for a condition (line {} the first of them: {}, "
        "{}): each counts as a vote of its own, and such conditions are not compared within "
        "participants",
        count == 1 ? "1 vote is" : fmt::format("{} votes are", count), rows_[first->answer].line,
        printable(table.names[table.sessions[answer.session].participant]),
        printable(table.names[table.conditions[answer.condition].id])));
}

}  // namespace obscura::analysis
