// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The rules of the formats that other programs read: TSV, JSON Lines, BIDS 1.9 beh, Psych-DS.
#include <gmock/gmock.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "analysis/export/export.h"
#include "analysis/store/store.h"
#include "analysis/table/csv.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using DatasetRows = std::vector<std::vector<std::string>>;

DatasetRows read_tsv(const fs::path& file) {
    DatasetRows rows;
    std::istringstream lines(base::read_file(file));
    for (std::string line; std::getline(lines, line);) {
        auto& row = rows.emplace_back();
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
    }
    return rows;
}

DatasetRows read_csv(const fs::path& file) {
    DatasetRows rows;
    for (const CsvRecord& record : parse_csv(base::read_file(file), file.string())) {
        rows.push_back(record.fields);
    }
    return rows;
}

json read_json(const fs::path& file) { return json::parse(base::read_file(file)); }

/// Three participants, the last of whom gave no answer; the first said little about herself.
class DatasetExport : public testing::Test {
  protected:
    void SetUp() override {
        auto shy = tests::a_participant(0);
        shy.participant_id = "p-0";
        shy.age_years.reset();
        shy.gender = "tab\tand\nline \"quoted\"";
        add(shy, 0);
        auto old = tests::a_participant(1);
        old.participant_id = "p.0";  // the same label as the first one's
        old.age_years = 97;
        add(old, 1);
        store_.begin_session(tests::a_participant(2), tests::a_session(2));

        const std::string image = "not really a PNG";
        base::write_file_atomically(images_ / "C0-a.png", image);
        ExportedStudy study;
        study.name = "jakobsen2010";
        study.title = "A title";
        study.question = "Which?";
        study.instructions = "Look.";
        study.file_text = "[study]\n";
        study.manifest_text = "{}\n";
        study.images = {{"C0", 'A', "C0-a.png", base::sha256_hex(image)}};
        study.image_folder = images_;
        options_.studies = {study};
        options_.software = "obscura 1.2";
        options_.folder = out_;
    }

    void add(const ParticipantRecord& participant, int number) {
        auto session = tests::a_session(number);
        session.participant_id = participant.participant_id;
        session.display = "Eizo 1920x1080 59 Hz";
        store_.begin_session(participant, session);
        auto trial = tests::a_trial(number, 0);
        trial.first_sha256 = base::sha256_hex("not really a PNG");
        store_.add_trial(trial);
        trial = tests::a_trial(number, 1);
        trial.kind = Kind::kCatch;
        trial.expected = 'B';
        store_.add_trial(trial);
    }

    Exported write(ExportFormat format) {
        options_.format = format;
        return export_store(store_, options_);
    }

    [[nodiscard]] std::string all_bytes() const {
        std::string all;
        for (const auto& entry : fs::recursive_directory_iterator(out_)) {
            all += entry.path().string() + '\n';
            if (entry.is_regular_file()) all += base::read_file(entry.path());
        }
        return all;
    }

    tests::TemporaryFolder folder_;
    fs::path out_ = folder_ / "out";
    fs::path images_ = folder_ / "images";
    Store store_{"sqlite3://" + (folder_ / "responses.sqlite").string(), Store::Access::kReadWrite};
    ExportOptions options_;
};

TEST_F(DatasetExport, EachFormatHasTheStudyTheManifestAndCountsWhatIsInIt) {
    for (const ExportFormat format : kExportFormats) {
        options_.overwrite = true;
        const Exported exported = write(format);
        EXPECT_EQ(exported.participants, 3U);
        EXPECT_EQ(exported.sessions, 3U);
        EXPECT_EQ(exported.trials, 4U);
        EXPECT_EQ(exported.unknown_images, 4U);  // side B is in no manifest
        const fs::path place =
            out_ / (format == ExportFormat::kPsychDs ? "materials" : "stimuli") / "jakobsen2010";
        EXPECT_EQ(base::read_file(place / "study.toml"), "[study]\n") << to_string(format);
        EXPECT_EQ(base::read_file(place / "manifest.json"), "{}\n") << to_string(format);
        EXPECT_EQ(export_format_from(to_string(format)), format);
    }
    EXPECT_EQ(export_format_from("xlsx"), std::nullopt);
}

