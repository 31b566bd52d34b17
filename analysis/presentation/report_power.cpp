// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"
#include "analysis/statistics/power.h"

namespace obscura::analysis {
namespace {

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

std::string tests_words(const RunPower& power) {
    return counted(static_cast<std::int64_t>(power.tests), "test");
}

PageTable power_table(const RunPower& power) {
    PageTable table{{"True share (%)", "Exact test (%)", "Chi-square test (%)",
                     fmt::format("Exact, {} (%)", tests_words(power))},
                    {}};
    for (const RunPower::At& at : power.shares) {
        table.rows.push_back({fmt::format("{:.0f}", 100.0 * at.share),
                              fmt::format("{:.1f}", 100.0 * at.exact.power),
                              fmt::format("{:.1f}", 100.0 * at.chi_square.power),
                              fmt::format("{:.1f}", 100.0 * at.holm.power)});
    }
    if (!power.shares.empty()) {
        const RunPower::At& any = power.shares.front();
        table.rows.push_back({"50 (false alarms)",
                              fmt::format("{:.1f}", 100.0 * any.exact.true_size),
                              fmt::format("{:.1f}", 100.0 * any.chi_square.true_size),
                              fmt::format("{:.1f}", 100.0 * any.holm.true_size)});
    }
    return table;
}

std::string found_words(const RunPower& power) {
    const auto words = [](const Possible<double>& share) {
        return share.has_value()
                   ? fmt::format("a preference that {} of people share or more", percent(*share, 1))
                   : std::string("no preference, however strong");
    };
    return fmt::format(
        "With {} a condition the exact test at {:g} finds, with {} probability, {}; when all {} "
        "have to stand together (Holm's correction), {}. Weaker preferences may be there and be "
        "missed: a result that is not significant is no proof that nobody saw a difference.",
        counted(power.n, "answer"), kSignificance, percent(kAskedPower), words(power.detectable),
        counted(static_cast<std::int64_t>(power.tests), "test"), words(power.detectable_holm));
}

Plot power_plot(const RunPower& power) {
    CurvePlot plot;
    plot.name = "power";
    plot.title =
        fmt::format("Power of the exact test with {} a condition", counted(power.n, "answer"));
    plot.x_axis = "true share that prefers one image (%)";
    plot.y_axis = "chance of a significant result (%)";
    plot.extra =
        "set xrange [50:100]\nset yrange [0:105]\nset ytics 20\n"
        "set arrow from graph 0, first 80 to graph 1, first 80 nohead lc rgb \"#000000\" dt "
        "(6,5)\n";
    plot.series.push_back(power_series("one test", power.n, kSignificance));
    if (power.tests > 1) {
        plot.series.push_back(power_series(fmt::format("{} tests, corrected", power.tests), power.n,
                                           kSignificance / static_cast<double>(power.tests)));
    }
    return curve_plot(plot);
}

}  // namespace

void add_power(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("What this many participants could show");
    if (!analysis.power.has_value()) {
        draft.page.paragraph(fmt::format("Not known: {}.", analysis.power.reason));
        return;
    }
    const RunPower& power = *analysis.power;
    draft.page.paragraph(found_words(power));
    draft.plot(
        power_plot(power),
        "How likely a significant result is, by how many people really prefer one image. The "
        "dashed line marks 80 %, the usual wish.");
    draft.page.table(
        power_table(power),
        "The same in numbers, for the exact test, the chi-square test as published, and "
        "the exact test at the level that passes Holm's correction whatever the other "
        "conditions give. False alarms: how often each test finds a preference that is "
        "not there.");
    draft.page.paragraph(
        "What the answers leave possible, the intervals of each share say. Power at the share that "
        "was observed is not given: it would say no more than the p-value does (Hoenig and Heisey "
        "2001). How many participants another study needs, obscura power STUDY says.");
}

}  // namespace obscura::analysis
