// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/tally.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_set>

#include "analysis/text/natural_order.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

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
        throw base::bad_input("{} has several studies, STUDY must name one of: {}", table.source,
                              fmt::join(studies, ", "));
    }
    if (chosen == kNone) {
        throw base::bad_input("STUDY {}: {} has no completed session of it, allowed are: {}", study,
                              table.source, fmt::join(studies, ", "));
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
        read_plan();
        name_study_files();
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
        for (ConditionVotes& condition : tally_.conditions) sort(condition.answers);
        return std::move(tally_);
    }

  private:
    [[nodiscard]] bool is_chosen(const SessionEntry& session) const {
        return counts(session, kind_) && session.study == study_;
    }

    void number_participants() {
        std::vector<std::uint32_t> names;
        for (const SessionEntry& session : table_.sessions) {
            if (is_chosen(session)) names.push_back(session.participant);
        }
        const auto before = [&](std::uint32_t one, std::uint32_t other) {
            return naturally_before(table_.names[one], table_.names[other]);
        };
        // A store's own names begin with the time, and so are in order.
        if (!std::is_sorted(names.begin(), names.end(), before)) {
            std::sort(names.begin(), names.end(), before);
        }
        names.erase(std::unique(names.begin(), names.end()), names.end());
        std::vector<std::int32_t> number(table_.names.size(), -1);
        for (const std::uint32_t name : names) {
            number[name] = static_cast<std::int32_t>(tally_.participants.size());
            tally_.participants.push_back({table_.names[name], {}, {}});
        }
        for (std::size_t i = 0; i < table_.sessions.size(); ++i) {
            const SessionEntry& session = table_.sessions[i];
            if (is_chosen(session)) participant_of_[i] = number[session.participant];
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
            tally_.exclusion_text = table_.names[rule];
        }
    }

    void name_study_files() {
        std::set<std::uint32_t> files;
        for (const SessionEntry& session : table_.sessions) {
            if (is_chosen(session) && session.study_sha256 != 0) files.insert(session.study_sha256);
        }
        for (const std::uint32_t file : files) tally_.study_files.push_back(table_.names[file]);
    }

    void read_plan() {
        std::uint32_t plan = kNone;
        for (const SessionEntry& session : table_.sessions) {
            if (!is_chosen(session) || session.study_plan == plan) continue;
            if (plan != kNone) {
                tally_.plan = Possible<StudyPlan>::none(
                    "the sessions carry different plans, so that none was fixed for all of them");
                return;
            }
            plan = session.study_plan;
        }
        if (plan == 0) {
            tally_.plan = Possible<StudyPlan>::none("the sessions carry no plan");
        } else {
            tally_.plan = study_plan(table_.names[plan], table_.source);
            tally_.plan_text = table_.names[plan];
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
        if (known != kNone) {
            ConditionVotes& entry = tally_.conditions[known];
            if (!is_same_thing(shown, entry) && !take_longer_names(answer, known)) {
                throw two_meanings(answer, entry);
            }
            if (entry.view != names[shown.scene]) entry.view.clear();
            place = known;
            entry.answers.reserve(entry.answers.size() + room_.at(answer.condition));
            return entry;
        }
        place = known = static_cast<std::uint32_t>(tally_.conditions.size());
        ConditionVotes& entry =
            tally_.conditions.emplace_back(ConditionVotes{names[shown.id],
                                                          names[shown.hypothesis],
                                                          names[shown.validity],
                                                          names[shown.variant_a],
                                                          names[shown.variant_b],
                                                          {},
                                                          names[shown.scene]});
        study_sha256_.push_back(table_.sessions[answer.session].study_sha256);
        entry.answers.reserve(room_.at(answer.condition));
        return entry;
    }

    /// Answers to one and the same study file may name its variants by technique and samples only
    /// (Blizzard24), as earlier versions wrote, and by what differs behind it (Blizzard24 R 0.8).
    /// The longer names stay. False where that is not what keeps the two apart.
    bool take_longer_names(const AnswerEntry& answer, std::uint32_t place) {
        const std::uint32_t sha256 = table_.sessions[answer.session].study_sha256;
        if (sha256 == 0 || sha256 != study_sha256_[place]) return false;
        const ConditionEntry& shown = table_.conditions[answer.condition];
        const Names& names = table_.names;
        ConditionVotes& entry = tally_.conditions[place];
        if (names[shown.hypothesis] != entry.hypothesis || names[shown.validity] != entry.validity)
            return false;
        const auto longer = [](const std::string& one, const std::string& other) {
            const bool goes_on = one == other || other.starts_with(one + ' ');
            return goes_on ? other : one.starts_with(other + ' ') ? one : std::string();
        };
        const std::string a = longer(entry.variant_a, names[shown.variant_a]);
        const std::string b = longer(entry.variant_b, names[shown.variant_b]);
        if (a.empty() || b.empty()) return false;
        entry.variant_a = a;
        entry.variant_b = b;
        return true;
    }

    [[nodiscard]] bool is_same_thing(const ConditionEntry& shown,
                                     const ConditionVotes& entry) const {
        const Names& names = table_.names;
        return names[shown.hypothesis] == entry.hypothesis &&
               names[shown.validity] == entry.validity &&
               names[shown.variant_a] == entry.variant_a &&
               names[shown.variant_b] == entry.variant_b;
    }

    /// By participant and trial; where a table does not number the trials, by all else.
    static void sort(std::vector<Answer>& answers) {
        const auto key = [](const Answer& answer) {
            return std::tuple(answer.participant, answer.position, answer.chose_b, answer.b_second,
                              answer.response_time_s);
        };
        const auto before = [&](const Answer& one, const Answer& other) {
            return key(one) < key(other);
        };
        if (!std::is_sorted(answers.begin(), answers.end(), before)) {
            std::sort(answers.begin(), answers.end(), before);
        }
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
        using SessionAndCondition = std::pair<std::uint32_t, std::uint32_t>;
        std::map<SessionAndCondition, const AnswerEntry*> first;
        for (const AnswerEntry& answer : table_.answers) {
            const std::uint32_t id = table_.conditions[answer.condition].id;
            if (!is_vote(answer) || !repeated_.contains(id)) continue;
            const auto [known, is_new] =
                first.emplace(SessionAndCondition{answer.session, id}, &answer);
            if (!is_new && is_earlier(answer, *known->second)) known->second = &answer;
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

    /// Of two answers to one condition; where their numbers are not known, whatever the rows'
    /// order.
    static bool is_earlier(const AnswerEntry& one, const AnswerEntry& other) {
        return std::tuple(one.trial_index, one.a_selected) <
               std::tuple(other.trial_index, other.a_selected);
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
    std::vector<std::uint32_t> study_sha256_;        ///< of the tally's conditions, when first met
    std::map<std::uint32_t, std::size_t> room_;      ///< votes of the table's conditions
    std::unordered_set<std::uint32_t> repeated_;     ///< ids of conditions
};

}  // namespace

Tally tally_of(const AnswerTable& table, const std::string& study, Kind kind) {
    return Counter(table, study, kind).tally();
}

}  // namespace obscura::analysis
