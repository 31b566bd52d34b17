// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/plot/gnuplot.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/plot/child_process.h"
#include "analysis/text/text.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::seconds kLongestDrawing{30};

/// What every plot begins with. The colours are those of M. Okabe and K. Ito, "Color Universal
/// Design" (2008), without the yellow, which white paper swallows; dashes and point shapes differ
/// too, so that a copy in black and white can be read.
constexpr const char* kStyle = R"(set encoding utf8
set datafile separator tab
set datafile commentschars "#"
set linetype 1 lc rgb "#0072B2" lw 2 dt solid pt 7 ps 0.9
set linetype 2 lc rgb "#D55E00" lw 2 dt (10,4) pt 9 ps 1.1
set linetype 3 lc rgb "#009E73" lw 2 dt (3,3) pt 5 ps 0.8
set linetype 4 lc rgb "#000000" lw 2 dt (12,4,3,4) pt 6 ps 0.9
set linetype 5 lc rgb "#CC79A7" lw 2 dt (14,4,3,4,3,4) pt 13 ps 1.1
set linetype 6 lc rgb "#E69F00" lw 2 dt (6,6) pt 8 ps 1.1
set linetype 7 lc rgb "#56B4E9" lw 2 dt (2,6) pt 4 ps 0.8
set linetype 8 lc rgb "#666666" lw 2 dt (20,6) pt 12 ps 1.1
set linetype cycle 8
set border 3 lc rgb "#444444" lw 1
set tics nomirror out scale 0.6
set grid back lc rgb "#DDDDDD" lw 1 dt solid
set key outside right top Left reverse spacing 1.2 samplen 3
)";

/// How large a picture is: letters in points, sizes in the terminal's unit.
struct Sizes {
    double width = 0.0;
    double height = 0.0;
    double font = 0.0;
};

constexpr double kPixelsPerInch = 96.0;
constexpr double kPointsPerInch = 72.0;
constexpr double kMillimetresPerInch = 25.4;
constexpr double kPrinted_pt = 8.0;

Sizes svg_sizes(const Plot& plot) {
    if (plot.width_mm <= 0.0) {
        return {static_cast<double>(plot.width_px), static_cast<double>(plot.height_px), 15.0};
    }
    // Letters keep their size and rows with them, whatever the width.
    const double font_px = kPrinted_pt * kPixelsPerInch / kPointsPerInch;
    return {std::round(plot.width_mm / kMillimetresPerInch * kPixelsPerInch),
            std::round(plot.height_px * font_px / 15.0), font_px};
}

/// The commands that choose the terminal, by the variable `picture`.
std::string terminals_of(const Plot& plot) {
    const Sizes svg = svg_sizes(plot);
    return fmt::format(
        "if (!exists(\"picture\")) picture = \"svg\"\n"
        "if (picture eq \"png\") {{\n"
        "    set terminal pngcairo size {0},{1} noenhanced font \"sans-serif,11\" background "
        "\"#ffffff\"\n"
        "}} else {{ if (picture eq \"pdf\") {{\n"
        "    set terminal pdfcairo size {2:.3f}cm,{3:.3f}cm noenhanced font \"sans-serif,{4:g}\" "
        "linewidth 0.5\n"
        "}} else {{\n"
        "    set terminal svg size {5:g},{6:g} noenhanced font \"sans-serif,{7:.4g}\" background "
        "\"#ffffff\"\n"
        "}} }}\n",
        plot.width_px, plot.height_px, svg.width / kPixelsPerInch * kMillimetresPerInch / 10.0,
        svg.height / kPixelsPerInch * kMillimetresPerInch / 10.0,
        svg.font * kPointsPerInch / kPixelsPerInch, svg.width, svg.height, svg.font);
}

/// A script that stands alone: it draws NAME.svg where it is run, NAME.png with picture="png",
/// NAME.pdf with picture="pdf", and writes to the standard output with to_stdout=1.
std::string script_of(const Plot& plot) {
    std::string script = fmt::format(
        "# Run in this folder: gnuplot {0}.gnuplot\n{1}"
        "if (!exists(\"to_stdout\")) set output {2}.\".\".picture\n{3}",
        plot.name, terminals_of(plot), gnuplot_text(plot.name), kStyle);
    const std::string& above = plot.above.value_or(plot.title);
    if (!above.empty()) script += fmt::format("set title {}\n", gnuplot_text(above));
    script += plot.script;
    if (script.back() != '\n') script += '\n';
    return script;
}

ProcessResult run_gnuplot(const Plot& plot, const fs::path& folder, std::string_view picture) {
    return run_process(
        {"gnuplot", "--default-settings", "-e", fmt::format("to_stdout=1; picture=\"{}\"", picture),
         plot.name + ".gnuplot"},
        folder, kLongestDrawing);
}

/// gnuplot calls every picture "Gnuplot", which browsers show beside the pointer.
void name_picture(std::string& svg, const std::string& title) {
    constexpr std::string_view kName = "<title>Gnuplot</title>";
    const std::size_t place = svg.find(kName);
    if (place == std::string::npos) return;
    svg.replace(place, kName.size(), fmt::format("<title>{}</title>", html_escaped(title)));
}

/// A PDF says when it was made, which would make each one another. As many letters as before: the
/// file counts its bytes.
void date_picture(std::string& pdf) {
    constexpr std::string_view kDate = "/CreationDate (D:";
    constexpr std::string_view kAlways = "20000101000000";
    const std::size_t place = pdf.find(kDate);
    if (place == std::string::npos) return;
    pdf.replace(place + kDate.size(), kAlways.size(), kAlways);
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
    std::string constant = "'";
    for (const char letter : text) {
        if (letter == '\'') constant += '\'';
        constant += letter == '\n' || letter == '\r' ? ' ' : letter;
    }
    return constant + "'";
}

std::string plot_cell(std::string_view text) {
    std::string cell = "\"";
    for (const char letter : text) {
        cell += letter == '"' ? '\'' : static_cast<unsigned char>(letter) < ' ' ? ' ' : letter;
    }
    return cell + "\"";
}

DrawnPlot draw(const Plot& plot, const fs::path& folder, bool png) {
    for (const PlotData& data : plot.data) {
        base::write_file_atomically(folder / data.file, data.text);
    }
    base::write_file_atomically(folder / (plot.name + ".gnuplot"), script_of(plot));
    ProcessResult drawn = run_gnuplot(plot, folder, "svg");
    if (!drawn.problem.empty()) return {"", drawn.problem};
    if (drawn.out.find("</svg>") == std::string::npos) return {"", "gnuplot drew nothing"};
    name_picture(drawn.out, plot.title.empty() ? plot.name : plot.title);
    base::write_file_atomically(folder / (plot.name + ".svg"), drawn.out);
    if (png) {
        const ProcessResult picture = run_gnuplot(plot, folder, "png");
        if (!picture.problem.empty()) return {drawn.out, "no PNG: " + picture.problem};
        base::write_file_atomically(folder / (plot.name + ".png"), picture.out);
    }
    return {drawn.out, ""};
}

std::string draw_pdf(const Plot& plot, const fs::path& folder) {
    ProcessResult drawn = run_gnuplot(plot, folder, "pdf");
    if (!drawn.problem.empty() || !drawn.out.starts_with("%PDF")) return "";
    date_picture(drawn.out);
    return std::move(drawn.out);
}

}  // namespace obscura::analysis
