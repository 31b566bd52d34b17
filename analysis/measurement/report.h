// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "analysis/measurement/growth.h"
#include "analysis/measurement/hard_case_table.h"
#include "analysis/measurement/overview.h"
#include "analysis/measurement/plots.h"
#include "analysis/measurement/row.h"

namespace obscura::analysis {

/// What a fit of one technique to one scene found.
struct Fitted {
    std::string scene_id;  ///< the study's names of the views of that scene
    std::string scene;
    std::string technique;
    int samples = 0;
    std::string denoise;
    std::string depth_format = "r32f";
    std::vector<std::string> training_cameras;
    std::vector<std::string> reported_cameras;
    std::map<std::string, double> before;  ///< parameters that it started from
    std::map<std::string, double> after;
    double training_rmse_before = 0.0;
    double training_rmse_after = 0.0;
    int evaluations = 0;

    /// Whether it is reported on what it was fitted to: the scene has no other camera.
    [[nodiscard]] bool on_the_same_view() const { return training_cameras == reported_cameras; }
};

/// Everything that one run of a measurement found.
struct MeasurementReport {
    std::string title;
    std::string device;
    std::string timer_check;            ///< the self-check of timer against clock, in a sentence
    std::vector<std::string> method;    ///< sizes, rays, runs: sentences
    std::vector<std::string> findings;  ///< what an experiment found, and of its paper: sentences
    std::string denoise;                ///< filter of the lines in the plots
    bool of_study = true;               ///< false: of scenes without a study, which shows nothing
    bool asks_order = false;  ///< whether the study assumes the thesis's order of techniques
    std::vector<MeasurementRow> rows;
    std::vector<OverviewRow> overview;  ///< of settings over all views, where it was asked for
    std::vector<Fitted> fitted;
    std::vector<ErrorMap> maps;
    std::vector<Growth> growth;
    std::vector<HardCaseRow> hard_cases;
};

/// Writes measure.csv, measure.json, overview.csv, hard-cases.csv, growth.csv and fitted.csv (each
/// where there is something in it), the plots with their data and scripts, the error maps and
/// measure.html, which holds all of it. Gives what was written, the page last. Where gnuplot draws
/// nothing, tables come all the same and the page says why. Throws failure when a file cannot be
/// written.
std::vector<std::filesystem::path> write_report(const MeasurementReport& report,
                                                const std::filesystem::path& folder);

/// What measure prints: the sentences of the page, and a table of the settings that the study
/// shows; of all where there is no study.
[[nodiscard]] std::string report_text(const MeasurementReport& report);

/// scene_id,scene,technique,samples,blur,parameter,published,fitted, the training error, and
/// same_view, whether it is reported on what it was fitted to: one row a parameter.
[[nodiscard]] std::string fitted_csv(const std::vector<Fitted>& fitted);

}  // namespace obscura::analysis
