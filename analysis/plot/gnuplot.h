// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::analysis {

/// A file that a plot is drawn from, kept beside it: cells parted by tabs, `#` begins a comment.
struct PlotData {
    std::string file;  ///< a plain name in the plot's folder, as the script names it
    std::string text;
};

/// One plot: gnuplot commands without `set terminal` and `set output`, and what they read. Line
/// types 1 to 8 (`lt N`) are told apart by colour, dash and point shape; text is taken literally,
/// without gnuplot's enhanced mode.
struct Plot {
    std::string name;   ///< stem of its files
    std::string title;  ///< what the picture is called; may be empty
    int width_px = 900;
    int height_px = 560;
    std::string script;
    std::vector<PlotData> data;
    /// What stands above the plot; nothing: its title.
    std::optional<std::string> above = {};
    /// For print: so wide, with the letters and lines of a journal, 8 pt and half a point; the
    /// height follows. 0: for a screen, in pixels.
    double width_mm = 0.0;
};

/// The files of a drawn plot, relative to its folder, and the SVG itself for a page.
struct DrawnPlot {
    std::string svg;   ///< the text of NAME.svg; empty where it could not be drawn
    std::string note;  ///< why there is no picture; empty where there is one
};

/// Writes NAME.gnuplot and the data into `folder`, and draws NAME.svg, and NAME.png too where `png`
/// is true. Where gnuplot is absent or fails, data and script are written all the same and the note
/// says why there is no picture. Throws failure when a file cannot be written.
/// `gnuplot NAME.gnuplot` in the folder draws the SVG again.
[[nodiscard]] DrawnPlot draw(const Plot& plot, const std::filesystem::path& folder,
                             bool png = false);

/// The bytes of a PDF of a plot that draw() has put into `folder`, the same for the same plot;
/// empty where it cannot be drawn.
[[nodiscard]] std::string draw_pdf(const Plot& plot, const std::filesystem::path& folder);

/// The text as a string constant of a script, with its quotes.
[[nodiscard]] std::string gnuplot_text(std::string_view text);

/// The text as one cell of a plot's data, with its quotes: tabs, line ends and double quotes are
/// shown as a blank and a single quote.
[[nodiscard]] std::string plot_cell(std::string_view text);

}  // namespace obscura::analysis
