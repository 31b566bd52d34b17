// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "analysis/export/export.h"
#include "analysis/export/export_folder.h"
#include "analysis/store/store.h"
#include "analysis/table/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

/// A table as a stranger reads it: by the names of its columns.
using ExportedTable = std::vector<std::map<std::string, std::string>>;

class ExportTest : public testing::Test {
  protected:
    Store open() { return {url, Store::Access::kReadWrite}; }

    void write(bool overwrite = false) {
        Store store = open();
        ExportOptions options;
        options.folder = out;
        options.overwrite = overwrite;
        (void)export_store(store, options);
    }

    [[nodiscard]] ExportedTable read(const std::string& name) const {
        const auto records = parse_csv(base::read_file(out / name), name);
        ExportedTable table;
        for (std::size_t i = 1; i < records.size(); ++i) {
            EXPECT_EQ(records[i].fields.size(), records[0].fields.size());
            auto& row = table.emplace_back();
            for (std::size_t k = 0; k < records[0].fields.size(); ++k) {
                row[records[0].fields[k]] = records[i].fields[k];
            }
        }
        return table;
    }

    [[nodiscard]] std::vector<std::string> names_in(const fs::path& path) const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(path)) {
            names.push_back(entry.path().filename());
        }
        return names;
    }

    tests::TemporaryFolder folder;
    std::string url = "sqlite3://" + (folder / "responses.sqlite").string();
    fs::path out = folder / "deep" / "export";
};

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

/// The records of the store, made again from nothing but the exported text.
TrialRecord trial_of(const std::map<std::string, std::string>& row) {
    TrialRecord trial;
    trial.session_id = row.at("session_id");
    trial.kind = *kind_from(row.at("kind"));
    trial.trial_index = std::stoi(row.at("trial_index"));
    trial.condition = row.at("condition");
    trial.hypothesis = row.at("hypothesis");
    trial.scene = row.at("scene");
    trial.validity = row.at("validity");
    trial.condition_A = row.at("condition_A");
    trial.condition_B = row.at("condition_B");
    trial.first_shown = row.at("first_shown").at(0);
    trial.response_first = row.at("response") == "first";
    trial.is_A_selected = row.at("is_A_selected") == "1";
    trial.response_time_s = number(row.at("response_time_s"));
    trial.first_onset_s = number(row.at("first_onset_s"));
    trial.second_onset_s = number(row.at("second_onset_s"));
    trial.question_onset_s = number(row.at("question_onset_s"));
    trial.first_view_ms = number(row.at("first_view_ms"));
    trial.second_view_ms = number(row.at("second_view_ms"));
    trial.grey_ms_measured = number(row.at("grey_ms_measured"));
    trial.dropped_frames = std::stoi(row.at("dropped_frames"));
    if (!row.at("hidden_ms").empty()) trial.hidden_ms = number(row.at("hidden_ms"));
    trial.first_sha256 = row.at("first_sha256");
    trial.second_sha256 = row.at("second_sha256");
    trial.answered_utc = row.at("answered_utc");
    trial.expected = row.at("expected").empty() ? '\0' : row.at("expected").at(0);
    trial.repeats = row.at("repeats");
    trial.override_reason = row.at("override_reason");
    return trial;
}

SessionRecord session_of(const std::map<std::string, std::string>& row) {
    SessionRecord session;
    session.session_id = row.at("session_id");
    session.participant_id = row.at("participant_id");
    session.kind = *kind_from(row.at("kind"));
    session.study = row.at("study");
    session.study_sha256 = row.at("study_sha256");
    session.order = row.at("order");
    session.seed = std::stoull(row.at("seed"));
    session.slot = std::stoull(row.at("slot"));
    session.latin_square = std::stoull(row.at("latin_square"));
    session.latin_row = std::stoi(row.at("latin_row"));
    session.swapped = row.at("swapped") == "1";
    session.condition_count = std::stoi(row.at("condition_count"));
    session.state = *session_state_from(row.at("state"));
    session.started_utc = row.at("started_utc");
    session.ended_utc = row.at("ended_utc");
    session.software = row.at("software");
    session.operating_system = row.at("operating_system");
    session.gpu_renderer = row.at("gpu_renderer");
    session.display = row.at("display");
    session.refresh_hz = number(row.at("refresh_hz"));
    session.exclusion = row.at("exclusion");
    session.timing = row.at("timing");
    return session;
}

