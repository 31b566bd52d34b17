// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace obscura::analysis {

/// A file that a plot is drawn from, kept beside it.
struct PlotData {
    std::string file;  ///< relative to the plot's folder, as the script names it
    std::string text;
};

/// One plot: gnuplot commands without `set terminal` and `set output`, and what they read.
struct Plot {
    std::string name;  ///< stem of its files
    std::string title;
    int width_px = 900;
    int height_px = 560;
    std::string script;
    std::vector<PlotData> data;
};

/// The files of a drawn plot, relative to its folder, and the SVG itself for a page.
struct DrawnPlot {
    std::string svg;   ///< the text of NAME.svg; empty where it could not be drawn
    std::string note;  ///< why there is no picture; empty where there is one
};

/// Writes NAME.gnuplot and the data into `folder`, and draws NAME.svg, and NAME.png too where `png`
/// is true. Where gnuplot is absent or fails, data and script are written all the same and the note
/// says why there is no picture. Throws failure when a file cannot be written.
[[nodiscard]] DrawnPlot draw(const Plot& plot, const std::filesystem::path& folder,
                             bool png = false);

}  // namespace obscura::analysis
