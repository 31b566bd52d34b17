// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/measurement/report.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/measurement/order_of_techniques.h"
#include "analysis/presentation/html.h"
#include "analysis/table/csv.h"
#include "analysis/text/text.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

namespace fs = std::filesystem;

/// The rows of each view, in the order in which the views first come.
std::vector<std::vector<MeasurementRow>> by_view(const std::vector<MeasurementRow>& rows) {
    std::vector<std::vector<MeasurementRow>> views;
    for (const MeasurementRow& row : rows) {
        const auto view = std::find_if(views.begin(), views.end(), [&](const auto& held) {
            return same_view(held.front(), row);
        });
        if (view == views.end()) {
            views.push_back({row});
        } else {
            view->push_back(row);
        }
    }
    return views;
}

/// The variant with what of it is not as usual.
std::string setting_name(const MeasurementRow& row) {
    std::string name = row.variant;
    if (row.samples > 0 && row.denoise != "separable") name += ", " + row.denoise;
    return name + (row.options.empty() ? "" : ", " + row.options);
}

std::string cell(const Possible<AccessibilityError>& error, double AccessibilityError::*member) {
    return error.has_value() ? fmt::format("{:.4f}", (*error).*member) : "-";
}

/// Few columns, for people.
PageTable table_of(const std::vector<MeasurementRow>& rows) {
    PageTable table;
    table.headings = {"variant",
                      "filter",
                      "values",
                      "AO ms",
                      "filter ms",
                      "frame ms",
                      "fetches/px",
                      "RMSE",
                      "bias",
                      "p99",
                      "RMSE inside",
                      "image RMSE",
                      "seen to differ (Yee)",
                      "front"};
    for (const MeasurementRow& row : rows) {
        table.rows.push_back(
            {row.variant, row.denoise + (row.options.empty() ? "" : ", " + row.options), row.values,
             fmt::format("{:.2f}", row.accessibility.median_ms),
             fmt::format("{:.2f}", row.filter.median_ms),
             fmt::format("{:.2f}", row.frame.median_ms), std::to_string(row.fetches_per_px),
             cell(row.error, &AccessibilityError::rmse), cell(row.error, &AccessibilityError::bias),
             cell(row.error, &AccessibilityError::p99),
             cell(row.interior, &AccessibilityError::rmse),
             row.image ? fmt::format("{:.4f}", row.image->rmse) : "-",
             row.image ? fmt::format("{:.1f} %", 100.0 * row.image->yee_failed) : "-",
             row.on_front ? "yes" : ""});
    }
    return table;
}

/// The settings that the study shows, and what they become when fitted; all where there is no
/// study.
std::vector<MeasurementRow> to_be_looked_at(const MeasurementReport& report,
                                            const std::vector<MeasurementRow>& rows) {
    if (!report.of_study) return rows;
    std::vector<MeasurementRow> shown;
    std::copy_if(rows.begin(), rows.end(), std::back_inserter(shown),
                 [](const MeasurementRow& row) { return !row.published.empty(); });
    return shown;
}

PageTable hard_case_table(const std::vector<HardCaseRow>& rows, Holds wanted) {
    PageTable table;
    table.headings = {"case",       "technique", "quantity",  "truth",
                      "definition", "measured",  "tolerance", "note"};
    for (const HardCaseRow& row : rows) {
        if (row.holds != wanted) continue;
        table.rows.push_back(
            {row.name, row.technique, row.quantity,
             // What holds a shader against its definition says nothing of truth.
             row.against == HeldAgainst::kTruth ? fmt::format("{:.6g}", row.expected) : "",
             row.definition ? fmt::format("{:.6g}", *row.definition) : "",
             fmt::format("{:.6g}", row.measured), fmt::format("{:.3g}", row.tolerance), row.note});
    }
    return table;
}

/// What the columns of the hard cases mean, and the rows by what became of them.
void put_hard_cases(const std::vector<HardCaseRow>& rows, Page& page) {
    page.heading("Hard cases");
    page.paragraph(hard_cases_in_a_sentence(rows));
    page.paragraph(
        "Truth is a closed form or what any sound image has; definition is the same quantity "
        "by the technique's own definition, evaluated in double precision on the buffers that the "
        "shader read. Truth minus definition is the technique's nature; definition minus "
        "measured is the shader's arithmetic, which nothing excuses.");
    const std::pair<Holds, const char*> parts[] = {
        {Holds::kNo, "These fail, and nothing explains it"},
        {Holds::kUndecided, "These are not decided: the machine was too busy for their times"},
        {Holds::kByNature, "These fail by the technique's own definition"},
        {Holds::kYes, "These hold"}};
    for (const auto& [holds, title] : parts) {
        const PageTable table = hard_case_table(rows, holds);
        if (!table.rows.empty()) page.table(table, title);
    }
}

std::string trained_on(const Fitted& fit) {
    const std::string cameras = fmt::format("{}", fmt::join(fit.training_cameras, ", "));
    return fit.on_the_same_view() ? cameras + ": fitted and reported on the same view" : cameras;
}

