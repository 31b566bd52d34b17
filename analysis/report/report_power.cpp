// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/report/report_parts.h"
#include "analysis/report/report_plots.h"
#include "analysis/report/verdict.h"
#include "analysis/report/words.h"
#include "analysis/statistics/power.h"

namespace obscura::analysis {
namespace {

/// The conditions with votes that the tests are about.
struct Tested {
    std::int64_t fewest = 0;  ///< answers in the condition that has the fewest
    std::int64_t most = 0;
    int conditions = 0;
};

Tested tested_of(const Analysis& analysis) {
    Tested tested;
    for (const ConditionResult& result : analysis.conditions) {
        const std::int64_t n = result.condition.votes.n();
        if (n == 0) continue;
        tested.fewest = tested.conditions == 0 ? n : std::min(tested.fewest, n);
        tested.most = std::max(tested.most, n);
        ++tested.conditions;
    }
    return tested;
}

/// The smallest share above one half that the exact test finds with kPowerToHave; nothing where it
/// finds none.
Possible<double> share_found(std::int64_t n, double level) {
    constexpr double kLargest = 1.0 - 1e-9;
    constexpr int kHalvings = 40;
    const auto power = [&](double share) {
        return power_of(SplitTest::kExact, n, share, level).power;
    };
    if (power(kLargest) < kPowerToHave) return Possible<double>::none("too few answers");
    double low = 0.5;
    double high = kLargest;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (low + high) / 2.0;
        (power(middle) < kPowerToHave ? low : high) = middle;
    }
    return high;
}

Series power_series(const std::string& title, std::int64_t n, double level) {
    Series series;
    series.title = title;
    for (int percent_b = 50; percent_b <= 99; ++percent_b) {
        const double share = percent_b / 100.0;
        series.points.emplace_back(percent_b,
                                   100.0 * power_of(SplitTest::kExact, n, share, level).power);
    }
    return series;
}

std::string needed_cell(double share, double level) {
    if (std::abs(share - 0.5) < kSmallestEffect) return kNoValue;
    const double favoured = std::min(std::max(share, 1.0 - share), 1.0 - 1e-9);
    const Possible<std::int64_t> n =
        participants_needed(SplitTest::kExact, favoured, level, kPowerToHave);
    return n.has_value() ? std::to_string(*n) : kNoValue;
}

/// How many participants would show each share that was met.
Table needed_table(const Analysis& analysis, double corrected) {
    Table table{{"Condition", "Votes A : B", "B (%)", "Answers", "Needed, one test",
                 fmt::format("Needed, p < {:.4f}", corrected)},
                {}};
    for (const ConditionResult* result : by_validity(analysis)) {
        const Possible<double>& share = result->preference.share_b;
        const Votes& votes = result->condition.votes;
        table.rows.push_back({result->condition.id, fmt::format("{} : {}", votes.a, votes.b),
                              share.has_value() ? fmt::format("{:.1f}", 100.0 * *share) : kNoValue,
                              std::to_string(votes.n()),
                              share.has_value() ? needed_cell(*share, kSignificance) : kNoValue,
                              share.has_value() ? needed_cell(*share, corrected) : kNoValue});
    }
    return table;
}

std::string found_words(const Tested& tested, double corrected) {
    const Possible<double> alone = share_found(tested.fewest, kSignificance);
    const Possible<double> together = share_found(tested.fewest, corrected);
    const auto words = [](const Possible<double>& share) {
        return share.has_value() ? percent(*share, 1) : std::string("no share at all");
    };
    return fmt::format(
        "With {} a condition the exact test at {:g} finds, with {} probability, a preference that "
        "{} of people share or more; when all {} have to stand together (Holm's first step, p < "
        "{:.4f}) {}. Weaker preferences may be there and be missed: a result that is not "
        "significant is no proof that nobody saw a difference.",
        counted(tested.fewest, "answer"), kSignificance, percent(kPowerToHave), words(alone),
        counted(tested.conditions, "test"), corrected, words(together));
}

}  // namespace

void add_power(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("What this many participants could show");
    const Tested tested = tested_of(analysis);
    if (tested.conditions == 0) {
        draft.page.paragraph("Nothing: there are no answers.");
        return;
    }
    if (tested.most > kMostParticipants) {
        draft.page.paragraph(fmt::format(
            "More than {} answers: any difference worth the name shows.", kMostParticipants));
        return;
    }
    const double corrected = kSignificance / tested.conditions;
    draft.page.paragraph(found_words(tested, corrected));
    CurvePlot plot;
    plot.name = "power";
    plot.title = fmt::format("Power of the exact test with {} answers", tested.fewest);
    plot.x_axis = "true share that prefers one image (%)";
    plot.y_axis = "chance of a significant result (%)";
    plot.extra =
        "set xrange [50:100]\nset yrange [0:105]\nset ytics 20\n"
        "set arrow from graph 0, first 80 to graph 1, first 80 nohead lc rgb \"#000000\" dt "
        "(6,5)\n";
    plot.series.push_back(power_series(fmt::format("p < {:g}, one test", kSignificance),
                                       tested.fewest, kSignificance));
    Table table{{"True share (%)", "Power, one test (%)", "Power, corrected (%)"}, {}};
    if (tested.conditions > 1) {
        plot.series.push_back(
            power_series(fmt::format("p < {:.4f}, {} tests", corrected, tested.conditions),
                         tested.fewest, corrected));
    }
    for (int share = 55; share <= 90; share += 5) {
        table.rows.push_back(
            {std::to_string(share),
             fmt::format("{:.1f}", 100.0 * power_of(SplitTest::kExact, tested.fewest, share / 100.0,
                                                    kSignificance)
                                               .power),
             fmt::format(
                 "{:.1f}",
                 100.0 *
                     power_of(SplitTest::kExact, tested.fewest, share / 100.0, corrected).power)});
    }
    draft.plot(
        curve_plot(plot),
        "How likely a significant result is, by how many people really prefer one image. The "
        "dashed line marks 80 %, the usual wish.");
    draft.page.table(table,
                     fmt::format("The same in numbers, for {}.", counted(tested.fewest, "answer")));
    draft.page.heading("How many participants would have been needed", 3);
    draft.page.table(
        needed_table(analysis, corrected),
        fmt::format(
            "If the share met were the true one: participants for {} power with the exact "
            "test, for one test and at the level that holds over all conditions. No number "
            "where the votes are even. Shares met by chance are often too far from one half, "
            "so plan for more.",
            percent(kPowerToHave)));
}

}  // namespace obscura::analysis
