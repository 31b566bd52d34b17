// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/tally.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string_view>
#include <unordered_set>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

/// C2 before C10: runs of digits compare by length, then by digits.
bool naturally_before(std::string_view one, std::string_view other) {
    const auto is_digit = [](char letter) {
        return std::isdigit(static_cast<unsigned char>(letter)) != 0;
    };
    const auto take_run = [&](std::string_view& text) {
        const bool digits = is_digit(text.front());
        std::size_t length = 1;
        while (digits && length < text.size() && is_digit(text[length])) ++length;
        const std::string_view run = text.substr(0, length);
        text.remove_prefix(length);
        return run;
    };
    while (!one.empty() && !other.empty()) {
        const std::string_view a = take_run(one);
        const std::string_view b = take_run(other);
        if (a == b) continue;
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    }
    return one.size() < other.size();
}

/// A place that is not there.
constexpr std::uint32_t kNone = 0xFFFFFFFFU;

bool counts(const SessionEntry& session, Kind kind) {
    return session.state == SessionState::kCompleted && session.kind == kind;
}

base::Error no_sessions(const AnswerTable& table, Kind kind) {
    const Kind other = kind == Kind::kParticipant ? Kind::kSimulated : Kind::kParticipant;
    const auto others =
        std::count_if(table.sessions.begin(), table.sessions.end(),
                      [&](const SessionEntry& session) { return counts(session, other); });
    if (others > 0) {
        return base::bad_input(
            "{} has no completed session of kind {}, but {} of kind {}: --kind {} analyses those",
            table.source, to_string(kind), others, to_string(other), to_string(other));
    }
    return base::bad_input("{} has no completed session ({} in all): there is nothing to analyse",
                           table.source, table.sessions.size());
}

/// The one study to analyse.
std::uint32_t chosen_study(const AnswerTable& table, const std::string& study, Kind kind) {
    std::set<std::string_view> studies;
    std::uint32_t last = kNone;
    std::uint32_t chosen = kNone;
    for (const SessionEntry& session : table.sessions) {
        if (!counts(session, kind) || session.study == last) continue;
        last = session.study;
        studies.insert(table.names[last]);
        if (study.empty() || table.names[last] == study) chosen = last;
    }
    if (studies.empty()) throw no_sessions(table, kind);
    if (study.empty() && studies.size() > 1) {
        throw base::bad_input("{} has several studies, --study must name one of: {}", table.source,
                              fmt::join(studies, ", "));
    }
    if (chosen == kNone) {
        throw base::bad_input("--study {}: {} has no completed session of it, allowed are: {}",
                              study, table.source, fmt::join(studies, ", "));
    }
    return chosen;
}

class Counter {
  public:
    Counter(const AnswerTable& table, const std::string& study, Kind kind)
        : table_(table),
          kind_(kind),
          study_(chosen_study(table, study, kind)),
          participant_of_(table.sessions.size(), -1),
          place_of_condition_(table.conditions.size(), kNone),
          place_of_id_(table.names.size(), kNone) {}

    Tally tally() {
        tally_.source = table_.source;
        tally_.notes = table_.notes;
        tally_.kind = kind_;
        tally_.study = table_.names[study_];
        number_participants();
        read_rule();
        reserve();
        for (const AnswerEntry& answer : table_.answers) take(answer);
        compare_repeats();
        if (table_.order_unknown.empty()) {
            tally_.order = order_;
        } else {
            tally_.order = Possible<OrderVotes>::none(table_.order_unknown);
        }
        std::stable_sort(tally_.conditions.begin(), tally_.conditions.end(),
                         [](const ConditionVotes& one, const ConditionVotes& other) {
                             return naturally_before(one.id, other.id);
                         });
        return std::move(tally_);
    }

  private:
    [[nodiscard]] bool is_chosen(const SessionEntry& session) const {
        return counts(session, kind_) && session.study == study_;
    }