PageTable fitted_table(const std::vector<Fitted>& fitted) {
    PageTable table;
    table.headings = {"scene",  "variant",     "trained on", "before",
                      "fitted", "RMSE before", "RMSE after", "evaluations"};
    const auto listed = [](const std::map<std::string, double>& parameters) {
        std::string text;
        for (const auto& [name, value] : parameters) {
            text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ", name, value);
        }
        return text;
    };
    for (const Fitted& fit : fitted) {
        table.rows.push_back(
            {fit.scene_id, fit.technique + std::to_string(fit.samples), trained_on(fit),
             listed(fit.before), listed(fit.after), fmt::format("{:.4f}", fit.training_rmse_before),
             fmt::format("{:.4f}", fit.training_rmse_after), std::to_string(fit.evaluations)});
    }
    return table;
}

/// Writes files one after the other and remembers them.
class Folder {
  public:
    explicit Folder(fs::path folder) : folder_(std::move(folder)) {}

    void write(const std::string& name, const std::string& text) {
        base::write_file_atomically(folder_ / name, text);
        written_.push_back(folder_ / name);
    }

    /// Draws, and puts the drawing or the reason why there is none on the page.
    void draw_on(Page& page, const Plot& plot) {
        const DrawnPlot drawn = draw(plot, folder_, true);
        if (drawn.note.empty()) {
            page.svg(drawn.svg, plot.name + ".svg", plot.title);
            written_.push_back(folder_ / (plot.name + ".svg"));
        } else {
            page.paragraph(plot.title + ": " + drawn.note);
        }
    }

    void draw_picture_on(Page& page, const Plot& plot) {
        const DrawnPlot drawn = draw(plot, folder_, true);
        const fs::path picture = folder_ / (plot.name + ".png");
        if (drawn.note.empty() && fs::exists(picture)) {
            page.image(base::read_file(picture), "image/png", plot.name + ".png", plot.title);
            written_.push_back(picture);
        } else {
            page.paragraph(plot.title + ": " + drawn.note);
        }
    }

    [[nodiscard]] std::vector<fs::path> take() { return std::move(written_); }

  private:
    fs::path folder_;
    std::vector<fs::path> written_;
};

void put_speed_and_error(const MeasurementReport& report, Page& page, Folder& folder) {
    if (report.rows.empty()) return;
    if (report.asks_order) {
        const auto orders = orders_of_techniques(report.rows, report.denoise);
        page.heading("Does accuracy order the techniques as the thesis assumes?");
        page.paragraph(order_in_a_sentence(orders));
        std::vector<std::string> sentences;
        for (const OrderOfTechniques& order : orders) sentences.push_back(order.sentence);
        if (!sentences.empty()) page.list(sentences);
    }
    page.heading("Speed against error");
    for (const auto& rows : by_view(report.rows)) {
        page.heading(view_name(rows.front()), 3);
        folder.draw_on(page, error_over_time(rows, report.denoise));
        if (report.of_study) {
            page.table(table_of(to_be_looked_at(report, rows)),
                       "The settings that the study shows");
        }
    }
}

void put_details(const MeasurementReport& report, Page& page, Folder& folder) {
    if (!report.maps.empty()) {
        page.heading("Where the error is");
        for (const ErrorMap& map : report.maps) folder.draw_picture_on(page, error_map(map));
    }
    if (!report.fitted.empty()) {
        page.heading("Fitted values");
        page.table(fitted_table(report.fitted));
    }
    if (!report.growth.empty()) {
        page.heading("How cost grows");
        std::vector<std::string> quantities;
        for (const Growth& growth : report.growth) {
            if (std::find(quantities.begin(), quantities.end(), growth.quantity) ==
                quantities.end()) {
                quantities.push_back(growth.quantity);
            }
        }
        for (const std::string& quantity : quantities) {
            folder.draw_on(page, growth_plot(report.growth, quantity));
        }
    }
    if (!report.hard_cases.empty()) put_hard_cases(report.hard_cases, page);
    if (!report.rows.empty()) {
        page.heading("All measurements");
        for (const auto& rows : by_view(report.rows)) {
            page.table(table_of(rows), view_name(rows.front()));
        }
    }
}

std::string json_of(const MeasurementReport& report) {
    nlohmann::ordered_json json;
    json["title"] = report.title;
    json["device"] = report.device;
    json["timer_check"] = report.timer_check;
    json["method"] = report.method;
    json["orders"] = nlohmann::ordered_json::array();
    std::vector<OrderOfTechniques> orders;
    if (report.asks_order) {
        orders = orders_of_techniques(report.rows, report.denoise);
        json["order"] = order_in_a_sentence(orders);
    }
    for (const OrderOfTechniques& order : orders) {
        json["orders"].push_back({{"view", order.view},
                                  {"fitted", order.fitted},
                                  {"by_error", order.by_error},
                                  {"rmse", order.rmse},
                                  {"as_assumed", order.as_assumed}});
    }
    json["rows"] = nlohmann::ordered_json::parse(measurement_json(report.rows));
    return json.dump(2) + '\n';
}

}  // namespace

