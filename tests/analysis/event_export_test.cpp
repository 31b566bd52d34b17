// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What happened in a session is exported in every format, and counted in the table of sessions.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>

#include "analysis/export/export.h"
#include "analysis/table/csv.h"
#include "renderer/base/files.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

using EventRow = std::map<std::string, std::string>;

/// A session that was left, cut off twice and closed, one that nothing disturbed, and an event of
/// no session.
class EventExport : public testing::Test {
  protected:
    EventExport() {
        store_.add_event({"", "2026-05-01T11:59:00Z", "operator left", ""});
        store_.begin_session(tests::a_participant(0), tests::a_session(0));
        tests::add_completed(store_, 1);
        const auto happened = [&](int second, const char* name, const char* detail = "") {
            store_.add_event(
                {"s0", fmt::format("2026-05-01T12:00:{:02}.250Z", second), name, detail});
        };
        happened(1, "lost focus", "in pair 1, \"first image\"");
        happened(2, "seen again");
        happened(3, "lost focus");
        happened(4, "operator left");
        happened(5, "session resumed");
        happened(6, "session resumed");
        happened(7, "monitor lost");
        store_.abandon_session("s0", "2026-05-01T13:00:00Z", "closed by the operator");
    }

    void write(ExportFormat format, bool anonymous = false) {
        ExportOptions options;
        options.folder = out_;
        options.format = format;
        options.overwrite = true;
        if (anonymous) options.anonymous_seed = 1;
        (void)export_store(store_, options);
    }

    [[nodiscard]] std::vector<EventRow> rows_of(const std::string& name) const {
        const auto records = parse_csv(base::read_file(out_ / name), name);
        std::vector<EventRow> rows;
        for (std::size_t i = 1; i < records.size(); ++i) {
            EventRow& row = rows.emplace_back();
            for (std::size_t k = 0; k < records[i].fields.size(); ++k) {
                row[records[0].fields.at(k)] = records[i].fields[k];
            }
        }
        return rows;
    }

    tests::TemporaryFolder folder_;
    fs::path out_ = folder_ / "out";
    Store store_{"sqlite3://" + (folder_ / "responses.sqlite").string(), Store::Access::kReadWrite};
};

TEST_F(EventExport, EveryEventIsARowWithItsSessionAndTimeSinceThatBegan) {
    write(ExportFormat::kCsv);
    const std::vector<EventRow> rows = rows_of("events.csv");
    ASSERT_EQ(rows.size(), store_.events().size());
    EXPECT_EQ(rows[0].at("event"), "operator left");
    EXPECT_EQ(rows[0].at("session_id"), "");
    EXPECT_EQ(rows[0].at("time_s"), "");
    EXPECT_EQ(rows[1].at("event"), "session started");
    EXPECT_EQ(rows[1].at("time_s"), "0");
    EXPECT_EQ(rows[2].at("event"), "lost focus");
    EXPECT_EQ(rows[2].at("detail"), "in pair 1, \"first image\"");
    EXPECT_EQ(rows[2].at("participant_id"), "p0");
    EXPECT_EQ(rows[2].at("kind"), "participant");
    EXPECT_EQ(rows[2].at("time_s"), "1.25");
    EXPECT_EQ(rows[2].at("time_utc"), "2026-05-01T12:00:01.250Z");
    EXPECT_EQ(rows[9].at("detail"), "closed by the operator");
    EXPECT_EQ(rows[9].at("time_s"), "3600");
}

TEST_F(EventExport, TheTableOfSessionsCountsThemByKind) {
    write(ExportFormat::kCsv);
    const std::vector<EventRow> sessions = rows_of("sessions.csv");
    ASSERT_EQ(sessions.size(), 2U);
    const std::map<std::string, std::string> expected{
        {"times_resumed", "2"},    {"times_left", "1"},         {"times_cut_off", "2"},
        {"times_lost_focus", "2"}, {"times_iconified", "0"},    {"times_covered", "0"},
        {"times_resized", "0"},    {"times_monitor_lost", "1"}, {"event_count", "9"}};
    for (const auto& [column, count] : expected) {
        EXPECT_EQ(sessions[0].at(column), count) << column;
        EXPECT_EQ(sessions[1].at(column), column == "event_count" ? "1" : "0") << column;
    }
}

TEST_F(EventExport, EveryFormatHasThemAndDescribesEachColumn) {
    for (const ExportFormat format :
         {ExportFormat::kCsv, ExportFormat::kTsv, ExportFormat::kJsonLines}) {
        write(format);
        const std::string file = format == ExportFormat::kCsv   ? "events.csv"
                                 : format == ExportFormat::kTsv ? "events.tsv"
                                                                : "events.jsonl";
        EXPECT_THAT(base::read_file(out_ / file), HasSubstr("lost focus"));
        const json dictionary = json::parse(base::read_file(out_ / "data_dictionary.json"));
        for (const char* column : {"session_id", "event", "detail", "time_s", "time_utc"}) {
            EXPECT_FALSE(dictionary.at(file).at(column).at("Description").empty()) << column;
        }
        EXPECT_EQ(dictionary.at(file).at("time_s").at("Units"), "s");
    }
    write(ExportFormat::kPsychDs);
    EXPECT_THAT(base::read_file(out_ / "data/description-events_data.csv"),
                HasSubstr("monitor lost"));
    EXPECT_THAT(base::read_file(out_ / "dataset_description.json"), HasSubstr("\"time_s\""));
    write(ExportFormat::kBids);
    const std::string events =
        base::read_file(out_ / "sub-p0/beh/sub-p0_task-jakobsen2010_events.tsv");
    EXPECT_THAT(events, testing::StartsWith("onset\tduration\tkind\tevent\tdetail\ttime_utc\n"));
    EXPECT_THAT(events, HasSubstr("\n1.25\tn/a\tparticipant\tlost focus\t"));
    EXPECT_TRUE(fs::exists(out_ / "sub-p1/beh/sub-p1_task-jakobsen2010_events.tsv"));
    const json sidecar = json::parse(base::read_file(out_ / "task-jakobsen2010_events.json"));
    for (const char* column : {"onset", "duration", "kind", "event", "detail", "time_utc"}) {
        EXPECT_TRUE(sidecar.contains(column)) << column;
    }
    EXPECT_THAT(base::read_file(out_ / "sourcedata/events.tsv"),
                AllOf(HasSubstr("operator left"), Not(HasSubstr("lost focus"))));
}

TEST_F(EventExport, AnonymousEventsKeepTheirOrderAndLoseTheTimeOfDay) {
    write(ExportFormat::kCsv, true);
    const std::string text = base::read_file(out_ / "events.csv");
    EXPECT_THAT(text, AllOf(HasSubstr("lost focus"), Not(HasSubstr("2026-05-01")),
                            Not(HasSubstr("time_utc"))));
    std::vector<std::string> disturbed;
    for (const EventRow& session : rows_of("sessions.csv")) {
        if (session.at("times_lost_focus") == "2") disturbed.push_back(session.at("session_id"));
    }
    ASSERT_EQ(disturbed.size(), 1U);
    for (const EventRow& row : rows_of("events.csv")) {
        if (row.at("event") == "lost focus") {
            EXPECT_EQ(row.at("session_id"), disturbed[0]);
        }
    }
}

}  // namespace
}  // namespace obscura::analysis
