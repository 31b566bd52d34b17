// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "app/kiosk/journal.h"
#include "app/kiosk/operators_page.h"
#include "app/kiosk/procedure.h"
#include "app/kiosk/stage.h"
#include "app/kiosk/stimulus_view.h"

namespace obscura::app::kiosk {

/// Plays one procedure on the stage: shows its screens, forwards what happens to it, and has its
/// rows committed before the next screen.
class SessionRunner {
  public:
    enum class End { kDone, kLeft };

    /// All must outlive it.
    SessionRunner(Stage& stage, Procedure& procedure, Journal& journal, OperatorsPage& operators)
        : stage_(stage),
          procedure_(procedure),
          journal_(journal),
          operators_(operators),
          interval_(stage.study) {}

    /// Returns when the participant is done or the operator left.
    [[nodiscard]] End run();

  private:
    /// Both images of a pair, on the GPU.
    struct LoadedPair {
        int pair = 0;
        std::unique_ptr<StimulusTexture> first;
        std::unique_ptr<StimulusTexture> second;
    };

    /// False: the operator left with rows that could not be saved.
    [[nodiscard]] bool save();
    /// Why rows could not be saved; `covered` becomes true where a page stood over the screen.
    [[nodiscard]] std::optional<std::string> flush(bool& covered);
    /// False: an image could not be read and the operator left.
    [[nodiscard]] bool load_pair();
    /// Tells the procedure whether the window is to be seen.
    void watch();
    /// In place of a screen that is hidden.
    void go_on_hidden();
    void show_first_frame();
    void finish_presenting(double asked_s);
    void go_on();
    void go_on_with_page();
    void go_on_with_image();
    /// A screen that goes by itself.
    void go_on_until_due();
    /// Draws it again where the system lost it.
    void mend_still();
    void draw_still(Screen screen);
    /// A page; keeps what was pressed in `pressed_`.
    void draw_page(Screen screen);
    /// To the procedure: keys that its screen knows, clicks on an image.
    void forward_presses();
    void feed(const Event& event, const Moment& moment);

    Stage& stage_;
    Procedure& procedure_;
    Journal& journal_;
    OperatorsPage& operators_;
    int opened_ = 0;  ///< Procedure::request() for which the operator's page was opened
    FormDraft form_;
    IntervalView interval_;
    std::optional<LoadedPair> loaded_;
    std::optional<Event> pressed_;
    int presented_ = 0;  ///< Procedure::request() of what is visible
    int idle_frames_ = 0;
    bool hidden_page_ = false;  ///< shown in place of the screen
    double restored_s_ = 0.0;   ///< when the window was last brought back
    double asked_s_ = 0.0;      ///< when the screen was asked for
};

}  // namespace obscura::app::kiosk
