// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/answers.h"
#include "analysis/exclusion.h"
#include "analysis/statistics/possible.h"
#include "analysis/store/records.h"
#include "analysis/study_plan.h"

namespace obscura::analysis {

/// One vote, and who gave it.
struct Answer {
    std::int32_t participant = 0;  ///< number of the participant in the tally, from 0
    bool chose_b = false;
    bool b_second = false;  ///< B was shown second; has no meaning where Tally::order has no value
    std::int32_t position = -1;    ///< number of the trial in its session, from 0; -1: not known
    double response_time_s = 0.0;  ///< 0: not known
};

/// What one condition is, and the votes it got.
struct ConditionVotes {
    std::string id;
    std::string hypothesis;  ///< may be empty
    std::string validity;    ///< low, moderate or high
    std::string variant_a;
    std::string variant_b;
    Votes votes;
    /// What was looked at, whatever the light: the scene, with the camera where that is known;
    /// empty: not known, or several.
    std::string view = {};
    std::vector<Answer> answers = {};  ///< each vote; empty where only the counts are known
};

/// Which image was chosen, by the order of showing.
struct OrderVotes {
    std::int64_t n = 0;
    std::int64_t second_chosen = 0;
};

/// How many of some trials came out as hoped.
struct Successes {
    std::int64_t n = 0;
    std::int64_t successes = 0;
};

/// Who voted, and how attentively.
struct ParticipantTrials {
    std::string id;
    Successes catch_trials;  ///< with the expected answer
    Successes repeats;       ///< with the same answer as the trial that they repeat
};

/// What the tests start from.
struct Tally {
    std::string source;        ///< the store's URL or the file
    std::string study;         ///< empty: not known
    std::optional<Kind> kind;  ///< nothing: the counts do not say
    Possible<std::int64_t> n_participants = Possible<std::int64_t>::none("not counted");
    std::vector<ConditionVotes> conditions;
    Possible<OrderVotes> order = Possible<OrderVotes>::none("not counted");
    /// By number, in natural order of their ids; empty where only counts are known.
    std::vector<ParticipantTrials> participants;
    /// Whether it was asked, beside the study's own hypotheses, if the preference depends on
    /// validity. The built-in study asks it in any case.
    bool asks_validity = false;
    /// The rule that all sessions carry.
    Possible<ExclusionRule> exclusion = Possible<ExclusionRule>::none("counts carry no rule");
    /// What all sessions carry that the study fixed before it had data.
    Possible<StudyPlan> plan = Possible<StudyPlan>::none("counts carry no plan");
    std::string plan_text;       ///< what all sessions carry as study_plan; empty: nothing alike
    std::string exclusion_text;  ///< the same of their rule of exclusion
    std::vector<std::string> study_files = {};  ///< SHA-256 of the sessions' study files, if known
    /// Participants at earlier looks at these answers, as far as somebody remembers them.
    std::vector<std::int64_t> looks_before = {};
    std::vector<std::string> notes;  ///< what the reader of a file passed over or took for granted
};

/// Votes of the completed sessions of one kind (participant or simulated) of one study; practice,
/// catch and repeated trials are no votes. `study` may be empty when there is only one. Conditions
/// and participants are in natural order of their names (C2 before C10), the answers of a condition
/// in that of participants and trials: the order of rows says nothing. Throws bad input when no
/// such session is there (saying what there is instead), when several studies are there and none is
/// named, when a condition has not the same variants, validity or hypothesis in all sessions, when
/// a trial repeats a condition with other variants, and for a rule of exclusion or plan that is
/// none.
[[nodiscard]] Tally tally_of(const AnswerTable& table, const std::string& study, Kind kind);

/// The same of records.
[[nodiscard]] Tally tally_trials(const std::string& source,
                                 const std::vector<SessionRecord>& sessions,
                                 const std::vector<TrialRecord>& trials, const std::string& study,
                                 Kind kind);

/// The same without the participants whose place in `left_out` is true. Those who stay keep their
/// numbers; Tally::participants has them all.
[[nodiscard]] Tally without(const Tally& tally, const std::vector<bool>& left_out);

/// Gives each condition whose scene has a name in `views` that as its view: scenes of one name show
/// the same thing by the same camera, at several levels.
void name_views(Tally& tally, const std::map<std::string, std::string>& views);

}  // namespace obscura::analysis
