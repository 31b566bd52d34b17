// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The Brain Imaging Data Structure, version 1.9.0 (bids-specification.readthedocs.io): "Behavioral
// experiments (with no neural recordings)", "Task events", "Participants file", "Dataset
// description".
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <set>

#include "analysis/export/form_columns.h"
#include "analysis/export/formats.h"
#include "analysis/export/question_table.h"
#include "analysis/export/screen_columns.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kBidsVersion = "1.9.0";
constexpr const char* kUnknown = "n/a";
/// From this age on, BIDS asks for no more than that it is reached.
constexpr int kAgeHidden_years = 89;

/// Labels of entities: letters and digits only, and no two alike.
class Labels {
  public:
    const std::string& of(const std::string& name) {
        const auto [place, is_new] = labels_.try_emplace(name);
        if (is_new) {
            std::string label = name;
            std::erase_if(label, [](unsigned char c) { return c >= 0x80 || std::isalnum(c) == 0; });
            if (label.empty()) label = "x";
            std::string free = label;
            for (int next = 2; !taken_.insert(free).second; ++next) {
                free = fmt::format("{}x{}", label, next);
            }
            place->second = std::move(free);
        }
        return place->second;
    }

  private:
    std::unordered_map<std::string, std::string> labels_;
    std::set<std::string> taken_;
};

/// Descriptions that say how a table of BIDS writes what is not known.
template <typename Row>
std::vector<ExportColumn<Row>> bids_columns(const ExportSource& source,
                                            const ExportTable<Row>& table) {
    auto columns = source.columns(table);
    constexpr std::string_view kEmpty = "empty:";
    for (auto& column : columns) {
        const auto at = column.description.find(kEmpty);
        if (at == std::string::npos) continue;
        column.description.replace(at, kEmpty.size(), std::string(kUnknown) + ':');
    }
    return columns;
}

std::vector<ExportColumn<ParticipantRecord>> participant_columns(ExportSource& source) {
    auto columns = bids_columns(source, participants_with_forms(source));
    for (auto& column : columns) {
        if (column.name == "participant_id") {
            column.description = "Participant, the name of the folder";
        } else if (column.name == "age_years") {
            column.name = "age";
            column.description = "Age as given in the form, 89 and above as 89+";
            column.cell = {[](const ParticipantRecord& row, std::string& out) {
                               if (!row.age_years) return;
                               out += *row.age_years < kAgeHidden_years
                                          ? std::to_string(*row.age_years)
                                          : fmt::format("{}+", kAgeHidden_years);
                           },
                           false};
        }
    }
    return columns;
}

void append_file(const std::string* file, std::string& out) {
    if (file != nullptr) out += *file;
}

/// The columns of a file of answers; the standard's own names where it has them.
std::vector<ExportColumn<TrialRow>> trial_columns(ExportSource& source) {
    auto columns = bids_columns(source, trials_with_ties(source));
    std::erase_if(columns, [](const auto& column) {
        return column.name == "participant_id" || column.name == "session_id" ||
               column.name == "exclusion" || column.name == "study_plan";
    });
    for (auto& column : columns) {
        if (column.name == "response_time_s") column.name = "response_time";
    }
    columns.push_back(
        {"stim_file",
         "Image shown first, in the folder stimuli",
         {},
         "",
         {[](const TrialRow& row, std::string& out) { append_file(row.first_file, out); }, false}});
    columns.push_back(
        {"second_stim_file",
         "Image shown second, in the folder stimuli",
         {},
         "",
         {[](const TrialRow& row, std::string& out) { append_file(row.second_file, out); },
          false}});
    return columns;
}

/// The first WIDTHxHEIGHT in the description of a display.
std::optional<std::pair<int, int>> resolution_in(const std::string& display) {
    for (std::size_t cross = display.find('x'); cross != std::string::npos;
         cross = display.find('x', cross + 1)) {
        std::size_t begin = cross;
        while (begin > 0 && std::isdigit(static_cast<unsigned char>(display[begin - 1])) != 0) {
            --begin;
        }
        int width = 0;
        int height = 0;
        const char* const text = display.data();
        const auto first = std::from_chars(text + begin, text + cross, width);
        const auto second = std::from_chars(text + cross + 1, text + display.size(), height);
        if (first.ec == std::errc() && second.ec == std::errc() && width > 0 && height > 0) {
            return std::pair(width, height);
        }
    }
    return std::nullopt;
}

