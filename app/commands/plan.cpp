// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/conclusions/pooling.h"
#include "app/commands/list.h"
#include "app/commands/planned_tally.h"
#include "app/commands/preregister.h"
#include "app/commands/study_argument.h"
#include "stimuli/order/balance.h"
#include "stimuli/study.h"

namespace obscura::app {
namespace {

using Json = nlohmann::ordered_json;
using stimuli::Balance;
using stimuli::SessionOrder;
using stimuli::Study;

constexpr int kMostParticipants = 1'000'000;

struct PlanOptions {
    std::string study;
    int participants = 0;
    std::filesystem::path preregister;  ///< empty: nothing is written
    bool json = false;
};

std::vector<std::string> ids_of(const Study& study) {
    std::vector<std::string> ids;
    for (const stimuli::Condition& condition : study.conditions) {
        if (!condition.practice) ids.push_back(condition.id);
    }
    return ids;
}

std::string_view first_image(const SessionOrder& session, std::size_t position) {
    return session.b_first(position) ? "b" : "a";
}

void print_sessions(const std::vector<SessionOrder>& sessions,
                    const std::vector<std::string>& ids) {
    fmt::print(
        "Who sees what: {0}-a means that of condition {0} image A is shown first.\n"
        "Squares and rows count from 0, as in trials.csv.\n\n"
        "participant  square  row  swapped  order of the conditions\n",
        ids.front());
    for (const SessionOrder& session : sessions) {
        std::string shown;
        for (std::size_t i = 0; i < session.conditions.size(); ++i) {
            shown += fmt::format("  {}-{}", ids[session.conditions[i]], first_image(session, i));
        }
        fmt::print("{:>11}  {:>6}  {:>3}  {:>7}{}\n", session.slot + 1, session.latin_square,
                   session.latin_row, session.swapped ? "yes" : "no", shown);
    }
}

/// A table of counts with the ids down the side.
void print_table(const std::string& title, const std::vector<std::string>& ids,
                 const std::vector<std::string>& heads,
                 const std::vector<std::vector<long long>>& rows) {
    std::size_t side = 0;
    for (const std::string& id : ids) side = std::max(side, id.size());
    std::size_t width = 3;
    for (const std::string& head : heads) width = std::max(width, head.size());
    for (const auto& row : rows) {
        for (const long long count : row) width = std::max(width, std::to_string(count).size());
    }
    fmt::print("\n{}\n{:>{}}", title, "", side);
    for (const std::string& head : heads) fmt::print("  {:>{}}", head, width);
    fmt::print("\n");
    for (std::size_t i = 0; i < rows.size(); ++i) {
        fmt::print("{:>{}}", ids[i], side);
        for (const long long count : rows[i]) fmt::print("  {:>{}}", count, width);
        fmt::print("\n");
    }
}

void print_verdict(bool holds, const std::string& property, const std::string& counted) {
    fmt::print("  {:<14}  {}: {}\n", holds ? "holds" : "does not hold", property, counted);
}

/// How many sessions have image A first in so many of their pairs.
void print_session_sides(const Study& study, const Balance& balance) {
    std::vector<std::string> counts;
    for (std::size_t a_first = 0; a_first < balance.sessions_with_a_first.size(); ++a_first) {
        const long long sessions = balance.sessions_with_a_first[a_first];
        if (sessions > 0) {
            counts.push_back(fmt::format("A first in {} of {} pairs in {} session{}", a_first,
                                         balance.condition_count, sessions,
                                         sessions == 1 ? "" : "s"));
        }
    }
    const std::string counted = fmt::format("{}", fmt::join(counts, ", "));
    if (study.sides == stimuli::SideOrder::kTrial) {
        print_verdict(balance.sides_hold_in_sessions(),
                      "each side first equally often in each session", counted);
    } else {
        fmt::print(
            "  {:<14}  sides change from session to session, not within one: {}\n{:>18}"
            "sides = \"trial\" does that\n",
            "by design", counted, "");
    }
}

void print_verdicts(const Study& study, const Balance& balance) {
    fmt::print("\nBalance\n");
    print_verdict(balance.rows_hold(), "each condition once in each row",
                  fmt::format("{} of {} participants", balance.complete_rows, balance.sessions));
    const std::uint64_t left = balance.sessions - balance.squares * balance.condition_count;
    print_verdict(balance.columns_hold(), "each condition once in each column of a square",
                  fmt::format("{} of {} whole squares{}", balance.latin_squares, balance.squares,
                              left == 0 ? ""
                                        : fmt::format("; the last one has {} of {} rows", left,
                                                      balance.condition_count)));
    print_verdict(balance.sides_hold(), "each image of a pair first equally often",
                  fmt::format("A first {}, B first {} in each condition", balance.a_first.front(),
                              balance.b_first.front()));
    print_session_sides(study, balance);
    const stimuli::CountRange range = stimuli::range_off_diagonal(balance.neighbours);
    print_verdict(balance.neighbours_hold(),
                  "each condition directly after each other one equally often",
                  range.low == range.high ? fmt::format("{} times", range.low)
                                          : fmt::format("{} to {} times", range.low, range.high));
    if (!balance.neighbours_hold() && study.order != stimuli::OrderKind::kWilliams) {
        fmt::print("{:>16}  order \"{}\" does not promise this; order = \"williams\" does\n", "",
                   to_string(study.order));
    }
}

void print_block(const Study& study, std::uint64_t participants) {
    const std::uint64_t block = stimuli::block_size(study.order, study.pair_count());
    const std::uint64_t whole = participants / block * block;
    if (participants == whole) {
        fmt::print("\n{} participants are {} whole block{} of {}.\n", participants,
                   participants / block, participants == block ? "" : "s", block);
    } else {
        fmt::print(
            "\n{} participants are no multiple of the block of {}, in which the order {} "
            "balances; the nearest are {}{}.\n",
            participants, block, to_string(study.order),
            whole > 0 ? fmt::format("{} and ", whole) : "", whole + block);
    }
}

std::string conditions_of(const stimuli::Hypothesis& hypothesis) {
    if (hypothesis.kind == stimuli::HypothesisKind::kPreference) {
        return fmt::format("{}", fmt::join(hypothesis.conditions, ", "));
    }
    std::vector<std::string> pairs;
    for (const auto& pair : hypothesis.pairs) {
        pairs.push_back(fmt::format("{}", fmt::join(pair, " against ")));
    }
    return fmt::format("{}", fmt::join(pairs, "; "));
}

/// The family as the answers will be tested: what cannot be pooled is said before there are any.
void print_hypotheses(const Study& study) {
    if (study.hypotheses.empty()) {
        fmt::print(
            "No [[hypothesis]]: nothing is fixed before there are data but what the conditions "
            "name.\n\n");
        return;
    }
    const analysis::Tally tally = planned_tally(study);
    fmt::print("Hypotheses, as every session will carry them\n");
    std::size_t tests = 0;
    std::vector<std::string> taken;
    for (const stimuli::Hypothesis& hypothesis : study.hypotheses) {
        const bool is_primary = hypothesis.role == stimuli::HypothesisRole::kPrimary;
        const bool is_preference = hypothesis.kind == stimuli::HypothesisKind::kPreference;
        if (is_primary) tests += is_preference ? 1 : hypothesis.pairs.size();
        fmt::print("  {}, {} {}, margin {:g} points: {}\n      {}\n", hypothesis.id,
                   to_string(hypothesis.role), to_string(hypothesis.kind),
                   100.0 * hypothesis.margin, conditions_of(hypothesis), hypothesis.statement);
        taken.insert(taken.end(), hypothesis.conditions.begin(), hypothesis.conditions.end());
        for (const auto& pair : hypothesis.pairs)
            taken.insert(taken.end(), pair.begin(), pair.end());
        if (!is_preference) continue;
        const auto pooling = pooling_of(tally, hypothesis.conditions);
        fmt::print("      {}\n", pooling.has_value()
                                     ? pooling->words
                                     : "cannot be tested, and counts as p = 1: " + pooling.reason);
    }
    fmt::print("Holm's correction is over {} test{}, those of the primary ones.\n", tests,
               tests == 1 ? "" : "s");
    for (const analysis::ConditionVotes& condition : tally.conditions) {
        if (std::find(taken.begin(), taken.end(), condition.id) != taken.end()) continue;
        fmt::print("{} is part of no hypothesis.\n", condition.id);
    }
    fmt::print("\n");
}

void print_text(const Study& study, const std::vector<SessionOrder>& sessions,
                const Balance& balance) {
    const std::vector<std::string> ids = ids_of(study);
    fmt::print("Study {}, order {}, sides {}, seed {}, {} conditions, {} participants\n\n",
               study.name, to_string(study.order), to_string(study.sides), study.seed, ids.size(),
               sessions.size());
    print_hypotheses(study);
    print_sessions(sessions, ids);
    std::vector<std::string> positions;
    for (std::size_t i = 1; i <= ids.size(); ++i) positions.push_back(std::to_string(i));
    print_table("How often each condition stood at each position", ids, positions,
                balance.at_position);
    std::vector<std::vector<long long>> firsts;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        firsts.push_back({balance.a_first[i], balance.b_first[i]});
    }
    print_table("How often each image was first", ids, {"A", "B"}, firsts);
    print_table(
        "Carry-over: how often the condition of the column came directly after the one of "
        "the row",
        ids, ids, balance.neighbours);
    print_verdicts(study, balance);
    print_block(study, sessions.size());
}

Json to_json(const Balance& balance, const std::vector<std::string>& ids) {
    const stimuli::CountRange range = stimuli::range_off_diagonal(balance.neighbours);
    return {{"conditions", ids},
            {"each_condition_once_per_row", balance.rows_hold()},
            {"each_condition_once_per_column", balance.columns_hold()},
            {"each_image_first_equally_often", balance.sides_hold()},
            {"each_side_first_equally_often_in_each_session", balance.sides_hold_in_sessions()},
            {"sessions_with_a_first", balance.sessions_with_a_first},
            {"carry_over_balanced", balance.neighbours_hold()},
            {"complete_rows", balance.complete_rows},
            {"whole_squares", balance.squares},
            {"latin_squares", balance.latin_squares},
            {"at_position", balance.at_position},
            {"a_first", balance.a_first},
            {"b_first", balance.b_first},
            {"carry_over", balance.neighbours},
            {"carry_over_low", range.low},
            {"carry_over_high", range.high}};
}

/// Written a participant at a time, since a million of them as one value would fill the memory.
void print_json(const Study& study, const stimuli::Questions& questions,
                const std::vector<SessionOrder>& sessions, const Balance& balance) {
    const std::vector<std::string> ids = ids_of(study);
    const std::uint64_t block = stimuli::block_size(study.order, static_cast<int>(ids.size()));
    const std::string fixed = stimuli::plan_json(study, questions);
    fmt::print(
        "{{\"study\": {}, \"fixed\": {}, \"order\": {}, \"sides\": {}, \"seed\": {}, "
        "\"n_participants\": {}, "
        "\"block\": {}, \"whole_blocks\": {},\n\"balance\": {},\n\"participants\": [",
        Json(study.name).dump(), fixed.empty() ? "null" : fixed,
        Json(to_string(study.order)).dump(), Json(to_string(study.sides)).dump(), study.seed,
        sessions.size(), block, sessions.size() % block == 0, to_json(balance, ids).dump());
    for (const SessionOrder& session : sessions) {
        std::vector<std::string> shown;
        std::vector<std::string> first;
        for (std::size_t i = 0; i < session.conditions.size(); ++i) {
            shown.push_back(ids[session.conditions[i]]);
            first.emplace_back(first_image(session, i));
        }
        const Json row = {{"participant", session.slot + 1},
                          {"slot", session.slot},
                          {"latin_square", session.latin_square},
                          {"latin_row", session.latin_row},
                          {"swapped", session.swapped},
                          {"first_images", first},
                          {"conditions", shown}};
        fmt::print("{}\n{}", session.slot == 0 ? "" : ",", row.dump());
    }
    fmt::print("]}}\n");
}

base::ExitCode plan(const PlanOptions& options, const Globals& globals) {
    const std::string named = study_named(options.study, globals);
    const Study study = stimuli::load_study(named, stimuli::SceneFiles::kTrusted);
    const stimuli::Questions questions = stimuli::load_questions(named);
    if (!options.preregister.empty()) {
        const auto document = preregister(study, {options.preregister, globals.data,
                                                  options.participants, globals.quiet, questions});
        fmt::print(stderr, "registered {}\n", document.string());
    }
    const int n = study.pair_count();
    const auto sessions = stimuli::session_orders(
        study.order, n, study.seed, static_cast<std::uint64_t>(options.participants), study.sides);
    const Balance balance = stimuli::balance_of(sessions, n);
    if (options.json) {
        print_json(study, questions, sessions, balance);
    } else {
        print_text(study, sessions, balance);
    }
    return base::ExitCode::kDone;
}

}  // namespace

Command plan_command() {
    return {"plan", "Print who sees what, with proof of its balance",
            [](const Options& options, const Globals& globals) -> std::function<base::ExitCode()> {
                auto chosen = std::make_shared<PlanOptions>();
                add_study(options, chosen->study);
                options
                    .add("--participants", chosen->participants,
                         "How many participants complete the study")
                    .required()
                    .between(1, kMostParticipants);
                options.add_flag("--json", chosen->json, "Print JSON");
                options
                    .add("--preregister", chosen->preregister,
                         "Write FOLDER/preregistration.md: hypotheses, participants and their "
                         "power, order, rules and analysis, with the SHA-256 of the study "
                         "file and of every image; obscura analyze --preregistered compares")
                    .type("FOLDER");
                return [chosen, &globals] { return plan(*chosen, globals); };
            }};
}

}  // namespace obscura::app
