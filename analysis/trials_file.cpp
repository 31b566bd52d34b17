// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/trials_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <unordered_map>

#include "analysis/trials_header.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

std::optional<int> whole_number(const std::string& field) {
    int value = 0;
    const char* const end = field.data() + field.size();
    const auto [next, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc() || next != end || value < 0) return std::nullopt;
    return value;
}

/// Text that no field holds stands between the parts.
std::string key_of(const std::string& one, const std::string& other,
                   const std::string& third = "") {
    return fmt::format("{}:{}{}:{}{}", one.size(), one, other.size(), other, third);
}

class Reader {
  public:
    explicit Reader(const std::string& name) : problems_(file_.name) { file_.name = name; }

    TrialsFile read(std::string_view text) {
        for_each_csv_record(text, file_.name, [&](const CsvRecord& record) {
            header_ ? read_row(record) : read_header(record);
        });
        if (!header_) {
            throw base::bad_input(
                "{}: the file is empty, allowed is a header with {} and a row "
                "for each trial",
                file_.name,
                fmt::join(kColumnNames.begin(), kColumnNames.begin() + kNeededColumns, ","));
        }
        problems_.throw_if_any();
        if (file_.trials.empty()) {
            throw base::bad_input("{}:1: there is no row below the header", file_.name);
        }
        return std::move(file_);
    }

  private:
    void read_header(const CsvRecord& record) {
        header_.emplace(record, problems_);
        problems_.throw_if_any();
        if (!header_->has(kOrder) && !header_->has(kFirstShown)) {
            file_.order_unknown = "the file does not say which image was shown first";
        }
    }

    void read_row(const CsvRecord& row) {
        if (row.fields.size() != header_->width()) {
            problems_.add(row.line, fmt::format("the row has {} fields, allowed are {}",
                                                row.fields.size(), header_->width()));
            return;
        }
        TrialRecord trial;
        trial.condition_A = needed(row, kConditionA);
        trial.condition_B = needed(row, kConditionB);
        trial.scene = header_->field(row, kScene);
        trial.hypothesis = header_->field(row, kHypothesis);
        read_choice(row, trial);
        read_validity(row, trial);
        read_kind(row, trial);
        read_order(row, trial);
        read_session(row, trial);
        read_index(row, trial);
        read_attention(row, trial);
        read_condition(row, trial);
        trial.response_first = trial.is_A_selected == (trial.first_shown == 'A');
        check_response(row, trial);
        file_.trials.push_back(std::move(trial));
    }

    const std::string& needed(const CsvRecord& row, TrialsColumn column) {
        const std::string& field = header_->field(row, column);
        if (field.empty()) {
            problems_.add(row.line, fmt::format("column {} is empty", kColumnNames[column]));
        }
        return field;
    }

    void read_choice(const CsvRecord& row, TrialRecord& trial) {
        const std::string& field = header_->field(row, kIsASelected);
        trial.is_A_selected = field == "1" || field == "true";
        if (!trial.is_A_selected && field != "0" && field != "false") {
            problems_.add(row.line, kIsASelected, field, "are 0, 1, true, false");
        }
    }

    void read_validity(const CsvRecord& row, TrialRecord& trial) {
        trial.validity = header_->field(row, kValidity);
        if (!trial.validity.empty() && trial.validity != "low" && trial.validity != "moderate" &&
            trial.validity != "high") {
            problems_.add(row.line, kValidity, trial.validity, "are low, moderate, high");
        }
    }

    void read_kind(const CsvRecord& row, TrialRecord& trial) {
        if (!header_->has(kKind)) return;
        const std::string& field = header_->field(row, kKind);
        const auto kind = kind_from(field);
        if (kind) {
            trial.kind = *kind;
        } else {
            problems_.add(row.line, kKind, field, "are participant, practice, catch, simulated");
        }
    }

