// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>

#include "analysis/direction.h"
#include "analysis/exclusion.h"
#include "analysis/trials_header.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

std::optional<int> whole_number(std::string_view field) {
    int value = 0;
    const char* const end = field.data() + field.size();
    const auto [next, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc() || next != end || value < 0) return std::nullopt;
    return value;
}

std::uint64_t pair_of(std::uint32_t one, std::uint32_t other) {
    return (std::uint64_t{one} << 32U) | other;
}

/// Reads one row after another; texts become numbers at once.
class Reader {
  public:
    explicit Reader(const std::string& name) : problems_(table_.source) { table_.source = name; }

    void take(const CsvRow& row) { header_ ? read_row(row) : read_header(row); }

    AnswerTable done() {
        if (!header_) {
            throw base::bad_input(
                "{}: the file is empty, allowed is a header with {} and a row for each trial",
                table_.source,
                fmt::join(kColumnNames.begin(), kColumnNames.begin() + kNeededColumns, ","));
        }
        find_duplicates();
        problems_.throw_if_any();
        settle_direction(table_);
        shorten_names();
        if (table_.answers.empty()) {
            throw base::bad_input("{}:1: there is no row below the header", table_.source);
        }
        return std::move(table_);
    }

  private:
    void read_header(const CsvRow& row) {
        header_.emplace(row, problems_);
        problems_.throw_if_any();
        if (!header_->has(kOrder) && !header_->has(kFirstShown)) {
            table_.order_unknown = "the file does not say which image was shown first";
        }
    }

    void read_row(const CsvRow& row) {
        if (row.fields.size() != header_->width()) {
            problems_.add(row.line, fmt::format("the row has {} fields, allowed are {}",
                                                row.fields.size(), header_->width()));
            return;
        }
        AnswerEntry answer;
        read_choice(row, answer);
        read_kind(row, answer);
        read_order(row, answer);
        read_session(row, answer);
        read_index(row, answer);
        read_time(row, answer);
        read_attention(row, answer);
        read_condition(row, answer);
        check_response(row, answer);
        table_.answers.push_back(answer);
    }

    /// The number of the field's text; most rows repeat what the row before says.
    std::uint32_t number_of(const CsvRow& row, TrialsColumn column) {
        const std::string_view field = header_->field(row, column);
        if (field.empty()) return 0;
        std::uint32_t& last = last_[column];
        if (table_.names[last] != field) last = table_.names.number_of(field);
        return last;
    }

    std::uint32_t needed(const CsvRow& row, TrialsColumn column) {
        const std::uint32_t number = number_of(row, column);
        if (number == 0) {
            problems_.add(row.line, fmt::format("column {} is empty", kColumnNames[column]));
        }
        return number;
    }

    void read_choice(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view field = header_->field(row, kIsASelected);
        answer.a_selected = field == "1" || field == "true";
        if (!answer.a_selected && field != "0" && field != "false") {
            problems_.add(row.line, kIsASelected, field, "are 0, 1, true, false");
        }
    }

    void read_kind(const CsvRow& row, AnswerEntry& answer) {
        if (!header_->has(kKind)) return;
        const std::string_view field = header_->field(row, kKind);
        const auto kind = kind_from(field);
        if (kind) {
            answer.kind = *kind;
        } else {
            problems_.add(row.line, kKind, field, "are participant, practice, catch, simulated");
        }
    }

    void read_order(const CsvRow& row, AnswerEntry& answer) {
        if (header_->has(kFirstShown)) {
            const std::string_view field = header_->field(row, kFirstShown);
            if (field != "A" && field != "B") {
                problems_.add(row.line, kFirstShown, field, "are A, B");
                return;
            }
            answer.first_shown = field.front();
        }
        if (!header_->has(kOrder)) return;
        const std::string_view field = header_->field(row, kOrder);
        const auto number = whole_number(field);
        const bool is_side = field == "AB" || field == "BA" || field == "A" || field == "B";
        if (!order_is_number_) order_is_number_ = number.has_value();
        if ((!number && !is_side) || number.has_value() != *order_is_number_) {
            problems_.add(row.line, kOrder, field,
                          "are AB, BA, A, B, or in all rows the trial's whole number");
        } else if (number) {
            answer.trial_index = *number;
            if (!header_->has(kFirstShown)) {
                table_.order_unknown =
                    "the column order numbers the trials and does not say which image was first";
            }
        } else if (header_->has(kFirstShown) && field.front() != answer.first_shown) {
            problems_.add(row.line, kOrder, field, "is what the column first_shown says");
        } else {
            answer.first_shown = field.front();
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
            problems_.add(row.line, kKind, to_string(answer.kind),
                          fmt::format("is {} as before in session {}", to_string(session.kind),
                                      header_->field(row, kSessionId)));
        }
        session.kind = answer.kind;
        has_kind_[answer.session] = true;
    }

    void check_exclusion(const CsvRow& row) {
        const std::string_view field = header_->field(row, kExclusion);
        if (const auto why = exclusion_problem(field); why) {
            problems_.add(row.line, kExclusion, field, *why);
        }
    }

    void same_in_session(const CsvRow& row, TrialsColumn column, std::uint32_t before) {
        if (number_of(row, column) == before) return;
        problems_.add(row.line, column, header_->field(row, column),
                      fmt::format("is '{}' as before in session {}", table_.names[before],
                                  header_->field(row, kSessionId)));
    }

    void read_session_state(const CsvRow& row, SessionEntry& session, bool is_new) {
        if (!header_->has(kSessionState)) return;
        const std::string_view field = header_->field(row, kSessionState);
        const auto state = session_state_from(field);
        if (!state || (!is_new && *state != session.state)) {
            problems_.add(row.line, kSessionState, field,
                          "are open, completed, abandoned, the same in all rows of a session");
            return;
        }
        session.state = *state;
    }

