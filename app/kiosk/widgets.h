// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "app/kiosk/fonts.h"

namespace obscura::app::kiosk {

/// The kiosk's calm look: dark text on a light grey card. `text_px` is the height of the text.
void set_style(float text_px);

/// Whether the keyboard moves over a card's buttons and presses them.
enum class Keyboard { kMovesAndPresses, kIsLeftToTheCaller };

/// A card in the middle of the window, `columns` times the text's height wide; it scrolls when the
/// content is higher than the window.
void card(const char* name, float columns, const std::function<void()>& content,
          Keyboard keyboard = Keyboard::kMovesAndPresses);

void heading(const Fonts& fonts, const std::string& text);
/// Wrapped and spaced for reading; an empty line in the text makes a paragraph.
void paragraph(const std::string& text);
void hint(const Fonts& fonts, const std::string& text);
/// Something the reader must change.
void complaint(const std::string& text);
void gap(float lines = 1.0F);

/// Whether Enter went down in this frame.
[[nodiscard]] bool enter_pressed();

/// Whether the key that types this letter ('a' to 'z') went down in this frame.
[[nodiscard]] bool letter_pressed(char letter);

/// The page's way on: centred, coloured; Enter presses it too.
[[nodiscard]] bool primary_button(const char* label);
/// Another way on, centred.
[[nodiscard]] bool quiet_button(const char* label);
/// As wide as given, `height` times the text's height.
[[nodiscard]] bool wide_button(const char* label, float width_px, float height, bool primary);

/// A choice of several; gives whether it was pressed.
[[nodiscard]] bool radio(const char* label, bool chosen);
void tick(const char* label, bool& ticked);

/// Yes and No side by side, neither chosen at first.
void yes_no(const char* name, const std::string& question, std::optional<bool>& answer);

}  // namespace obscura::app::kiosk
