// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/hypothesis_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "stimuli/view_names.h"

namespace obscura::stimuli {
namespace {

using Need = TableReader::Need;

constexpr std::size_t kLongestStatement = 500;
constexpr std::size_t kMostLooks = 50;
constexpr std::int64_t kMostParticipants = 1'000'000;
constexpr double kSmallestMargin = 0.01;
constexpr double kLargestMargin = 0.49;

std::vector<std::string> votable_ids(const Study& study) {
    std::vector<std::string> ids;
    for (const Condition& condition : study.conditions) {
        if (condition.is_votable() && !condition.id.empty()) ids.push_back(condition.id);
    }
    return ids;
}

/// The ids of conditions in an array; notes what is none, and what stands there twice.
std::vector<std::string> read_ids(TableReader& reader, const std::string& key,
                                  const toml::array& array, const Study& study) {
    const std::vector<std::string> allowed = votable_ids(study);
    std::vector<std::string> ids;
    for (const toml::node& node : array) {
        const auto id = node.value<std::string>();
        if (!node.is_string()) {
            reader.add(key, fmt::format("holds something else than a string, allowed are {}",
                                        listed(allowed)));
        } else if (std::find(allowed.begin(), allowed.end(), *id) == allowed.end()) {
            reader.add(key, fmt::format("{} {}, allowed are {}{}", in_quotes(*id),
                                        study.find_condition(*id) == nullptr
                                            ? "is no condition"
                                            : "is no condition that people vote on",
                                        listed(allowed), did_you_mean(*id, allowed)));
        } else if (std::find(ids.begin(), ids.end(), *id) != ids.end()) {
            reader.add(key, fmt::format("{} stands there twice, allowed is once", in_quotes(*id)));
        } else {
            ids.push_back(*id);
        }
    }
    return ids;
}

void read_conditions(TableReader& reader, const Study& study, Hypothesis& hypothesis) {
    const toml::array* array = reader.array("conditions", Need::kRequired,
                                            "an array of the ids of conditions: [\"I\", \"II\"]");
    if (array == nullptr) return;
    hypothesis.conditions = read_ids(reader, "conditions", *array, study);
    if (array->empty()) {
        reader.add("conditions", fmt::format("is empty, allowed are one or more of {}",
                                             listed(votable_ids(study))));
    }
}

/// What keeps the conditions from being compared with each other; empty where nothing does.
std::string obstacle(const std::vector<std::string>& ids, const Study& study) {
    const auto views = view_names(study);
    const Condition& first = *study.find_condition(ids.front());
    std::set<Validity> levels;
    for (const std::string& id : ids) {
        const Condition& condition = *study.find_condition(id);
        const bool is_same = condition.a == first.a && condition.b == first.b;
        const bool is_turned = condition.a == first.b && condition.b == first.a;
        if (!is_same && !is_turned) return "show other variants";
        const auto view = views.find(condition.scene);
        const auto of_first = views.find(first.scene);
        if (view == views.end() || of_first == views.end()) return "";  // reported at its scene
        if (view->second != of_first->second) return "show other scenes or cameras";
        if (!levels.insert(study.scene_of(condition).validity).second) {
            return "are at one level of validity";
        }
    }
    return "";
}

void read_pairs(TableReader& reader, const Study& study, Hypothesis& hypothesis) {
    const toml::array* array =
        reader.array("pairs", Need::kRequired,
                     "an array of pairs of conditions: [[\"II\", \"V\"], [\"III\", \"VI\"]]");
    if (array == nullptr) return;
    const char* const allowed =
        "two or three conditions with the same two variants in one scene and camera, each at "
        "another level of validity";
    if (array->empty()) reader.add("pairs", fmt::format("is empty, allowed are {}", allowed));
    std::set<std::set<std::string>> seen;
    for (const toml::node& node : *array) {
        const toml::array* pair = node.as_array();
        if (pair == nullptr || pair->size() < 2 || pair->size() > 3) {
            reader.add("pairs", fmt::format("holds what is no pair, allowed are {}", allowed));
            continue;
        }
        const std::vector<std::string> ids = read_ids(reader, "pairs", *pair, study);
        if (ids.size() != pair->size()) continue;
        if (const std::string why = obstacle(ids, study); !why.empty()) {
            reader.add("pairs", fmt::format("{} {}, allowed are {}", listed(ids), why, allowed));
        } else if (!seen.insert({ids.begin(), ids.end()}).second) {
            reader.add("pairs", fmt::format("{} stand there twice, allowed is once", listed(ids)));
        }
        hypothesis.pairs.push_back(ids);
    }
}

}  // namespace

std::string_view to_string(HypothesisKind kind) {
    return kind == HypothesisKind::kPreference ? "preference" : "interaction";
}

std::string_view to_string(HypothesisRole role) {
    return role == HypothesisRole::kPrimary ? "primary" : "secondary";
}

Hypothesis read_hypothesis(TableReader& reader, const std::string& id, const Study& study) {
    Hypothesis hypothesis;
    hypothesis.id = id;
    hypothesis.statement = reader.text("statement", Need::kRequired).value_or("");
    const bool is_blank = hypothesis.statement.find_first_not_of(" \t\n") == std::string::npos;
    if (reader.has("statement") && (is_blank || hypothesis.statement.size() > kLongestStatement)) {
        reader.add("statement",
                   fmt::format("has {} bytes, allowed is a sentence of 1 to {}",
                               is_blank ? 0 : hypothesis.statement.size(), kLongestStatement));
    }
    const auto kind = reader.choice("kind", Need::kRequired, names_of(kHypothesisKinds));
    const bool is_interaction = kind == to_string(HypothesisKind::kInteraction);
    hypothesis.kind = is_interaction ? HypothesisKind::kInteraction : HypothesisKind::kPreference;
    hypothesis.margin = reader.number("margin", Need::kOptional, kSmallestMargin, kLargestMargin)
                            .value_or(hypothesis.margin);
    const auto role = reader.choice("role", Need::kOptional, names_of(kHypothesisRoles));
    if (role == to_string(HypothesisRole::kSecondary)) hypothesis.role = HypothesisRole::kSecondary;
    hypothesis.accuracy = reader.boolean("accuracy", Need::kOptional).value_or(false);
    if (hypothesis.accuracy && is_interaction) {
        reader.add("accuracy", "is not allowed for kind interaction, which orders no images");
    }
    const char* const other = is_interaction ? "conditions" : "pairs";
    if (!kind) {
        reader.allow("conditions");
        reader.allow("pairs");
    } else {
        if (is_interaction) {
            read_pairs(reader, study, hypothesis);
        } else {
            read_conditions(reader, study, hypothesis);
        }
        if (reader.has(other)) {
            reader.allow(other);
            reader.add(other, fmt::format("is not allowed for kind {}, which takes {}",
                                          to_string(hypothesis.kind),
                                          is_interaction ? "pairs" : "conditions"));
        }
    }
    reader.finish();
    return hypothesis;
}

void settle_hypotheses(Study& study, const std::vector<const toml::table*>& conditions,
                       const std::vector<const toml::table*>& hypotheses,
                       std::vector<StudyProblem>& problems) {
    if (study.hypotheses.empty()) return;
    std::vector<std::string> ids;
    int interactions = 0;
    int primary = 0;
    for (std::size_t i = 0; i < study.hypotheses.size(); ++i) {
        const Hypothesis& hypothesis = study.hypotheses[i];
        ids.push_back(hypothesis.id);
        if (hypothesis.role == HypothesisRole::kPrimary) ++primary;
        if (hypothesis.kind != HypothesisKind::kInteraction || ++interactions == 1) continue;
        problems.push_back({line_of(*hypotheses[i]),
                            fmt::format("hypothesis {} is a second interaction, allowed is one: "
                                        "its pairs are a test each",
                                        in_quotes(hypothesis.id))});
    }
    if (primary == 0) {
        problems.push_back({line_of(*hypotheses.front()),
                            "every [[hypothesis]] is secondary, needed is one with role = "
                            "\"primary\""});
    }
    for (std::size_t i = 0; i < study.conditions.size(); ++i) {
        Condition& condition = study.conditions[i];
        if (!condition.is_votable()) continue;
        if (condition.hypothesis.empty()) {
            const auto takes = std::find_if(
                study.hypotheses.begin(), study.hypotheses.end(), [&](const Hypothesis& own) {
                    return std::find(own.conditions.begin(), own.conditions.end(), condition.id) !=
                           own.conditions.end();
                });
            if (takes != study.hypotheses.end()) condition.hypothesis = takes->id;
        } else if (std::find(ids.begin(), ids.end(), condition.hypothesis) == ids.end()) {
            TableReader reader(*conditions[i], fmt::format("condition {}", in_quotes(condition.id)),
                               problems);
            reader.add("hypothesis",
                       fmt::format("{} is not defined by a [[hypothesis]], defined are {}{}",
                                   in_quotes(condition.hypothesis), listed(ids),
                                   did_you_mean(condition.hypothesis, ids)));
        }
    }
}

void read_stopping(const toml::table& table, Study& study, std::vector<StudyProblem>& problems) {
    TableReader reader(table, "stopping", problems);
    const std::string wanted =
        fmt::format("an array of 1 to {} rising numbers of participants, 1 to {}: [12, 24, 36]",
                    kMostLooks, kMostParticipants);
    StoppingRule& rule = study.stopping;
    if (const toml::array* looks = reader.array("looks", Need::kRequired, wanted)) {
        for (const toml::node& node : *looks) {
            const auto look = node.value<std::int64_t>().value_or(0);
            const bool rises = rule.looks.empty() || look > rule.looks.back();
            if (!node.is_integer() || look < 1 || look > kMostParticipants || !rises) {
                rule.looks.clear();
                break;
            }
            rule.looks.push_back(static_cast<int>(look));
        }
        if (rule.looks.empty() || rule.looks.size() > kMostLooks) {
            reader.add("looks", "is no such list, allowed is " + wanted);
        }
    }
    rule.spending =
        reader.choice("spending", Need::kOptional, {kSpendings.begin(), kSpendings.end()})
            .value_or(rule.spending);
    if (rule.looks.size() > 1 && rule.spending == "none") {
        reader.add("looks",
                   fmt::format("are {} with spending \"none\", allowed is one look, or spending = "
                               "\"obrien-fleming\" or \"pocock\"",
                               rule.looks.size()));
    }
    reader.finish();
}

}  // namespace obscura::stimuli
