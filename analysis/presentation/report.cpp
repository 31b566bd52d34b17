// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/report.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "analysis/conclusions/caveats.h"
#include "analysis/conclusions/published_study.h"
#include "analysis/export/export_folder.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/questions_text.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/text_report.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

bool is_simulated(const ReportInput& input) {
    return input.analysis.tally.kind == Kind::kSimulated;
}

std::string title_of(const ReportInput& input) {
    const Tally& tally = input.analysis.tally;
    std::string title = input.study.title;
    if (title.empty()) title = tally.study.empty() ? "Which image was preferred?" : tally.study;
    if (is_published_votes(tally)) title += ": the published votes";
    return title;
}

fs::path new_folder() {
    std::string path = (fs::temp_directory_path() / "obscura-report-XXXXXX").string();
    if (::mkdtemp(path.data()) == nullptr) {
        throw base::failure("cannot make a folder for plots in {}: {}",
                            fs::temp_directory_path().string(), std::strerror(errno));
    }
    return path;
}

}  // namespace

ReportDraft::ReportDraft(const ReportInput& from)
    : input(from), page(title_of(from)), folder_(new_folder()) {
    if (is_simulated(from)) {
        page.mark(
            "SIMULATED DATA: computer-made answers. Nobody has looked at these images, and nothing "
            "here is evidence about people.");
    }
}

ReportDraft::~ReportDraft() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void ReportDraft::file(std::string name, std::string bytes) {
    files.push_back({std::move(name), std::move(bytes)});
}

void ReportDraft::plot(Plot plot, const std::string& caption) {
    plot.above = is_simulated(input) ? "SIMULATED DATA" : "";
    const DrawnPlot drawn = draw(plot, folder_);
    file("plots/" + plot.name + ".gnuplot", base::read_file(folder_ / (plot.name + ".gnuplot")));
    for (const PlotData& data : plot.data) file("plots/" + data.file, data.text);
    const std::string svg = "plots/" + plot.name + ".svg";
    if (drawn.svg.empty()) {
        page.svg("", svg,
                 fmt::format("There is no picture here ({}); the table has all of it, and gnuplot "
                             "draws plots/{}.gnuplot.",
                             drawn.note, plot.name));
        return;
    }
    file(svg, drawn.svg);
    page.svg(drawn.svg, svg, fmt::format("Figure {}. {}", ++figures_, caption));
}

void ReportDraft::paper_figure(Plot plot) {
    plot.above = is_simulated(input) ? "SIMULATED DATA" : "";
    const DrawnPlot drawn = draw(plot, folder_);
    if (drawn.svg.empty()) return;
    file("paper/" + plot.name + ".svg", drawn.svg);
    if (std::string pdf = draw_pdf(plot, folder_); !pdf.empty()) {
        file("paper/" + plot.name + ".pdf", std::move(pdf));
    }
}

void add_caveats(ReportDraft& draft) {
    const ReportInput& input = draft.input;
    std::vector<std::string> points;
    for (const Caveat& caveat : caveats_of(input.analysis, input.images, input.attendance)) {
        points.push_back(fmt::format("{}: {}", caveat.about, caveat.sentence));
    }
    draft.page.box("To know before believing it", points);
}

std::vector<ReportFile> report_files(const ReportInput& input) {
    ReportDraft draft(input);
    add_answers(draft);
    add_caveats(draft);
    add_published_study(draft);
    add_stimuli(draft);
    add_participants(draft);
    add_preferences(draft);
    add_hypotheses(draft);
    add_scales(draft);
    add_questions(draft);
    add_order_bias(draft);
    add_response_times(draft);
    add_attention(draft);
    add_power(draft);
    add_preference_and_cost(draft);
    add_speed_and_error(draft);
    add_methods(draft);
    add_paper(draft);
    draft.file("report.html", draft.page.html());
    draft.file("report.md", draft.page.markdown());
    draft.file("analysis.txt", text_report(input.analysis, caveats_of(input.analysis, input.images,
                                                                      input.attendance)) +
                                   (input.questions ? questions_text(*input.questions) : ""));
    draft.file("analysis.json",
               json_report(input.analysis, input.questions ? &*input.questions : nullptr));
    return std::move(draft.files);
}

void write_report(const std::vector<ReportFile>& files, const fs::path& folder) {
    ExportFolder place(folder, true);
    for (const ReportFile& file : files) place.add(file.name, file.bytes);
    place.keep();
}

}  // namespace obscura::analysis
