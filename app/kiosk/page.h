// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "app/kiosk/input.h"
#include "app/kiosk/typesetter.h"
#include "stimuli/words.h"

namespace obscura::app::kiosk {

/// Whether the keyboard moves over a page's fields and buttons and presses them.
enum class Keyboard { kMovesAndPresses, kIsLeftToTheCaller };

/// A place of a page where the keyboard can be.
struct FocusStop {
    unsigned id = 0;  ///< Dear ImGui's
    float top_px = 0.0F;
    float height_px = 0.0F;
    bool in_body = false;
    bool primary = false;  ///< the page's way on
    bool text = false;     ///< takes typing
};

/// The keys on the screen: below a field that was pressed by mouse or finger, until a keyboard
/// types.
struct KeypadState {
    unsigned field = 0;     ///< Dear ImGui's id of it; 0: no keys
    bool capitals = false;  ///< for the next letter
    bool changed = false;   ///< other letters than those that come first
    bool pressed = false;   ///< one of them, in this frame
    int frames = 0;         ///< drawn below that field
};

/// A page's first frame is drawn as often: a card's height is known when it was drawn once, its
/// scroll bar when twice, and with that its height again.
inline constexpr int kFirstFrames = 4;

/// What every page is written with. Both outlive the page.
struct PageTools {
    Typesetter* typesetter = nullptr;
    const stimuli::Words* words = nullptr;
};

/// What a page on the screen remembers from frame to frame; a page shown anew begins anew.
struct PageState {
    PageTools tools;
    bool end_seen = false;  ///< its last line was in view
    InputFrame input;       ///< for the frame being drawn
    int frames = 0;         ///< drawn so far
    // Of the frame before.
    float body_px = 0.0F;
    float foot_px = 0.0F;
    float scrolled_px = 0.0F;
    bool at_end = false;  ///< of what scrolls
    std::vector<FocusStop> stops;
    // Of this frame.
    std::vector<FocusStop> stops_now;
    Keyboard keyboard = Keyboard::kMovesAndPresses;
    bool in_body = false;
    float scroll_px = 0.0F;  ///< to scroll by
    unsigned focus = 0;      ///< the stop where the keyboard is
    bool reveal = false;     ///< scroll until that is in view
    bool focus_next = false;
    KeypadState keypad;
    bool keyboard_types = false;  ///< a keyboard has typed on this page

    /// As a page that nobody has seen.
    void begin_anew() {
        const PageTools kept = tools;
        *this = PageState();
        tools = kept;
    }
};

/// That of the current Dear ImGui context, which Ui puts there.
[[nodiscard]] PageState& page_state();

/// The kiosk's words, in the language of the page.
[[nodiscard]] const stimuli::Words& words();
/// Whether the page is mirrored: its language is written from right to left.
[[nodiscard]] bool is_mirrored();

/// A card in the middle of the window, `columns` times the text's height wide: a body, and a foot
/// that stays in view below it. A body that is higher than the window has room for opens at its
/// top and scrolls by wheel, scroll bar, arrows, Page Up, Page Down, Home and End; until its end
/// was seen a button that scrolls on stands in place of the foot.
void card(const char* name, float columns, const std::function<void()>& body,
          const std::function<void()>& foot = nullptr,
          Keyboard keyboard = Keyboard::kMovesAndPresses);

/// So many times the text's height, in whole pixels. Heights on a page are whole ones, or what
/// scrolls would be higher above the window than in it: Dear ImGui rounds places towards 0.
[[nodiscard]] float times_text(float times);

/// Whether a key (GLFW_KEY_...) went down in this frame.
[[nodiscard]] bool key_pressed(int key);
[[nodiscard]] bool enter_pressed();
/// The same of the key that types this letter ('a' to 'z').
[[nodiscard]] bool letter_pressed(char letter);

/// Makes the next stop that is drawn the one where the keyboard is.
void focus_next();

/// Whether what is drawn next can be neither pressed nor filled in.
[[nodiscard]] bool is_disabled();

/// Makes the item that is drawn next a stop; gives whether the keyboard is there.
enum class StopKind { kPlain, kPrimary, kText };
[[nodiscard]] bool begin_stop(unsigned id, StopKind kind = StopKind::kPlain);
/// After the item: rings it where the keyboard is, and moves the keyboard to where the mouse
/// pressed. Gives whether the space bar pressed it.
[[nodiscard]] bool end_stop(unsigned id, bool here);

}  // namespace obscura::app::kiosk
