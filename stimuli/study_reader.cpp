// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/study_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "renderer/base/hash.h"
#include "renderer/frame/plan.h"
#include "stimuli/attention_reader.h"
#include "stimuli/hypothesis_reader.h"
#include "stimuli/participant_reader.h"
#include "stimuli/presentation_reader.h"
#include "stimuli/question_reader.h"
#include "stimuli/scene_reader.h"
#include "stimuli/table_reader.h"
#include "stimuli/variant_format.h"

namespace obscura::stimuli {
namespace {

using Need = TableReader::Need;
using Problems = std::vector<StudyProblem>;

constexpr std::int64_t kMostPixels = 16384;  // a side; what OpenGL 4.5 drivers allow at least
constexpr std::size_t kLongestId = 64;

/// A text that can be part of a file's name everywhere; empty where it is missing or wrong.
std::string read_id(TableReader& reader, const std::string& key) {
    const std::optional<std::string> id = reader.text(key, Need::kRequired);
    if (!id) return "";
    const std::string problem = problem_of_id(*id);
    if (problem.empty()) return *id;
    reader.add(key, problem);
    return "";
}

void read_resolution(TableReader& reader, Study& study) {
    const std::string wanted =
        fmt::format("a pair of integers from 1 to {}: [width, height]", kMostPixels);
    const toml::array* sides = reader.array("resolution", Need::kOptional, wanted);
    if (sides == nullptr) return;
    if (sides->size() != 2) {
        reader.add("resolution",
                   fmt::format("has {} values, allowed is {}", sides->size(), wanted));
        return;
    }
    std::array<int, 2> pixels{study.width, study.height};
    for (std::size_t i = 0; i < 2; ++i) {
        const toml::value<std::int64_t>* side = sides->get(i)->as_integer();
        if (side == nullptr) {
            reader.add("resolution",
                       fmt::format("value {} is no integer, allowed is {}", i + 1, wanted));
        } else if (**side < 1 || **side > kMostPixels) {
            reader.add("resolution",
                       fmt::format("{} is out of range, allowed is {}", **side, wanted));
        } else {
            pixels[i] = static_cast<int>(**side);
        }
    }
    study.width = pixels[0];
    study.height = pixels[1];
}

/// The question of [study], where the study has none of its own.
void read_only_question(TableReader& reader, bool has_questions, Study& study) {
    const Need need = has_questions ? Need::kOptional : Need::kRequired;
    study.question = read_shown_text(reader, "study", "question", need, study);
    if (has_questions && reader.has("question")) {
        reader.add("question", "has no effect beside [[question]]: give the text there");
    }
}

void read_study_table(const toml::table& table, const toml::table* texts, bool has_questions,
                      Study& study, Problems& problems) {
    TableReader reader(table, "study", problems);
    study.name = read_id(reader, "name");
    study.title = read_shown_text(reader, "study", "title", Need::kRequired, study);
    read_only_question(reader, has_questions, study);
    study.instructions = read_shown_text(reader, "study", "instructions", Need::kRequired, study);
    study.thanks = read_shown_text(reader, "study", "thanks", Need::kOptional, study);
    read_words(reader, texts, study, problems);
    read_resolution(reader, study);
    study.supersampling = static_cast<int>(
        reader.integer("supersampling", Need::kOptional, 1, renderer::kMostSupersampling)
            .value_or(study.supersampling));
    if (const auto opacity = reader.number("occluding_opacity", Need::kOptional, 0.01, 1.0)) {
        study.occluding_opacity = static_cast<float>(*opacity);
    }
    study.match_luminance =
        reader.boolean("match_luminance", Need::kOptional).value_or(study.match_luminance);
    read_presentation(reader, study.presentation);
    const auto order = reader.choice("order", Need::kOptional, names_of(kOrderKinds));
    if (order) study.order = *order_kind_from(*order);
    const auto sides = reader.choice("sides", Need::kOptional, names_of(kSideOrders));
    if (sides) study.sides = *side_order_from(*sides);
    study.seed = static_cast<std::uint64_t>(
        reader.integer("seed", Need::kRequired, 0, std::numeric_limits<std::int64_t>::max())
            .value_or(0));
    reader.allow("ties");
    reader.finish();
}

/// How messages call the index-th table of an array of tables.
std::string name_of_entry(const toml::table& table, std::string_view kind, std::size_t index) {
    const std::optional<std::string> id = table["id"].value<std::string>();
    return id ? fmt::format("{} {}", kind, in_quotes(*id)) : fmt::format("{} {}", kind, index + 1);
}

void refuse_second(TableReader& reader, const std::string& id, std::set<std::string>& seen) {
    if (!id.empty() && !seen.insert(id).second) {
        reader.add("id", fmt::format("{} is used twice, each must be another", in_quotes(id)));
    }
}

/// The entries of an array of tables, with what is no table reported.
std::vector<const toml::table*> read_entries(TableReader& root, const std::string& key) {
    const std::string wanted = fmt::format("an array of tables, each begun with [[{}]]", key);
    std::vector<const toml::table*> entries;
    const toml::array* array = root.array(key, Need::kOptional, wanted);
    if (array == nullptr) return entries;
    for (const toml::node& node : *array) {
        if (node.is_table()) entries.push_back(node.as_table());
    }
    if (entries.size() != array->size()) {
        root.add(key, fmt::format("holds something that is no table, allowed is {}", wanted));
    }
    return entries;
}

/// One side of a condition; nothing where it is missing or something in it is wrong.
std::optional<renderer::Variant> read_side(TableReader& reader, const std::string& side,
                                           const std::string& where, Problems& problems) {
    const toml::table* table = reader.table(side, Need::kRequired);
    if (table == nullptr) return std::nullopt;
    const std::size_t before = problems.size();
    renderer::Variant variant = read_variant(*table, where + ", " + side, problems);
    if (problems.size() != before) return std::nullopt;
    return variant;
}

/// The scenes that conditions may name.
struct KnownScenes {
    std::vector<std::string> ids;
    bool is_complete = true;  ///< every scene has an id
};

/// A scene without an id may be the one that is meant.
void require_scene(TableReader& reader, const std::string& scene, const KnownScenes& scenes) {
    if (!scenes.is_complete ||
        std::find(scenes.ids.begin(), scenes.ids.end(), scene) != scenes.ids.end()) {
        return;
    }
    reader.add("scene",
               fmt::format("{} is not defined by a [[scene]], defined are {}{}", in_quotes(scene),
                           listed(scenes.ids), did_you_mean(scene, scenes.ids)));
}

Condition read_condition(TableReader& reader, const std::string& where, const KnownScenes& scenes,
                         Problems& problems) {
    Condition condition;
    condition.id = read_id(reader, "id");
    condition.expected = read_expected(reader);
    condition.practice = reader.boolean("practice", Need::kOptional).value_or(false);
    if (reader.has("repeats") || (reader.is_misspelt("repeats") && !reader.has("scene"))) {
        read_repeats(reader, condition);
        return condition;
    }
    const auto scene = reader.text("scene", Need::kRequired);
    if (scene) {
        condition.scene = *scene;
        require_scene(reader, *scene, scenes);
    }
    reader.allow("repeats");
    condition.hypothesis = reader.text("hypothesis", Need::kOptional).value_or("");
    condition.identical = read_identical(reader, condition);
    check_practice(reader, condition);
    const auto a = read_side(reader, "a", where, problems);
    const auto b = read_side(reader, "b", where, problems);
    if (a) condition.a = *a;
    if (b) condition.b = *b;
    if (a && b && *a == *b && !condition.identical) {
        reader.add(
            "b",
            "is the same as a in every way: there would be nothing to choose between; a pair "
            "that is meant so says identical = true");
    }
    reader.finish();
    return condition;
}

/// An order needs something to order; a single pair is a study only where its order is fixed.
void check_condition_count(const Study& study, const std::vector<const toml::table*>& conditions,
                           Problems& problems) {
    if (conditions.empty()) {
        problems.push_back({0, "no [[condition]]: a study needs at least one pair to show"});
    } else if (study.pair_count() == 0) {
        problems.push_back({line_of(*conditions.front()),
                            "every [[condition]] is practice: a study needs a pair that counts"});
    } else if (study.pair_count() == 1 && study.order != OrderKind::kFixed) {
        problems.push_back(
            {line_of(*conditions.front()),
             fmt::format("order \"{}\" needs at least two conditions, there is 1{}; a single pair "
                         "can be shown with order = \"fixed\"",
                         to_string(study.order),
                         conditions.size() == 1 ? "" : " beside practice")});
    } else if (conditions.size() > static_cast<std::size_t>(kMostConditions)) {
        problems.push_back({line_of(*conditions[kMostConditions]),
                            fmt::format("{} conditions, allowed are 1 to {}", conditions.size(),
                                        kMostConditions)});
    }
}

void read_root(const toml::table& root, SceneReader& scene_reader, StudyReading& reading) {
    Study& study = reading.study;
    Problems& problems = reading.problems;
    TableReader reader(root, "file", problems);
    const toml::table* table = reader.table("study", Need::kRequired);
    const toml::table* texts = reader.table("texts", Need::kOptional);
    const bool has_questions = root.contains("question");
    if (table != nullptr) read_study_table(*table, texts, has_questions, study, problems);
    const auto questions = read_entries(reader, "question");
    if (!questions.empty()) reading.questions = read_questions(questions, study, problems);
    if (table != nullptr) read_ties(*table, reading.questions, problems);

    const toml::table* information = reader.table("information", Need::kOptional);
    if (information != nullptr) read_information(*information, study, problems);
    const toml::table* consent = reader.table("consent", Need::kOptional);
    if (consent != nullptr) read_consent(*consent, study, problems);
    const toml::table* form = reader.table("form", Need::kOptional);
    if (form != nullptr) read_form(*form, study, problems);

    std::set<std::string> seen;
    KnownScenes known;
    const auto scenes = read_entries(reader, "scene");
    known.is_complete = !reader.is_misspelt("scene");
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        TableReader entry(*scenes[i], name_of_entry(*scenes[i], "scene", i), problems);
        study.scenes.push_back(scene_reader.read(entry, read_id(entry, "id"), problems));
        const std::string& id = study.scenes.back().id;
        if (id.empty()) known.is_complete = false;
        if (!id.empty() && !seen.contains(id)) known.ids.push_back(id);
        refuse_second(entry, id, seen);
    }
    seen.clear();
    const auto conditions = read_entries(reader, "condition");
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        const std::string where = name_of_entry(*conditions[i], "condition", i);
        TableReader entry(*conditions[i], where, problems);
        study.conditions.push_back(read_condition(entry, where, known, problems));
        refuse_second(entry, study.conditions.back().id, seen);
    }
    const toml::node* array = root.get("condition");
    const bool is_counted = array == nullptr ? !reader.is_misspelt("condition") : array->is_array();
    if (is_counted) check_condition_count(study, conditions, problems);
    resolve_repeats(study, conditions, problems);
    seen.clear();
    const auto hypotheses = read_entries(reader, "hypothesis");
    for (std::size_t i = 0; i < hypotheses.size(); ++i) {
        TableReader entry(*hypotheses[i], name_of_entry(*hypotheses[i], "hypothesis", i), problems);
        study.hypotheses.push_back(read_hypothesis(entry, read_id(entry, "id"), study));
        refuse_second(entry, study.hypotheses.back().id, seen);
    }
    settle_hypotheses(study, conditions, hypotheses, problems);
    const toml::table* exclusion = reader.table("exclusion", Need::kOptional);
    if (exclusion != nullptr) read_exclusion(*exclusion, conditions, study, problems);
    const toml::table* stopping = reader.table("stopping", Need::kOptional);
    if (stopping != nullptr) read_stopping(*stopping, study, problems);
    // The order is one of the others, whose indices it counts.
    std::stable_partition(study.conditions.begin(), study.conditions.end(),
                          [](const Condition& condition) { return !condition.practice; });
    reader.finish();
}

