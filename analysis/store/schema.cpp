// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/store/schema.h"

#include <array>
#include <string_view>
#include <utility>

namespace obscura::analysis {
namespace {

std::vector<std::string> first_schema() {
    return {
        R"(CREATE TABLE obscura_schema (
            only_row {integer} NOT NULL PRIMARY KEY CHECK (only_row = 1),
            version {integer} NOT NULL CHECK (version >= 1)
        ){strict})",
        "INSERT INTO obscura_schema (only_row, version) VALUES (1, 1)",

        R"(CREATE TABLE participants (
            entry {identity},
            participant_id TEXT NOT NULL UNIQUE CHECK (participant_id <> ''),
            kind TEXT NOT NULL CHECK (kind IN ('participant', 'simulated')),
            age_years {integer} CHECK (age_years BETWEEN 1 AND 120),
            gender TEXT NOT NULL,
            normal_vision {integer} CHECK (normal_vision IN (0, 1)),
            naive {integer} CHECK (naive IN (0, 1)),
            consent {integer} NOT NULL CHECK (consent IN (0, 1)),
            created_utc TEXT NOT NULL CHECK (created_utc LIKE '____-__-__T__:__:__%Z')
        ){strict})",

        R"(CREATE TABLE sessions (
            entry {identity},
            session_id TEXT NOT NULL UNIQUE CHECK (session_id <> ''),
            participant_id TEXT NOT NULL REFERENCES participants (participant_id),
            kind TEXT NOT NULL CHECK (kind IN ('participant', 'simulated')),
            study TEXT NOT NULL CHECK (study <> ''),
            study_sha256 TEXT NOT NULL,
            order_kind TEXT NOT NULL CHECK (order_kind <> ''),
            seed {integer} NOT NULL CHECK (seed >= 0),
            slot {integer} NOT NULL CHECK (slot >= 0),
            latin_square {integer} NOT NULL CHECK (latin_square >= 0),
            latin_row {integer} NOT NULL CHECK (latin_row >= 0),
            swapped {integer} NOT NULL CHECK (swapped IN (0, 1)),
            condition_count {integer} NOT NULL CHECK (condition_count >= 1),
            state TEXT NOT NULL CHECK (state IN ('open', 'completed', 'abandoned')),
            started_utc TEXT NOT NULL CHECK (started_utc LIKE '____-__-__T__:__:__%Z'),
            ended_utc TEXT CHECK (ended_utc LIKE '____-__-__T__:__:__%Z'),
            software TEXT NOT NULL,
            operating_system TEXT NOT NULL,
            gpu_renderer TEXT NOT NULL,
            display TEXT NOT NULL,
            refresh_hz {real} NOT NULL CHECK (refresh_hz >= 0 AND refresh_hz <= 1000000),
            CHECK ((state = 'open') = (ended_utc IS NULL))
        ){strict})",
        // Two kiosks on one store never give the same row of the order; one that was broken off
        // gives its row back.
        R"(CREATE UNIQUE INDEX sessions_one_per_slot ON sessions (study, seed, kind, slot)
            WHERE state <> 'abandoned')",

        R"(CREATE TABLE trials (
            entry {identity},
            session_id TEXT NOT NULL REFERENCES sessions (session_id),
            kind TEXT NOT NULL CHECK (kind IN ('participant', 'practice', 'catch', 'simulated')),
            trial_index {integer} NOT NULL CHECK (trial_index >= 0),
            condition TEXT NOT NULL CHECK (condition <> ''),
            hypothesis TEXT NOT NULL,
            scene TEXT NOT NULL,
            validity TEXT NOT NULL CHECK (validity IN ('low', 'moderate', 'high')),
            condition_A TEXT NOT NULL CHECK (condition_A <> ''),
            condition_B TEXT NOT NULL CHECK (condition_B <> ''),
            first_shown TEXT NOT NULL CHECK (first_shown IN ('A', 'B')),
            response_first {integer} NOT NULL CHECK (response_first IN (0, 1)),
            is_A_selected {integer} NOT NULL CHECK (is_A_selected IN (0, 1)),
            response_time_s {real} NOT NULL CHECK (response_time_s BETWEEN 0 AND 1e9),
            first_onset_s {real} NOT NULL CHECK (first_onset_s BETWEEN 0 AND 1e9),
            second_onset_s {real} NOT NULL CHECK (second_onset_s BETWEEN 0 AND 1e9),
            question_onset_s {real} NOT NULL CHECK (question_onset_s BETWEEN 0 AND 1e9),
            first_view_ms {real} NOT NULL CHECK (first_view_ms BETWEEN 0 AND 1e12),
            second_view_ms {real} NOT NULL CHECK (second_view_ms BETWEEN 0 AND 1e12),
            grey_ms_measured {real} NOT NULL CHECK (grey_ms_measured BETWEEN 0 AND 1e12),
            dropped_frames {integer} NOT NULL CHECK (dropped_frames >= 0),
            first_sha256 TEXT NOT NULL,
            second_sha256 TEXT NOT NULL,
            answered_utc TEXT NOT NULL CHECK (answered_utc LIKE '____-__-__T__:__:__%Z'),
            UNIQUE (session_id, trial_index),
            CHECK (is_A_selected =
                CASE WHEN first_shown = 'A' THEN response_first ELSE 1 - response_first END)
        ){strict})",
        // Practice and catch trials may show a condition again.
        R"(CREATE UNIQUE INDEX trials_one_per_condition ON trials (session_id, condition)
            WHERE kind IN ('participant', 'simulated'))",

        R"(CREATE TABLE events (
            entry {identity},
            session_id TEXT REFERENCES sessions (session_id),
            time_utc TEXT NOT NULL CHECK (time_utc LIKE '____-__-__T__:__:__%Z'),
            name TEXT NOT NULL CHECK (name <> ''),
            detail TEXT NOT NULL
        ){strict})",
        "CREATE INDEX events_of_session ON events (session_id)",
    };
}

