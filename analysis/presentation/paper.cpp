// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/html_table.h"
#include "analysis/presentation/journal.h"
#include "analysis/presentation/latex.h"
#include "analysis/presentation/paper_words.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"
#include "analysis/table/csv.h"

namespace obscura::analysis {
namespace {

/// The widths of one and of two columns that most journals print.
constexpr double kColumn_mm = 85.0;
constexpr double kPage_mm = 174.0;

struct PaperTable {
    PageTable table;
    std::string caption;
};

struct PaperFigure {
    Plot plot;
    std::string caption;
};

std::string plain_share(const Possible<double>& share) {
    return share.has_value() ? fmt::format("{:.1f}", 100.0 * *share) : kNoValue;
}
std::string plain_interval(const Possible<Interval>& interval, double scale = 100.0) {
    if (!interval.has_value()) return kNoValue;
    return fmt::format("{:.1f} to {:.1f}", scale * interval->low, scale * interval->high);
}

PaperTable pairs(const Analysis& analysis) {
    PageTable table{{"Pair", "Validity", "A", "B", "A : B", "B (%)", "95 % CI", "p", "p, Holm"},
                    {}};
    for (const ConditionResult* result : by_validity(analysis)) {
        const ConditionVotes& condition = result->condition;
        const Preference& tests = result->preference;
        table.rows.push_back({condition.id,
                              condition.validity.empty() ? kNoValue : condition.validity,
                              condition.variant_a, condition.variant_b,
                              fmt::format("{} : {}", condition.votes.a, condition.votes.b),
                              plain_share(tests.share_b), plain_interval(tests.wilson),
                              tests.exact.has_value() ? p_number(*tests.exact) : kNoValue,
                              p_number(result->p_holm)});
    }
    return {std::move(table),
            "The pairs with their votes for A and B, the share of B with Wilson's 95 % interval, p "
            "of the exact binomial test, and p after Holm's correction over all pairs."};
}

std::string corrected(const Verdict& verdict, const Possible<double>& p_holm) {
    return verdict.is_primary ? p_number(p_holm) : "secondary";
}

PaperTable verdicts(const Analysis& analysis) {
    PageTable table{{"Hypothesis", "Conditions", "B (%) or change (points)", "95 % CI", "p",
                     "p, Holm", "Verdict"},
                    {}};
    for (const Verdict& verdict : analysis.verdicts) {
        std::string conditions = kNoValue;
        std::string share = kNoValue;
        for (const HypothesisResult& result : analysis.hypotheses) {
            if (verdict.is_on_validity || result.name != verdict.hypothesis) continue;
            conditions = listed(result.conditions);
            share = plain_share(result.pooled.share_b);
        }
        table.rows.push_back({verdict.hypothesis, conditions, share,
                              plain_interval(verdict.interval),
                              verdict.p.has_value() ? p_number(*verdict.p) : kNoValue,
                              corrected(verdict, verdict.p_holm), verdict_words(verdict)});
        for (const ComparedVerdict& compared : verdict.compared) {
            if (verdict.compared.size() < 2) continue;
            table.rows.push_back({verdict.hypothesis, listed(compared.conditions), kNoValue,
                                  plain_interval(compared.interval), p_cell(compared.p),
                                  corrected(verdict, compared.p_holm), kNoValue});
        }
    }
    return {
        std::move(table),
        "The hypotheses: votes pooled over their conditions, p of the test over participants "
        "(of counts where only those are known), p after Holm's correction over the tests of all "
        "primary ones, and the verdict; of validity that of the smallest p, the interval of "
        "the difference that may be largest, and below it every comparison."};
}

/// Shares of B, named by the pairs alone: Table 1 says what they are.
PaperFigure shares(const Analysis& analysis) {
    IntervalPlot plot;
    plot.name = "figure-1";
    plot.title = "Share of answers for B";
    plot.axis = "answers for B (%)";
    plot.groups = {"low", "moderate", "high", "other"};
    plot.has_line = true;
    plot.line = 50.0;
    plot.x_high = 100.0;
    for (const ConditionResult* result : by_validity(analysis)) {
        const Preference& tests = result->preference;
        IntervalRow& row = plot.rows.emplace_back();
        row.label = result->condition.id;
        row.note = fmt::format("{} : {}", result->condition.votes.a, result->condition.votes.b);
        row.group = level_number(result->condition.validity);
        if (!tests.share_b.has_value() || !tests.wilson.has_value()) continue;
        row.has_value = true;
        row.value = 100.0 * *tests.share_b;
        row.low = 100.0 * tests.wilson->low;
        row.high = 100.0 * tests.wilson->high;
    }
    return {interval_plot(plot),
            "Share of answers for image B in each pair with Wilson's 95 % interval, by validity of "
            "the lighting; on the right the votes, A : B. The dashed line is an equal split."};
}

std::string paragraphs(const std::vector<std::string>& texts) {
    std::string all;
    for (const std::string& text : texts) all += text + "\n\n";
    return all;
}

/// Both widths of a figure, each as SVG and PDF where gnuplot is there.
void add_figure(ReportDraft& draft, const PaperFigure& figure) {
    for (const double width_mm : {kColumn_mm, kPage_mm}) {
        Plot plot = figure.plot;
        plot.width_mm = width_mm;
        if (width_mm == kPage_mm) plot.name += "-wide";
        draft.paper_figure(std::move(plot));
    }
}

std::string latex_figure(const std::string& name, std::string_view caption) {
    return fmt::format(
        "\\begin{{figure}}\n  \\centering\n  \\includegraphics{{{0}.pdf}}\n  \\caption{{{1}}}\n"
        "  \\label{{fig:{0}}}\n\\end{{figure}}\n",
        name, latex_text(caption));
}

}  // namespace

void add_paper(ReportDraft& draft) {
    const ReportInput& input = draft.input;
    const bool is_simulated = input.analysis.tally.kind == Kind::kSimulated;
    const std::vector<PaperTable> tables{pairs(input.analysis), verdicts(input.analysis)};
    const PaperFigure figure = shares(input.analysis);
    const std::string methods = paragraphs(method_paragraphs(input));
    const std::string results = paragraphs(result_paragraphs(input));
    const std::string mark = is_simulated ? "SIMULATED DATA, no evidence about people." : "";
    std::string markdown = mark.empty() ? "" : "> **" + mark + "**\n\n";
    markdown += "# Methods\n\n" + methods + "# Results\n\n" + results;
    std::string floats;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        const std::string name = fmt::format("table-{}", i + 1);
        const PaperTable& table = tables[i];
        std::string csv = csv_line(table.table.headings);
        for (const auto& row : table.table.rows) csv += csv_line(row);
        draft.file("paper/" + name + ".csv", csv);
        draft.file("paper/" + name + ".tex",
                   latex_table(table.table, table.caption, "tab:" + name));
        markdown += markdown_table(table.table, fmt::format("Table {}. {}", i + 1, table.caption));
        floats += fmt::format("\\input{{{}}}\n", name);
    }
    markdown += fmt::format("![Figure 1. {}](figure-1.svg)\n", figure.caption);
    add_figure(draft, figure);
    floats += latex_figure("figure-1", figure.caption);
    draft.file("paper/paper.md", markdown);
    draft.file("paper/paper.tex",
               fmt::format("% Run pdflatex, bibtex, pdflatex, pdflatex; or take what is needed.\n"
                           "\\documentclass{{article}}\n\\usepackage[T1]{{fontenc}}\n"
                           "\\usepackage[utf8]{{inputenc}}\n\\usepackage{{booktabs,graphicx}}\n"
                           "\\begin{{document}}\n{}\\section{{Methods}}\n\n{}"
                           "\\section{{Results}}\n\n{}{}\\bibliographystyle{{plain}}\n"
                           "\\bibliography{{references}}\n\\end{{document}}\n",
                           mark.empty() ? "" : "\\textbf{" + latex_text(mark) + "}\n\n",
                           latex_text(methods), latex_text(results), floats));
    draft.file("paper/references.bib", cited_entries(methods + results));
    draft.page.heading("For a paper");
    draft.page.paragraph(
        "The folder paper/ beside this page has methods and results as Markdown (paper.md) and "
        "LaTeX (paper.tex, references.bib), the tables as CSV and LaTeX, and the figure as SVG and "
        "PDF, one column (85 mm) and two columns (174 mm) wide. Its numbers are those of this "
        "page.");
}

}  // namespace obscura::analysis
