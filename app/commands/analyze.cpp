// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>

#include "analysis/conclusions/caveats.h"
#include "analysis/conclusions/model_check.h"
#include "analysis/conclusions/published_study.h"
#include "analysis/counts_file.h"
#include "analysis/export/export_folder.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/questions_text.h"
#include "analysis/presentation/report.h"
#include "analysis/presentation/summary.h"
#include "analysis/presentation/text_report.h"
#include "analysis/published_votes.h"
#include "analysis/store/store.h"
#include "analysis/tally.h"
#include "analysis/trials_file.h"
#include "app/commands/list.h"
#include "app/commands/look_log.h"
#include "app/commands/report_input.h"
#include "app/commands/store_argument.h"
#include "app/commands/study_argument.h"
#include "renderer/base/files.h"
#include "renderer/base/log.h"
#include "renderer/base/version.h"
#include "stimuli/package/package.h"
#include "stimuli/view_names.h"

namespace obscura::app {
namespace {

struct AnalyzeOptions {
    std::string db;  ///< empty: the data folder's
    std::string counts;
    std::string trials;
    std::vector<std::string> map;  ///< OURS=THEIRS, of the columns of a table
    bool published = false;
    std::string study;                    ///< name: whose answers; empty: there is one study
    std::string study_file;               ///< what they are answers to; empty: not said
    std::filesystem::path preregistered;  ///< empty: none
    std::string kind = "participant";
    bool validity = false;
    bool model = false;
    bool no_model = false;
    bool json = false;
    bool full = false;
    std::filesystem::path measurement;  ///< empty: the data folder's
    std::filesystem::path out;          ///< empty: nothing is written
};

/// The votes, and who gave them where that is known.
struct Answers {
    analysis::Tally tally;
    analysis::Conducted conducted = {};
    analysis::Possible<analysis::Attendance> attendance =
        analysis::Possible<analysis::Attendance>::none("only votes are known");
    std::optional<analysis::QuestionsResult> questions = {};
    std::map<std::string, int> study_files = {};  ///< SHA-256, and how many sessions began with it
};

/// What else was asked of each pair; nothing where only they were, with what stands in the way.
std::optional<analysis::QuestionsResult> questions_of(analysis::Store& store,
                                                      analysis::Tally& tally, analysis::Kind kind) {
    // Where all sessions carry one plan it says so without another look at each of them.
    const bool none =
        tally.plan.has_value() && analysis::asked_questions(tally.plan_text).list.empty();
    if (none) return std::nullopt;
    const auto data = analysis::read_question_data(store, tally.study, kind);
    if (data.has_value()) return analysis::analyse_questions(*data);
    if (data.reason != analysis::kNothingElseAsked) tally.notes.push_back(data.reason);
    return std::nullopt;
}

/// SHA-256 of every image that a completed session showed, by the file that it was of.
std::map<std::string, std::vector<std::string>> images_shown(analysis::Store& store,
                                                             const std::string& study,
                                                             analysis::Kind kind) {
    std::map<std::string, std::vector<std::string>> shown;
    const auto note = [&](const analysis::TrialRecord& trial, char side, const std::string& hash) {
        auto& hashes = shown[fmt::format("{}-{}.png", trial.condition, side)];
        if (std::find(hashes.begin(), hashes.end(), hash) == hashes.end()) hashes.push_back(hash);
    };
    store.each_trial(
        [&](const analysis::TrialRecord& trial, const analysis::SessionRecord& session) {
            if (session.study != study || session.kind != kind ||
                session.state != analysis::SessionState::kCompleted) {
                return;
            }
            const bool a_first = trial.first_shown == 'A';
            note(trial, 'a', a_first ? trial.first_sha256 : trial.second_sha256);
            note(trial, 'b', a_first ? trial.second_sha256 : trial.first_sha256);
        });
    return shown;
}

Answers answers_of_store(const std::string& url, const AnalyzeOptions& options) {
    analysis::Store store(url, analysis::Store::Access::kReadOnly);
    const auto kind = analysis::kind_from(options.kind);
    Answers answers;
    const auto read = [&] {
        answers.tally =
            analysis::tally_of(analysis::read_answers(store, url), options.study, *kind);
        answers.questions = questions_of(store, answers.tally, *kind);
        if (!options.study_file.empty()) {
            store.each_session([&](const analysis::SessionRecord& session) {
                if (session.study == answers.tally.study && session.kind == *kind) {
                    ++answers.study_files[session.study_sha256];
                }
            });
        }
        if (!options.preregistered.empty()) {
            answers.conducted.images = images_shown(store, answers.tally.study, *kind);
        }
        if (!options.out.empty() || options.full) {
            answers.attendance = analysis::attendance_of(store, answers.tally.study, *kind);
        }
    };
    // Images and attendance are read beside the answers; a kiosk would wait for all of it.
    const bool reads_on = !options.preregistered.empty() || !options.out.empty() || options.full;
    store.of_one_moment(read, reads_on ? analysis::Moment::kCopied : analysis::Moment::kHeld);
    return answers;
}

Answers answers_of(const AnalyzeOptions& options, const Globals& globals) {
    if (options.published) return {analysis::published_votes()};
    const analysis::ColumnMap map(options.map);
    if (!options.map.empty() && options.counts.empty() && options.trials.empty()) {
        throw base::bad_input("--map {}: it needs --trials or --counts", options.map.front());
    }
    if (!options.counts.empty()) return {analysis::read_counts(options.counts, map)};
    if (options.trials.empty()) {
        refuse_no_answers(options.db, globals);
        return answers_of_store(store_url_from(options.db, globals), options);
    }
    Answers answers{analysis::tally_of(analysis::read_trials(options.trials, map), options.study,
                                       *analysis::kind_from(options.kind))};
    answers.attendance = analysis::Possible<analysis::Attendance>::none(
        "a file of answers says nothing of the people");
    return answers;
}

/// Whether mixed models are fitted: unasked to as many answers as take no time to speak of.
bool wants_model(const AnalyzeOptions& options, const analysis::Tally& tally) {
    std::int64_t answers = 0;
    for (const analysis::ConditionVotes& condition : tally.conditions) {
        answers += static_cast<std::int64_t>(condition.answers.size());
    }
    return options.model || (!options.no_model && answers <= analysis::kMostModelled);
}

/// The study that the answers are to, where its file is known.
std::optional<stimuli::Study> study_of(const AnalyzeOptions& options,
                                       const analysis::Tally& tally) {
    if (options.study_file.empty()) {
        return builtin_study(is_published_votes(tally) ? analysis::kPublishedStudy : tally.study);
    }
    stimuli::Study study = stimuli::load_study(options.study_file);
    if (!tally.study.empty() && study.name != tally.study) {
        throw base::bad_input("STUDY: {} is the study {}, the answers are to {}",
                              options.study_file, study.name, tally.study);
    }
    return study;
}

/// A file that was edited once answers had come: what each session fixed is analysed all the same.
void warn_of_another_version(const std::optional<stimuli::Study>& study, const Answers& answers) {
    if (!study) return;
    int others = 0;
    for (const auto& [sha256, sessions] : answers.study_files) {
        if (sha256 != study->sha256) others += sessions;
    }
    if (others == 0) return;
    base::log::warn(
        "{} session{} of {} began with another version of its file: hypotheses, plan and rule of "
        "exclusion are those that the sessions carry; of this file only title, question and views "
        "are taken",
        others, others == 1 ? "" : "s", study->name);
}

/// What is shown on the standard output.
std::string shown_text(const analysis::ReportInput& input, const AnalyzeOptions& options) {
    const analysis::QuestionsResult* const questions =
        input.questions ? &*input.questions : nullptr;
    if (options.json) return analysis::json_report(input.analysis, questions);
    const std::string asked = questions == nullptr ? "" : analysis::questions_text(*questions);
    if (options.full) {
        return analysis::text_report(
                   input.analysis,
                   analysis::caveats_of(input.analysis, input.images, input.attendance)) +
               asked;
    }
    std::string text = analysis::summary_text(input.analysis) + asked + '\n';
    if (options.out.empty()) {
        return text +
               "All tests in words: --full. As a page with plots, and ready for a paper: --out "
               "FOLDER.\n";
    }
    return text + fmt::format("report    {}\npaper     {}\nall tests {}\n",
                              (options.out / "report.html").string(),
                              (options.out / "paper").string(),
                              (options.out / "analysis.txt").string());
}

/// Counts and tables of other programs are looked at once, or nobody knows how often.
bool is_of_store(const AnalyzeOptions& options) {
    return !options.published && options.counts.empty() && options.trials.empty();
}

analysis::RegistrationResult registration_of(Answers& answers, const analysis::Analysis& result,
                                             const AnalyzeOptions& options) {
    analysis::Conducted& conducted = answers.conducted;
    conducted.software = base::program_version();
    conducted.analysis_seed = analysis::kAnalysisSeed;
    conducted.asks_validity = options.validity && result.family.interaction() == nullptr;
    return analysis::compare_registration(analysis::read_registration(options.preregistered),
                                          options.preregistered.string(), answers.tally, conducted);
}

/// A name says whose answers are wanted, a file or a package also what they are answers to.
void resolve_study(AnalyzeOptions& options, const Globals& globals) {
    const std::string word = options.study;
    if (word.empty()) return;
    std::error_code ignored;
    const bool is_file = word.ends_with(".toml") || stimuli::is_package(word) ||
                         std::filesystem::is_regular_file(word, ignored);
    if (is_file && !builtin_study(word)) {
        options.study_file = study_named(word, globals);
        const auto trusted = stimuli::SceneFiles::kTrusted;
        options.study =
            is_of_store(options) ? stimuli::load_study(options.study_file, trusted).name : "";
    } else if (options.published || !options.counts.empty()) {
        throw base::bad_input("STUDY: there is no file {}; {} holds the votes of one study", word,
                              options.published ? "--published" : options.counts);
    }
}

base::ExitCode analyze(AnalyzeOptions options, const Globals& globals) {
    resolve_study(options, globals);
    if (!options.out.empty()) {
        base::require_writable_folder(options.out, "--out");
        analysis::require_own_export_folder(options.out);
    }
    Answers answers = answers_of(options, globals);
    for (const std::string& note : answers.tally.notes) {
        base::log::warn("{}: {}", answers.tally.source, note);
    }
    answers.tally.asks_validity = options.validity;
    std::optional<LookLog> looks;
    if (is_of_store(options) && answers.tally.kind == analysis::Kind::kParticipant) {
        looks.emplace(globals.data, answers.tally.study);
        answers.tally.looks_before = looks->looks();
    }
    const std::optional<stimuli::Study> study = study_of(options, answers.tally);
    warn_of_another_version(study, answers);
    if (study) analysis::name_views(answers.tally, stimuli::view_names(*study));
    analysis::ReportInput input;
    const analysis::AnalysisOptions parts{wants_model(options, answers.tally)};
    input.analysis = analysis::analyse(answers.tally, parts);
    if (!options.preregistered.empty()) {
        input.analysis.registration = registration_of(answers, input.analysis, options);
    }
    if (looks) looks->note(static_cast<std::int64_t>(answers.tally.participants.size()));
    input.attendance = std::move(answers.attendance);
    input.questions = std::move(answers.questions);
    if (!options.out.empty() || options.full) {
        add_sources(input, {globals.data, study, options.measurement});
    }
    if (!options.out.empty()) {
        analysis::write_report(analysis::report_files(input), options.out);
        if (!globals.quiet && (options.json || options.full)) {
            fmt::print(stderr, "report    {}\n", (options.out / "report.html").string());
        }
    }
    fmt::print("{}", shown_text(input, options));
    return base::ExitCode::kDone;
}

void attach_sources(const Options& app, AnalyzeOptions& options) {
    const Option db = add_store(app, options.db);
    const Option counts =
        app.add("--counts", options.counts,
                "Votes from a table: variant_a,variant_b,count_a,count_b, and where they are there "
                "condition,hypothesis,validity,scene")
            .type("FILE");
    const Option trials = app.add("--trials", options.trials,
                                  "Answers from a table, one row a trial: "
                                  "observer,condition_A,condition_B and is_A_selected "
                                  "(yes or no), chose_B, or chosen (a variant's name, A or B ...), "
                                  "and where they are there "
                                  "session_id,scene,order,response_time; or an exported trials.csv")
                              .type("FILE");
    const Option map = app.add("--map", options.map,
                               "What the table calls a column, as in observer=Subject; empty: its "
                               "column of our name is something else. Once for each column")
                           .type("OURS=THEIRS")
                           .repeatable();
    const Option published =
        app.add_flag("--published", options.published,
                     "The votes of Jakobsen 2010, Table 4, which are built in");
    app.add(
        "STUDY", options.study,
        "Study file, package (.zip) or name of a study: whose answers, where there are several; "
        "and for which scenes are the same, and the report's title and question (default: the "
        "built-in study of the answers' name)");
    const Option kind = app.add("--kind", options.kind, "Whose answers: participant or simulated")
                            .one_of({"participant", "simulated"})
                            .shows_default();
    map.excludes({db});
    counts.excludes({db, trials, kind});
    published.excludes({map, counts, db, trials, kind});
    trials.excludes({db});
}

std::function<base::ExitCode()> attach_analyze(const Options& app, const Globals& globals) {
    auto options = std::make_shared<AnalyzeOptions>();
    attach_sources(app, *options);
    app.add_flag("--by-validity", options->validity,
                 "Also ask whether the preference depends on ecological validity, as the built-in "
                 "study does: the same two variants in the same scene at two levels; corrected "
                 "together with the hypotheses");
    const Option model = app.add_flag(
        "--model", options->model,
        fmt::format("Check each verdict by a logistic model with an intercept for each participant "
                    "(default: for up to {} answers)",
                    analysis::kMostModelled));
    app.add_flag("--no-model", options->no_model, "Leave that out").excludes({model});
    const Option json = app.add_flag("--json", options->json, "Print JSON");
    app.add_flag("--full", options->full,
                 "Print every test in words instead of one screen: what analysis.txt of the report "
                 "holds")
        .excludes({json});
    const Option out = app.add("--out", options->out,
                               "Folder for the report: report.html, report.md, analysis.txt, "
                               "analysis.json, plots/, thumbnails/, and in paper/ methods, "
                               "results, tables and figures as Markdown, LaTeX, CSV, SVG and PDF; "
                               "what is there is replaced")
                           .type("FOLDER");
    app.add("--preregistered", options->preregistered,
            "Document of obscura plan --preregister: say what deviates from it")
        .type("FILE");
    app.add("--measurement", options->measurement,
            "Table of obscura measure, for speed, error and what relates them to the answers "
            "(default: DATA/reports/measure/measure.csv, where it is there)")
        .type("FILE")
        .needs(out);
    app.footer(
        "Tables are CSV with commas, semicolons or tabs, in UTF-8, UTF-16 or Latin-1, or JSON as "
        "jsPsych writes it; other columns are passed over. "
        "The report shows the images of DATA/stimuli/STUDY that the answers were given to. Its "
        "plots "
        "need gnuplot; without it the tables stand alone.");
    return [options, &globals] { return analyze(*options, globals); };
}

}  // namespace

Command analyze_command() {
    return {"analyze", "Test the answers: is one image preferred, and where?", attach_analyze};
}

}  // namespace obscura::app