TEST_F(DatasetExport, TsvAndJsonLinesHoldTheCellsOfTheCsv) {
    options_.overwrite = true;
    write(ExportFormat::kCsv);
    const DatasetRows csv = read_csv(out_ / "trials.csv");
    const DatasetRows people = read_csv(out_ / "participants.csv");
    write(ExportFormat::kTsv);
    EXPECT_FALSE(fs::exists(out_ / "trials.csv")) << "of the export that was replaced";
    const std::string tsv = base::read_file(out_ / "trials.tsv");
    EXPECT_EQ(tsv.substr(0, tsv.find('\t')), "participant_id");
    EXPECT_THAT(base::read_file(out_ / "participants.tsv"),
                HasSubstr("\"tab\tand\nline \"\"quoted\"\"\""));
    write(ExportFormat::kJsonLines);
    const auto compare = [&](const fs::path& file, const DatasetRows& rows) {
        std::istringstream lines(base::read_file(file));
        std::size_t number = 0;
        for (std::string line; std::getline(lines, line);) {
            const json object = json::parse(line);
            const auto& row = rows.at(++number);
            ASSERT_EQ(object.size(), row.size());
            for (std::size_t i = 0; i < row.size(); ++i) {
                const json& value = object.at(rows.at(0)[i]);
                if (value.is_null()) {
                    EXPECT_EQ(row[i], "");
                } else if (value.is_string()) {
                    EXPECT_EQ(value.get<std::string>(), row[i]);
                } else {
                    EXPECT_EQ(value, json::parse(row[i])) << rows[0][i];
                }
            }
        }
        EXPECT_EQ(number + 1, rows.size());
    };
    compare(out_ / "trials.jsonl", csv);
    compare(out_ / "participants.jsonl", people);
}

TEST_F(DatasetExport, BidsHasItsRequiredFilesAndNothingWithAnotherName) {
    write(ExportFormat::kBids);
    const std::regex allowed(
        "dataset_description\\.json|README|participants\\.(tsv|json)|\\.obscura-export|"
        "task-[a-zA-Z0-9]+_(beh|events)\\.json|stimuli/.*|sourcedata/events\\.(tsv|json)|"
        "code/main_tests\\.(?:R|py)|code/tests\\.(?:tsv|json)|"
        "(sub-[a-zA-Z0-9]+)/beh/"
        "\\4_task-[a-zA-Z0-9]+(_run-[0-9]+)?_(beh\\.(tsv|json)|events\\.tsv)");
    for (const auto& entry : fs::recursive_directory_iterator(out_)) {
        if (!entry.is_regular_file()) continue;
        const std::string name = fs::relative(entry.path(), out_).string();
        EXPECT_TRUE(std::regex_match(name, allowed)) << name;
    }
    const json description = read_json(out_ / "dataset_description.json");
    EXPECT_EQ(description["Name"], "jakobsen2010");
    EXPECT_EQ(description["BIDSVersion"], "1.9.0");
    EXPECT_EQ(description["DatasetType"], "raw");
    EXPECT_EQ(description["GeneratedBy"][0]["Version"], "1.2");
    EXPECT_GT(fs::file_size(out_ / "README"), 150U);
}

TEST_F(DatasetExport, BidsParticipantsAreTheFoldersAndHideAgesFrom89) {
    write(ExportFormat::kBids);
    const DatasetRows rows = read_tsv(out_ / "participants.tsv");
    ASSERT_EQ(rows.size(), 4U);
    const auto column = [&](const char* name) {
        return static_cast<std::size_t>(std::find(rows[0].begin(), rows[0].end(), name) -
                                        rows[0].begin());
    };
    EXPECT_EQ(rows[0][0], "participant_id");
    std::set<std::string> subjects;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].size(), rows[0].size());
        EXPECT_TRUE(fs::is_directory(out_ / rows[i][0])) << rows[i][0];
        EXPECT_TRUE(subjects.insert(rows[i][0]).second);
    }
    EXPECT_EQ(rows[1][column("age")], "n/a");
    EXPECT_EQ(rows[2][column("age")], "89+");
    EXPECT_EQ(rows[3][column("age")], "31");
    EXPECT_EQ(rows[1][column("gender")], "tab and line \"quoted\"");
    const json sidecar = read_json(out_ / "participants.json");
    for (const std::string& name : rows[0]) EXPECT_TRUE(sidecar.contains(name)) << name;
    EXPECT_EQ(sidecar["age"]["Units"], "years");
}