std::string fitted_csv(const std::vector<Fitted>& fitted) {
    std::string text = csv_line({"scene_id", "scene", "technique", "samples", "blur", "parameter",
                                 "published", "fitted", "training_rmse_published",
                                 "training_rmse_fitted", "evaluations", "same_view"});
    for (const Fitted& fit : fitted) {
        for (const auto& [name, value] : fit.after) {
            text += csv_line({fit.scene_id, fit.scene, fit.technique, std::to_string(fit.samples),
                              fit.denoise, name, shortest(fit.before.at(name)), shortest(value),
                              shortest(fit.training_rmse_before), shortest(fit.training_rmse_after),
                              std::to_string(fit.evaluations),
                              fit.on_the_same_view() ? "true" : "false"});
        }
    }
    return text;
}

std::string report_text(const MeasurementReport& report) {
    std::string text = report.title + '\n' + report.device + '\n';
    if (!report.timer_check.empty()) text += report.timer_check + '\n';
    if (!report.rows.empty()) {
        const std::vector<MeasurementRow> rows = to_be_looked_at(report, report.rows);
        std::size_t view = 28;
        std::size_t variant = 15;
        for (const MeasurementRow& row : rows) {
            view = std::max(view, view_name(row).size());
            variant = std::max(variant, setting_name(row).size());
        }
        text += fmt::format("\n{:<{}} {:<{}} {:<10} {:>9} {:>9} {:>8} {:>8} {:>8} {:>8}\n", "view",
                            view, "variant", variant, "values", "AO ms", "frame ms", "fetches",
                            "RMSE", "bias", "p99");
        for (const MeasurementRow& row : rows) {
            text += fmt::format("{:<{}} {:<{}} {:<10} {:>9.2f} {:>9.2f} {:>8} {:>8} {:>8} {:>8}\n",
                                view_name(row), view, setting_name(row), variant, row.values,
                                row.cost.median_ms, row.frame.median_ms, row.fetches_per_px,
                                cell(row.error, &AccessibilityError::rmse),
                                cell(row.error, &AccessibilityError::bias),
                                cell(row.error, &AccessibilityError::p99));
        }
    }
    if (!report.overview.empty()) text += '\n' + overview_text(report.overview);
    if (!report.findings.empty()) text += '\n';
    for (const std::string& finding : report.findings) text += finding + '\n';
    if (report.asks_order && !report.rows.empty()) {
        const auto orders = orders_of_techniques(report.rows, report.denoise);
        text += '\n';
        for (const OrderOfTechniques& order : orders) text += order.sentence + '\n';
        text += order_in_a_sentence(orders) + '\n';
    }
    for (const Fitted& fit : report.fitted) {
        if (!fit.on_the_same_view()) continue;
        text += fmt::format("{}, {}{}: fitted and reported on the same view ({}).\n", fit.scene_id,
                            fit.technique, fit.samples, fmt::join(fit.reported_cameras, ", "));
    }
    for (const Growth& growth : report.growth) {
        text +=
            growth.law.has_value()
                ? fmt::format("{}: time grows with {} to the power {:.3f} ({:.3f} to {:.3f})\n",
                              growth.technique, growth.quantity, growth.law->exponent,
                              growth.law->low, growth.law->high)
                : fmt::format("{}: {}: {}\n", growth.technique, growth.quantity, growth.law.reason);
    }
    if (!report.hard_cases.empty()) text += hard_cases_in_a_sentence(report.hard_cases) + '\n';
    return text;
}

std::vector<fs::path> write_report(const MeasurementReport& report, const fs::path& folder_path) {
    Folder folder(folder_path);
    if (!report.rows.empty()) {
        folder.write("measure.csv", measurement_csv(report.rows));
        folder.write("measure.json", json_of(report));
    }
    if (!report.overview.empty()) folder.write("overview.csv", overview_csv(report.overview));
    if (!report.fitted.empty()) folder.write("fitted.csv", fitted_csv(report.fitted));
    if (!report.growth.empty()) folder.write("growth.csv", growth_csv(report.growth));
    if (!report.hard_cases.empty()) {
        folder.write("hard-cases.csv", hard_cases_csv(report.hard_cases));
    }
    Page page(report.title);
    page.paragraph("Rendered on: " + report.device);
    if (!report.timer_check.empty()) page.paragraph(report.timer_check);
    if (!report.findings.empty()) {
        page.heading("What it found");
        page.list(report.findings);
    }
    if (!report.overview.empty()) {
        page.heading("All techniques");
        folder.draw_on(page, overview_chart(report.overview));
        page.table(overview_table(report.overview));
    }
    put_speed_and_error(report, page, folder);
    put_details(report, page, folder);
    page.heading("How it was measured");
    page.list(report.method);
    folder.write("measure.html", page.html());
    return folder.take();
}

}  // namespace obscura::analysis