    void number_participants() {
        std::vector<std::int32_t> number(table_.names.size(), -1);
        for (std::size_t i = 0; i < table_.sessions.size(); ++i) {
            const SessionEntry& session = table_.sessions[i];
            if (!is_chosen(session)) continue;
            std::int32_t& own = number[session.participant];
            if (own < 0) {
                own = static_cast<std::int32_t>(tally_.participants.size());
                tally_.participants.push_back({table_.names[session.participant], {}, {}});
            }
            participant_of_[i] = own;
        }
        tally_.n_participants = static_cast<std::int64_t>(tally_.participants.size());
    }

    void read_rule() {
        std::uint32_t rule = kNone;
        for (const SessionEntry& session : table_.sessions) {
            if (!is_chosen(session) || session.exclusion == rule) continue;
            if (rule != kNone) {
                tally_.exclusion = Possible<ExclusionRule>::none(
                    "the sessions carry different rules, so that none was fixed for all of them");
                return;
            }
            rule = session.exclusion;
        }
        if (rule == 0) {
            tally_.exclusion = Possible<ExclusionRule>::none("the study has no rule");
        } else {
            tally_.exclusion = exclusion_rule(table_.names[rule], table_.source);
        }
    }

    /// Room for the votes of each condition at once: they are many.
    void reserve() {
        std::vector<std::size_t> votes(table_.conditions.size());
        for (const AnswerEntry& answer : table_.answers) {
            if (participant_of_[answer.session] < 0) continue;
            if (is_vote(answer)) ++votes[answer.condition];
            if (answer.repeats != 0) repeated_.insert(answer.repeats);
        }
        for (std::size_t i = 0; i < votes.size(); ++i) {
            if (votes[i] > 0) room_.emplace(static_cast<std::uint32_t>(i), votes[i]);
        }
    }

    [[nodiscard]] bool is_vote(const AnswerEntry& answer) const {
        return answer.kind == kind_ && answer.repeats == 0;
    }

    void take(const AnswerEntry& answer) {
        const std::int32_t participant = participant_of_[answer.session];
        if (participant < 0) return;
        if (answer.kind == Kind::kCatch && answer.expected != 0) {
            Successes& trials =
                tally_.participants[static_cast<std::size_t>(participant)].catch_trials;
            ++trials.n;
            if ((answer.expected == 'A') == answer.a_selected) ++trials.successes;
        }
        if (!is_vote(answer)) return;
        ConditionVotes& condition = entry_of(answer);
        ++(answer.a_selected ? condition.votes.a : condition.votes.b);
        condition.answers.push_back({participant, !answer.a_selected, answer.first_shown == 'A',
                                     answer.trial_index, answer.response_time_s});
        ++order_.n;
        if (answer.a_selected != (answer.first_shown == 'A')) ++order_.second_chosen;
    }

    /// The entry of the trial's condition, made when it is new.
    ConditionVotes& entry_of(const AnswerEntry& answer) {
        std::uint32_t& place = place_of_condition_[answer.condition];
        if (place != kNone) return tally_.conditions[place];
        const ConditionEntry& shown = table_.conditions[answer.condition];
        const Names& names = table_.names;
        std::uint32_t& known = place_of_id_[shown.id];
        if (known != kNone) throw two_meanings(answer, tally_.conditions[known]);
        place = known = static_cast<std::uint32_t>(tally_.conditions.size());
        ConditionVotes& entry =
            tally_.conditions.emplace_back(ConditionVotes{names[shown.id],
                                                          names[shown.hypothesis],
                                                          names[shown.validity],
                                                          names[shown.variant_a],
                                                          names[shown.variant_b],
                                                          {}});
        entry.answers.reserve(room_.at(answer.condition));
        return entry;
    }

    [[nodiscard]] base::Error two_meanings(const AnswerEntry& answer,
                                           const ConditionVotes& first) const {
        const ConditionEntry& shown = table_.conditions[answer.condition];
        const Names& names = table_.names;
        return base::bad_input(
            "{}: condition {} is {} against {} ({}, {}) in session {}, but {} against {} ({}, {}) "
            "in an earlier one: answers to different studies cannot be added up",
            table_.source, names[shown.id], names[shown.variant_a], names[shown.variant_b],
            names[shown.validity], names[shown.hypothesis],
            names[table_.sessions[answer.session].name], first.variant_a, first.variant_b,
            first.validity, first.hypothesis);
    }

