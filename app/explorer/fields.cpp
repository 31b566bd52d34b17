// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/fields.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "app/window/theme.h"

namespace obscura::app::explorer {
namespace {

/// Of the item just drawn.
void note_place(Desk& desk, const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    desk.state.places[desk.state.panel + '/' + name] = {0.5F * (low.x + high.x),
                                                        0.5F * (low.y + high.y)};
}

/// The name in the first column; a dot marks what is not at its standard.
void name_cell(const std::string& name, const std::string& tip, bool differs) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (differs) {
        ImGui::PushStyleColor(ImGuiCol_Text, window::theme::kAccent);
        ImGui::TextUnformatted(("\xE2\x80\xA2 " + name).c_str());
        ImGui::PopStyleColor();
    } else {
        ImGui::TextUnformatted(name.c_str());
    }
    tooltip(tip);
    ImGui::TableNextColumn();
}

[[nodiscard]] std::string range_of(const NumberField& field) {
    return fmt::format("{:g} to {:g}{}{}", field.low, field.high, field.unit.empty() ? "" : " ",
                       field.unit);
}

/// Where most of the range is far above the standard, equal steps would crowd what matters.
[[nodiscard]] bool spans_magnitudes(const NumberField& field) {
    return !field.whole && field.standard - field.low < 0.1 * (field.high - field.low);
}

[[nodiscard]] std::optional<double> typing(Desk& desk, const NumberField& field) {
    PanelState& state = desk.state;
    const bool begins = std::exchange(state.typed_begins, false);
    if (begins) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0F);
    const bool entered =
        ImGui::InputText("##typed", &state.typed,
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    const bool left = ImGui::IsItemDeactivated() && !entered;
    if (entered || left) state.typed_id = 0;
    if (!entered) return std::nullopt;
    std::string problem;
    const auto value = typed_number(field, state.typed, problem);
    if (!value) desk.say(problem, true);
    return value;
}

[[nodiscard]] std::optional<double> sliding(Desk& desk, const NumberField& field, unsigned id,
                                            float width_px) {
    PanelState& state = desk.state;
    double value = field.value;
    // A long unit leaves no room for the number; the tooltip has it.
    constexpr std::size_t kShort = 4;
    const bool short_unit = !field.unit.empty() && field.unit.size() <= kShort;
    const std::string form =
        value == 0.0 && !field.at_zero.empty()
            ? field.at_zero
            : (field.whole ? "%.0f" : "%.4g") + (short_unit ? " " + field.unit : std::string());
    ImGui::SetNextItemWidth(width_px);
    const bool changed = ImGui::SliderScalar(
        "##slider", ImGuiDataType_Double, &value, &field.low, &field.high, form.c_str(),
        spans_magnitudes(field) ? ImGuiSliderFlags_Logarithmic : 0);
    note_place(desk, field.name);
    if (ImGui::IsItemActivated() && ImGui::GetIO().MouseClickedCount[0] < 2) {
        state.pressed_value = field.value;
    }
    if (ImGui::IsItemDeactivated()) desk.model.settle();
    const bool twice = ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    tooltip(fmt::format("{} Range {}, default {:g}. Double-click to type.", field.tooltip,
                        range_of(field), field.standard));
    if (twice) {
        // The first click moved it.
        state.typed_id = id;
        state.typed_begins = true;
        state.typed = fmt::format("{}", state.pressed_value);
        ImGui::ClearActiveID();
        return state.pressed_value;
    }
    if (!changed) return std::nullopt;
    if (!(value >= field.low && value <= field.high)) {
        desk.say(
            fmt::format("{}: {} is not allowed, allowed is {}", field.name, value, range_of(field)),
            true);
        return std::nullopt;
    }
    return value;
}

}  // namespace

std::optional<double> typed_number(const NumberField& field, const std::string& text,
                                   std::string& problem) {
    const std::size_t first = text.find_first_not_of(" \t+");
    const std::size_t last = text.find_last_not_of(" \t");
    double value = 0.0;
    bool is_number = false;
    if (first != std::string::npos) {
        const char* const end = text.data() + last + 1;
        const auto [rest, error] = std::from_chars(text.data() + first, end, value);
        is_number = error == std::errc() && rest == end && std::isfinite(value);
    }
    const bool whole = !field.whole || value == std::floor(value);
    if (is_number && whole && value >= field.low && value <= field.high) return value;
    problem = fmt::format("{}: \"{}\" is not allowed, allowed is {}{}", field.name, text,
                          field.whole ? "a whole number from " : "", range_of(field));
    return std::nullopt;
}

std::optional<double> number_field(Desk& desk, const NumberField& field) {
    const bool differs = field.value != field.standard;
    name_cell(field.name, field.tooltip, differs);
    ImGui::PushID(field.name.c_str());
    const unsigned id = ImGui::GetID("typed");
    std::optional<double> value;
    if (desk.state.typed_id == id) {
        value = typing(desk, field);
    } else {
        const float room = ImGui::CalcTextSize("reset").x + 4.0F * ImGui::GetStyle().FramePadding.x;
        value = sliding(desk, field, id, -room);
        ImGui::SameLine();
        ImGui::BeginDisabled(!differs);
        if (ImGui::SmallButton("reset")) value = field.standard;
        ImGui::EndDisabled();
    }
    ImGui::PopID();
    return value;
}

std::optional<std::string> choice_field(Desk& desk, const std::string& name, const std::string& tip,
                                        const std::vector<std::string>& words,
                                        const std::string& now,
                                        const std::vector<std::string>& tooltips,
                                        const std::string& standard) {
    name_cell(name, tip, !standard.empty() && now != standard);
    std::optional<std::string> chosen;
    ImGui::PushID(name.c_str());
    ImGui::SetNextItemWidth(-1.0F);
    const bool open = ImGui::BeginCombo("##choice", now.c_str(), ImGuiComboFlags_HeightLarge);
    if (!open) note_place(desk, name);
    if (open) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            const bool is_now = words[i] == now;
            if (ImGui::Selectable(words[i].c_str(), is_now) && !is_now) chosen = words[i];
            note_place(desk, name + '/' + words[i]);
            if (i < tooltips.size()) tooltip(tooltips[i]);
            if (is_now) ImGui::SetItemDefaultFocus();
        }
        ImGui::EndCombo();
    } else {
        tooltip(tip);
    }
    ImGui::PopID();
    return chosen;
}

bool text_field(const char* name, std::string& text, float width_px) {
    ImGui::SetNextItemWidth(width_px);
    return ImGui::InputText(name, &text, ImGuiInputTextFlags_EnterReturnsTrue);
}

void tooltip(const std::string& text) {
    if (text.empty() || !ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(28.0F * ImGui::GetFontSize());
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool escape_pressed() { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false); }

bool begin_fields(const char* name) {
    if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingStretchProp)) return false;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.38F);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.62F);
    return true;
}

void end_fields() { ImGui::EndTable(); }

}  // namespace obscura::app::explorer
