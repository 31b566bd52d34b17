// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/kiosk/operator_report.h"
#include "app/kiosk/stage.h"

namespace obscura::app::kiosk {

/// What the operator's page asks the store and the disk for. Each may throw; the page says why.
struct OperatorHooks {
    std::function<OperatorReport()> report;
    /// Copies the store; a sentence for the operator.
    std::function<std::string()> back_up;
    /// Erases the participant of that session; a sentence for the operator.
    std::function<std::string(const analysis::SessionRecord&)> withdraw;
    std::function<std::vector<std::string>()> machine_lines;  ///< disk and timing
    std::filesystem::path pin;  ///< its file; not there: the operator needs none
};

/// The operator's page through its parts, behind the PIN where there is one.
class OperatorsPage {
  public:
    /// `stage` must outlive it.
    OperatorsPage(Stage& stage, OperatorHooks hooks) : stage_(stage), hooks_(std::move(hooks)) {}

    /// Shown anew, locked. `session_open`: one is under way, which leaving cuts off. The session on
    /// the screen, which still writes, cannot be withdrawn before the next participant's turn.
    void open(bool session_open, const std::string& session_on_screen);
    /// Draws it; gives the operator's wish to leave the kiosk or to go back to it.
    [[nodiscard]] std::optional<Event> draw();
    /// Does what was pressed, between two frames. True: another page stood over it meanwhile.
    [[nodiscard]] bool act();

  private:
    void try_pin();
    void show_overview();
    void choose();
    /// The work's sentence, or why it failed, as the page's note.
    void note_of(const std::function<std::string()>& work);

    Stage& stage_;
    OperatorHooks hooks_;
    OperatorView view_;
    OperatorReport report_;
    std::string session_on_screen_;
    std::optional<OperatorAct> pressed_;
    int wrong_pins_ = 0;
    double next_pin_s_ = 0.0;
    bool covered_ = false;
};

}  // namespace obscura::app::kiosk
