// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/questions.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>

#include "analysis/statistics/holm.h"
#include "analysis/store/store.h"
#include "analysis/text/natural_order.h"

namespace obscura::analysis {
namespace {

using ByParticipant = std::map<std::string, double>;

MeanRating mean_rating(const std::vector<double>& values) {
    MeanRating rating;
    rating.n = static_cast<std::int64_t>(values.size());
    if (values.empty()) return rating;
    for (const double value : values) rating.mean += value / static_cast<double>(values.size());
    const Possible<MeanTest> test = mean_test(values);
    rating.interval = test.has_value() ? Possible<Interval>(test->interval)
                                       : Possible<Interval>::none(test.reason);
    return rating;
}

std::vector<double> values_of(const ByParticipant& given) {
    std::vector<double> values;
    for (const auto& [participant, value] : given) values.push_back(value);
    return values;
}

double step_of(const QuestionAnswer& answer) {
    return static_cast<double>(std::strtol(answer.answer.c_str(), nullptr, 10));
}

struct Natural {
    bool operator()(const std::string& one, const std::string& other) const {
        return naturally_before(one, other);
    }
};
using ByCondition = std::map<std::string, std::vector<const PairAnswer*>, Natural>;

void count_choices(const std::vector<const PairAnswer*>& answers, const std::string& ties,
                   QuestionCondition& result) {
    for (const PairAnswer* given : answers) {
        const std::string& answer = given->answer.answer;
        ++(answer == "A" ? result.votes.a : answer == "B" ? result.votes.b : result.votes.none);
    }
    result.split = split_share(result.votes);
    result.davidson = davidson_pair(result.votes);
    const bool by_davidson = ties == "davidson" && result.davidson.has_value();
    if (by_davidson) {
        result.p = result.davidson->p;
    } else {
        // Where all who saw a difference agree the model has no end, the sign test has.
        result.p = result.split.has_value() ? Possible<PValue>(result.split->p)
                                            : Possible<PValue>::none(result.split.reason);
    }
}

void rate(const std::vector<const PairAnswer*>& answers, QuestionCondition& result) {
    std::map<std::string, ByParticipant> by_image;
    for (const PairAnswer* given : answers) {
        by_image[given->answer.about][given->participant] = step_of(given->answer);
    }
    result.rating = mean_rating(values_of(by_image[kAboutPair]));
    result.rating_a = mean_rating(values_of(by_image["A"]));
    result.rating_b = mean_rating(values_of(by_image["B"]));
    std::vector<double> differences;
    for (const auto& [participant, rating] : by_image["A"]) {
        const auto other = by_image["B"].find(participant);
        if (other != by_image["B"].end()) differences.push_back(other->second - rating);
    }
    if (differences.empty()) return;
    result.difference = mean_rating(differences);
    result.signed_rank = signed_rank(differences);
    result.p = result.signed_rank.has_value() ? Possible<PValue>(result.signed_rank->p)
                                              : Possible<PValue>::none(result.signed_rank.reason);
}

/// Whether the choice is that of most of the other participants; nothing: as many chose the other.
std::optional<bool> agrees(const PairAnswer& given, const TiedVotes& all) {
    const std::int64_t same = (given.chose_b ? all.b : all.a) - 1;
    const std::int64_t other = given.chose_b ? all.a : all.b;
    if (same == other) return std::nullopt;
    return same > other;
}

ConfidenceResult confidence_of(const ByCondition& conditions) {
    ConfidenceResult result;
    std::map<int, ConfidenceLevel> levels;
    struct Sums {
        double sum[2] = {0.0, 0.0};
        double n[2] = {0.0, 0.0};
    };
    std::map<std::string, Sums> participants;
    for (const auto& [condition, answers] : conditions) {
        TiedVotes all;
        for (const PairAnswer* given : answers) ++(given->chose_b ? all.b : all.a);
        for (const PairAnswer* given : answers) {
            const std::optional<bool> with_most = agrees(*given, all);
            if (!with_most) continue;
            const double step = step_of(given->answer);
            ConfidenceLevel& level = levels[static_cast<int>(step)];
            level.step = static_cast<int>(step);
            ++level.n;
            if (*with_most) ++level.agreeing;
            Sums& own = participants[given->participant];
            own.sum[*with_most ? 1 : 0] += step;
            own.n[*with_most ? 1 : 0] += 1.0;
        }
    }
    for (const auto& [step, level] : levels) result.levels.push_back(level);
    std::vector<double> differences;
    for (const auto& [participant, own] : participants) {
        if (own.n[0] == 0.0 || own.n[1] == 0.0) continue;
        differences.push_back(own.sum[1] / own.n[1] - own.sum[0] / own.n[0]);
    }
    result.difference = mean_rating(differences);
    result.signed_rank = differences.empty()
                             ? Possible<SignedRankTest>::none("nobody chose both ways")
                             : signed_rank(differences);
    return result;
}

QuestionResult result_of(const AskedQuestion& question, const QuestionData& data) {
    QuestionResult result;
    result.question = question;
    ByCondition conditions;
    for (const PairAnswer& given : data.answers) {
        if (given.answer.question == question.id) {
            conditions[given.answer.condition].push_back(&given);
        }
    }
    for (const auto& [condition, answers] : conditions) {
        QuestionCondition& of = result.conditions.emplace_back();
        of.condition = condition;
        if (question.kind == "rating" || question.kind == "confidence") {
            rate(answers, of);
        } else {
            count_choices(answers, data.asked.ties, of);
        }
    }
    if (question.kind == "confidence") result.confidence = confidence_of(conditions);
    return result;
}

/// One family: the conditions of all questions, but of the first, which has the main one.
void correct(QuestionsResult& results) {
    std::vector<QuestionCondition*> tested;
    std::vector<double> p_values;
    for (QuestionResult& result : results.results) {
        if (result.is_first) continue;
        for (QuestionCondition& condition : result.conditions) {
            if (!condition.p.has_value()) continue;
            tested.push_back(&condition);
            p_values.push_back(condition.p->p);
        }
    }
    const std::vector<double> corrected = holm(p_values);
    for (std::size_t i = 0; i < tested.size(); ++i) tested[i]->p_holm = corrected[i];
    results.tests = static_cast<std::int64_t>(tested.size());
}

}  // namespace

QuestionsResult analyse_questions(const QuestionData& data) {
    QuestionsResult results;
    results.ties = data.asked.ties;
    for (const AskedQuestion& question : data.asked.list) {
        const bool is_first = &question == &data.asked.list.front();
        if (is_first && question.kind == "choice") continue;
        results.results.push_back(result_of(question, data));
        results.results.back().is_first = is_first;
        if (!is_first) continue;
        for (const QuestionCondition& condition : results.results.back().conditions) {
            results.coins += condition.votes.none;
            results.votes += condition.votes.n();
        }
    }
    correct(results);
    return results;
}

namespace {

struct Taken {
    std::map<std::string, std::string> participants;  ///< by completed session
    std::set<std::string> plans;
};

Taken sessions_of(Store& store, const std::string& study, Kind kind) {
    Taken taken;
    store.each_session([&](const SessionRecord& session) {
        if (session.study != study || session.kind != kind ||
            session.state != SessionState::kCompleted) {
            return;
        }
        taken.plans.insert(session.study_plan);
        taken.participants[session.session_id] = session.participant_id;
    });
    return taken;
}

/// Whether B was chosen, by session and place of what people vote on.
std::map<std::pair<std::string, int>, bool> chosen_by_pair(Store& store, const Taken& taken,
                                                           Kind kind) {
    std::map<std::pair<std::string, int>, bool> votes;
    store.each_trial([&](const TrialRecord& trial, const SessionRecord&) {
        const bool is_vote = trial.kind == kind && trial.repeats.empty();
        if (!is_vote || !taken.participants.contains(trial.session_id)) return;
        votes[{trial.session_id, trial.trial_index}] = !trial.is_A_selected;
    });
    return votes;
}

}  // namespace

Possible<QuestionData> read_question_data(Store& store, const std::string& study, Kind kind) {
    const Taken taken = sessions_of(store, study, kind);
    const bool any = std::any_of(taken.plans.begin(), taken.plans.end(), [](const auto& plan) {
        return !asked_questions(plan).list.empty();
    });
    if (!any) return Possible<QuestionData>::none(kNothingElseAsked);
    if (taken.plans.size() != 1) {
        return Possible<QuestionData>::none(
            "not all sessions asked the same questions of the pairs: only the pairs are analysed");
    }
    QuestionData data;
    data.asked = asked_questions(*taken.plans.begin());
    const auto votes = chosen_by_pair(store, taken, kind);
    store.each_session_with_events(
        [&](const SessionRecord& session, const std::vector<EventRecord>& events) {
            if (!taken.participants.contains(session.session_id)) return;
            for (QuestionAnswer& answer : answers_among(events)) {
                const auto vote = votes.find({answer.session_id, answer.trial_index});
                if (vote == votes.end()) continue;
                data.answers.push_back({session.participant_id, std::move(answer), vote->second});
            }
        });
    return data;
}

}  // namespace obscura::analysis