ParticipantRecord participant_of(const std::map<std::string, std::string>& row) {
    const auto yes_no = [](const std::string& text) {
        return text.empty() ? std::nullopt : std::optional<bool>(text == "1");
    };
    ParticipantRecord participant;
    participant.participant_id = row.at("participant_id");
    participant.kind = *kind_from(row.at("kind"));
    if (!row.at("age_years").empty()) participant.age_years = std::stoi(row.at("age_years"));
    participant.gender = row.at("gender");
    participant.normal_vision = yes_no(row.at("normal_vision"));
    participant.naive = yes_no(row.at("naive"));
    participant.consent = row.at("consent") == "1";
    participant.created_utc = row.at("created_utc");
    return participant;
}

TEST_F(ExportTest, EveryFieldReadsBackFromTheTextBitForBit) {
    auto participant = tests::a_participant(0);
    participant.gender = "kvinde, \"ikke binær\"\nÆØÅ; åndsfrisk\r\n";
    participant.age_years.reset();
    participant.naive = false;
    auto session = tests::a_session(0);
    session.seed = 9'223'372'036'854'775'807ULL;
    session.display = "Eizo, \"24\" tommer\"";
    session.refresh_hz = 59.94005994005994;
    session.timing = R"({"source":"GLX_OML_sync_control","waits":true})";
    auto trial = tests::a_trial(0, 0);
    trial.scene = "gårdhave, nr. 1";
    trial.first_shown = 'B';
    trial.is_A_selected = true;
    trial.response_time_s = 0.1 + 0.2;
    trial.first_onset_s = 1.0 / 3.0;
    trial.second_onset_s = std::numbers::pi;
    trial.question_onset_s = 123456789.12345678;
    trial.first_view_ms = std::nextafter(2000.0, 3000.0);
    trial.second_view_ms = 5e-324;
    trial.grey_ms_measured = 1e12;
    trial.dropped_frames = 2;
    trial.hidden_ms = 1234.5678901234567;
    trial.override_reason = "the \"other\" monitor, again";
    Store store = open();
    store.begin_session(participant, session);
    store.add_trial(trial);
    tests::add_completed(store, 1, Kind::kSimulated);
    write();

    std::vector<TrialRecord> trials;
    for (const auto& row : read("trials.csv")) trials.push_back(trial_of(row));
    EXPECT_EQ(trials, store.trials());
    EXPECT_EQ(trials.front(), trial);
    std::vector<SessionRecord> sessions;
    for (const auto& row : read("sessions.csv")) sessions.push_back(session_of(row));
    EXPECT_EQ(sessions, store.sessions());
    std::vector<ParticipantRecord> participants;
    for (const auto& row : read("participants.csv")) participants.push_back(participant_of(row));
    EXPECT_EQ(participants, store.participants());
}

TEST_F(ExportTest, TrialsHaveThePromisedColumns) {
    Store store = open();
    tests::add_completed(store, 8);
    write();
    const auto header = parse_csv(base::read_file(out / "trials.csv"), "trials.csv")[0].fields;
    const std::vector<std::string> promised{"participant_id",
                                            "session_id",
                                            "trial_index",
                                            "condition",
                                            "scene",
                                            "validity",
                                            "condition_A",
                                            "condition_B",
                                            "is_A_selected",
                                            "first_shown",
                                            "response",
                                            "response_time_s",
                                            "grey_ms_measured",
                                            "first_view_ms",
                                            "second_view_ms",
                                            "first_sha256",
                                            "second_sha256",
                                            "latin_square",
                                            "latin_row",
                                            "swapped",
                                            "seed",
                                            "kind"};
    ASSERT_GE(header.size(), promised.size());
    EXPECT_EQ(std::vector<std::string>(header.begin(),
                                       header.begin() + static_cast<long>(promised.size())),
              promised);
    const auto row = read("trials.csv").front();
    EXPECT_EQ(row.at("participant_id"), "p8");
    EXPECT_EQ(row.at("latin_row"), "1");
    EXPECT_EQ(row.at("swapped"), "1");
    EXPECT_EQ(row.at("seed"), "20100501");
    EXPECT_EQ(row.at("kind"), "participant");
    EXPECT_EQ(row.at("response"), "second");
}