    void read_order(const CsvRecord& row, TrialRecord& trial) {
        if (header_->has(kFirstShown)) {
            const std::string& field = header_->field(row, kFirstShown);
            if (field != "A" && field != "B") {
                problems_.add(row.line, kFirstShown, field, "are A, B");
                return;
            }
            trial.first_shown = field.front();
        }
        if (!header_->has(kOrder)) return;
        const std::string& field = header_->field(row, kOrder);
        const bool is_number = whole_number(field).has_value();
        const bool is_side = field == "AB" || field == "BA" || field == "A" || field == "B";
        if (!order_is_number_) order_is_number_ = is_number;
        if ((!is_number && !is_side) || is_number != *order_is_number_) {
            problems_.add(row.line, kOrder, field,
                          "are AB, BA, A, B, or in all rows the trial's whole number");
        } else if (is_number) {
            trial.trial_index = *whole_number(field);
            if (!header_->has(kFirstShown)) {
                file_.order_unknown =
                    "the column order numbers the trials and does not say which image was first";
            }
        } else if (header_->has(kFirstShown) && field.front() != trial.first_shown) {
            problems_.add(row.line, kOrder, field, "is what the column first_shown says");
        } else {
            trial.first_shown = field.front();
        }
    }

    /// Sessions of different observers may have the same name in the file.
    void read_session(const CsvRecord& row, TrialRecord& trial) {
        const std::string& observer = needed(row, kObserver);
        const std::string& name = header_->field(row, kSessionId);
        trial.session_id = name.empty() ? observer : key_of(observer, name);
        const auto [place, is_new] = session_.emplace(trial.session_id, file_.sessions.size());
        if (is_new) {
            SessionRecord& session = file_.sessions.emplace_back();
            session.session_id = trial.session_id;
            session.participant_id = observer;
            session.study = header_->field(row, kStudy);
            session.exclusion = header_->field(row, kExclusion);
            session.state = SessionState::kCompleted;
            has_kind_.push_back(false);
        }
        SessionRecord& session = file_.sessions[place->second];
        if (session.study != header_->field(row, kStudy)) {
            problems_.add(row.line, kStudy, header_->field(row, kStudy),
                          fmt::format("is '{}' as before in session {}", session.study, name));
        }
        if (session.exclusion != header_->field(row, kExclusion)) {
            problems_.add(row.line, kExclusion, header_->field(row, kExclusion),
                          fmt::format("is '{}' as before in session {}", session.exclusion, name));
        }
        read_session_state(row, session, is_new);
        if (trial.kind != Kind::kParticipant && trial.kind != Kind::kSimulated) return;
        if (has_kind_[place->second] && session.kind != trial.kind) {
            problems_.add(
                row.line, kKind, std::string(to_string(trial.kind)),
                fmt::format("is {} as before in session {}", to_string(session.kind), name));
        }
        session.kind = trial.kind;
        has_kind_[place->second] = true;
    }

    void read_session_state(const CsvRecord& row, SessionRecord& session, bool is_new) {
        if (!header_->has(kSessionState)) return;
        const std::string& field = header_->field(row, kSessionState);
        const auto state = session_state_from(field);
        if (!state || (!is_new && *state != session.state)) {
            problems_.add(row.line, kSessionState, field,
                          "are open, completed, abandoned, the same in all rows of a session");
            return;
        }
        session.state = *state;
    }

    void read_index(const CsvRecord& row, TrialRecord& trial) {
        const bool has_index = header_->has(kTrialIndex);
        const bool is_numbered = order_is_number_.value_or(false) && header_->has(kSessionId);
        if (!has_index && !is_numbered) return;
        const TrialsColumn column = has_index ? kTrialIndex : kOrder;
        const std::string& field = header_->field(row, column);
        const auto index = whole_number(field);
        if (!index) {
            if (has_index) problems_.add(row.line, column, field, "is a whole number from 0");
            return;
        }
        trial.trial_index = *index;
        const auto [first, is_new] = index_line_.emplace(key_of(trial.session_id, field), row.line);
        if (!is_new) {
            problems_.add(row.line, column, field,
                          fmt::format("is each number once in a session, this one is in line {}",
                                      first->second));
        }
    }

