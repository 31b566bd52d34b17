// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/list.h"
#include "app/commands/planned_tally.h"
#include "app/commands/study_argument.h"
#include "app/kiosk/page_check.h"
#include "app/kiosk/text_check.h"
#include "stimuli/manifest.h"
#include "stimuli/pairs.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/study_reader.h"
#include "stimuli/study_warnings.h"

namespace obscura::app {
namespace {

using Json = nlohmann::ordered_json;

/// The study's images, where they are there; nothing is rendered or traced.
struct Images {
    stimuli::Manifest manifest;
    std::vector<stimuli::ManifestPair> pairs;
};

Images images_of(const stimuli::Study& study, const std::filesystem::path& folder) {
    try {
        Images images{stimuli::load_manifest(folder / "manifest.json"), {}};
        images.pairs = stimuli::compared_pairs(study, images.manifest, folder);
        return images;
    } catch (const base::Error&) {
        return {};  // run and render say what is wrong with it
    }
}

/// What may not be as the author expects, of the study and of its images where they are there.
std::vector<std::string> warnings_of(const stimuli::Study& study, const Images& images) {
    std::vector<std::string> warnings = stimuli::warnings_of(study);
    for (std::string& warning : stimuli::warnings_of(study, images.pairs)) {
        warnings.push_back(std::move(warning));
    }
    for (std::string& claim : stimuli::disordered_claims(study, images.manifest)) {
        warnings.push_back(std::move(claim));
    }
    const auto stale = std::count_if(
        images.manifest.images.begin(), images.manifest.images.end(),
        [&](const auto& image) { return !stimuli::shows_what_is_asked(study, image); });
    if (stale > 0) {
        warnings.push_back(
            fmt::format("{} of {} images are of before the study was edited; obscura render makes "
                        "them anew",
                        stale, images.manifest.images.size()));
    }
    const analysis::Tally planned = planned_tally(study);
    for (const stimuli::Hypothesis& hypothesis : study.hypotheses) {
        if (hypothesis.kind != stimuli::HypothesisKind::kPreference) continue;
        const auto pooling = pooling_of(planned, hypothesis.conditions);
        if (pooling.has_value()) continue;
        warnings.push_back(fmt::format("hypothesis {} cannot be tested, and counts as p = 1: {}",
                                       hypothesis.id, pooling.reason));
    }
    return warnings;
}

/// Everything that there is to say of a study file.
struct Findings {
    stimuli::StudySource source;
    stimuli::Questions questions;
    stimuli::Study study;  ///< of use where there is no problem
    std::vector<stimuli::StudyProblem> problems;
    std::vector<std::string> warnings;
    std::vector<std::string> notes;
};

Findings findings_of(const std::string& word, const Globals& globals) {
    Findings found;
    found.source = stimuli::study_source(study_named(word, globals));
    stimuli::StudyReading read =
        stimuli::read_study(found.source.text, stimuli::builtin_scenes(), found.source.folder);
    found.study = std::move(read.study);
    found.questions = std::move(read.questions);
    found.problems = std::move(read.problems);
    for (auto& problem : kiosk::problems_of_texts(found.study)) {
        found.problems.push_back(std::move(problem));
    }
    std::stable_sort(found.problems.begin(), found.problems.end(),
                     [](const auto& a, const auto& b) { return a.line < b.line; });
    if (!found.problems.empty()) return found;
    const Images images =
        images_of(found.study, stimuli::stimuli_folder(globals.data, found.study));
    found.warnings = warnings_of(found.study, images);
    for (const auto& notes :
         {stimuli::notes_on(found.study), kiosk::notes_on_pages(found.study, found.questions),
          stimuli::facts_of(found.study, images.manifest, images.pairs)}) {
        found.notes.insert(found.notes.end(), notes.begin(), notes.end());
    }
    if (const std::string note = kiosk::note_on_words(found.study); !note.empty()) {
        found.notes.push_back(note);
    }
    return found;
}

void print_findings_as_json(const Findings& found) {
    auto problems = Json::array();
    for (const stimuli::StudyProblem& problem : found.problems) {
        problems.push_back({{"line", problem.line}, {"message", problem.message}});
    }
    fmt::print("{}\n", Json{{"file", found.source.name},
                            {"study", found.study.name},
                            {"conditions", found.study.conditions.size()},
                            {"problems", problems},
                            {"warnings", found.warnings},
                            {"notes", found.notes}}
                           .dump(2));
}

void print_findings(const Findings& found) {
    const std::string& name = found.source.name;
    for (const std::string& warning : found.warnings) {
        fmt::print("{}: warning: {}\n", name, warning);
    }
    for (const std::string& note : found.notes) fmt::print("{}: note: {}\n", name, note);
    const std::size_t conditions = found.study.conditions.size();
    const std::size_t count = found.warnings.size();
    fmt::print("{}: {} condition{}, {} images, no problems{}\n", name, conditions,
               conditions == 1 ? "" : "s", 2 * conditions,
               count == 0 ? "" : fmt::format(", {} warning{}", count, count == 1 ? "" : "s"));
}

base::ExitCode check(const std::string& word, bool json, const Globals& globals) {
    const Findings found = findings_of(word, globals);
    if (json) {
        print_findings_as_json(found);
    } else if (!found.problems.empty()) {
        fmt::print("{}\n", stimuli::to_lines(found.problems, found.source.name));
    } else {
        print_findings(found);
    }
    return found.problems.empty() ? base::ExitCode::kDone : base::ExitCode::kBadInput;
}

}  // namespace

Command check_command() {
    return {"check", "Say everything that is wrong with a study file, each with its line",
            [](const Options& options, const Globals& globals) -> std::function<base::ExitCode()> {
                auto study = std::make_shared<std::string>();
                auto json = std::make_shared<bool>(false);
                add_study(options, *study);
                options.add_flag("--json", *json, "Print JSON");
                return [study, json, &globals] { return check(*study, *json, globals); };
            }};
}

}  // namespace obscura::app
