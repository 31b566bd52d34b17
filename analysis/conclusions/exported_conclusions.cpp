// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/exported_conclusions.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

#include "analysis/answers.h"
#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/words.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

const ConditionVotes& condition_of(const Analysis& analysis, const std::string& id) {
    const auto found =
        std::find_if(analysis.tally.conditions.begin(), analysis.tally.conditions.end(),
                     [&](const ConditionVotes& condition) { return condition.id == id; });
    return *found;  // tests are of conditions of the tally
}

const char* role_of(bool is_primary) { return is_primary ? "primary" : "secondary"; }

ExportedTest not_repeated(ExportedTest like, const std::string& test, const char* role) {
    like.test = test;
    like.role = role;
    like.question = "none";
    return like;
}

void add_preferences(std::vector<ExportedTest>& tests, const Analysis& analysis,
                     const ExportedTest& like) {
    for (const HypothesisResult& hypothesis : analysis.hypotheses) {
        const char* const role = role_of(hypothesis.is_primary);
        if (!hypothesis.pooling.has_value()) {
            tests.push_back(not_repeated(like, hypothesis.name, role));
            continue;
        }
        for (std::size_t i = 0; i < hypothesis.conditions.size(); ++i) {
            ExportedTest& row = tests.emplace_back(like);
            row.test = hypothesis.name;
            row.role = role;
            row.question = "preference";
            row.condition = hypothesis.conditions[i];
            row.level = condition_of(analysis, row.condition).validity;
            row.weight = hypothesis.pooling->turned[i] ? "-1" : "1";
        }
    }
}

/// The weights of the conditions of a comparison over two levels: of each scene the mean of the
/// second level less that of the first, times what makes all of them whole (LevelContrast).
std::vector<std::int64_t> weights_of(const std::vector<const ConditionVotes*>& conditions) {
    std::map<std::pair<std::string_view, std::string_view>, std::int64_t> shown;
    std::size_t first = level_number(conditions.front()->validity);
    for (const ConditionVotes* condition : conditions) {
        ++shown[{condition->view, condition->validity}];
        first = std::min(first, level_number(condition->validity));
    }
    std::int64_t factor = 1;
    for (const auto& [where, count] : shown) factor = std::lcm(factor, count);
    std::vector<std::int64_t> weights;
    for (const ConditionVotes* condition : conditions) {
        const std::int64_t weight = factor / shown.at({condition->view, condition->validity});
        weights.push_back(level_number(condition->validity) == first ? -weight : weight);
    }
    return weights;
}

void add_interactions(std::vector<ExportedTest>& tests, const Analysis& analysis,
                      const ExportedTest& like) {
    if (!analysis.validity.has_value()) return;
    const ValidityResult& validity = *analysis.validity;
    const char* const role = role_of(validity.is_primary);
    for (std::size_t i = validity.by_level.size(); i < std::max<std::size_t>(validity.planned, 1);
         ++i) {
        tests.push_back(
            not_repeated(like, fmt::format("{}: not compared {}", validity.name, i + 1), role));
    }
    for (const Comparison& comparison : validity.by_level) {
        const std::string name = fmt::format("{}: {}", validity.name, what_is_compared(comparison));
        // A large-sample test over incomplete answers is not one that tables repeat.
        if (comparison.contrast.has_value() && !comparison.contrast->is_exact) {
            tests.push_back(not_repeated(like, name, role));
            continue;
        }
        const bool is_weighed =
            comparison.contrast.has_value() || comparison.conditions.size() == 2;
        std::vector<const ConditionVotes*> conditions;
        for (const std::string& id : comparison.conditions) {
            conditions.push_back(&condition_of(analysis, id));
        }
        const std::vector<std::int64_t> weights = weights_of(conditions);
        for (std::size_t i = 0; i < conditions.size(); ++i) {
            ExportedTest& row = tests.emplace_back(like);
            row.test = name;
            row.role = role;
            row.question = is_weighed ? "interaction" : "levels";
            row.condition = conditions[i]->id;
            row.level = conditions[i]->validity;
            if (is_weighed) {
                row.weight = std::to_string(comparison.turned[i] ? -weights[i] : weights[i]);
            }
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
            const ExportedTest like{.study = study, .kind = kind};
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
