// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_file.h"

#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

#include "analysis/direction.h"
#include "analysis/exclusion.h"
#include "analysis/study_plan.h"
#include "analysis/table/table.h"
#include "analysis/table/values.h"
#include "analysis/trials_choice.h"
#include "analysis/trials_columns.h"
#include "analysis/trials_conditions.h"
#include "analysis/trials_fields.h"
#include "analysis/trials_order.h"
#include "analysis/trials_repeats.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

std::uint64_t pair_of(std::uint32_t one, std::uint32_t other) {
    return (std::uint64_t{one} << 32U) | other;
}

/// Reads one row after another.
class TrialsReader {
  public:
    TrialsReader(std::string bytes, const std::string& name, const ColumnMap& map)
        : map_(map),
          table_(named(name)),
          file_(std::move(bytes), table_.source),
          problems_(table_.source),
          numbers_(!file_.has_commas()) {}

    AnswerTable read() {
        file_.for_each_row(problems_,
                           [&](const CsvRow& row) { columns_ ? read_row(row) : read_header(row); });
        if (!columns_) {
            throw base::bad_input(
                "{}: the file is empty, allowed is a header with observer, condition_A, "
                "condition_B, is_A_selected and a row for each trial",
                table_.source);
        }
        choice_->finish();
        repeats_.report_equal_indices(*columns_, problems_);
        table_.order_unknown = order_->unknown();
        problems_.throw_if_any();
        if (table_.answers.empty()) throw no_answers();
        settle_direction(table_);
        conditions_->shorten_names();
        write_notes();
        return std::move(table_);
    }

  private:
    [[nodiscard]] static AnswerTable named(const std::string& name) {
        AnswerTable table;
        table.source = name;
        return table;
    }

    void read_header(const CsvRow& row) {
        columns_.emplace(row, map_, problems_);
        header_line_ = row.line;
        problems_.throw_if_any();
        choice_.emplace(*columns_, problems_);
        order_.emplace(*columns_, problems_, numbers_);
        fields_.emplace(table_, *columns_, problems_);
        conditions_.emplace(table_, *columns_, problems_, *fields_);
    }

    [[nodiscard]] base::Error no_answers() const {
        const std::size_t rows = no_trials_.count() + unanswered_.count();
        if (rows == 0) {
            return base::bad_input("{}:{}: there is no row below the header", table_.source,
                                   header_line_);
        }
        return base::bad_input(
            "{}:{}: none of the {} rows is an answered trial: {} lack both variants, {} the answer",
            table_.source, header_line_, rows, no_trials_.count(), unanswered_.count());
    }

    void write_notes() {
        std::vector<std::string>& notes = table_.notes;
        notes = file_.notes();
        if (const std::string names = columns_->passed_over(); !names.empty()) {
            notes.push_back(fmt::format("columns that are not read: {}", names));
        }
        const auto passed_over = [&](const Lines& lines, std::string_view why) {
            if (lines.count() == 0) return;
            notes.push_back(fmt::format(
                "{} passed over, {} ({})",
                lines.count() == 1 ? "1 row is" : fmt::format("{} rows are", lines.count()), why,
                lines.words()));
        };
        passed_over(no_trials_, "without the two variants");
        passed_over(unanswered_, "without an answer");
        const auto repeats = repeats_.notes(table_);
        notes.insert(notes.end(), repeats.begin(), repeats.end());
        note_one_variant();
        note_slow_answers();
    }

    /// Where a pair is of one name twice, nothing says which of them is A.
    void note_one_variant() {
        std::set<std::string> ids;
        for (const AnswerEntry& answer : table_.answers) {
            const ConditionEntry& condition = table_.conditions[answer.condition];
            const bool is_vote =
                answer.kind == Kind::kParticipant || answer.kind == Kind::kSimulated;
            if (is_vote && condition.variant_a == condition.variant_b) {
                ids.insert(table_.names[condition.id]);
            }
        }
        for (const std::string& id : ids) {
            table_.notes.push_back(fmt::format(
                "condition {} compares two variants of one name: which of them is A is what each "
                "row says, and rows that name them the other way round cannot be told; name them "
                "apart",
                id));
        }
    }