    void read_index(const CsvRow& row, AnswerEntry& answer) {
        if (header_->has(kTrialIndex)) {
            const std::string_view field = header_->field(row, kTrialIndex);
            const auto index = whole_number(field);
            if (!index) {
                problems_.add(row.line, kTrialIndex, field, "is a whole number from 0");
                return;
            }
            answer.trial_index = *index;
        } else if (!order_is_number_.value_or(false) || !header_->has(kSessionId)) {
            return;
        }
        if (answer.trial_index < 0) return;
        indices_.push_back(
            {pair_of(answer.session, static_cast<std::uint32_t>(answer.trial_index)), row.line});
    }

    void read_time(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view field = header_->field(row, kResponseTime);
        if (field.empty() || field == "n/a") return;
        const char* const end = field.data() + field.size();
        const auto [next, error] = std::from_chars(field.data(), end, answer.response_time_s);
        if (error == std::errc() && next == end && std::isfinite(answer.response_time_s) &&
            answer.response_time_s >= 0.0) {
            return;
        }
        answer.response_time_s = 0.0;
        problems_.add(row.line, kResponseTime, field,
                      "is a number of seconds from 0, or nothing or n/a");
    }

    void read_attention(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view expected = header_->field(row, kExpected);
        if (!expected.empty()) {
            if ((expected != "A" && expected != "B") || answer.kind != Kind::kCatch) {
                problems_.add(row.line, kExpected, expected,
                              "are A, B for kind catch, else nothing");
            }
            answer.expected = expected.front();
        }
        answer.repeats = number_of(row, kRepeats);
        if (answer.repeats == 0) return;
        const bool is_vote = answer.kind == Kind::kParticipant || answer.kind == Kind::kSimulated;
        if (!is_vote || answer.repeats == number_of(row, kCondition)) {
            problems_.add(row.line, kRepeats, table_.names[answer.repeats],
                          "is another condition, for kind participant or simulated");
        }
    }

    void read_condition(const CsvRow& row, AnswerEntry& answer) {
        const std::string_view validity = header_->field(row, kValidity);
        if (!validity.empty() && validity != "low" && validity != "moderate" &&
            validity != "high") {
            problems_.add(row.line, kValidity, validity, "are low, moderate, high");
        }
        ConditionEntry shown;
        shown.variant_a = needed(row, kConditionA);
        shown.variant_b = needed(row, kConditionB);
        shown.hypothesis = number_of(row, kHypothesis);
        shown.validity = number_of(row, kValidity);
        shown.scene = number_of(row, kScene);
        if (header_->has(kCondition)) {
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
            problems_.add(row.line, kConditionB, header_->field(row, kConditionB),
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

    void check_response(const CsvRow& row, const AnswerEntry& answer) {
        if (!header_->has(kResponse)) return;
        const std::string_view field = header_->field(row, kResponse);
        const bool chose_first = answer.a_selected == (answer.first_shown == 'A');
        if (field != "first" && field != "second") {
            problems_.add(row.line, kResponse, field, "are first, second");
        } else if (table_.order_unknown.empty() && (field == "first") != chose_first) {
            problems_.add(row.line, kResponse, field,
                          "is what is_A_selected and the order of showing say");
        }
    }

    /// Two trials of a session with one number are one trial twice.
    void find_duplicates() {
        const auto before = [](const Index& one, const Index& other) {
            return std::tie(one.key, one.line) < std::tie(other.key, other.line);
        };
        if (!std::is_sorted(indices_.begin(), indices_.end(), before)) {
            std::sort(indices_.begin(), indices_.end(), before);
        }
        const TrialsColumn column = header_->has(kTrialIndex) ? kTrialIndex : kOrder;
        for (std::size_t i = 1; i < indices_.size(); ++i) {
            if (indices_[i].key != indices_[i - 1].key) continue;
            problems_.add(indices_[i].line, column,
                          std::to_string(static_cast<std::uint32_t>(indices_[i].key)),
                          fmt::format("is each number once in a session, this one is in line {}",
                                      indices_[i - 1].line));
        }
        indices_.clear();
        indices_.shrink_to_fit();
    }

    struct Index {
        std::uint64_t key = 0;  ///< session and number
        int line = 0;
    };

    AnswerTable table_;
    FileProblems problems_;
    std::optional<TrialsHeader> header_;
    std::array<std::uint32_t, kColumnCount> last_{};            ///< number of each column's text
    std::unordered_map<std::uint64_t, std::uint32_t> session_;  ///< observer and name to place
    std::vector<bool> has_kind_;                                ///< of each session
    std::vector<Index> indices_;
    /// Scene, level and two variants, to the condition's name.
    std::unordered_map<ConditionEntry, std::uint32_t, ConditionHash> named_;
    /// Condition, study and kind, to the first description and its line.
    std::unordered_map<ConditionEntry, std::pair<std::uint32_t, int>, ConditionHash> described_;
    std::optional<bool> order_is_number_;
};

}  // namespace

AnswerTable parse_trials(std::string_view text, const std::string& name) {
    Reader reader(name);
    for_each_csv_row(text, name, [&](const CsvRow& row) { reader.take(row); });
    return reader.done();
}

AnswerTable read_trials(const std::filesystem::path& file) {
    Reader reader(file.string());
    for_each_csv_row(file, [&](const CsvRow& row) { reader.take(row); });
    return reader.done();
}

}  // namespace obscura::analysis