    void read_attention(const CsvRecord& row, TrialRecord& trial) {
        const std::string& expected = header_->field(row, kExpected);
        if (!expected.empty()) {
            if ((expected != "A" && expected != "B") || trial.kind != Kind::kCatch) {
                problems_.add(row.line, kExpected, expected,
                              "are A, B for kind catch, else nothing");
            }
            trial.expected = expected.front();
        }
        trial.repeats = header_->field(row, kRepeats);
        if (trial.repeats.empty()) return;
        const bool is_vote = trial.kind == Kind::kParticipant || trial.kind == Kind::kSimulated;
        if (!is_vote || trial.repeats == header_->field(row, kCondition)) {
            problems_.add(row.line, kRepeats, trial.repeats,
                          "is another condition, for kind participant or simulated");
        }
    }

    void read_condition(const CsvRecord& row, TrialRecord& trial) {
        if (header_->has(kCondition)) {
            trial.condition = needed(row, kCondition);
            check_description(row, trial);
            return;
        }
        if (trial.condition_A == trial.condition_B) {
            problems_.add(row.line, kConditionB, trial.condition_B,
                          "is another variant than condition_A");
            return;
        }
        const auto& [low, high] = std::minmax(trial.condition_A, trial.condition_B);
        const auto [place, is_new] =
            first_a_.emplace(key_of(low, high, trial.scene), trial.condition_A);
        if (place->second != trial.condition_A) {
            std::swap(trial.condition_A, trial.condition_B);
            trial.is_A_selected = !trial.is_A_selected;
            trial.first_shown = trial.first_shown == 'A' ? 'B' : 'A';
            if (trial.expected != '\0') trial.expected = trial.expected == 'A' ? 'B' : 'A';
        }
        trial.condition = fmt::format("{}{}{} - {}", trial.scene, trial.scene.empty() ? "" : ": ",
                                      trial.condition_A, trial.condition_B);
        check_description(row, trial);
    }

    /// A condition is the same thing in every row that is counted together.
    void check_description(const CsvRecord& row, const TrialRecord& trial) {
        const SessionRecord& session = file_.sessions[session_.at(trial.session_id)];
        if (session.state != SessionState::kCompleted || trial.kind != session.kind) return;
        const auto description =
            fmt::format("{} against {} (validity '{}', hypothesis '{}')", trial.condition_A,
                        trial.condition_B, trial.validity, trial.hypothesis);
        const auto [first, is_new] = described_.emplace(
            key_of(session.study, trial.condition, std::string(to_string(trial.kind))),
            std::pair(description, row.line));
        if (first->second.first == description) return;
        problems_.add(
            row.line,
            fmt::format("condition '{}' is {}, allowed is what line {} says: {}", trial.condition,
                        description, first->second.second, first->second.first));
    }

    void check_response(const CsvRecord& row, const TrialRecord& trial) {
        if (!header_->has(kResponse)) return;
        const std::string& field = header_->field(row, kResponse);
        if (field != "first" && field != "second") {
            problems_.add(row.line, kResponse, field, "are first, second");
        } else if (file_.order_unknown.empty() && (field == "first") != trial.response_first) {
            problems_.add(row.line, kResponse, field,
                          "is what is_A_selected and the order of showing say");
        }
    }

    TrialsFile file_;
    FileProblems problems_;
    std::optional<TrialsHeader> header_;
    std::unordered_map<std::string, std::size_t> session_;  ///< name to place
    std::vector<bool> has_kind_;                            ///< of each session
    std::unordered_map<std::string, int> index_line_;
    std::unordered_map<std::string, std::string> first_a_;  ///< what is A in a condition
    std::unordered_map<std::string, std::pair<std::string, int>> described_;
    std::optional<bool> order_is_number_;
};

}  // namespace

TrialsFile parse_trials(std::string_view text, const std::string& name) {
    return Reader(name).read(text);
}

TrialsFile read_trials(const std::filesystem::path& file) {
    return parse_trials(base::read_file(file), file.string());
}

Tally tally_of(const TrialsFile& file, const std::string& study, Kind kind) {
    Tally tally = tally_trials(file.name, file.sessions, file.trials, study, kind);
    if (!file.order_unknown.empty()) tally.order = Possible<OrderVotes>::none(file.order_unknown);
    return tally;
}

}  // namespace obscura::analysis
