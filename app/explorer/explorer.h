// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/explorer/desk.h"
#include "app/explorer/explorer_window.h"
#include "app/explorer/opener.h"
#include "app/explorer/render_worker.h"
#include "app/explorer/truth_worker.h"
#include "app/explorer/view_area.h"

namespace obscura::app::explorer {

struct ExploreOptions {
    std::string what;            ///< study, scene or file; empty: what was open last, or the atrium
    std::filesystem::path data;  ///< the data folder
    bool reset = false;          ///< forget window, scene and layout of the last time
    std::optional<WindowSize> window;  ///< nothing: as the last time
    std::optional<WindowSize> image;   ///< nothing: the study's
};

/// The window, the model and the workers, joined.
class Explorer {
  public:
    /// Throws failure without a display; bad input for what cannot be opened, naming it.
    explicit Explorer(ExploreOptions options);
    /// Remembers window, scene and layout.
    ~Explorer();
    Explorer(const Explorer&) = delete;
    Explorer& operator=(const Explorer&) = delete;

    /// One frame. False: the window was closed. Throws failure where the driver was reset, when
    /// view and pair are in a study file of the data folder, which it names.
    bool step();

    [[nodiscard]] Model& model() { return model_; }
    [[nodiscard]] PanelState& state() { return state_; }
    [[nodiscard]] ExplorerWindow& window() { return window_; }
    /// Whether nothing is opened, rendered or to be rendered.
    [[nodiscard]] bool at_rest() const;
    /// What a dropped file, a menu or the command line names. Throws bad input.
    void open(const std::string& what);
    void show_condition(const std::string& id);

    /// What was put in since the frame before, and the image that showed it.
    struct Answered {
        double input_s = 0.0;  ///< the first of it, when the window heard of it
        double shown_s = 0.0;
        std::uint64_t look = 0;  ///< what the image shows
    };
    /// Since it was asked last, in their order.
    [[nodiscard]] std::vector<Answered> take_answered() { return std::exchange(answered_, {}); }

  private:
    /// That a frame waits for something to happen.
    [[nodiscard]] double longest_wait_s() const;
    void take_results();
    /// Once everything is at rest with a new scene.
    void give_back_memory();
    /// What was measured for the scene may have come since.
    void read_fitted();
    void ask_for_work();
    void draw(Desk& desk);
    void draw_side_panel(Desk& desk, const Box& box);
    void carry_out(Orders& orders);
    void save_when_ready();
    void save_to_study();
    [[noreturn]] void end_without_driver();
    /// What the images on the screen show by now.
    void note_answered();
    /// Where something is saved that was given no name.
    [[nodiscard]] std::filesystem::path file_for(char side, const char* ending) const;
    void say(std::string text, bool problem = false);

    ExploreOptions options_;
    ExplorerWindow window_;
    Model model_;
    PanelState state_;
    ViewArea view_;
    RenderWorker renderer_;
    TruthWorker tracer_;
    Opener opener_;
    bool software_ = true;
    bool keys_held_ = false;
    int frames_due_ = 0;                          ///< that wait for nothing
    std::optional<PanelPlace> side_panel_;        ///< as it was drawn last
    double frame_s_ = 0.0;                        ///< when the last one began
    std::optional<renderer::Camera> own_camera_;  ///< of the study, for the scene being opened
    bool waiting_image_ = false;                  ///< to be saved once it is as good as it gets
    bool waiting_buffers_ = false;
    bool scene_is_new_ = false;         ///< since everything was at rest
    double truth_s_ = 0.0;              ///< when the truth was looked at last
    std::vector<Answered> unanswered_;  ///< inputs that no rendered image shows yet
    std::vector<Answered> answered_;
};

/// Runs until the window is closed.
void run_explorer(ExploreOptions options);

}  // namespace obscura::app::explorer
