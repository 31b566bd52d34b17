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

// Every text is set by the page's typesetter, in any script; on a mirrored page all of this begins
// at the right.

/// The kiosk's calm look: dark text on a light grey card. `text_px` is the height of the text.
void set_style(float text_px);

void heading(const Fonts& fonts, const std::string& text);
/// Wrapped and spaced for reading; an empty line in the text makes a paragraph.
void paragraph(const std::string& text);
void hint(const Fonts& fonts, const std::string& text);
/// Something the reader must change.
void complaint(const std::string& text);
void gap(float lines = 1.0F);

/// Width of a text on one line, in pixels.
[[nodiscard]] float text_width(const std::string& text);

/// Things side by side in the order of reading, on further lines where there is no room.
class SideBySide {
  public:
    explicit SideBySide(float apart_px);
    /// Moves Dear ImGui's cursor to where the next thing, so wide, is to be drawn.
    void next(float width_px);

  private:
    float apart_px_;
    float left_px_;
    float room_px_;
    float used_px_ = 0.0F;
    bool first_ = true;
};

/// The page's way on: centred, coloured; Enter presses it too.
[[nodiscard]] bool primary_button(const std::string& label);
/// Another way on, centred.
[[nodiscard]] bool quiet_button(const std::string& label);
/// As wide as given, `height` times the text's height, or as high as its label.
[[nodiscard]] bool wide_button(const std::string& label, float width_px, float height,
                               bool primary);
/// For the mouse or a finger only: the keyboard has it already.
[[nodiscard]] bool pad_button(const std::string& label, float width_px);

/// A choice of several, the next of a row; gives whether it was pressed.
[[nodiscard]] bool radio(SideBySide& row, const std::string& label, bool chosen);
void tick(const std::string& label, bool& ticked);

/// The label of what has to be answered, marked so.
[[nodiscard]] std::string marked_required(const std::string& label);

/// A text beside a field, the next of a row.
void row_text(SideBySide& row, const std::string& text);
/// A line to type in. Characters that no font of the machine draws are shown as a box.
void text_field(const char* name, TextEntry& entry, float width_px);
/// Keys on the screen for the field of that name, drawn below it: while it was pressed by mouse or
/// finger, and no keyboard has typed since. Letters are those of the page's words, of which the
/// others are a key away where a language is not written in Latin.
enum class KeypadLetters { kOfLanguage, kLatin };
void keypad(const char* name, TextEntry& entry, KeypadLetters first = KeypadLetters::kOfLanguage);
/// Whether text_field() shows a box for some of it.
[[nodiscard]] bool has_boxes(const TextEntry& entry);

/// Yes and No side by side, neither chosen at first.
void yes_no(const char* name, const std::string& question, std::optional<bool>& answer);

}  // namespace obscura::app::kiosk