/// Ordered by their lines, and a mistake that was made in several places told once: at the first of
/// them, with the others behind it.
Problems each_mistake_once(Problems problems) {
    std::stable_sort(problems.begin(), problems.end(),
                     [](const auto& a, const auto& b) { return a.line < b.line; });
    Problems once;
    std::map<std::string, std::size_t> told;
    std::vector<std::string> elsewhere;
    for (StudyProblem& problem : problems) {
        const auto [first, is_new] = told.emplace(problem.mistake, once.size());
        if (is_new || problem.mistake.empty()) {
            once.push_back(std::move(problem));
            elsewhere.emplace_back();
            continue;
        }
        std::string& places = elsewhere[first->second];
        places += fmt::format("{} {} (line {})", places.empty() ? "; the same in" : ",",
                              problem.where, problem.line);
    }
    for (std::size_t i = 0; i < once.size(); ++i) once[i].message += elsewhere[i];
    return once;
}

}  // namespace

std::string problem_of_id(const std::string& id) {
    const auto safe = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '-' || c == '_' || c == '.';
    };
    const bool holds = !id.empty() && id.size() <= kLongestId && id.front() != '.' &&
                       id.front() != '-' && std::all_of(id.begin(), id.end(), safe);
    if (holds) return "";
    return fmt::format(
        "{} cannot be part of a file name, allowed are 1 to {} of A-Z a-z 0-9 - _ . not beginning "
        "with - or .",
        in_quotes(id), kLongestId);
}

StudyReading read_study(std::string_view text, const std::vector<BuiltinScene>& catalogue,
                        const std::filesystem::path& folder, SceneFiles files) {
    StudyReading reading;
    reading.study.folder = folder;
    SceneReader scene_reader(catalogue, folder, files);
    reading.study.sha256 = base::sha256_hex(text);
    try {
        read_root(toml::parse(text), scene_reader, reading);
    } catch (const toml::parse_error& error) {
        reading.problems.push_back({static_cast<int>(error.source().begin.line),
                                    fmt::format("not TOML: {}", error.description())});
    }
    reading.problems = each_mistake_once(std::move(reading.problems));
    return reading;
}

}  // namespace obscura::stimuli
