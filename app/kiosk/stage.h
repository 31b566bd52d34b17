// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <optional>
#include <string>
#include <utility>

#include "app/kiosk/pace.h"
#include "app/kiosk/screens.h"
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
    std::string saved_note;  ///< what the last page says of where the answers are
};

/// Ctrl+Shift and the key that types that letter: 'q' is the operator's way out.
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

/// Asks once more whether to close it for good; nothing: the operator's key.
[[nodiscard]] std::optional<bool> ask_whether_to_abandon(Stage& stage,
                                                         const CutOffSession& session);

/// Returns when `ready_within` that many seconds is true. After half a second a page says that
/// something is being saved, and what is pressed on it is forgotten; gives whether it did.
bool wait_for_saving(Stage& stage, const std::function<bool(double)>& ready_within);

/// What `work` gives (or throws), done by another thread while the window lives on. `page_shown`
/// tells whether a page stood over the screen meanwhile.
template <typename Work>
[[nodiscard]] auto done_aside(Stage& stage, bool& page_shown, const Work& work) {
    auto result = std::async(std::launch::async, [&work] { return work(); });
    page_shown = wait_for_saving(stage, [&result](double seconds) {
        return result.wait_for(std::chrono::duration<double>(seconds)) == std::future_status::ready;
    });
    return result.get();
}

}  // namespace obscura::app::kiosk