    /// Milliseconds taken for seconds are a thousand times too long.
    void note_slow_answers() {
        constexpr double kHardlyEver_s = 100.0;
        if (timed_ == 0 || times_s_ / static_cast<double>(timed_) < kHardlyEver_s) return;
        table_.notes.push_back(
            fmt::format("the answers took {:.0f} s on average: if {} is in ms, {}",
                        times_s_ / static_cast<double>(timed_), columns_->name(kResponseTime),
                        map_option("response_time_ms", columns_->name(kResponseTime))));
    }

    void read_row(const CsvRow& row) {
        const bool has_a = !is_missing_name(fields_->field(row, kConditionA));
        const bool has_b = !is_missing_name(fields_->field(row, kConditionB));
        if (!has_a && !has_b) return no_trials_.add(row.line);
        if (has_a && has_b && !choice_->is_answered(row)) return unanswered_.add(row.line);
        AnswerEntry answer;
        read_kind(row, answer);
        order_->read(row, answer);
        answer.a_selected =
            choice_->is_a_chosen(row, order_->unknown().empty() ? answer.first_shown : '\0');
        read_session(row, answer);
        read_index(row, answer);
        read_time(row, answer);
        read_attention(row, answer);
        conditions_->read(row, answer);
        order_->check_response(row, answer);
        table_.answers.push_back(answer);
        repeats_.add(row);
    }

    void read_kind(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view text = fields_->field(row, kKind);
        if (is_missing(text)) return;
        const auto kind = kind_from(lower(text));
        if (kind) {
            answer.kind = *kind;
        } else {
            fields_->report(
                row, kKind, text,
                "are participant, practice, catch, simulated; --map kind= passes the column over");
        }
    }

    /// Sessions of different observers may have the same name in the file.
    void read_session(const CsvRow& row, AnswerEntry& answer) {
        const std::uint32_t observer = fields_->needed(row, kObserver);
        const std::uint32_t name = fields_->number_of(row, kSessionId);
        const auto number = static_cast<std::uint32_t>(table_.sessions.size());
        const auto [place, is_new] = session_.emplace(pair_of(observer, name), number);
        answer.session = place->second;
        if (is_new) {
            table_.sessions.push_back(
                {name == 0 ? observer : name, observer, fields_->number_of(row, kStudy),
                 fields_->number_of(row, kExclusion), Kind::kParticipant, SessionState::kCompleted,
                 0, fields_->number_of(row, kStudyPlan)});
            has_kind_.push_back(false);
            check_rule(row, kExclusion, exclusion_problem);
            check_rule(row, kStudyPlan, study_plan_problem);
        }
        SessionEntry& session = table_.sessions[answer.session];
        same_in_session(row, kStudy, session.study);
        same_in_session(row, kExclusion, session.exclusion);
        same_in_session(row, kStudyPlan, session.study_plan);
        read_session_state(row, session, is_new);
        if (answer.kind != Kind::kParticipant && answer.kind != Kind::kSimulated) return;
        if (has_kind_[answer.session] && session.kind != answer.kind) {
            fields_->report(row, kKind, to_string(answer.kind),
                            fmt::format("is {} as before in session {}", to_string(session.kind),
                                        fields_->field(row, kSessionId)));
        }
        session.kind = answer.kind;
        has_kind_[answer.session] = true;
    }

    template <typename Problem>
    void check_rule(const CsvRow& row, TrialsColumn column, const Problem& problem_of) {
        const std::string_view text = fields_->field(row, column);
        if (const auto why = problem_of(text); why) fields_->report(row, column, text, *why);
    }

    void same_in_session(const CsvRow& row, TrialsColumn column, std::uint32_t before) {
        if (fields_->number_of(row, column) == before) return;
        fields_->report(row, column, fields_->field(row, column),
                        fmt::format("is '{}' as before in session {}", table_.names[before],
                                    fields_->field(row, kSessionId)));
    }

