// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/exported_conclusions.h"

#include <fmt/ranges.h>

#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "analysis/answers.h"
#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/words.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

std::string_view level_of(const Analysis& analysis, const std::string& condition) {
    for (const ConditionResult& result : analysis.conditions) {
        if (result.condition.id == condition) return result.condition.validity;
    }
    return "";
}

void add_preferences(std::vector<ExportedTest>& tests, const Analysis& analysis,
                     const ExportedTest& like) {
    for (const HypothesisResult& hypothesis : analysis.hypotheses) {
        if (!hypothesis.pooling.has_value()) continue;
        for (std::size_t i = 0; i < hypothesis.conditions.size(); ++i) {
            ExportedTest& row = tests.emplace_back(like);
            row.test = hypothesis.name;
            row.question = "preference";
            row.condition = hypothesis.conditions[i];
            row.level = level_of(analysis, row.condition);
            row.weight = hypothesis.pooling->turned[i] ? "-1" : "1";
        }
    }
}

void add_interactions(std::vector<ExportedTest>& tests, const Analysis& analysis,
                      const ExportedTest& like) {
    if (!analysis.validity.has_value()) return;
    for (const Comparison& comparison : analysis.validity->by_level) {
        const bool is_pair = comparison.conditions.size() == 2;
        for (std::size_t i = 0; i < comparison.conditions.size(); ++i) {
            ExportedTest& row = tests.emplace_back(like);
            row.test = fmt::format("{}: {}", analysis.validity->name, what_is_compared(comparison));
            row.question = is_pair ? "interaction" : "levels";
            row.condition = comparison.conditions[i];
            row.level = level_of(analysis, row.condition);
            if (is_pair) row.weight = (i == 1) != comparison.turned[i] ? "1" : "-1";
        }
    }
}

Tally named_tally(const AnswerTable& answers, const std::string& study, Kind kind,
                  const std::vector<ExportedStudy>& studies) {
    Tally tally = tally_of(answers, study, kind);
    for (const ExportedStudy& known : studies) {
        if (known.name != study) continue;
        std::map<std::string, std::string> names;
        for (const auto& [scene, view] : known.views) names.emplace(scene, view.name);
        name_views(tally, names);
    }
    return tally;
}

/// Of the completed sessions of one study and kind.
void add_exclusions(ExportOptions& options, const Analysis& analysis, const AnswerTable& answers,
                    const std::string& study, Kind kind) {
    std::unordered_map<std::string_view, std::string> reasons;
    for (const ParticipantResult& who : analysis.attention->participants) {
        reasons.emplace(who.id, fmt::format("{}", fmt::join(who.left_out, "; ")));
    }
    for (const SessionEntry& session : answers.sessions) {
        if (session.state != SessionState::kCompleted || session.kind != kind ||
            answers.names[session.study] != study) {
            continue;
        }
        options.left_out.emplace(answers.names[session.name],
                                 reasons.at(answers.names[session.participant]));
    }
}

}  // namespace

std::vector<std::string> add_conclusions(ExportOptions& options, Store& store,
                                         const std::string& url) {
    const AnswerTable answers = read_answers(store, url);
    std::set<std::pair<std::string, Kind>> analysed;
    for (const SessionEntry& session : answers.sessions) {
        if (session.state != SessionState::kCompleted) continue;
        analysed.emplace(answers.names[session.study], session.kind);
    }
    std::vector<std::string> notes;
    for (const auto& [study, kind] : analysed) {
        try {
            const Analysis analysis = analyse(named_tally(answers, study, kind, options.studies));
            const ExportedTest like{study, kind, {}, {}, {}, {}, {}};
            add_preferences(options.tests, analysis, like);
            add_interactions(options.tests, analysis, like);
            add_exclusions(options, analysis, answers, study, kind);
        } catch (const base::Error& error) {
            notes.push_back(fmt::format("tests and exclusions of study {} ({}) are not known: {}",
                                        study, to_string(kind), error.what()));
        }
    }
    return notes;
}

}  // namespace obscura::analysis
