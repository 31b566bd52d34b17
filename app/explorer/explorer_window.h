// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/explorer/kept_panel.h"
#include "app/window/fonts.h"

struct GLFWwindow;

namespace obscura::app::explorer {

/// Width and height of a window in pixels; nothing: of its own choice.
struct WindowSize {
    int width = 0;
    int height = 0;
};

/// The explorer's window with its OpenGL context, current while it lives, and Dear ImGui in it.
class ExplorerWindow {
  public:
    /// Throws failure when there is no display or no driver, naming it.
    explicit ExplorerWindow(const std::optional<WindowSize>& size);
    ~ExplorerWindow();
    ExplorerWindow(const ExplorerWindow&) = delete;
    ExplorerWindow& operator=(const ExplorerWindow&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return window_; }
    [[nodiscard]] const window::Fonts& fonts() const { return fonts_; }
    [[nodiscard]] WindowSize size() const;
    [[nodiscard]] bool wants_to_close() const;
    void close();
    void set_title(const std::string& title);

    /// Lets events in, for at most that long, and begins a frame of Dear ImGui: not before
    /// `not_before_s`, unless `at_once` says so when the window is woken.
    void begin_frame(double wait_s, double not_before_s = 0.0,
                     const std::function<bool()>& at_once = {});
    /// Draws it and shows it. `kept` is a panel that may be shown as it was a moment ago.
    void end_frame(const std::optional<PanelPlace>& kept = std::nullopt);
    /// From any thread: ends the waiting of begin_frame.
    static void wake();

    /// Files dropped on the window since it was asked last.
    [[nodiscard]] std::vector<std::string> take_dropped();
    /// Factor of the text's size over the screen's own, 0.5 to 3.
    void set_text_scale(float factor) { wanted_text_scale_ = factor; }
    [[nodiscard]] float text_scale() const { return text_scale_; }
    /// When the first input came that no frame has shown yet; nothing: none did.
    [[nodiscard]] std::optional<double> first_input_s() const { return first_input_s_; }

    /// Whether a key or button went down that no frame has shown yet.
    [[nodiscard]] bool pressed() const { return pressed_; }

    /// Whether the driver was reset, so that nothing can be drawn in this window any more.
    [[nodiscard]] bool is_lost() const;
    /// Says so from now on: for those who have no driver that resets.
    void lose() { told_lost_ = true; }

    /// Seconds of GLFW's monotonic clock.
    [[nodiscard]] static double now_s();

  private:
    struct Callbacks;
    void load_fonts();
    [[nodiscard]] float screen_scale() const;
    /// A key that went down and up since the last frame is down for this one.
    void show_short_presses();

    /// A key that went down.
    struct Press {
        int key = 0;
        int modifiers = 0;  ///< GLFW_MOD_...
    };

    GLFWwindow* window_ = nullptr;
    std::unique_ptr<KeptPanel> kept_panel_;  ///< while there is a context
    window::Fonts fonts_;
    float text_scale_ = 1.0F;
    float wanted_text_scale_ = 1.0F;
    float screen_scale_ = 0.0F;  ///< that the fonts were made for
    std::vector<std::string> dropped_;
    std::vector<Press> presses_;  ///< since the last frame
    std::vector<int> shown_;      ///< keys that are down for this frame alone
    std::optional<double> first_input_s_;
    bool pressed_ = false;
    bool told_lost_ = false;
};

}  // namespace obscura::app::explorer