TEST_F(ExportTest, EveryColumnIsInTheDictionaryAndEveryTableSaysItsKind) {
    Store store = open();
    tests::add_completed(store, 0);
    write();
    const json dictionary = json::parse(base::read_file(out / "data_dictionary.json"));
    ASSERT_EQ(dictionary.size(), 6U);
    for (const auto& [file, entries] : dictionary.items()) {
        const auto header = parse_csv(base::read_file(out / file), file)[0].fields;
        EXPECT_EQ(header.size(), entries.size()) << file;
        EXPECT_THAT(header, testing::Contains("kind")) << file;
        for (const std::string& column : header) {
            ASSERT_TRUE(entries.contains(column)) << file << " " << column;
            EXPECT_FALSE(entries[column]["Description"].get<std::string>().empty());
        }
    }
    EXPECT_EQ(dictionary["trials.csv"]["response_time_s"]["Units"], "s");
    EXPECT_EQ(dictionary["trials.csv"]["grey_ms_measured"]["Units"], "ms");
    EXPECT_TRUE(dictionary["trials.csv"]["kind"]["Levels"].contains("simulated"));
    EXPECT_TRUE(dictionary["trials.csv"]["first_shown"]["Levels"].contains("B"));
}

TEST_F(ExportTest, EveryValueOfAColumnWithLevelsIsOneOfThem) {
    Store store = open();
    tests::add_completed(store, 0);
    tests::add_completed(store, 1, Kind::kSimulated);
    write();
    const json dictionary = json::parse(base::read_file(out / "data_dictionary.json"));
    for (const auto& [file, entries] : dictionary.items()) {
        for (const auto& row : read(file)) {
            for (const auto& [column, value] : row) {
                if (!entries[column].contains("Levels")) continue;
                if (value.empty()) {
                    EXPECT_THAT(entries[column]["Description"], HasSubstr("empty: ")) << column;
                    continue;
                }
                EXPECT_TRUE(entries[column]["Levels"].contains(value))
                    << file << " " << column << " " << value;
            }
        }
    }
}

TEST_F(ExportTest, ConditionsCountVotesOfCompletedSessionsByKind) {
    Store store = open();
    tests::add_completed(store, 0);
    tests::add_completed(store, 1);
    tests::add_completed(store, 2, Kind::kSimulated);
    store.begin_session(tests::a_participant(3), tests::a_session(3));
    store.add_trial(tests::a_trial(3, 0));  // never completed: no vote
    write();
    const ExportedTable conditions = read("conditions.csv");
    ASSERT_EQ(conditions.size(), 14U);
    EXPECT_EQ(conditions[0].at("condition"), "C0");
    EXPECT_EQ(conditions[0].at("kind"), "participant");
    EXPECT_EQ(conditions[0].at("count_A"), "0");
    EXPECT_EQ(conditions[0].at("count_B"), "2");
    EXPECT_EQ(conditions[7].at("kind"), "simulated");
    EXPECT_EQ(conditions[7].at("count_B"), "1");
    EXPECT_EQ(read("trials.csv").size(), 22U);
}

TEST_F(ExportTest, AnEmptyStoreGivesHeadersOnly) {
    write();
    EXPECT_TRUE(read("trials.csv").empty());
    EXPECT_TRUE(read("conditions.csv").empty());
}

