// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/attendance.h"
#include "analysis/conclusions/measurement_table.h"
#include "analysis/conclusions/questions.h"
#include "analysis/conclusions/shown_image.h"

namespace obscura::analysis {

/// What a study is called and asks.
struct StudyWords {
    std::string title;
    std::string question;
    /// How the two images of a pair are shown, as the end of a sentence: one after the other, with
    /// a grey screen for 2 s between them.
    std::string shown = "one after the other";
    std::string order = {};  ///< latin-square, williams, random, fixed; empty: not known
};

/// Everything a report is made of. What is missing is said in it, not left out.
struct ReportInput {
    Analysis analysis;
    StudyWords study;
    /// Of the study and kind that are analysed.
    Possible<Attendance> attendance = Possible<Attendance>::none("only votes are known");
    std::vector<ShownImage> images;  ///< of the study's conditions; empty where none are known
    std::string images_unknown;      ///< why there are none
    std::optional<QuestionsResult> questions;  ///< nothing: the pairs alone were asked about
    std::optional<MeasurementTable> measurement;
    std::string measurement_unknown;  ///< why there is none
    std::string software;             ///< name and version of this program
};

/// A file of a report, not yet written.
struct ReportFile {
    std::string name;  ///< relative to the report's folder; may begin with a folder
    std::string bytes;
};

/// The whole report as files: report.html (one self-contained page), report.md, analysis.txt,
/// analysis.json, in plots/ and thumbnails/ what the pages show, with each plot's script and
/// data, and in paper/ paragraphs, tables and figures for a paper. The same input gives the same
/// bytes. Without gnuplot the tables stand alone and the page says so. Throws failure when there is
/// no place for temporary files.
[[nodiscard]] std::vector<ReportFile> report_files(const ReportInput& input);

/// Puts all of the files into the folder or none, in place of an earlier report's. Throws bad input
/// when the folder cannot be written; failure, with everything as it was, when writing fails.
void write_report(const std::vector<ReportFile>& files, const std::filesystem::path& folder);

}  // namespace obscura::analysis
