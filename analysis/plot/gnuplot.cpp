// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/plot/gnuplot.h"

#include <fmt/format.h>

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

/// A script that stands alone: it draws NAME.svg where it is run, NAME.png with picture="png", and
/// writes to the standard output with to_stdout=1.
std::string script_of(const Plot& plot) {
    std::string script = fmt::format(
        "# Run in this folder: gnuplot {0}.gnuplot\n"
        "if (!exists(\"picture\")) picture = \"svg\"\n"
        "if (picture eq \"png\") {{\n"
        "    set terminal pngcairo size {1},{2} noenhanced font \"sans-serif,11\" background "
        "\"#ffffff\"\n"
        "}} else {{\n"
        "    set terminal svg size {1},{2} noenhanced font \"sans-serif,15\" background "
        "\"#ffffff\"\n"
        "}}\n"
        "if (!exists(\"to_stdout\")) set output {3}.\".\".picture\n{4}",
        plot.name, plot.width_px, plot.height_px, gnuplot_text(plot.name), kStyle);
    if (!plot.title.empty()) script += fmt::format("set title {}\n", gnuplot_text(plot.title));
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

}  // namespace obscura::analysis
