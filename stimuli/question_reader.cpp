// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/question_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "stimuli/participant_reader.h"
#include "stimuli/presentation_reader.h"
#include "stimuli/study_reader.h"

namespace obscura::stimuli {

std::string_view to_string(QuestionKind kind) {
    switch (kind) {
        case QuestionKind::kChoice:
            return "choice";
        case QuestionKind::kChoiceOrNone:
            return "choice-or-none";
        case QuestionKind::kRating:
            return "rating";
        case QuestionKind::kConfidence:
            return "confidence";
    }
    return "";
}

std::string_view to_string(Ties ties) { return ties == Ties::kDavidson ? "davidson" : "split"; }

int Question::answer_count() const {
    if (is_scale()) return max - min + 1;
    return kind == QuestionKind::kChoice ? 2 : 3;
}

std::string Question::label_of(int answer) const {
    const auto count = static_cast<int>(labels.size());
    if (count == answer_count()) return labels[static_cast<std::size_t>(answer)];
    if (count != 2) return "";
    if (answer == 0) return labels.front();
    return answer == answer_count() - 1 ? labels.back() : "";
}

namespace {

using Need = TableReader::Need;
using Problems = std::vector<StudyProblem>;

constexpr std::size_t kMostQuestions = 20;
constexpr std::int64_t kFarthestStep = 100;

/// Different texts of an array; none where it is missing or wrong.
std::vector<std::string> read_labels(TableReader& reader, const std::string& where, Need need,
                                     const std::string& wanted, Study& study) {
    const toml::array* array = reader.array("labels", need, wanted);
    if (array == nullptr) return {};
    std::vector<std::string> labels;
    for (const toml::node& node : *array) {
        const auto text = node.value<std::string>();
        if (!text || text->find_first_not_of(" \t\n") == std::string::npos) continue;
        labels.push_back(*text);
        study.shown_texts.push_back({where + ": labels", line_of(node), *text});
    }
    const std::set<std::string> different(labels.begin(), labels.end());
    if (labels.empty() || different.size() != array->size()) {
        reader.add("labels",
                   "holds what is no text, an empty one or one twice; allowed is " + wanted);
        return {};
    }
    return labels;
}

/// Least and greatest step; as many as there are labels where nothing else is said.
void read_steps(TableReader& reader, Question& question) {
    const auto low = reader.integer("min", Need::kOptional, -kFarthestStep, kFarthestStep);
    const auto high = reader.integer("max", Need::kOptional, -kFarthestStep, kFarthestStep);
    const auto count = static_cast<int>(question.labels.size());
    if (!low && !high && count > 2) question.max = count;
    if (low) question.min = static_cast<int>(*low);
    if (high) question.max = static_cast<int>(*high);
    const int steps = question.max - question.min + 1;
    if (steps < 2 || steps > kMostSteps) {
        reader.add(reader.has("max") ? "max" : "min",
                   fmt::format("makes a scale of {} steps from {} to {}, allowed are 2 to {}",
                               steps, question.min, question.max, kMostSteps));
        question.min = 1;
        question.max = 2;
    } else if (count != 0 && count != 2 && count != steps) {
        reader.add("labels", fmt::format("has {} texts for {} steps, allowed are 2 for the ends or "
                                         "{} for the steps",
                                         count, steps, steps));
    }
}

void read_scale(TableReader& reader, const std::string& where, Question& question, Study& study) {
    question.labels = read_labels(
        reader, where, Need::kRequired,
        fmt::format("an array of 2 texts for the ends of the scale, or one for each of its 2 to {} "
                    "steps",
                    kMostSteps),
        study);
    read_steps(reader, question);
    if (question.kind != QuestionKind::kRating) {
        reader.known_elsewhere("of", "rating");
        return;
    }
    const auto of = reader.choice("of", Need::kOptional, {"pair", "images"});
    question.each_image = of == "images";
}

void read_sides(TableReader& reader, const std::string& where, Question& question, Study& study) {
    for (const char* key : {"min", "max"}) reader.known_elsewhere(key, "rating and confidence");
    reader.known_elsewhere("of", "rating");
    const auto count = static_cast<std::size_t>(question.answer_count());
    const std::string wanted =
        count == 2 ? "an array of 2 different texts: of the first image and of the second"
                   : "an array of 3 different texts: of the first image, of the second, and of no "
                     "difference";
    question.labels = read_labels(reader, where, Need::kOptional, wanted, study);
    if (!question.labels.empty() && question.labels.size() != count) {
        reader.add("labels",
                   fmt::format("has {} texts, allowed is {}", question.labels.size(), wanted));
    }
}

/// The names of one answer's keys; those that are no key are noted.
std::vector<std::string> key_names(TableReader& reader, const toml::node& node,
                                   const std::string& wanted, std::set<std::string>& used) {
    std::vector<std::string> names;
    const toml::array* array = node.as_array();
    if (array == nullptr || array->empty()) {
        reader.add("keys", "has an answer without keys, allowed is " + wanted);
        return names;
    }
    for (const toml::node& one : *array) {
        const std::string name = one.value<std::string>().value_or("");
        if (!is_key_name(name)) {
            reader.add("keys", fmt::format("{} is no key, allowed is {}", in_quotes(name), wanted));
        } else if (!used.insert(name).second) {
            reader.add("keys", fmt::format("{} stands for two answers", in_quotes(name)));
        }
        names.push_back(name);
    }
    return names;
}

void read_keys(TableReader& reader, Question& question) {
    const int count = question.answer_count();
    const std::string wanted = fmt::format(
        "an array of {} arrays, the keys of each answer: {}, a letter a to z or a "
        "digit",
        count, listed({kAdvanceKeys.begin(), kAdvanceKeys.end()}));
    const toml::array* keys = reader.array("keys", Need::kOptional, wanted);
    if (keys == nullptr) {
        const bool digits = !question.is_scale() || (question.min >= 0 && question.max <= 9) ||
                            (question.min >= 1 && question.max <= 10);
        if (!digits) {
            reader.add("keys",
                       fmt::format("is needed: steps {} to {} are not digits; allowed is {}",
                                   question.min, question.max, wanted));
        }
        return;
    }
    if (static_cast<int>(keys->size()) != count) {
        reader.add("keys", fmt::format("has {} values, allowed is {}", keys->size(), wanted));
        return;
    }
    std::set<std::string> used;
    for (const toml::node& node : *keys) {
        question.keys.push_back(key_names(reader, node, wanted, used));
    }
}

Question read_question(TableReader& reader, const std::string& where, bool first, Study& study) {
    Question question;
    question.id = reader.safe_id("question");
    const auto kind = reader.choice("kind", Need::kRequired, names_of(kQuestionKinds));
    for (const QuestionKind known : kQuestionKinds) {
        if (kind && to_string(known) == *kind) question.kind = known;
    }
    question.text = read_shown_text(reader, where, "text", Need::kRequired, study);
    for (const char* key : {"labels", "keys", "min", "max", "of"}) {
        if (!kind) reader.allow(key);
    }
    if (!kind) {
        reader.finish();
        return question;
    }
    if (first && question.is_scale()) {
        reader.add("kind", fmt::format("{} cannot be the first question, by which the pairs are "
                                       "compared; allowed is choice or choice-or-none",
                                       in_quotes(*kind)));
    }
    if (question.is_scale()) {
        read_scale(reader, where, question, study);
    } else {
        read_sides(reader, where, question, study);
    }
    read_keys(reader, question);
    reader.finish();
    return question;
}

}  // namespace

Questions read_questions(const std::vector<const toml::table*>& entries, Study& study,
                         Problems& problems) {
    Questions questions;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto id = (*entries[i])["id"].value<std::string>();
        const std::string where =
            id ? fmt::format("question {}", in_quotes(*id)) : fmt::format("question {}", i + 1);
        TableReader reader(*entries[i], where, problems);
        questions.list.push_back(read_question(reader, where, i == 0, study));
        const std::string& name = questions.list.back().id;
        if (!name.empty() && !seen.insert(name).second) {
            reader.add("id",
                       fmt::format("{} is used twice, each must be another", in_quotes(name)));
        }
        if (i == kMostQuestions) {
            problems.push_back(
                {line_of(*entries[i]),
                 fmt::format("{} questions, allowed are 1 to {}", entries.size(), kMostQuestions)});
        }
    }
    if (!questions.list.empty()) study.question = questions.list.front().text;
    return questions;
}