TEST_F(DatasetExport, EachFieldOfAStudysFormIsAColumnWithWhatWasAsked) {
    auto asked = tests::a_participant(3);
    asked.form = R"([{"field":"games","kind":"scale","label":"Plays",)"
                 R"("levels":{"1":"never","7":"daily"},"value":3},)"
                 R"({"field":"hand","kind":"choice","label":"Hand",)"
                 R"("choices":["left","right"],"value":"left"},)"
                 R"({"field":"wears","kind":"choices","label":"Wears",)"
                 R"("choices":["lenses","glasses"],"value":["lenses","glasses"]}])";
    add(asked, 3);
    write(ExportFormat::kBids);
    const json sidecar = read_json(out_ / "participants.json");
    EXPECT_EQ(sidecar["form_games"]["Levels"], (json{{"1", "never"},
                                                     {"2", "2"},
                                                     {"3", "3"},
                                                     {"4", "4"},
                                                     {"5", "5"},
                                                     {"6", "6"},
                                                     {"7", "daily"}}))
        << "a validator refuses a value that is no level";
    EXPECT_THAT(sidecar["form_wears"]["Description"].get<std::string>(),
                HasSubstr("any of: lenses; glasses"));
    EXPECT_EQ(sidecar["form_hand"]["Levels"], (json{{"left", "left"}, {"right", "right"}}));
    EXPECT_THAT(sidecar["form_games"]["Description"].get<std::string>(), HasSubstr("Plays"));
    const auto rows = read_tsv(out_ / "participants.tsv");
    const auto cell = [&](const std::vector<std::string>& row, const std::string& column) {
        const auto at = std::find(rows[0].begin(), rows[0].end(), column) - rows[0].begin();
        return row.at(static_cast<std::size_t>(at));
    };
    EXPECT_EQ(cell(rows.back(), "form_games"), "3");
    EXPECT_EQ(cell(rows.back(), "form_wears"), "lenses; glasses");
    EXPECT_EQ(cell(rows[1], "form_games"), "n/a") << "was not asked";
}

TEST_F(DatasetExport, BidsAnswersNameTheirColumnsAsTheStandardDoesAndDescribeThemAll) {
    write(ExportFormat::kBids);
    const DatasetRows rows = read_tsv(out_ / "sub-p0/beh/sub-p0_task-jakobsen2010_beh.tsv");
    ASSERT_EQ(rows.size(), 3U);
    const json sidecar = read_json(out_ / "task-jakobsen2010_beh.json");
    EXPECT_EQ(sidecar["TaskName"], "jakobsen2010");
    EXPECT_EQ(sidecar["Instructions"], "Look.");
    std::map<std::string, std::string> cells;
    for (std::size_t i = 0; i < rows[0].size(); ++i) {
        EXPECT_FALSE(sidecar[rows[0][i]]["Description"].get<std::string>().empty());
        EXPECT_NE(rows[1][i], "") << rows[0][i];
        cells[rows[0][i]] = rows[1][i];
    }
    EXPECT_EQ(cells.at("response_time"), "1.25");
    EXPECT_EQ(sidecar["response_time"]["Units"], "s");
    EXPECT_EQ(cells.at("response"), "second");
    EXPECT_EQ(cells.at("expected"), "n/a");
    EXPECT_EQ(cells.at("stim_file"), "jakobsen2010/C0-a.png");
    EXPECT_EQ(cells.at("second_stim_file"), "n/a") << "it is not in the manifest";
    EXPECT_TRUE(fs::exists(out_ / "stimuli" / cells.at("stim_file")));
    // Whoever gave no answer has a file with a header alone.
    EXPECT_EQ(read_tsv(out_ / "sub-p2/beh/sub-p2_task-jakobsen2010_beh.tsv"), DatasetRows{rows[0]});
}

TEST_F(DatasetExport, BidsSaysOnWhatEachSessionWasShown) {
    write(ExportFormat::kBids);
    const json sidecar = read_json(out_ / "sub-p0/beh/sub-p0_task-jakobsen2010_beh.json");
    const json& shown = sidecar["StimulusPresentation"];
    EXPECT_EQ(shown["OperatingSystem"], "Debian GNU/Linux 12");
    EXPECT_EQ(shown["SoftwareName"], "Obscura");
    EXPECT_EQ(shown["SoftwareVersion"], "0.1.0");
    EXPECT_EQ(shown["ScreenResolution"], json({1920, 1080}));
    EXPECT_EQ(shown["ScreenRefreshRate"], 60.0);
    EXPECT_EQ(shown["ScreenDistance"], "n/a");
    EXPECT_EQ(shown["ScreenSize"], "n/a");
    EXPECT_EQ(sidecar["Session"]["study_sha256"], std::string(64, 'a'));
    EXPECT_EQ(sidecar["Session"]["seed"], 20100501);
    const json task = read_json(out_ / "task-jakobsen2010_beh.json");
    for (const auto& [field, ignored] : sidecar["Session"].items()) {
        EXPECT_TRUE(task["SessionFields"].contains(field)) << field;
    }
}