/// "obscura 0.1.0" as name and version.
std::pair<std::string, std::string> name_and_version(const std::string& software) {
    const auto blank = software.rfind(' ');
    if (blank == std::string::npos) return {software.empty() ? kUnknown : software, kUnknown};
    return {software.substr(0, blank), software.substr(blank + 1)};
}

Json stimulus_presentation(const SessionRecord& session) {
    const auto [name, version] = name_and_version(session.software);
    const auto resolution = resolution_in(session.display);
    Json json = {
        {"OperatingSystem", session.operating_system.empty() ? kUnknown : session.operating_system},
        {"ScreenDistance", kUnknown},
        {"ScreenRefreshRate", kUnknown},
        {"ScreenResolution", kUnknown},
        {"ScreenSize", kUnknown},
        {"SoftwareName", name},
        {"SoftwareVersion", version},
        {"Display", session.display.empty() ? kUnknown : session.display},
        {"GraphicsRenderer", session.gpu_renderer.empty() ? kUnknown : session.gpu_renderer}};
    // In metres, as the standard has them.
    constexpr double kCmPerM = 100.0;
    if (const auto distance = screen_fact(session, "viewing_distance_cm")) {
        json["ScreenDistance"] = *distance / kCmPerM;
    }
    const auto width = screen_fact(session, "screen_width_cm");
    const auto height = screen_fact(session, "screen_height_cm");
    if (width && height) json["ScreenSize"] = {*width / kCmPerM, *height / kCmPerM};
    if (session.refresh_hz > 0.0) json["ScreenRefreshRate"] = session.refresh_hz;
    if (resolution) json["ScreenResolution"] = {resolution->first, resolution->second};
    return json;
}

class BidsExport {
  public:
    explicit BidsExport(const ExportJob& job)
        : job_(job),
          session_columns_(bids_columns(job.source, sessions_export())),
          columns_(trial_columns(job.source)),
          event_columns_(bids_columns(job.source, bids_events_export())) {}

    void run() {
        write_participants();
        write_answers();
        write_other_events();
        write_question_answers();
        write_tasks();
        write_description();
        write_stimuli();
        write_tests();
    }

  private:
    void write_participants() {
        const auto columns = participant_columns(job_.source);
        write_table(job_, "participants", columns, Layout::kBidsTsv, [&](const auto& take) {
            job_.source.each_participant([&](const ParticipantRecord& participant) {
                ++job_.exported.participants;
                ParticipantRecord shown = participant;
                shown.participant_id = "sub-" + subjects_.of(participant.participant_id);
                take(shown);
            });
        });
        job_.folder.add("participants.json", described(columns).dump(2) + '\n');
    }

    /// A file for each session, also for one without answers: its participant is in the list.
    void write_answers() {
        job_.source.each_session([&](const SessionRow& row) {
            ++job_.exported.sessions;
            if (row.session->kind == Kind::kSimulated) ++job_.exported.simulated;
            const std::string stem = stem_of(*row.session);
            const std::string name = stem + "_beh";
            job_.folder.add(name + ".json", sidecar_of(row).dump(2) + '\n');
            names_[row.session->session_id] = {name, false};
            write_table(job_, stem + "_events", event_columns_, Layout::kBidsTsv,
                        [&](const auto& take) {
                            for (const EventRecord& event : *row.events) {
                                take(EventRow{&event, row.session});
                            }
                        });
        });
        std::string open_id;
        std::optional<OutputFile> file;
        std::optional<TableWriter<TrialRow>> writer;
        job_.source.each_trial(
            [&](const TrialRow& row) {
                if (!writer || row.session->session_id != open_id) {
                    if (file) file->close();
                    open_id = row.session->session_id;
                    Place& place = names_.at(open_id);
                    place.written = true;
                    file.emplace(job_.folder.add(place.name + ".tsv"));
                    writer.emplace(columns_, Layout::kBidsTsv, *file);
                }
                writer->write(row);
            },
            job_.exported);
        if (file) file->close();
        for (const auto& [id, place] : names_) {
            if (place.written) continue;
            OutputFile empty(job_.folder.add(place.name + ".tsv"));
            TableWriter<TrialRow>(columns_, Layout::kBidsTsv, empty);
            empty.close();
        }
    }

    /// Events of no session have no place in the standard's folders but among what is as it was.
    void write_other_events() {
        const auto columns = bids_columns(job_.source, events_export());
        write_table(job_, "sourcedata/events", columns, Layout::kBidsTsv, [&](const auto& take) {
            job_.source.each_event([&](const EventRow& row) {
                if (row.session == nullptr) take(row);
            });
        });
        job_.folder.add("sourcedata/events.json", described(columns).dump(2) + '\n');
    }