    void read_session_state(const CsvRow& row, SessionEntry& session, bool is_new) {
        if (!columns_->has(kSessionState)) return;
        const std::string_view text = fields_->field(row, kSessionState);
        const auto state = session_state_from(lower(text));
        if (!state || (!is_new && *state != session.state)) {
            fields_->report(row, kSessionState, text,
                            "are open, completed, abandoned, the same in all rows of a session");
            return;
        }
        session.state = *state;
    }

    void read_index(const CsvRow& row, AnswerEntry& answer) {
        if (columns_->has(kTrialIndex)) {
            const std::string_view text = fields_->field(row, kTrialIndex);
            const auto index = numbers_.whole(text, kLastIndex);
            if (!index) {
                fields_->report(
                    row, kTrialIndex, text,
                    "is a whole number from 0; --map trial_index= passes the column over");
                return;
            }
            answer.trial_index = static_cast<std::int32_t>(*index);
        } else if (!order_->numbers_trials() || !columns_->has(kSessionId)) {
            return;
        }
        if (answer.trial_index >= 0) repeats_.add_index(answer, row.line);
    }

    void read_time(const CsvRow& row, AnswerEntry& answer) {
        const TrialsColumn column =
            columns_->has(kResponseTimeMs) ? kResponseTimeMs : kResponseTime;
        const std::string_view text = fields_->field(row, column);
        if (is_missing(text)) return;
        const auto time = numbers_.number(text);
        if (!time || *time < 0.0) {
            fields_->report(row, column, text,
                            column == kResponseTime
                                ? "is a number of seconds from 0, or nothing or n/a"
                                : "is a number of milliseconds from 0, or nothing");
            return;
        }
        constexpr double kMillisecondsPerSecond = 1000.0;
        answer.response_time_s = column == kResponseTime ? *time : *time / kMillisecondsPerSecond;
        times_s_ += answer.response_time_s;
        ++timed_;
    }

    void read_attention(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view expected = fields_->field(row, kExpected);
        if (!is_missing(expected)) {
            if ((expected != "A" && expected != "B") || answer.kind != Kind::kCatch) {
                fields_->report(row, kExpected, expected, "are A, B for kind catch, else nothing");
            }
            answer.expected = expected.front();
        }
        answer.repeats = fields_->number_of(row, kRepeats);
        if (answer.repeats == 0) return;
        const bool is_vote = answer.kind == Kind::kParticipant || answer.kind == Kind::kSimulated;
        if (!is_vote || answer.repeats == fields_->number_of(row, kCondition)) {
            fields_->report(row, kRepeats, table_.names[answer.repeats],
                            "is another condition, for kind participant or simulated");
        }
    }

    const ColumnMap& map_;
    AnswerTable table_;
    ForeignTable file_;
    FileProblems problems_;
    NumberReader numbers_;
    std::optional<TrialsColumns> columns_;
    std::optional<ChoiceReader> choice_;
    std::optional<OrderReader> order_;
    std::optional<TrialFields> fields_;
    std::optional<ConditionReader> conditions_;
    RepeatFinder repeats_;
    Lines no_trials_;   ///< rows without variants
    Lines unanswered_;  ///< rows without a choice
    int header_line_ = 1;
    double times_s_ = 0.0;  ///< the sum of the known times
    std::size_t timed_ = 0;
    std::unordered_map<std::uint64_t, std::uint32_t> session_;  ///< observer and name to place
    std::vector<bool> has_kind_;                                ///< of each session
};

}  // namespace

AnswerTable parse_trials(std::string bytes, const std::string& name, const ColumnMap& map) {
    return TrialsReader(std::move(bytes), name, map).read();
}

AnswerTable read_trials(const std::filesystem::path& file, const ColumnMap& map) {
    return parse_trials(base::read_file(file), file.string(), map);
}

}  // namespace obscura::analysis