void read_ties(const toml::table& study_table, Questions& questions, Problems& problems) {
    TableReader reader(study_table, "study", problems);
    const auto ties = reader.choice("ties", Need::kOptional, names_of(kTies));
    if (!ties) return;
    questions.ties = *ties == to_string(Ties::kDavidson) ? Ties::kDavidson : Ties::kSplit;
    const bool has_ties = std::any_of(
        questions.list.begin(), questions.list.end(),
        [](const Question& question) { return question.kind == QuestionKind::kChoiceOrNone; });
    if (!has_ties) {
        reader.add("ties", "has no effect without a [[question]] of kind \"choice-or-none\"");
    }
}

Questions load_questions(const std::string& file_or_name) {
    const StudySource source = study_source(file_or_name);
    return read_study(source.text, builtin_scenes(), source.folder, SceneFiles::kTrusted).questions;
}

std::string plan_json(const Study& study, const Questions& questions) {
    const std::string without = study.plan_json();
    if (questions.list.empty()) return without;
    using Json = nlohmann::ordered_json;
    Json json = without.empty() ? Json::object() : Json::parse(without);
    bool has_ties = false;
    for (const Question& question : questions.list) {
        Json entry = {{"id", question.id},
                      {"kind", to_string(question.kind)},
                      {"text", question.text},
                      {"labels", question.labels}};
        if (question.is_scale()) {
            entry["min"] = question.min;
            entry["max"] = question.max;
        }
        if (question.each_image) entry["of"] = "images";
        json["questions"].push_back(std::move(entry));
        has_ties = has_ties || question.kind == QuestionKind::kChoiceOrNone;
    }
    if (has_ties) json["ties"] = to_string(questions.ties);
    return json.dump();
}

}  // namespace obscura::stimuli
