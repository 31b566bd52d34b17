// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "analysis/direction.h"
#include "analysis/exclusion.h"
#include "analysis/table/table.h"
#include "analysis/table/values.h"
#include "analysis/trials_choice.h"
#include "analysis/trials_columns.h"
#include "analysis/trials_order.h"
#include "analysis/trials_repeats.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

std::uint64_t pair_of(std::uint32_t one, std::uint32_t other) {
    return (std::uint64_t{one} << 32U) | other;
}

bool is_control(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code < 0x20U || code == 0x7FU;
}

/// Reads one row after another; texts become numbers at once.
class Reader {
  public:
    Reader(std::string bytes, const std::string& name, const ColumnMap& map)
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
        shorten_names();
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
    }

    [[nodiscard]] std::string_view field(const CsvRow& row, TrialsColumn column) const {
        return columns_->field(row, column);
    }
    void report(const CsvRow& row, TrialsColumn column, std::string_view value,
                std::string_view allowed) {
        columns_->report(problems_, row.line, column, value, allowed);
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
        note_slow_answers();
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
        const bool has_a = !is_missing_name(field(row, kConditionA));
        const bool has_b = !is_missing_name(field(row, kConditionB));
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
        read_condition(row, answer);
        order_->check_response(row, answer);
        table_.answers.push_back(answer);
        repeats_.add(row);
    }

    /// The number of the field's text; most rows repeat what the row before says.
    std::uint32_t number_of(const CsvRow& row, TrialsColumn column) {
        const std::string_view text = field(row, column);
        std::uint32_t& last = last_[column];
        if (table_.names[last] == text) return last;
        if (is_missing_name(text)) return 0;
        const std::size_t known = table_.names.size();
        last = table_.names.number_of(text);
        if (last >= known) check_name(row, column, text);
        return last;
    }

    void check_name(const CsvRow& row, TrialsColumn column, std::string_view text) {
        constexpr std::size_t kLongestName = 1000;
        if (std::any_of(text.begin(), text.end(), is_control)) {
            report(row, column, text, "is text without control characters");
        } else if (text.size() > kLongestName) {
            report(row, column, text,
                   fmt::format("are {} bytes, not {}", kLongestName, text.size()));
        }
    }

    std::uint32_t needed(const CsvRow& row, TrialsColumn column) {
        const std::uint32_t number = number_of(row, column);
        if (number == 0) {
            problems_.add(row.line, fmt::format("column {} is empty", columns_->name(column)));
        }
        return number;
    }

    void read_kind(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view text = field(row, kKind);
        if (is_missing(text)) return;
        const auto kind = kind_from(lower(text));
        if (kind) {
            answer.kind = *kind;
        } else {
            report(
                row, kKind, text,
                "are participant, practice, catch, simulated; --map kind= passes the column over");
        }
    }

    /// Sessions of different observers may have the same name in the file.
    void read_session(const CsvRow& row, AnswerEntry& answer) {
        const std::uint32_t observer = needed(row, kObserver);
        const std::uint32_t name = number_of(row, kSessionId);
        const auto number = static_cast<std::uint32_t>(table_.sessions.size());
        const auto [place, is_new] = session_.emplace(pair_of(observer, name), number);
        answer.session = place->second;
        if (is_new) {
            table_.sessions.push_back({name == 0 ? observer : name, observer,
                                       number_of(row, kStudy), number_of(row, kExclusion),
                                       Kind::kParticipant, SessionState::kCompleted});
            has_kind_.push_back(false);
            check_exclusion(row);
        }
        SessionEntry& session = table_.sessions[answer.session];
        same_in_session(row, kStudy, session.study);
        same_in_session(row, kExclusion, session.exclusion);
        read_session_state(row, session, is_new);
        if (answer.kind != Kind::kParticipant && answer.kind != Kind::kSimulated) return;
        if (has_kind_[answer.session] && session.kind != answer.kind) {
            report(row, kKind, to_string(answer.kind),
                   fmt::format("is {} as before in session {}", to_string(session.kind),
                               field(row, kSessionId)));
        }
        session.kind = answer.kind;
        has_kind_[answer.session] = true;
    }

    void check_exclusion(const CsvRow& row) {
        const std::string_view text = field(row, kExclusion);
        if (const auto why = exclusion_problem(text); why) {
            report(row, kExclusion, text, *why);
        }
    }

    void same_in_session(const CsvRow& row, TrialsColumn column, std::uint32_t before) {
        if (number_of(row, column) == before) return;
        report(row, column, field(row, column),
               fmt::format("is '{}' as before in session {}", table_.names[before],
                           field(row, kSessionId)));
    }

    void read_session_state(const CsvRow& row, SessionEntry& session, bool is_new) {
        if (!columns_->has(kSessionState)) return;
        const std::string_view text = field(row, kSessionState);
        const auto state = session_state_from(lower(text));
        if (!state || (!is_new && *state != session.state)) {
            report(row, kSessionState, text,
                   "are open, completed, abandoned, the same in all rows of a session");
            return;
        }
        session.state = *state;
    }

    void read_index(const CsvRow& row, AnswerEntry& answer) {
        if (columns_->has(kTrialIndex)) {
            const std::string_view text = field(row, kTrialIndex);
            const auto index = numbers_.whole(text, kLastIndex);
            if (!index) {
                report(row, kTrialIndex, text,
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
        const std::string_view text = field(row, column);
        if (is_missing(text)) return;
        const auto time = numbers_.number(text);
        if (!time || *time < 0.0) {
            report(row, column, text,
                   column == kResponseTime ? "is a number of seconds from 0, or nothing or n/a"
                                           : "is a number of milliseconds from 0, or nothing");
            return;
        }
        constexpr double kMillisecondsPerSecond = 1000.0;
        answer.response_time_s = column == kResponseTime ? *time : *time / kMillisecondsPerSecond;
        times_s_ += answer.response_time_s;
        ++timed_;
    }

    void read_attention(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view expected = field(row, kExpected);
        if (!is_missing(expected)) {
            if ((expected != "A" && expected != "B") || answer.kind != Kind::kCatch) {
                report(row, kExpected, expected, "are A, B for kind catch, else nothing");
            }
            answer.expected = expected.front();
        }
        answer.repeats = number_of(row, kRepeats);
        if (answer.repeats == 0) return;
        const bool is_vote = answer.kind == Kind::kParticipant || answer.kind == Kind::kSimulated;
        if (!is_vote || answer.repeats == number_of(row, kCondition)) {
            report(row, kRepeats, table_.names[answer.repeats],
                   "is another condition, for kind participant or simulated");
        }
    }

    void read_condition(const CsvRow& row, AnswerEntry& answer) {
        const std::string validity = lower(field(row, kValidity));
        const bool is_level = validity == "low" || validity == "moderate" || validity == "high";
        if (!is_level && !is_missing(validity)) {
            report(row, kValidity, field(row, kValidity),
                   "are low, moderate, high; --map validity= passes the column over");
        }
        ConditionEntry shown;
        shown.variant_a = needed(row, kConditionA);
        shown.variant_b = needed(row, kConditionB);
        shown.hypothesis = number_of(row, kHypothesis);
        shown.validity = is_level ? table_.names.number_of(validity) : 0;
        shown.scene = number_of(row, kScene);
        if (columns_->has(kCondition)) {
            shown.id = needed(row, kCondition);
        } else if (!name_condition(row, shown)) {
            return;
        }
        answer.condition = table_.place_of(shown);
        check_description(row, answer);
    }

    /// Calls a condition by what it shows: scene, variants and level.
    bool name_condition(const CsvRow& row, ConditionEntry& shown) {
        if (shown.variant_a == shown.variant_b) {
            report(row, kConditionB, field(row, kConditionB),
                   "is another variant than condition_A");
            return false;
        }
        ConditionEntry pair;
        pair.scene = shown.scene;
        pair.validity = shown.validity;
        std::tie(pair.variant_a, pair.variant_b) = std::minmax(shown.variant_a, shown.variant_b);
        const auto [named, is_new] = named_.emplace(pair, 0);
        if (is_new) {
            const std::string& level = table_.names[pair.validity];
            named->second = table_.names.number_of(
                level.empty() ? pair_name(pair) : fmt::format("{} ({})", pair_name(pair), level));
        }
        shown.id = named->second;
        return true;
    }

    /// `atrium: None - Blizzard24`
    [[nodiscard]] std::string pair_name(const ConditionEntry& pair) const {
        const std::string* a = &table_.names[pair.variant_a];
        const std::string* b = &table_.names[pair.variant_b];
        if (is_a_of(*b, *a)) std::swap(a, b);
        const std::string& scene = table_.names[pair.scene];
        return fmt::format("{}{}{} - {}", scene, scene.empty() ? "" : ": ", *a, *b);
    }

    /// The level is part of a condition's name only where a scene and pair have several.
    void shorten_names() {
        std::map<std::string, std::vector<std::uint32_t>> levels;
        for (const auto& [pair, id] : named_) levels[pair_name(pair)].push_back(id);
        std::unordered_map<std::uint32_t, std::uint32_t> shorter;
        for (const auto& [name, ids] : levels) {
            if (ids.size() == 1) shorter.emplace(ids.front(), table_.names.number_of(name));
        }
        table_.rename(shorter);
    }

    /// A condition is the same thing in every row that is counted together.
    void check_description(const CsvRow& row, const AnswerEntry& answer) {
        const SessionEntry& session = table_.sessions[answer.session];
        if (session.state != SessionState::kCompleted || answer.kind != session.kind) return;
        ConditionEntry key;
        key.id = table_.conditions[answer.condition].id;
        key.hypothesis = session.study;
        key.validity = static_cast<std::uint32_t>(answer.kind);
        const auto [first, is_new] = described_.emplace(key, std::pair(answer.condition, row.line));
        if (first->second.first == answer.condition ||
            is_same_thing(table_.conditions[first->second.first],
                          table_.conditions[answer.condition])) {
            return;
        }
        problems_.add(row.line,
                      fmt::format("condition '{}' is {}, allowed is what line {} says: {}",
                                  table_.names[key.id], description_of(answer.condition),
                                  first->second.second, description_of(first->second.first)));
    }

    /// Whichever variant is called A; one condition may be shown in several scenes.
    [[nodiscard]] static bool is_same_thing(const ConditionEntry& one,
                                            const ConditionEntry& other) {
        return one.hypothesis == other.hypothesis && one.validity == other.validity &&
               std::minmax(one.variant_a, one.variant_b) ==
                   std::minmax(other.variant_a, other.variant_b);
    }

    [[nodiscard]] std::string description_of(std::uint32_t condition) const {
        const ConditionEntry& shown = table_.conditions[condition];
        const Names& names = table_.names;
        return fmt::format("{} against {} (validity '{}', hypothesis '{}')", names[shown.variant_a],
                           names[shown.variant_b], names[shown.validity], names[shown.hypothesis]);
    }

    const ColumnMap& map_;
    AnswerTable table_;
    Table file_;
    FileProblems problems_;
    NumberReader numbers_;
    std::optional<TrialsColumns> columns_;
    std::optional<ChoiceReader> choice_;
    std::optional<OrderReader> order_;
    RepeatFinder repeats_;
    Lines no_trials_;   ///< rows without variants
    Lines unanswered_;  ///< rows without a choice
    int header_line_ = 1;
    double times_s_ = 0.0;  ///< the sum of the known times
    std::size_t timed_ = 0;
    std::array<std::uint32_t, kColumnCount> last_{};            ///< number of each column's text
    std::unordered_map<std::uint64_t, std::uint32_t> session_;  ///< observer and name to place
    std::vector<bool> has_kind_;                                ///< of each session
    /// Scene, level and two variants, to the condition's name.
    std::unordered_map<ConditionEntry, std::uint32_t, ConditionHash> named_;
    /// Condition, study and kind, to the first description and its line.
    std::unordered_map<ConditionEntry, std::pair<std::uint32_t, int>, ConditionHash> described_;
};

}  // namespace

AnswerTable parse_trials(std::string bytes, const std::string& name, const ColumnMap& map) {
    return Reader(std::move(bytes), name, map).read();
}

AnswerTable read_trials(const std::filesystem::path& file, const ColumnMap& map) {
    return parse_trials(base::read_file(file), file.string(), map);
}

}  // namespace obscura::analysis
