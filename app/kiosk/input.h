// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <limits>
#include <map>
#include <optional>
#include <variant>
#include <vector>

namespace obscura::app::kiosk {

/// A key that went down; held keys do not repeat.
struct KeyPress {
    int key = 0;        ///< GLFW_KEY_..., by its place on the keyboard
    int modifiers = 0;  ///< GLFW_MOD_...
    double time_s = 0.0;
};

/// A key as a page sees it: it went down, or repeats while it is held.
struct Stroke {
    int key = 0;             ///< GLFW_KEY_...; 0: text that came without a key
    int modifiers = 0;       ///< GLFW_MOD_...
    bool repeats = false;    ///< it is held
    char32_t character = 0;  ///< what it types; 0: nothing
};

/// A place in the window, in its own coordinates from the upper left corner.
struct PointerPlace {
    double x = 0.0;
    double y = 0.0;
    [[nodiscard]] bool operator==(const PointerPlace&) const = default;
};

/// A button of the mouse that came up where a page had seen it go down.
struct Release {
    double pressed_s = 0.0;
    double released_s = 0.0;
};

/// What keyboard and mouse did since the frame before, as a page is to see it: strokes, or one
/// button that went down or up.
struct InputFrame {
    std::vector<Stroke> strokes;          ///< one that may do more than type stands alone
    std::vector<int> buttons;             ///< of the mouse that are down
    std::optional<PointerPlace> pointer;  ///< where it was when a button went down or up
    std::optional<Release> release;       ///< of the button that came up in this frame
};

/// Keyboard and mouse, and what of them a page may see: only what went down since the page takes
/// input. What was held over from before counts as up until it goes down anew, its repeats too.
/// All times are of one monotonic clock.
class Input {
  public:
    // What happened, in order.
    void key_down(KeyPress press);
    void key_repeats(int key, int modifiers);
    /// Of the key event just before it, if there was one.
    void types(char32_t character);
    void pointer_moves(PointerPlace to) { pointer_ = to; }
    /// Where the pointer is then.
    void button_down(int button, double time_s);
    void button_up(int button, double time_s);

    /// The page takes what goes down from then on.
    void open_at(double time_s) { open_from_s_ = time_s; }
    [[nodiscard]] bool open(double time_s) const { return time_s >= open_from_s_; }
    /// Nothing that has gone down so far reaches anyone.
    void forget();

    /// What a page is to see next, in the order in which it happened. What may move the page's
    /// focus has a frame of its own, so that what comes before and after it is for where the focus
    /// is then: a stroke that does more than type, and each button that goes down or up.
    [[nodiscard]] InputFrame take_frame();
    /// Whether a frame would have more at once.
    [[nodiscard]] bool more() const { return !waiting_.empty(); }

    // For who decides by the time of a press itself: all of them since the last call.
    [[nodiscard]] std::vector<KeyPress> take_keys();
    /// When the mouse's left button, or a finger, went down.
    [[nodiscard]] std::vector<double> take_clicks();

    /// When a key or button last went down.
    [[nodiscard]] double last_press_s() const { return last_press_s_; }

  private:
    static constexpr double kNever = -std::numeric_limits<double>::infinity();

    struct TimedStroke {
        Stroke stroke;
        double pressed_s = kNever;
    };
    struct ButtonChange {
        int button = 0;
        bool down = false;
        double time_s = kNever;
        std::optional<PointerPlace> place;
    };

    /// Whether it goes on with what began before the page took input: a code without its first
    /// letters would be another code.
    [[nodiscard]] bool continues_left_out(const TimedStroke& next) const;
    /// Whether the page sees it.
    bool hand_over(const ButtonChange& change, InputFrame& frame);

    double open_from_s_ = kNever;
    double last_press_s_ = kNever;
    std::map<int, double> key_pressed_s_;
    std::map<int, double> buttons_;  ///< that the page sees as down, and when they went down
    std::optional<PointerPlace> pointer_;
    double left_out_s_ = kNever;  ///< when the last character was typed that came too early
    bool key_may_type_ = false;   ///< the last stroke may still get its character
    double key_time_s_ = kNever;  ///< press of the last key event
    std::deque<std::variant<TimedStroke, ButtonChange>> waiting_;
    std::vector<KeyPress> keys_;
    std::vector<double> clicks_;
};

}  // namespace obscura::app::kiosk
