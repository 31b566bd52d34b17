// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands/list.h"
#include "app/commands/planned_tally.h"
#include "app/kiosk/page_check.h"
#include "app/kiosk/text_check.h"
#include "stimuli/manifest.h"
#include "stimuli/pairs.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/study_reader.h"
#include "stimuli/study_warnings.h"

namespace obscura::app {
namespace {

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

base::ExitCode check(const std::string& file_or_name, const Globals& globals) {
    const stimuli::StudySource source = stimuli::study_source(file_or_name);
    const auto& [study, of_file] =
        stimuli::read_study(source.text, stimuli::builtin_scenes(), source.folder);
    std::vector<stimuli::StudyProblem> problems = of_file;
    for (auto& problem : kiosk::problems_of_texts(study)) {
        problems.push_back(std::move(problem));
    }
    if (!problems.empty()) {
        std::stable_sort(problems.begin(), problems.end(),
                         [](const auto& a, const auto& b) { return a.line < b.line; });
        fmt::print("{}\n", stimuli::to_lines(problems, source.name));
        return base::ExitCode::kBadInput;
    }
    const Images images = images_of(study, stimuli::stimuli_folder(globals.data, study));
    const std::vector<std::string> warnings = warnings_of(study, images);
    for (const std::string& warning : warnings) {
        fmt::print("{}: warning: {}\n", source.name, warning);
    }
    for (const auto& notes : {stimuli::notes_on(study), kiosk::notes_on_pages(study),
                              stimuli::facts_of(study, images.manifest, images.pairs)}) {
        for (const std::string& note : notes) fmt::print("{}: note: {}\n", source.name, note);
    }
    if (const std::string note = kiosk::note_on_words(study); !note.empty()) {
        fmt::print("{}: note: {}\n", source.name, note);
    }
    const std::size_t conditions = study.conditions.size();
    const std::size_t count = warnings.size();
    fmt::print("{}: {} condition{}, {} images, no problems{}\n", source.name, conditions,
               conditions == 1 ? "" : "s", 2 * conditions,
               count == 0 ? "" : fmt::format(", {} warning{}", count, count == 1 ? "" : "s"));
    return base::ExitCode::kDone;
}

}  // namespace

Command check_command() {
    return {"check", "Say everything that is wrong with a study file, each with its line",
            [](const Options& options, const Globals& globals) -> std::function<base::ExitCode()> {
                auto study = std::make_shared<std::string>();
                options.add("STUDY", *study,
                            "Study file, or the name of a built-in study; default: "
                            "jakobsen2010");
                return [study, &globals] { return check(*study, globals); };
            }};
}

}  // namespace obscura::app
