// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/preregister.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "analysis/conclusions/analysis.h"
#include "analysis/registration.h"
#include "app/commands/planned_tally.h"
#include "app/commands/study_power_text.h"
#include "app/kiosk/clock.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/version.h"
#include "stimuli/manifest.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;
using stimuli::Hypothesis;
using stimuli::HypothesisKind;
using stimuli::Study;

std::string hypothesis_lines(const Study& study) {
    const analysis::Tally planned = planned_tally(study);
    std::string text;
    for (const Hypothesis& hypothesis : study.hypotheses) {
        text += fmt::format("- **{}** ({} {}, margin {:g} points): {}\n", hypothesis.id,
                            to_string(hypothesis.role), to_string(hypothesis.kind),
                            100.0 * hypothesis.margin, hypothesis.statement);
        if (hypothesis.kind == HypothesisKind::kPreference) {
            const auto pooling = pooling_of(planned, hypothesis.conditions);
            text += fmt::format(
                "  Conditions {} together; {}.\n", fmt::join(hypothesis.conditions, ", "),
                pooling.has_value() ? pooling->words : "no test: " + pooling.reason);
            continue;
        }
        for (const auto& pair : hypothesis.pairs) {
            text += fmt::format("  {}, a test of its own.\n", fmt::join(pair, " against "));
        }
    }
    return text;
}

std::string condition_lines(const Study& study) {
    std::string text =
        "| condition | scene | validity | A | B |\n| --- | --- | --- | --- | --- |\n";
    for (const analysis::ConditionVotes& condition : planned_tally(study).conditions) {
        text += fmt::format("| {} | {} | {} | {} | {} |\n", condition.id, condition.view,
                            condition.validity, condition.variant_a, condition.variant_b);
    }
    return text;
}

std::string exclusion_words(const Study& study) {
    const stimuli::ExclusionRule& rule = study.exclusion;
    std::vector<std::string> parts;
    if (rule.min_catch_correct) {
        parts.push_back(fmt::format("a share of attention checks as expected below {:g}",
                                    *rule.min_catch_correct));
    }
    if (rule.min_repeat_agreement) {
        parts.push_back(fmt::format("a share of repeated pairs answered alike below {:g}",
                                    *rule.min_repeat_agreement));
    }
    if (rule.min_response_time_s) {
        parts.push_back(
            fmt::format("a median response time below {:g} s", *rule.min_response_time_s));
    }
    if (parts.empty()) return "Nobody who completes the study is left out.";
    return fmt::format("Left out is whoever has {}.", fmt::join(parts, ", or "));
}

std::string stopping_words(const Study& study, int participants) {
    const stimuli::StoppingRule& rule = study.stopping;
    if (rule.looks.empty()) {
        return fmt::format("One look at the answers, at {} participants.", participants);
    }
    return fmt::format("{} at {} participants; spending of the level: {}.",
                       rule.looks.size() == 1 ? "One look at the answers,"
                                              : fmt::format("{} looks,", rule.looks.size()),
                       fmt::join(rule.looks, ", "), rule.spending);
}

analysis::Registration registration_of(const Study& study, const PreregisterRequest& request) {
    const fs::path images = stimuli::stimuli_folder(request.data, study);
    const std::vector<std::string> problems = stimuli::problems_of_stimuli(study, images);
    if (!problems.empty()) {
        throw base::bad_input(
            "--preregister: the images are fixed with the rest, and are not ready: {}",
            problems.front());
    }
    analysis::Registration registration;
    registration.study = study.name;
    registration.study_sha256 = study.sha256;
    registration.study_plan = stimuli::plan_json(study, request.questions);
    registration.exclusion = study.exclusion.to_json();
    registration.participants = request.participants;
    registration.analysis_seed = analysis::kAnalysisSeed;
    registration.software = base::program_version();
    registration.written_utc = kiosk::utc_now();
    const stimuli::Manifest manifest = stimuli::load_manifest(images / "manifest.json");
    for (const stimuli::Condition& condition : study.conditions) {
        for (const char* side : {"a", "b"}) {
            const stimuli::ManifestImage* image = manifest.find(condition.id, side);
            registration.images[image->file] = image->sha256;
        }
    }
    return registration;
}

std::string image_lines(const analysis::Registration& registration) {
    std::string text = fmt::format("| file | SHA-256 |\n| --- | --- |\n| the study's | {} |\n",
                                   registration.study_sha256);
    for (const auto& [file, sha256] : registration.images) {
        text += fmt::format("| {} | {} |\n", file, sha256);
    }
    return text;
}

std::string power_block(const Study& study, const PreregisterRequest& request) {
    PowerRequest power;
    power.participants = request.participants;
    power.asks_needed = false;
    power.quiet = request.quiet;
    return "```\n" + study_power_text(study, power, power_of_study(study, power)) + "```\n";
}

/// What is asked beside the study's one question.
std::string question_lines(const stimuli::Questions& questions) {
    if (questions.list.empty()) return "";
    std::string text = "## Questions of each pair, in this order\n";
    for (const stimuli::Question& question : questions.list) {
        text += fmt::format("- {} ({}{}): {}\n", question.id, to_string(question.kind),
                            question.each_image ? ", of each image" : "", question.text);
    }
    return text +
           fmt::format(
               "\nAnswers without a difference: {}. The pairs are compared by the first.\n\n",
               to_string(questions.ties));
}

std::string document_of(const Study& study, const PreregisterRequest& request,
                        const analysis::Registration& registration) {
    return fmt::format(
        "# Pre-registration of the study {}: {}\n\nWritten {} by {}. The question: {}\n\n"
        "{}## Conditions\n{}\n"
        "## Hypotheses\n{}\nHolm's correction is over the tests of the primary ones.\n\n"
        "## Participants and power\n{} participants.\n\n{}\n"
        "## Order\nOrder of the pairs: {}, seed {}; sides of the images: balanced by {}.\n\n"
        "## Whom to leave out\n{}\n\n## When to look\n{}\n\n"
        "## Analysis\n`obscura analyze` of {}, seed {}. {}\n\n## Files\n{}\n"
        "## For `obscura analyze --preregistered`\n{}",
        study.name, study.title, registration.written_utc, registration.software, study.question,
        question_lines(request.questions), condition_lines(study), hypothesis_lines(study),
        request.participants, power_block(study, request), to_string(study.order), study.seed,
        to_string(study.sides), exclusion_words(study), stopping_words(study, request.participants),
        registration.software, registration.analysis_seed, analysis::verdict_rule(),
        image_lines(registration), registration_block(registration));
}

void check(const Study& study, const PreregisterRequest& request, const fs::path& document) {
    if (study.hypotheses.empty()) {
        throw base::bad_input(
            "--preregister: the study {} has no [[hypothesis]]: there is nothing to register",
            study.name);
    }
    const auto& looks = study.stopping.looks;
    if (!looks.empty() && looks.back() != request.participants) {
        throw base::bad_input(
            "--participants {}: the last look of the study is at {}, allowed is that number",
            request.participants, looks.back());
    }
    std::error_code ignored;
    if (fs::exists(document, ignored)) {
        throw base::bad_input(
            "--preregister: {} is there; what was registered is not replaced, give another folder",
            document.string());
    }
}

}  // namespace

fs::path preregister(const Study& study, const PreregisterRequest& request) {
    const fs::path document = request.folder / "preregistration.md";
    check(study, request, document);
    const analysis::Registration registration = registration_of(study, request);
    base::require_writable_folder(request.folder, "--preregister");
    base::write_file_atomically(document, document_of(study, request, registration));
    return document;
}

}  // namespace obscura::app
