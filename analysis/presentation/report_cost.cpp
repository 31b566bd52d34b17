// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/conclusions/preference_and_cost.h"
#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"

namespace obscura::analysis {
namespace {

/// What the answers are set against.
struct Quantity {
    const char* file;        ///< stem of the plot
    const char* axis;        ///< with unit
    const char* noun;        ///< in running text
    const char* step_words;  ///< of `step`
    double step;             ///< that slopes are quoted for
    Possible<double> MeasuredPair::*difference;
    const PreferenceCurve PreferenceAndCost::*curve;
};

const Quantity kError{"preference-error",
                      "difference in error, RMSE of accessibility, B minus A",
                      "error",
                      "0.01 of RMSE",
                      0.01,
                      &MeasuredPair::error_difference,
                      &PreferenceAndCost::by_error};
const Quantity kTime{"preference-ms",
                     "difference in cost, milliseconds a frame, B minus A",
                     "milliseconds",
                     "1 ms",
                     1.0,
                     &MeasuredPair::ms_difference,
                     &PreferenceAndCost::by_ms};

double logistic(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

Plot plot_of(const PreferenceAndCost& joined, const Quantity& quantity) {
    DependencePlot plot;
    plot.name = quantity.file;
    plot.title = fmt::format("Preference against difference in {}", quantity.noun);
    plot.x_axis = quantity.axis;
    plot.groups = {"low validity", "moderate validity", "high validity", "other"};
    double low = 0.0;
    double high = 0.0;
    for (const MeasuredPair& pair : joined.pairs) {
        const Possible<double>& x = pair.*quantity.difference;
        const Preference& preference = pair.condition->preference;
        if (!x.has_value() || !preference.share_b.has_value()) continue;
        low = std::min(low, *x);
        high = std::max(high, *x);
        plot.points.push_back(
            {pair.condition->condition.id, level_number(pair.condition->condition.validity), *x,
             *preference.share_b, preference.wilson->low, preference.wilson->high});
    }
    const Possible<PreferenceFit>& fit = (joined.*quantity.curve).overall;
    if (fit.has_value()) {
        constexpr int kSteps = 60;
        for (int i = 0; i <= kSteps; ++i) {
            const double x = low + (high - low) * i / kSteps;
            const double one = logistic(fit->slope_interval.low * x);
            const double other = logistic(fit->slope_interval.high * x);
            plot.curve.push_back({x, fit->share_b(x), std::min(one, other), std::max(one, other)});
        }
    }
    return dependence_plot(plot);
}

std::vector<std::string> fit_row(const std::string& level, const Possible<PreferenceFit>& fit,
                                 const Quantity& quantity) {
    if (!fit.has_value()) {
        return {level, kNoValue, kNoValue, kNoValue, kNoValue, kNoValue, "none: " + fit.reason};
    }
    const std::string enough =
        fit->difference_75_interval.has_value()
            ? fmt::format("{:+.3g} ({:+.3g} to {:+.3g})", *fit->difference_75,
                          fit->difference_75_interval->low, fit->difference_75_interval->high)
            : "unknown";
    return {level,
            std::to_string(fit->points),
            fmt::format("{:+.3f}", fit->slope * quantity.step),
            fmt::format("{:+.3f} to {:+.3f}", fit->slope_interval.low * quantity.step,
                        fit->slope_interval.high * quantity.step),
            fmt::format("{:.3f}", fit->likelihood_ratio.statistic),
            p_cell(Possible<PValue>(fit->likelihood_ratio.p)),
            enough};
}

PageTable fits_table(const PreferenceCurve& curve, const Quantity& quantity) {
    PageTable table{{"Validity", "Pairs", fmt::format("Log odds for {}", quantity.step_words),
                     "95 % interval", "Likelihood ratio", "p", "75 % choose B at"},
                    {}};
    table.rows.push_back(fit_row("all", curve.overall, quantity));
    for (const auto& [level, fit] : curve.by_validity) {
        table.rows.push_back(fit_row(level, fit, quantity));
    }
    return table;
}

/// How much error people notice, as far as the votes say.
std::string error_words(const PreferenceAndCost& joined) {
    const Possible<PreferenceFit>& fit = joined.by_error.overall;
    if (!fit.has_value()) {
        return fmt::format("How much error people notice here is unknown: {}.", fit.reason);
    }
    if (!fit->difference_75_interval.has_value()) {
        return fmt::format(
            "How much error people notice here is unknown. Over {} the log odds of choosing an "
            "image "
            "change by {:+.3f} for each {} that it is worse (95 % interval {:+.3f} to {:+.3f}), "
            "which holds 0: the answers allow that people do not care about error at all, and that "
            "they care in either direction.",
            counted(static_cast<std::int64_t>(fit->points), "pair"), fit->slope * kError.step,
            kError.step_words, fit->slope_interval.low * kError.step,
            fit->slope_interval.high * kError.step);
    }
    const double enough = std::abs(*fit->difference_75);
    const double one = std::abs(fit->difference_75_interval->low);
    const double other = std::abs(fit->difference_75_interval->high);
    std::string text = fmt::format(
        "75 % choose the {} accurate image when the two differ by {:.3g} of RMSE (95 % interval "
        "{:.3g} "
        "to {:.3g}; {}).",
        fit->slope < 0.0 ? "more" : "less", enough, std::min(one, other), std::max(one, other),
        p_words(fit->likelihood_ratio.p));
    double largest = 0.0;
    for (const MeasuredPair& pair : joined.pairs) {
        if (pair.error_difference.has_value()) {
            largest = std::max(largest, std::abs(*pair.error_difference));
        }
    }
    if (enough > largest) {
        text += fmt::format(
            " No pair shown differs by more than {:.3g}, so this lies beyond what was seen: a "
            "guess.",
            largest);
    }
    return text;
}

/// What leaving the dearer image out would save, over the pairs.
std::string savings_words(const PreferenceAndCost& joined) {
    std::vector<double> savings;
    for (const MeasuredPair& pair : joined.pairs) {
        if (pair.ms_difference.has_value()) savings.push_back(std::abs(*pair.ms_difference));
    }
    if (savings.empty()) return "What not computing it would save was not measured.";
    const auto [low, high] = std::minmax_element(savings.begin(), savings.end());
    return fmt::format(
        "Showing the cheaper image of a pair instead of the dearer one would save {:.2f} to {:.2f} "
        "ms a frame{}{}.",
        *low, *high,
        joined.width > 0 ? fmt::format(" at {} × {}", joined.width, joined.height) : "",
        joined.device.empty() ? "" : fmt::format(" on {}", joined.device));
}

PageTable pairs_table(const PreferenceAndCost& joined) {
    PageTable table{{"Condition", "Validity", "A", "B", "RMSE A", "RMSE B", "B minus A", "ms A",
                     "ms B", "ms, B minus A", "B (%)"},
                    {}};
    for (const MeasuredPair& pair : joined.pairs) {
        const ConditionVotes& condition = pair.condition->condition;
        const auto with_sign = [](const Possible<double>& value, int decimals) {
            return value.has_value() ? fmt::format("{:+.{}f}", *value, decimals) : kNoValue;
        };
        const Possible<double>& share = pair.condition->preference.share_b;
        table.rows.push_back(
            {condition.id, condition.validity, condition.variant_a, condition.variant_b,
             cell(pair.a.rmse, 4), cell(pair.b.rmse, 4), with_sign(pair.error_difference, 4),
             cell(pair.a.ms_median, 2), cell(pair.b.ms_median, 2), with_sign(pair.ms_difference, 2),
             share.has_value() ? fmt::format("{:.1f}", 100.0 * *share) : kNoValue});
    }
    return table;
}

void add_curve(ReportDraft& draft, const PreferenceAndCost& joined, const Quantity& quantity) {
    draft.page.heading(fmt::format("By difference in {}", quantity.noun), 3);
    draft.plot(plot_of(joined, quantity),
               "Each point is a pair with the 95 % Wilson interval of its share. The line is the "
               "logistic fit through the origin, grey its 95 % band; a band that holds the dashed "
               "line at 50 % everywhere says that no dependence was found.");
    draft.page.table(fits_table(joined.*quantity.curve, quantity),
                     "Logistic fit through the origin (two images that do not differ are chosen "
                     "alike), by maximum "
                     "likelihood with a profile interval, answers taken as independent. Unknown: "
                     "the interval of "
                     "the slope holds 0.");
}

}  // namespace

void add_preference_and_cost(ReportDraft& draft) {
    const ReportInput& input = draft.input;
    draft.page.heading("How much error do people notice, and what would not computing it save?");
    if (!input.measurement) {
        draft.page.paragraph(
            fmt::format("Unknown: {}. obscura measure writes the table of each technique's error "
                        "and milliseconds that this part is made from.",
                        input.measurement_unknown));
        return;
    }
    const PreferenceAndCost joined =
        preference_and_cost(input.analysis.conditions, input.images, *input.measurement);
    if (joined.pairs.empty()) {
        draft.page.paragraph(
            fmt::format("Unknown: no condition has both its images in the measurement {}.",
                        input.measurement->source));
    } else {
        draft.page.paragraph(error_words(joined));
        draft.page.paragraph(savings_words(joined));
        if (is_published_votes(input.analysis.tally)) {
            draft.page.notice(
                "The answers are about the thesis's own images, error and milliseconds about this "
                "program's images of stand-in scenes: the two are related here only as far as the "
                "scenes are alike.");
        }
        draft.page.table(
            pairs_table(joined),
            fmt::format("Error and cost of each pair's two images, from {}. Error: root "
                        "mean square of the accessibility (0 to 1) against the "
                        "ray-traced truth. Cost: median milliseconds of the technique "
                        "and its filter.",
                        input.measurement->source));
        add_curve(draft, joined, kError);
        add_curve(draft, joined, kTime);
    }
    if (!joined.not_joined.empty()) {
        draft.page.paragraph("Conditions without a measurement:");
        draft.page.list(joined.not_joined);
    }
}

}  // namespace obscura::analysis
