// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/conclusions/order_words.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"

namespace obscura::analysis {
namespace {

/// How often the image shown second was chosen, in one condition or in all.
struct SecondChosen {
    std::string name;
    std::int64_t chosen = 0;
    std::int64_t n = 0;
};

std::vector<SecondChosen> second_chosen(const Analysis& analysis) {
    std::vector<SecondChosen> rows;
    for (const ConditionVotes& condition : analysis.tally.conditions) {
        SecondChosen row{condition.id, 0, 0};
        for (const Answer& answer : condition.answers) {
            ++row.n;
            if (answer.chose_b == answer.b_second) ++row.chosen;
        }
        if (row.n > 0) rows.push_back(row);
    }
    rows.push_back({"all", analysis.order_bias->votes.second_chosen, analysis.order_bias->votes.n});
    return rows;
}

std::string bias_words(const Analysis& analysis) {
    const OrderBias& bias = *analysis.order_bias;
    std::string text = fmt::format("The image shown second was chosen {} of {} times. {} ",
                                   bias.votes.second_chosen, bias.votes.n, order_words(analysis));
    if (!bias.logistic.has_value()) {
        return text + fmt::format("A regression with a term for the order is not possible: {}.",
                                  bias.logistic.reason);
    }
    const OrderBiasTest& test = *bias.logistic;
    return text + fmt::format(
                      "A logistic regression over {}, which takes every answer as independent, "
                      "says that of two equally liked images the second would be chosen {} of the "
                      "time (order term {:+.3f}, standard error {:.3f}). Each image of a pair came "
                      "first as often as second, so that an influence of the order adds noise "
                      "rather than a false preference.",
                      counted(test.conditions, "condition"), percent(test.second_share, 1),
                      test.order_term, test.standard_error);
}

}  // namespace

void add_order_bias(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("Did the order of showing matter?");
    if (!analysis.order_bias.has_value()) {
        draft.page.paragraph(fmt::format("Not known: {}.", analysis.order_bias.reason));
        return;
    }
    draft.page.paragraph(bias_words(analysis));
    IntervalPlot plot;
    plot.name = "order";
    plot.title = "Was the image shown second chosen more often?";
    plot.axis = "answers for the image shown second (%), with 95 % Wilson interval";
    plot.groups = {"one condition", "all together"};
    plot.has_line = true;
    plot.line = 50.0;
    plot.left = "first chosen";
    plot.right = "second chosen";
    plot.x_low = 0.0;
    plot.x_high = 100.0;
    PageTable table{{"Condition", "Second chosen", "Answers", "Second (%)", "95 % interval (%)"},
                    {}};
    for (const SecondChosen& row : second_chosen(analysis)) {
        const Possible<Interval> interval = wilson(row.chosen, row.n, kConfidence);
        if (!interval.has_value()) continue;
        const double share = static_cast<double>(row.chosen) / static_cast<double>(row.n);
        plot.rows.push_back({row.name, fmt::format("{} of {}", row.chosen, row.n),
                             row.name == "all" ? 1U : 0U, true, 100.0 * share,
                             100.0 * interval->low, 100.0 * interval->high});
        table.rows.push_back(
            {row.name, std::to_string(row.chosen), std::to_string(row.n),
             fmt::format("{:.1f}", 100.0 * share),
             fmt::format("{:.1f} to {:.1f}", 100.0 * interval->low, 100.0 * interval->high)});
    }
    draft.plot(
        interval_plot(plot),
        "Share of answers for the image shown second. Around 50 %: the order did not matter.");
    draft.page.table(table, "The same in numbers.");
}

}  // namespace obscura::analysis
