// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/events.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string_view>
#include <utility>

#include "analysis/text/text.h"

namespace obscura::analysis {
namespace {

constexpr std::string_view kResumed = "session resumed";
constexpr std::string_view kAbandoned = "session abandoned";
constexpr std::string_view kLeft = "operator left";

/// Seconds since 1970 of a time as records carry it; nothing for other text.
std::optional<double> seconds_of(const std::string& utc) {
    int year = 0;
    unsigned month = 0;
    unsigned day = 0;
    int hour = 0;
    int minute = 0;
    double second = 0.0;
    if (std::sscanf(utc.c_str(), "%d-%u-%uT%d:%d:%lfZ", &year, &month, &day, &hour, &minute,
                    &second) != 6) {
        return std::nullopt;
    }
    const std::chrono::year_month_day date{std::chrono::year(year), std::chrono::month(month),
                                           std::chrono::day(day)};
    if (!date.ok()) return std::nullopt;
    const auto days = std::chrono::sys_days(date).time_since_epoch();
    return static_cast<double>(std::chrono::seconds(days).count() + hour * 3600 + minute * 60) +
           second;
}

void append_onset(const EventRow& row, std::string& out) {
    if (row.session == nullptr) return;
    const auto began = seconds_of(row.session->started_utc);
    const auto now = seconds_of(row.event->time_utc);
    if (!began || !now) return;
    // Records have milliseconds, which differences of doubles must not blur.
    constexpr double kMillisecondsPerSecond = 1000.0;
    append_shortest(out,
                    std::round((*now - *began) * kMillisecondsPerSecond) / kMillisecondsPerSecond);
}

using Count = int (*)(const std::vector<EventRecord>&);

template <const std::string_view* kName>
int count_named(const std::vector<EventRecord>& events) {
    return static_cast<int>(std::count_if(events.begin(), events.end(),
                                          [](const auto& event) { return event.name == *kName; }));
}

/// A session that is resumed or closed was cut off, unless the operator had left it.
int count_cut_off(const std::vector<EventRecord>& events) {
    int count = 0;
    bool left = false;
    for (const EventRecord& event : events) {
        const bool taken_up = event.name == kResumed || event.name == kAbandoned;
        if (taken_up && !left) ++count;
        if (taken_up || event.name == kLeft) left = event.name == kLeft;
    }
    return count;
}

int count_all(const std::vector<EventRecord>& events) { return static_cast<int>(events.size()); }

constexpr std::string_view kLostFocus = "lost focus";
constexpr std::string_view kIconified = "iconified";
constexpr std::string_view kCovered = "covered";
constexpr std::string_view kResized = "resized";
constexpr std::string_view kMonitorLost = "monitor lost";

}  // namespace

const ExportTable<EventRow>& events_export() {
    static const ExportTable<EventRow> table{
        "events",
        {
            {"participant_id",
             "Participant, as in the table participants; empty: the event is of no session",
             {},
             "",
             {[](const EventRow& row, std::string& out) {
                  if (row.session != nullptr) out += row.session->participant_id;
              },
              false}},
            {"session_id",
             "Session, as in the table sessions; empty: the event is of no session",
             {},
             "",
             {[](const EventRow& row, std::string& out) {
                  if (row.session != nullptr) out += row.session->session_id;
              },
              false}},
            {"kind",
             "Who answered; empty: the event is of no session",
             {{"participant", "a person took part"},
              {"simulated", "answers made by a simulated observer, not a person"}},
             "",
             {[](const EventRow& row, std::string& out) {
                  if (row.session != nullptr) out += to_string(row.session->kind);
              },
              false}},
            {"study",
             "Name of the study; empty: the event is of no session",
             {},
             "",
             {[](const EventRow& row, std::string& out) {
                  if (row.session != nullptr) out += row.session->study;
              },
              false}},
            {"time_s",
             "When it happened, since the session began; empty: not known",
             {},
             "s",
             {append_onset, true}},
            {"event",
             "What happened: session started, stimuli digest (SHA-256 over all images of the "
             "study), session resumed, operator left, lost focus ...",
             {},
             "",
             {[](const EventRow& row, std::string& out) { out += row.event->name; }, false}},
            {"detail",
             "More about it, in words; may be empty",
             {},
             "",
             {[](const EventRow& row, std::string& out) { out += row.event->detail; }, false}},
            {"time_utc",
             "Time in UTC, ISO 8601",
             {},
             "",
             {[](const EventRow& row, std::string& out) { out += row.event->time_utc; }, false},
             true},
        }};
    return table;
}

ExportTable<EventRow> bids_events_export() {
    ExportTable<EventRow> table{
        "events",
        {{"onset", "When it happened, since the session began", {}, "s", {append_onset, true}},
         {"duration",
          "An event has none: n/a",
          {},
          "s",
          {[](const EventRow&, std::string&) {}, true}}}};
    for (const auto& column : events_export().columns) {
        const bool is_files = column.name == "participant_id" || column.name == "session_id" ||
                              column.name == "study" || column.name == "time_s";
        if (!is_files) table.columns.push_back(column);
    }
    return table;
}

std::vector<ExportColumn<SessionRow>> event_count_columns() {
    struct Counted {
        const char* column;
        const char* description;
        Count count;
    };
    constexpr Counted kCounted[]{
        {"times_resumed", "How often the session was continued", count_named<&kResumed>},
        {"times_left", "How often the operator left the session before its end",
         count_named<&kLeft>},
        {"times_cut_off",
         "How often the session was found cut off, by a crash or a power cut, when it was "
         "continued "
         "or closed",
         count_cut_off},
        {"times_lost_focus", "How often another window took the keyboard",
         count_named<&kLostFocus>},
        {"times_iconified", "How often the window was iconified", count_named<&kIconified>},
        {"times_covered", "How often the window was covered", count_named<&kCovered>},
        {"times_resized", "How often the window changed its size", count_named<&kResized>},
        {"times_monitor_lost", "How often the monitor was switched off or lost",
         count_named<&kMonitorLost>},
        {"event_count", "Rows in the table events", count_all},
    };
    std::vector<ExportColumn<SessionRow>> columns;
    for (const Counted& counted : kCounted) {
        const Count count = counted.count;
        columns.push_back({counted.column,
                           counted.description,
                           {},
                           "",
                           {[count](const SessionRow& row, std::string& out) {
                                out += std::to_string(count(*row.events));
                            },
                            true}});
    }
    return columns;
}

}  // namespace obscura::analysis
