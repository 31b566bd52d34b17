// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>

#include "app/explorer/fields.h"

namespace obscura::app::explorer {
namespace {

[[nodiscard]] const analysis::Possible<Comparison>& comparison_of(Desk& desk, char side) {
    constexpr double kOften_s = 0.7;
    KeptComparison& kept = desk.state.comparisons[side];
    const auto shot = desk.model.buffers(side);
    const auto& truth = desk.model.truth();
    if (!shot || !truth) {
        kept = {};
        return kept.outcome;
    }
    const bool other = kept.shot != shot || kept.region != desk.model.region();
    const bool grown = kept.truth != truth && desk.now_s - kept.made_s > kOften_s;
    if (other || grown) {
        kept = {shot, truth, desk.model.region(), desk.now_s,
                compare(*shot, *truth, desk.model.region())};
    }
    return kept.outcome;
}

void row(const char* name, const char* meaning, const std::optional<double>& a,
         const std::optional<double>& b, const char* form) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    tooltip(meaning);
    for (const auto& value : {a, b}) {
        ImGui::TableNextColumn();
        if (value) {
            ImGui::Text(form, *value);
        } else {
            ImGui::TextUnformatted("-");
        }
    }
}

void table(const analysis::Possible<Comparison>& a, const analysis::Possible<Comparison>& b) {
    const auto of = [](const analysis::Possible<Comparison>& from, auto member) {
        return from.has_value() ? std::optional<double>(member(*from)) : std::nullopt;
    };
    const auto both = [&](const char* name, const char* meaning, auto member, const char* form) {
        row(name, meaning, of(a, member), of(b, member), form);
    };
    both(
        "RMSE", "Root mean square of the error, in linear accessibility",
        [](const Comparison& c) { return c.error.rmse; }, "%.4f");
    both(
        "without truth's", "The same less what the truth's own noise adds",
        [](const Comparison& c) { return c.rmse_without_truths; }, "%.4f");
    both(
        "bias", "Mean of the error: negative is too dark",
        [](const Comparison& c) { return c.error.bias; }, "%+.4f");
    both(
        "MAE", "Mean of the error's size", [](const Comparison& c) { return c.error.mae; }, "%.4f");
    both(
        "p99", "99 of 100 pixels are off by less", [](const Comparison& c) { return c.error.p99; },
        "%.4f");
    both(
        "truth's RMSE",
        "What an exact technique would show for an RMSE, by the truth's own "
        "standard error",
        [](const Comparison& c) { return c.truth_rmse; }, "%.4f");
    both(
        "pixels", "Surfaces that rays have reached",
        [](const Comparison& c) { return static_cast<double>(c.error.pixels); }, "%.0f");
    both(
        "not numbers", "NaN or infinite in the buffer",
        [](const Comparison& c) { return static_cast<double>(c.error.nonfinite); }, "%.0f");
}

void radius_field(Desk& desk) {
    const Choices& choices = desk.model.choices();
    const double standard = standard_truth_radius_m(choices);
    NumberField field{"truth's R", "Occluders further than this do not count in the truth.",
                      "m",         1e-3,
                      100.0,       standard,
                      false,       truth_radius_m(choices)};
    if (const auto value = number_field(desk, field)) {
        desk.model.change(
            [&](Choices& to) {
                to.truth_radius_m.reset();
                if (*value != standard) to.truth_radius_m = *value;
            },
            "truth's R", desk.now_s);
    }
}

}  // namespace

void error_panel(Desk& desk) {
    desk.state.panel = "error";
    if (begin_fields("truth")) {
        radius_field(desk);
        end_fields();
    }
    const auto& truth = desk.model.truth();
    if (!truth) {
        ImGui::TextUnformatted("The truth is traced once the view stands still.");
        return;
    }
    ImGui::Text("%d rays a pixel at least, %.0f on average%s", truth->least_rays(),
                truth->mean_rays(),
                desk.tracing    ? ""
                : truth->done() ? ", done"
                                : ", waiting");
    if (const auto& region = desk.model.region()) {
        ImGui::Text("region %d, %d, %d x %d", region->left, region->top, region->width,
                    region->height);
        ImGui::SameLine();
        if (ImGui::SmallButton("whole image")) desk.model.set_region(std::nullopt);
    } else {
        ImGui::TextDisabled("Shift and drag marks a region.");
    }
    const auto& a = comparison_of(desk, 'a');
    const auto& b = comparison_of(desk, 'b');
    if (ImGui::BeginTable("errors", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerH)) {
        ImGui::TableSetupColumn("");
        ImGui::TableSetupColumn("A");
        ImGui::TableSetupColumn("B");
        ImGui::TableHeadersRow();
        table(a, b);
        ImGui::EndTable();
    }
    for (const auto& [name, outcome] : {std::pair{"A", &a}, {"B", &b}}) {
        if (!outcome->has_value()) {
            ImGui::Text("%s: %s", name, outcome->reason.c_str());
            continue;
        }
        const auto& bins = (*outcome)->histogram;
        const float room =
            std::max(1.0F, ImGui::GetContentRegionAvail().x - 2.0F * ImGui::GetFontSize());
        ImGui::PlotHistogram(fmt::format("{}##histogram", name).c_str(), bins.data(),
                             static_cast<int>(bins.size()), 0, "errors from -1 to 1", 0.0F, FLT_MAX,
                             {room, 4.0F * ImGui::GetFontSize()});
    }
}

}  // namespace obscura::app::explorer