TEST_F(ExportTest, FilesThatAreThereAreOverwrittenOnlyWhenAsked) {
    { Store store = open(); }
    write();
    base::write_file_atomically(out / "trials.csv", "mine\n");
    fs::remove(out / "sessions.csv");
    try {
        write();
        ADD_FAILURE() << "overwritten";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        EXPECT_THAT(error.what(), HasSubstr("an export of 9 files (participants.csv"));
        EXPECT_THAT(error.what(), HasSubstr("--force"));
    }
    EXPECT_EQ(base::read_file(out / "trials.csv"), "mine\n");
    EXPECT_FALSE(fs::exists(out / "sessions.csv"));
    write(true);
    EXPECT_NE(base::read_file(out / "trials.csv"), "mine\n");
    EXPECT_THAT(names_in(out),
                UnorderedElementsAre("participants.csv", "sessions.csv", "trials.csv",
                                     "conditions.csv", "events.csv", "tests.csv", "main_tests.R",
                                     "main_tests.py", "data_dictionary.json", ".obscura-export"));
}

TEST_F(ExportTest, AFileThatIsNotOfAnExportIsOverwrittenOnlyWhenAsked) {
    { Store store = open(); }
    base::write_file_atomically(out / "trials.csv", "mine\n");
    try {
        write();
        ADD_FAILURE() << "overwritten";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        EXPECT_THAT(error.what(), HasSubstr("trials.csv is there already; --force"));
    }
    EXPECT_THAT(names_in(out), ElementsAre("trials.csv"));
}

/// Names and what is in them, as an export of its own.
void write_files(const fs::path& out, const std::vector<std::pair<std::string, std::string>>& files,
                 bool overwrite = true) {
    ExportFolder folder(out, overwrite);
    for (const auto& [name, bytes] : files) folder.add(name, bytes);
    folder.keep();
}

TEST_F(ExportTest, WhenOneFileCannotBeWrittenNoneIs) {
    fs::create_directories(out);
    base::write_file_atomically(out / "one.csv", "old\n");
    const std::string impossible(300, 'x');  // longer than a name may be
    EXPECT_THROW(write_files(out, {{"one.csv", "new\n"}, {impossible, "new\n"}}), base::Error);
    EXPECT_EQ(base::read_file(out / "one.csv"), "old\n");
    EXPECT_THAT(names_in(out), ElementsAre("one.csv"));
}

TEST_F(ExportTest, ARenameThatFailsHalfWayGivesTheEarlierFilesBack) {
    base::write_file_atomically(out / "one.csv", "old\n");
    base::write_file_atomically(out / "no", "a file where a folder must be\n");
    EXPECT_THROW(
        write_files(out, {{"one.csv", "new\n"}, {"deep/two.csv", ""}, {"no/three.csv", ""}}),
        base::Error);
    EXPECT_EQ(base::read_file(out / "one.csv"), "old\n");
    EXPECT_THAT(names_in(out), UnorderedElementsAre("one.csv", "no"));
}

TEST_F(ExportTest, ALaterExportLeavesNothingOfTheEarlierOneAndAllOfWhatIsNotAnExports) {
    write_files(out, {{"sub-1/beh/one.tsv", "1"}, {"sub-2/two.tsv", "2"}, {"kept.tsv", "3"}});
    base::write_file_atomically(out / "sub-2" / "mine.txt", "mine");
    base::write_file_atomically(folder / "deep" / "secret", "");
    base::write_file_atomically(out / ".obscura-export", base::read_file(out / ".obscura-export") +
                                                             "../secret\n/etc/passwd\nsub-2\n");
    EXPECT_THROW(write_files(out, {{"other.tsv", ""}}, false), base::Error);
    write_files(out, {{"kept.tsv", "new"}});
    EXPECT_THAT(names_in(out), UnorderedElementsAre("kept.tsv", "sub-2", ".obscura-export"));
    EXPECT_THAT(names_in(out / "sub-2"), ElementsAre("mine.txt"));
    EXPECT_EQ(base::read_file(out / "kept.tsv"), "new");
    EXPECT_TRUE(fs::exists(folder / "deep" / "secret"));
}

TEST_F(ExportTest, AFolderThatCannotBeWrittenIsBadInput) {
    base::write_file_atomically(folder / "file", "");
    for (const fs::path& bad : {folder / "file", fs::path("/proc/nowhere")}) {
        try {
            write_files(bad, {{"one.csv", ""}}, false);
            ADD_FAILURE() << "written";
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            EXPECT_THAT(error.what(), HasSubstr("--out"));
        }
    }
}

}  // namespace
}  // namespace obscura::analysis
