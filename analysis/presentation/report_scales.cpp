// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"

namespace obscura::analysis {

void add_scales(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("All variants on one scale");
    if (analysis.scales.empty()) {
        draft.page.paragraph("No two variants were compared with answers, so there is no scale.");
        return;
    }
    draft.page.paragraph(
        "Pairs that share a variant put all of them on one scale, over all scenes together. Its "
        "unit "
        "is the just objectionable difference (JOD): a variant 1 JOD above another is chosen over "
        "it "
        "by 75 %.");
    int number = 0;
    for (const VariantScale& scale : analysis.scales) {
        ++number;
        if (!scale.thurstone.has_value()) {
            draft.page.paragraph(fmt::format("There is no scale of {}: {}.", listed(scale.variants),
                                             scale.thurstone.reason));
            continue;
        }
        IntervalPlot plot;
        plot.name = analysis.scales.size() == 1 ? "scale" : fmt::format("scale-{}", number);
        plot.title = "Preference on one scale";
        plot.axis = fmt::format("JOD above {} (bars: 95 % interval)", scale.variants.front());
        plot.has_line = true;
        plot.line = 0.0;
        plot.left = "less preferred";
        plot.right = "more preferred";
        PageTable table{{"Variant", "JOD", "SE (JOD)", "95 % interval (JOD)",
                         "Bradley-Terry (log odds)", "SE (log odds)"},
                        {}};
        std::vector<std::size_t> order(scale.variants.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](std::size_t one, std::size_t other) {
            return scale.thurstone->values[one] > scale.thurstone->values[other];
        });
        for (const std::size_t i : order) {
            const double value = scale.thurstone->values[i];
            const bool has_errors = scale.jod_intervals.has_value();
            const Interval bounds = has_errors ? (*scale.jod_intervals)[i] : Interval{value, value};
            const auto error = [&](const Possible<Scale>& own) {
                return has_errors && own.has_value()
                           ? fmt::format("{:.3f}", own->standard_errors[i])
                           : std::string(kNoValue);
            };
            plot.rows.push_back({scale.variants[i], i == 0 ? "reference" : "", 0, true, value,
                                 bounds.low, bounds.high});
            const Possible<Scale>& odds = scale.bradley_terry;
            table.rows.push_back(
                {scale.variants[i], fmt::format("{:+.3f}", value), error(scale.thurstone),
                 i == 0       ? "reference"
                 : has_errors ? fmt::format("{:+.2f} to {:+.2f}", bounds.low, bounds.high)
                              : kNoValue,
                 odds.has_value() ? fmt::format("{:+.3f}", odds->values[i]) : kNoValue,
                 error(odds)});
        }
        draft.plot(interval_plot(plot),
                   fmt::format("Thurstone's Case V by maximum likelihood; {} is the reference and "
                               "stands at 0.",
                               scale.variants.front()));
        draft.page.table(table, "The same in numbers, with the scale of Bradley and Terry. " +
                                    scale_words(scale));
    }
}

}  // namespace obscura::analysis