/// Catch trials say what was expected, repeated ones what they repeat; the study's rule of
/// exclusion is kept with the session, so that it cannot be changed after the answers are known.
std::vector<std::string> checks_of_attention() {
    return {
        "ALTER TABLE sessions ADD COLUMN exclusion TEXT CHECK (exclusion <> '')",
        "ALTER TABLE trials ADD COLUMN expected TEXT "
        "CHECK (expected IS NULL OR (expected IN ('A', 'B') AND kind = 'catch'))",
        "ALTER TABLE trials ADD COLUMN repeats TEXT "
        "CHECK (repeats IS NULL OR (repeats <> '' AND repeats <> condition "
        "AND kind IN ('participant', 'simulated')))",
    };
}

/// How long a trial's screen was not to be seen; trials from before it was measured do not know.
std::vector<std::string> hidden_stimuli() {
    return {
        "ALTER TABLE trials ADD COLUMN hidden_ms {real} "
        "CHECK (hidden_ms IS NULL OR hidden_ms BETWEEN 0 AND 1e12)",
    };
}

/// What the study fixed before it had data is kept with each session, as its rule of exclusion is.
std::vector<std::string> study_plans() {
    return {"ALTER TABLE sessions ADD COLUMN study_plan TEXT CHECK (study_plan <> '')"};
}

/// What a participant agreed to and when, the study's own questions with their answers, and
/// sessions that were merged from stores that counted their slots for themselves.
std::vector<std::string> forms_and_merged_sessions() {
    return {
        "ALTER TABLE participants ADD COLUMN code TEXT CHECK (code <> '')",
        "ALTER TABLE participants ADD COLUMN consent_version TEXT CHECK (consent_version <> '')",
        "ALTER TABLE participants ADD COLUMN consent_items TEXT CHECK (consent_items <> '')",
        "ALTER TABLE participants ADD COLUMN consent_utc TEXT "
        "CHECK (consent_utc LIKE '____-__-__T__:__:__%Z')",
        "ALTER TABLE participants ADD COLUMN form TEXT CHECK (form <> '')",
        "ALTER TABLE sessions ADD COLUMN slot_copy {integer} NOT NULL DEFAULT 0 "
        "CHECK (slot_copy >= 0)",
        "DROP INDEX sessions_one_per_slot",
        "CREATE UNIQUE INDEX sessions_one_per_slot ON sessions "
        "(study, seed, kind, slot, slot_copy) WHERE state <> 'abandoned'",
    };
}

