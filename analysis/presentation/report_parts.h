// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/plot/gnuplot.h"
#include "analysis/presentation/html.h"
#include "analysis/presentation/report.h"

namespace obscura::analysis {

/// A report on its way: the page, and the files that it names. Plots are drawn in a folder of
/// their own that goes away with this.
class ReportDraft {
  public:
    explicit ReportDraft(const ReportInput& from);
    ~ReportDraft();
    ReportDraft(const ReportDraft&) = delete;
    ReportDraft& operator=(const ReportDraft&) = delete;

    /// Draws it, keeps its files and shows it, marked where the data are simulated; where it
    /// cannot be drawn, says why.
    /// It has a number and no title: its caption says what it shows.
    void plot(Plot plot, const std::string& caption);
    /// Draws it for print, as SVG and PDF among the files of the paper; nothing where it cannot be
    /// drawn.
    void paper_figure(Plot plot);
    void file(std::string name, std::string bytes);

    const ReportInput& input;
    Page page;
    std::vector<ReportFile> files;

  private:
    std::filesystem::path folder_;
    int figures_ = 0;
};

// One part of the report each, in the order of the page.
void add_answers(ReportDraft& draft);
void add_published_study(ReportDraft& draft);  ///< nothing where the votes are not those
void add_stimuli(ReportDraft& draft);
void add_participants(ReportDraft& draft);
void add_preferences(ReportDraft& draft);
void add_hypotheses(ReportDraft& draft);
void add_scales(ReportDraft& draft);
void add_questions(ReportDraft& draft);  ///< nothing where no more was asked
void add_order_bias(ReportDraft& draft);
void add_response_times(ReportDraft& draft);
void add_attention(ReportDraft& draft);  ///< and whom the study's rule leaves out
void add_power(ReportDraft& draft);
void add_preference_and_cost(ReportDraft& draft);
void add_speed_and_error(ReportDraft& draft);
void add_methods(ReportDraft& draft);
void add_caveats(ReportDraft& draft);
void add_paper(ReportDraft& draft);

}  // namespace obscura::analysis