TEST_F(DatasetExport, BidsRefusesAnImageThatIsNotTheManifests) {
    base::write_file_atomically(images_ / "C0-a.png", "another");
    try {
        write(ExportFormat::kBids);
        ADD_FAILURE() << "written";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        EXPECT_THAT(error.what(), HasSubstr("C0-a.png: its SHA-256 is"));
    }
    EXPECT_TRUE(fs::is_empty(out_));
}

TEST_F(DatasetExport, PsychDsMeasuresEveryColumnAndNumbersEveryRow) {
    write(ExportFormat::kPsychDs);
    const json description = read_json(out_ / "dataset_description.json");
    EXPECT_EQ(description["@context"], "https://schema.org/");
    EXPECT_EQ(description["@type"], "Dataset");
    EXPECT_FALSE(description["name"].get<std::string>().empty());
    EXPECT_FALSE(description["description"].get<std::string>().empty());
    std::vector<std::string> measured;
    for (const json& variable : description["variableMeasured"]) {
        EXPECT_EQ(variable["@type"], "PropertyValue");
        EXPECT_FALSE(variable["description"].get<std::string>().empty());
        measured.push_back(variable["name"]);
    }
    EXPECT_EQ(std::set<std::string>(measured.begin(), measured.end()).size(), measured.size());
    const std::regex name("[a-z]+-[a-zA-Z0-9]+(_[a-z]+-[a-zA-Z0-9]+)*_data\\.csv");
    int tables = 0;
    for (const auto& entry : fs::directory_iterator(out_ / "data")) {
        EXPECT_TRUE(std::regex_match(entry.path().filename().string(), name)) << entry.path();
        const DatasetRows rows = read_csv(entry.path());
        for (const std::string& column : rows[0]) EXPECT_THAT(measured, Contains(column));
        EXPECT_EQ(rows[0][0], "row_id");
        std::set<std::string> ids;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            EXPECT_EQ(rows[i].size(), rows[0].size());
            EXPECT_TRUE(ids.insert(rows[i][0]).second);
        }
        ++tables;
    }
    EXPECT_EQ(tables, 6);
}

TEST_F(DatasetExport, AnAnonymousExportOfAnyFormatTellsNothingOfWhoItWas) {
    options_.overwrite = true;
    for (const ExportFormat format : kExportFormats) {
        options_.anonymous_seed.reset();
        write(format);
        EXPECT_THAT(all_bytes(), HasSubstr("2026-05-01T12:00:00Z"));
        options_.anonymous_seed = 4;
        EXPECT_EQ(write(format).trials, 4U);
        const std::string all = all_bytes();
        for (const char* personal : {"2026-05-01", "age_years", "\"age\"", "\tage", ",gender",
                                     "\tgender", "\"gender\"", "female", "quoted", "p-0", "p.0",
                                     "89+", "created_utc", "started_utc", "answered_utc", "slot"}) {
            EXPECT_THAT(all, Not(HasSubstr(personal))) << to_string(format);
        }
        EXPECT_THAT(all, HasSubstr("normal_vision"));
    }
}

TEST_F(DatasetExport, AnonymousNumbersAreShuffledBySeedAndHoldTheTablesTogether) {
    options_.overwrite = true;
    options_.format = ExportFormat::kCsv;
    const auto order_of = [&](std::uint64_t seed) {
        options_.anonymous_seed = seed;
        write(ExportFormat::kCsv);
        std::vector<std::string> rows;
        for (const auto& row : read_csv(out_ / "sessions.csv")) rows.push_back(row.at(7) + row[8]);
        return rows;
    };
    EXPECT_EQ(order_of(1), order_of(1));
    std::set<std::vector<std::string>> orders;
    for (std::uint64_t seed = 0; seed < 20; ++seed) orders.insert(order_of(seed));
    EXPECT_GT(orders.size(), 2U) << "of six";
    std::set<std::string> participants;
    for (const auto& row : read_csv(out_ / "participants.csv")) participants.insert(row[0]);
    EXPECT_THAT(participants, Contains("p1"));
    std::set<std::string> sessions;
    for (const auto& row : read_csv(out_ / "sessions.csv")) {
        sessions.insert(row[0]);
        EXPECT_THAT(participants, Contains(row[1]));
    }
    for (const auto& row : read_csv(out_ / "trials.csv")) {
        EXPECT_THAT(participants, Contains(row[0]));
        EXPECT_THAT(sessions, Contains(row[1]));
    }
}

}  // namespace
}  // namespace obscura::analysis
