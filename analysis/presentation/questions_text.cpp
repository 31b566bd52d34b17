// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/questions_text.h"

#include <fmt/format.h>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/text_layout.h"

namespace obscura::analysis {
namespace {

bool is_choice(const QuestionResult& result) {
    return result.question.kind == "choice" || result.question.kind == "choice-or-none";
}

std::string interval_cell(const Possible<Interval>& interval) {
    return interval.has_value() ? fmt::format("{:.2f} to {:.2f}", interval->low, interval->high)
                                : kNoValue;
}

std::string mean_cell(const MeanRating& rating) {
    return rating.n == 0 ? kNoValue : fmt::format("{:.2f}", rating.mean);
}

PageTable choice_table(const QuestionResult& result) {
    PageTable table{{"Condition", "A", "none", "B", "Share B, ties split", "95 % interval",
                     "Share B, Davidson", "95 % interval", "nu", "p", "p, Holm"},
                    {}};
    for (const QuestionCondition& of : result.conditions) {
        const bool split = of.split.has_value();
        const bool fitted = of.davidson.has_value();
        table.rows.push_back({of.condition, std::to_string(of.votes.a),
                              std::to_string(of.votes.none), std::to_string(of.votes.b),
                              split ? fmt::format("{:.3f}", of.split->share_b) : kNoValue,
                              split ? interval_cell(of.split->interval) : kNoValue,
                              fitted ? fmt::format("{:.3f}", of.davidson->share_b) : kNoValue,
                              fitted ? interval_cell(of.davidson->interval) : kNoValue,
                              fitted ? fmt::format("{:.2f}", of.davidson->nu) : kNoValue,
                              p_cell(of.p), p_cell(of.p_holm)});
    }
    return table;
}

PageTable image_table(const QuestionResult& result) {
    PageTable table{{"Condition", "n", "Mean A", "95 % interval", "Mean B", "95 % interval",
                     "B - A", "95 % interval", "V", "p", "p, Holm"},
                    {}};
    for (const QuestionCondition& of : result.conditions) {
        table.rows.push_back(
            {of.condition, std::to_string(of.difference.n), mean_cell(of.rating_a),
             interval_cell(of.rating_a.interval), mean_cell(of.rating_b),
             interval_cell(of.rating_b.interval), mean_cell(of.difference),
             interval_cell(of.difference.interval),
             of.signed_rank.has_value() ? fmt::format("{:g}", of.signed_rank->positive) : kNoValue,
             p_cell(of.p), p_cell(of.p_holm)});
    }
    return table;
}

PageTable pair_table(const QuestionResult& result) {
    PageTable table{{"Condition", "n", "Mean", "95 % interval"}, {}};
    for (const QuestionCondition& of : result.conditions) {
        table.rows.push_back({of.condition, std::to_string(of.rating.n), mean_cell(of.rating),
                              interval_cell(of.rating.interval)});
    }
    return table;
}

std::string text_table(const PageTable& table) {
    std::vector<TextRow> rows{table.headings};
    rows.insert(rows.end(), table.rows.begin(), table.rows.end());
    return aligned(rows, 1);
}

void put_rating(Json& object, const std::string& name, const MeanRating& rating) {
    object[name + "_n"] = rating.n;
    if (rating.n == 0) {
        put_none(object, name + "_mean", rating.interval.reason);
    } else {
        object[name + "_mean"] = rating.mean;
    }
    put_interval(object, name, rating.interval);
}

void put_signed_rank(Json& object, const Possible<SignedRankTest>& test) {
    put_p(object, "signed_rank_p",
          test.has_value() ? Possible<PValue>(test->p) : Possible<PValue>::none(test.reason));
    if (!test.has_value()) return;
    object["signed_rank_v"] = test->positive;
    object["signed_rank_n"] = test->n;
    object["signed_rank_zeros"] = test->zeros;
    object["signed_rank_exact"] = test->is_exact;
}

void put_choice(Json& entry, const QuestionCondition& of) {
    entry["count_a"] = of.votes.a;
    entry["count_none"] = of.votes.none;
    entry["count_b"] = of.votes.b;
    if (of.split.has_value()) {
        entry["share_b_split"] = of.split->share_b;
        put_interval(entry, "share_b_split", Possible<Interval>(of.split->interval));
        put_p(entry, "sign_test_p", Possible<PValue>(of.split->p));
    } else {
        put_none(entry, "share_b_split", of.split.reason);
    }
    if (!of.davidson.has_value()) {
        put_none(entry, "davidson", of.davidson.reason);
        return;
    }
    Json fit;
    fit["share_b"] = of.davidson->share_b;
    put_interval(fit, "share_b", Possible<Interval>(of.davidson->interval));
    fit["log_odds"] = of.davidson->log_odds;
    fit["standard_error"] = of.davidson->standard_error;
    fit["nu"] = of.davidson->nu;
    fit["likelihood_ratio"] = of.davidson->likelihood_ratio;
    put_p(fit, "p", Possible<PValue>(of.davidson->p));
    entry["davidson"] = fit;
}

Json pair_json(const QuestionResult& result, const QuestionCondition& of) {
    Json entry = {{"id", of.condition}};
    if (is_choice(result)) {
        put_choice(entry, of);
    } else if (result.question.each_image) {
        put_rating(entry, "a", of.rating_a);
        put_rating(entry, "b", of.rating_b);
        put_rating(entry, "difference", of.difference);
        put_signed_rank(entry, of.signed_rank);
    } else {
        put_rating(entry, "rating", of.rating);
    }
    put_p(entry, "p_value", of.p);
    put(entry, "p_holm", of.p_holm);
    return entry;
}

Json confidence_json(const ConfidenceResult& confidence) {
    Json json;
    for (const ConfidenceLevel& level : confidence.levels) {
        json["levels"].push_back(
            {{"step", level.step}, {"n", level.n}, {"agreeing", level.agreeing}});
    }
    put_rating(json, "difference", confidence.difference);
    put_signed_rank(json, confidence.signed_rank);
    return json;
}

}  // namespace

std::string question_words(const AskedQuestion& question) {
    return fmt::format("{} ({}{}): {}", question.id, question.kind,
                       question.each_image ? ", of each image" : "", question.text);
}

PageTable question_table(const QuestionResult& result) {
    if (is_choice(result)) return choice_table(result);
    return result.question.each_image ? image_table(result) : pair_table(result);
}

PageTable confidence_table(const ConfidenceResult& confidence) {
    PageTable table{{"Confidence", "Answers", "As most others", "Share"}, {}};
    for (const ConfidenceLevel& level : confidence.levels) {
        table.rows.push_back(
            {std::to_string(level.step), std::to_string(level.n), std::to_string(level.agreeing),
             percent(static_cast<double>(level.agreeing) / static_cast<double>(level.n))});
    }
    return table;
}

std::string question_note(const QuestionResult& result, const std::string& ties) {
    if (is_choice(result)) {
        return fmt::format(
            "A and B: answers for each image; none: no difference. Ties split: half a vote to each "
            "image, Wilson's interval. Davidson: of those who see a difference, by his model of "
            "ties, whose nu says how readily none is answered. p, as declared beforehand ({}): {}.",
            ties,
            ties == "davidson"
                ? "likelihood ratio of Davidson's model, and where all who saw a difference agree "
                  "the exact sign test"
                : "exact sign test of those who saw a difference");
    }
    if (result.question.each_image) {
        return "Means over participants with Student's intervals. V, p: Wilcoxon's signed-rank "
               "test "
               "of B - A within participants, exact up to 200 of them; equal ratings are left out, "
               "equal sizes share their ranks.";
    }
    std::string note = "Means over participants with Student's intervals.";
    if (result.question.kind != "confidence") return note;
    const ConfidenceResult& confidence = result.confidence;
    if (!confidence.signed_rank.has_value()) {
        return note + " Confidence against agreement with most others: no test, " +
               confidence.signed_rank.reason + '.';
    }
    return note +
           fmt::format(
               " Participants were {:.2f} steps {} of choices that most of the others shared "
               "(n {}; Wilcoxon's signed-rank V {:g}, {}{}).",
               std::abs(confidence.difference.mean),
               confidence.difference.mean < 0.0 ? "less sure" : "surer", confidence.difference.n,
               confidence.signed_rank->positive, p_words(confidence.signed_rank->p),
               confidence.signed_rank->is_exact ? ", exact" : "");
}

std::string coin_words(const QuestionsResult& questions) {
    if (questions.votes == 0) return "";
    return fmt::format(
        "{} of {} answers to the pairs saw no difference. In the tables and tests of the pairs "
        "each "
        "of them counts for the side that a coin gave it, fixed by session and pair before anybody "
        "answered; below they count as declared beforehand (ties = \"{}\").",
        questions.coins, questions.votes, questions.ties);
}

std::string correction_words(const QuestionsResult& questions) {
    if (questions.tests == 0) return "None of these questions has a test beside the pairs' own.";
    return fmt::format(
        "p, Holm: corrected over the {} of these questions and their conditions together; the "
        "pairs' own comparison is a family of its own.",
        counted(questions.tests, "test"));
}

std::string questions_text(const QuestionsResult& questions) {
    std::string text = "\nQuestions of each pair\n";
    if (const std::string coins = coin_words(questions); !coins.empty()) {
        text += wrapped(coins + '\n');
    }
    for (const QuestionResult& result : questions.results) {
        text += '\n' + wrapped(question_words(result.question) + '\n');
        text += text_table(question_table(result));
        if (!result.confidence.levels.empty()) {
            text += '\n' + text_table(confidence_table(result.confidence));
        }
        text += wrapped(question_note(result, questions.ties) + '\n');
    }
    return text + wrapped(correction_words(questions) + '\n');
}

void put_questions(Json& report, const QuestionsResult& questions) {
    Json json = {{"ties", questions.ties},
                 {"no_difference_by_coin", questions.coins},
                 {"n_tests", questions.tests}};
    json["questions"] = Json::array();
    for (const QuestionResult& result : questions.results) {
        Json entry = {{"id", result.question.id},
                      {"kind", result.question.kind},
                      {"text", result.question.text},
                      {"is_first", result.is_first}};
        entry["conditions"] = Json::array();
        for (const QuestionCondition& of : result.conditions) {
            entry["conditions"].push_back(pair_json(result, of));
        }
        if (result.question.kind == "confidence") {
            entry["against_agreement"] = confidence_json(result.confidence);
        }
        json["questions"].push_back(std::move(entry));
    }
    report["questions"] = std::move(json);
}

}  // namespace obscura::analysis