    /// Whether each repeated answer is that of the trial in the same session that it repeats.
    void compare_repeats() {
        if (repeated_.empty()) return;
        using Key = std::pair<std::uint32_t, std::uint32_t>;  // session, id of the condition
        std::map<Key, const AnswerEntry*> first;
        for (const AnswerEntry& answer : table_.answers) {
            const std::uint32_t id = table_.conditions[answer.condition].id;
            if (is_vote(answer) && repeated_.contains(id)) {
                first.emplace(Key{answer.session, id}, &answer);
            }
        }
        for (const AnswerEntry& answer : table_.answers) {
            const std::int32_t participant = participant_of_[answer.session];
            if (answer.repeats == 0 || answer.kind != kind_ || participant < 0) continue;
            const auto found = first.find({answer.session, answer.repeats});
            if (found == first.end()) continue;  // what it repeats was never answered
            Successes& trials = tally_.participants[static_cast<std::size_t>(participant)].repeats;
            ++trials.n;
            if (is_same_choice(answer, *found->second)) ++trials.successes;
        }
    }

    [[nodiscard]] bool is_same_choice(const AnswerEntry& again, const AnswerEntry& first) const {
        const ConditionEntry& one = table_.conditions[again.condition];
        const ConditionEntry& other = table_.conditions[first.condition];
        const bool alike = one.variant_a == other.variant_a && one.variant_b == other.variant_b;
        const bool swapped = one.variant_a == other.variant_b && one.variant_b == other.variant_a;
        const Names& names = table_.names;
        if (!alike && !swapped) {
            throw base::bad_input(
                "{}: condition {} repeats {}, but shows {} against {} and not {} against {}",
                table_.source, names[one.id], names[other.id], names[one.variant_a],
                names[one.variant_b], names[other.variant_a], names[other.variant_b]);
        }
        return (again.a_selected == first.a_selected) == alike;
    }

    const AnswerTable& table_;
    Kind kind_;
    std::uint32_t study_;
    Tally tally_;
    OrderVotes order_;
    std::vector<std::int32_t> participant_of_;       ///< of each session; -1: does not count
    std::vector<std::uint32_t> place_of_condition_;  ///< in the tally, of the table's conditions
    std::vector<std::uint32_t> place_of_id_;         ///< the same, of ids
    std::map<std::uint32_t, std::size_t> room_;      ///< votes of the table's conditions
    std::unordered_set<std::uint32_t> repeated_;     ///< ids of conditions
};

}  // namespace

Tally tally_of(const AnswerTable& table, const std::string& study, Kind kind) {
    return Counter(table, study, kind).tally();
}

Tally tally_trials(const std::string& source, const std::vector<SessionRecord>& sessions,
                   const std::vector<TrialRecord>& trials, const std::string& study, Kind kind) {
    AnswerTable table;
    table.source = source;
    for (const SessionRecord& session : sessions) table.add(session);
    for (const TrialRecord& trial : trials) table.add(trial);
    return tally_of(table, study, kind);
}

Tally without(const Tally& tally, const std::vector<bool>& left_out) {
    Tally kept;
    kept.source = tally.source;
    kept.study = tally.study;
    kept.kind = tally.kind;
    kept.participants = tally.participants;
    kept.exclusion = tally.exclusion;
    kept.n_participants = std::count(left_out.begin(), left_out.end(), false);
    OrderVotes order;
    for (const ConditionVotes& condition : tally.conditions) {
        ConditionVotes& entry = kept.conditions.emplace_back(ConditionVotes{condition.id,
                                                                            condition.hypothesis,
                                                                            condition.validity,
                                                                            condition.variant_a,
                                                                            condition.variant_b,
                                                                            {}});
        for (const Answer& answer : condition.answers) {
            if (left_out[static_cast<std::size_t>(answer.participant)]) continue;
            entry.answers.push_back(answer);
            ++(answer.chose_b ? entry.votes.b : entry.votes.a);
            ++order.n;
            if (answer.chose_b == answer.b_second) ++order.second_chosen;
        }
    }
    kept.order = tally.order.has_value() ? Possible<OrderVotes>(order) : tally.order;
    return kept;
}

}  // namespace obscura::analysis
