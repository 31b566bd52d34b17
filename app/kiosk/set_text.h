// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include "app/kiosk/typesetter.h"

namespace obscura::app::kiosk {

/// Into Dear ImGui's current window, with its upper left corner there on the screen.
void draw_text(const SetText& text, ImVec2 at);

}  // namespace obscura::app::kiosk
