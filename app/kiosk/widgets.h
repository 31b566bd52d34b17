// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "app/kiosk/page.h"
#include "app/kiosk/text_entry.h"
#include "app/window/fonts.h"

namespace obscura::app::kiosk {

using window::Fonts;

/// The kiosk's calm look: dark text on a light grey card. `text_px` is the height of the text.
void set_style(float text_px);

void heading(const Fonts& fonts, const std::string& text);
/// Wrapped and spaced for reading; an empty line in the text makes a paragraph.
void paragraph(const std::string& text);
void hint(const Fonts& fonts, const std::string& text);
/// Something the reader must change.
void complaint(const std::string& text);
void gap(float lines = 1.0F);

/// The page's way on: centred, coloured; Enter presses it too.
[[nodiscard]] bool primary_button(const char* label);
/// Another way on, centred.
[[nodiscard]] bool quiet_button(const char* label);
/// As wide as given, `height` times the text's height.
[[nodiscard]] bool wide_button(const char* label, float width_px, float height, bool primary);

/// A choice of several; gives whether it was pressed.
[[nodiscard]] bool radio(const char* label, bool chosen);
void tick(const char* label, bool& ticked);

/// A line to type in. Characters that no font of the kiosk draws are shown as a box.
void text_field(const char* name, TextEntry& entry, float width_px);
/// Whether text_field() shows a box for some of it.
[[nodiscard]] bool has_boxes(const TextEntry& entry);

/// Yes and No side by side, neither chosen at first.
void yes_no(const char* name, const std::string& question, std::optional<bool>& answer);

}  // namespace obscura::app::kiosk