    /// The standard has one table of answers a session, whose rows are the pairs: answers to
    /// further questions of them stand among what is as it was.
    void write_question_answers() {
        if (!job_.source.has_questions()) return;
        const auto columns = bids_columns(job_.source, answers_export(job_.source));
        write_table(job_, "sourcedata/answers", columns, Layout::kBidsTsv, [&](const auto& take) {
            job_.source.each_answer([&](const QuestionAnswer& answer, const SessionRecord& from) {
                SessionRecord session = from;
                session.participant_id = "sub-" + subjects_.of(from.participant_id);
                take(QuestionRow{&answer, &session});
            });
        });
        job_.folder.add("sourcedata/answers.json", described(columns).dump(2) + '\n');
    }

    std::string stem_of(const SessionRecord& session) {
        const std::string subject = "sub-" + subjects_.of(session.participant_id);
        const std::string stem =
            fmt::format("{0}/beh/{0}_task-{1}", subject, tasks_.of(session.study));
        studies_.insert(session.study);
        const int run = ++runs_[stem];
        return run == 1 ? stem : fmt::format("{}_run-{}", stem, run);
    }

    Json sidecar_of(const SessionRow& row) {
        Json fields;
        for (const auto& column : session_columns_) {
            std::string text;
            column.cell.append(row, text);
            if (text.empty()) {
                fields[column.name] = kUnknown;
            } else {
                fields[column.name] = column.cell.number ? Json::parse(text) : Json(text);
            }
        }
        return {{"StimulusPresentation", stimulus_presentation(*row.session)}, {"Session", fields}};
    }

    /// What holds for every answer of a study; the sidecars of the sessions inherit it.
    void write_tasks() {
        for (const std::string& name : studies_) {
            Json json = {{"TaskName", name}};
            for (const ExportedStudy& study : job_.options.studies) {
                if (study.name != name) continue;
                if (!study.title.empty()) json["TaskDescription"] = study.title;
                if (!study.instructions.empty()) json["Instructions"] = study.instructions;
                if (!study.question.empty()) json["Question"] = study.question;
            }
            json["SessionFields"] = described(session_columns_);
            json.update(described(columns_));
            job_.folder.add(fmt::format("task-{}_beh.json", tasks_.of(name)), json.dump(2) + '\n');
            job_.folder.add(fmt::format("task-{}_events.json", tasks_.of(name)),
                            described(event_columns_).dump(2) + '\n');
        }
    }

    void write_description() {
        const auto [name, version] = name_and_version(job_.options.software);
        std::string title;
        for (const std::string& study : studies_) title += (title.empty() ? "" : ", ") + study;
        const Json json = {{"Name", title.empty() ? "obscura" : title},
                           {"BIDSVersion", kBidsVersion},
                           {"DatasetType", "raw"},
                           {"GeneratedBy", {{{"Name", name}, {"Version", version}}}}};
        job_.folder.add("dataset_description.json", json.dump(2) + '\n');
        job_.folder.add("README", readme_text(job_));
    }

    /// stim_file is relative to the folder stimuli, so the images are there.
    void write_stimuli() { add_studies(job_, "stimuli"); }

    /// The standard's place for what is done with the answers is the folder code.
    void write_tests() {
        const auto columns = bids_columns(job_.source, tests_export());
        write_table(job_, "code/tests", columns, Layout::kBidsTsv, [&](const auto& take) {
            for (const ExportedTest& row : job_.options.tests) take(row);
        });
        job_.folder.add("code/tests.json", described(columns).dump(2) + '\n');
        add_scripts(job_, "code/");
    }

    struct Place {
        std::string name;
        bool written = false;
    };

    const ExportJob& job_;
    std::vector<ExportColumn<SessionRow>> session_columns_;
    std::vector<ExportColumn<TrialRow>> columns_;
    std::vector<ExportColumn<EventRow>> event_columns_;
    Labels subjects_;
    Labels tasks_;
    std::set<std::string> studies_;
    std::unordered_map<std::string, int> runs_;
    std::unordered_map<std::string, Place> names_;  ///< of a session's files, without the ending
};

}  // namespace

void export_bids(const ExportJob& job) { BidsExport(job).run(); }

}  // namespace obscura::analysis
