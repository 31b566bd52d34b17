// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "app/kiosk/pace.h"
#include "app/kiosk/screens/screens.h"
#include "app/kiosk/ui.h"
#include "app/kiosk/window.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// What a session is played on.
struct Stage {
    Window& window;
    Ui& ui;
    const stimuli::Study& study;
    std::filesystem::path folder;  ///< of the study's images
    Pace pace;
};

/// Ctrl+Shift and that letter: 'q' is the operator's way out.
[[nodiscard]] bool is_operators_key(const KeyPress& press, char letter = 'q');

/// Begins a page: draws it until its layout is settled, without presenting it. It takes no input
/// before the window's input is opened.
void draw_first_frame(Ui& ui, const std::function<void()>& page);

/// Waits for input and draws the page again; `idle_frames` counts frames without input.
void draw_next_frame(Stage& stage, const std::function<void()>& page, int& idle_frames);

enum class TroubleChoice { kRetry, kLeave };

/// Shows the trouble until someone tries again, or the operator leaves by the operator's key.
[[nodiscard]] TroubleChoice ask_about_trouble(Stage& stage, const Trouble& trouble);

/// Shows the session until the operator decides; nothing: the operator's key.
[[nodiscard]] std::optional<CutOffChoice> ask_about_cut_off(Stage& stage,
                                                            const CutOffSession& session);

}  // namespace obscura::app::kiosk