/// How a session's times came about, and why it was begun where the start refused.
std::vector<std::string> timing_and_overrides() {
    return {
        "ALTER TABLE sessions ADD COLUMN timing TEXT CHECK (timing <> '')",
        "ALTER TABLE trials ADD COLUMN override_reason TEXT CHECK (override_reason <> '')",
    };
}

/// The statement in the system's own words.
std::string spelled_for(Database::System system, std::string statement) {
    const bool sqlite = system == Database::System::kSqlite;
    const std::array<std::pair<std::string_view, std::string_view>, 4> words{{
        {"{identity}",
         sqlite ? "INTEGER PRIMARY KEY" : "BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY"},
        {"{integer}", sqlite ? "INTEGER" : "BIGINT"},
        {"{real}", sqlite ? "REAL" : "DOUBLE PRECISION"},
        {"{strict}", sqlite ? " STRICT" : ""},
    }};
    for (const auto& [word, spelling] : words) {
        for (auto at = statement.find(word); at != std::string::npos; at = statement.find(word)) {
            statement.replace(at, word.size(), spelling);
        }
    }
    return statement;
}

struct TableCounts {
    int all = 0;
    int ours = 0;  ///< tables named obscura_schema
};

/// In one statement, because another process may be making the store meanwhile.
TableCounts count_tables(Database& database) {
    const bool sqlite = database.system() == Database::System::kSqlite;
    TableCounts counts;
    database.session() << (sqlite
                               ? "SELECT COUNT(*), COUNT(CASE name WHEN 'obscura_schema' THEN 1 "
                                 "END) FROM sqlite_master WHERE type = 'table' AND name NOT LIKE "
                                 "'sqlite!_%' ESCAPE '!'"
                               : "SELECT COUNT(*), COUNT(CASE table_name WHEN 'obscura_schema' "
                                 "THEN 1 END) FROM information_schema.tables WHERE "
                                 "table_schema = current_schema()"),
        soci::into(counts.all), soci::into(counts.ours);
    return counts;
}

base::Error newer(const Database& database, int met, int known) {
    return base::bad_input(
        "the store {} has schema version {}, this program knows versions up to {}: it was written "
        "by a newer Obscura",
        database.name(), met, known);
}

}  // namespace

const std::vector<Migration>& migrations() {
    static const std::vector<Migration> steps{
        {1, first_schema()}, {2, checks_of_attention()},       {3, hidden_stimuli()},
        {4, study_plans()},  {5, forms_and_merged_sessions()}, {6, timing_and_overrides()}};
    return steps;
}

int schema_version(Database& database) {
    const TableCounts tables = count_tables(database);
    if (tables.ours == 0) {
        // A PostgreSQL database may well hold other tables beside the store's.
        if (database.system() == Database::System::kSqlite && tables.all > 0) {
            throw base::bad_input(
                "cannot open the store {}: it is a database of another program (no table "
                "obscura_schema)",
                database.name());
        }
        return 0;
    }
    int version = 0;
    database.session() << "SELECT version FROM obscura_schema", soci::into(version);
    return version;
}

void migrate(Database& database, const std::vector<Migration>& steps) {
    const int known = steps.back().version;
    const int met = schema_version(database);
    if (met > known) throw newer(database, met, known);
    if (met == known) return;

    Transaction transaction(database);
    const int from = schema_version(database);  // another process may have been first
    for (const Migration& step : steps) {
        if (step.version <= from) continue;
        for (const std::string& statement : step.statements) {
            database.execute(spelled_for(database.system(), statement));
        }
        database.session() << "UPDATE obscura_schema SET version = :version",
            soci::use(step.version);
    }
    transaction.commit();
}

void require_current(Database& database, const std::vector<Migration>& steps) {
    const int known = steps.back().version;
    const int met = schema_version(database);
    if (met > known) throw newer(database, met, known);
    if (met == 0) {
        throw base::bad_input("cannot open the store {}: it is empty", database.name());
    }
    if (met < known) {
        throw base::bad_input(
            "the store {} has schema version {}, needed is {}: opening it for writing brings it up "
            "to date",
            database.name(), met, known);
    }
}

}  // namespace obscura::analysis
