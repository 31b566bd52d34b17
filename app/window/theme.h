// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

/// The pages' colours, sRGB from 0 to 1. Text has a contrast of at least 7:1 with what is behind it
/// (WCAG 2.2, success criterion 1.4.6), as a test computes.
namespace obscura::app::window::theme {

inline const ImVec4 kCard{0.855F, 0.858F, 0.862F, 1.0F};
inline const ImVec4 kField{0.955F, 0.957F, 0.960F, 1.0F};
inline const ImVec4 kFieldHovered{0.985F, 0.987F, 0.990F, 1.0F};
inline const ImVec4 kLine{0.60F, 0.61F, 0.63F, 1.0F};
inline const ImVec4 kInk{0.10F, 0.11F, 0.13F, 1.0F};
inline const ImVec4 kFaintInk{0.24F, 0.26F, 0.29F, 1.0F};
inline const ImVec4 kAccent{0.145F, 0.325F, 0.500F, 1.0F};
inline const ImVec4 kAccentHovered{0.160F, 0.350F, 0.530F, 1.0F};
inline const ImVec4 kAccentPressed{0.110F, 0.255F, 0.400F, 1.0F};
inline const ImVec4 kOnAccent{0.985F, 0.99F, 1.0F, 1.0F};
inline const ImVec4 kQuiet{0.745F, 0.752F, 0.762F, 1.0F};
inline const ImVec4 kQuietHovered{0.70F, 0.712F, 0.728F, 1.0F};
inline const ImVec4 kQuietPressed{0.67F, 0.685F, 0.702F, 1.0F};
inline const ImVec4 kComplaint{0.50F, 0.08F, 0.06F, 1.0F};

/// Dear ImGui's style in these colours; its sizes are each window's own.
void set_colours(ImGuiStyle& style);

}  // namespace obscura::app::window::theme
