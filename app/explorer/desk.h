// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/explorer/fitted_values.h"
#include "app/explorer/model.h"
#include "app/window/fonts.h"

namespace obscura::app::explorer {

/// Something that was said to the person at the window.
struct Message {
    std::string text;
    bool problem = false;
    double said_s = 0.0;
};

/// What panels ask to be done once the frame is drawn; done and forgotten by the explorer.
struct Orders {
    std::optional<std::string> open;       ///< a scene's id or file, or a study
    std::optional<std::string> condition;  ///< of the open study, to be shown
    bool cancel_opening = false;
    bool save_image = false;          ///< of A and B, as PNG
    bool save_buffers = false;        ///< the same as EXR
    bool save_to_study = false;       ///< what the dialog says
    std::optional<std::string> copy;  ///< text for the clipboard
    bool close = false;
};

/// The fields of the dialog that writes into a study.
struct StudyDialog {
    std::string file;
    std::string scene_id;
    std::string condition_id;
    bool camera_only = false;         ///< the scene alone, without a condition
    bool replaces = false;            ///< the condition of that id gets A and B
    bool takes_changed_file = false;  ///< the file changed on disk, and that is all right
    std::string problem;              ///< why the last try was refused
    bool done = false;                ///< it was written: the dialog closes
};

/// Comparing a whole image takes tens of milliseconds: what came of it, while nothing changes.
struct KeptComparison {
    std::shared_ptr<const Shot> shot;
    std::shared_ptr<const Truth> truth;
    std::optional<Region> region;
    double made_s = -1e9;
    analysis::Possible<Comparison> outcome = analysis::Possible<Comparison>::none("nothing yet");
};

/// What the panels remember from frame to frame beside the model.
struct PanelState {
    bool help = false;
    bool panels = true;
    std::string open_path;
    bool open_dialog = false;
    bool study_dialog_open = false;
    StudyDialog study_dialog;
    std::string environment;  ///< as it is typed
    unsigned typed_id = 0;    ///< the slider that is being typed into; 0: none
    bool typed_begins = false;
    std::string typed;
    double pressed_value = 0.0;  ///< of a slider when the mouse went down on it
    float speed_m_s = 1.0F;
    std::optional<glm::vec2> pointer_px;  ///< in the image
    int active_pane = 0;
    std::vector<Message> messages;
    float text_scale = 1.0F;
    float whole_zoom = 1.0F;      ///< screen pixels of one of the image's, where all of it is shown
    bool keys_in_panels = false;  ///< they go through the panels and do not fly
    std::map<char, KeptComparison> comparisons;  ///< by side
    std::vector<FittedValues> fitted;            ///< of the last `measure --fit` in the data folder
    /// Middles of the fields, by panel and name (`b/radius_m`, `b/technique/hbao`), as they were
    /// drawn last: for those who drive the window from outside.
    std::map<std::string, glm::vec2> places;
    std::string panel;  ///< that is being drawn
};

/// All that a panel may use for one frame.
struct Desk {
    Model& model;
    double now_s = 0.0;
    const window::Fonts& fonts;
    Orders& orders;
    PanelState& state;
    std::string device = {};
    std::string opening = {};  ///< what is being opened; empty: nothing
    double opening_s = 0.0;
    bool rendering = false;
    bool tracing = false;

    void say(std::string text, bool problem = false) const {
        state.messages.push_back({std::move(text), problem, now_s});
    }
};

// The panels, each in the file of its name.
void menu_bar(Desk& desk);
void technique_panel(Desk& desk, char side);
void scene_panel(Desk& desk);
void view_panel(Desk& desk);
void error_panel(Desk& desk);
void cost_panel(Desk& desk);
void status_bar(Desk& desk, float height_px);
void help_window(Desk& desk);
void open_window(Desk& desk);
void study_window(Desk& desk);

}  // namespace obscura::app::explorer
