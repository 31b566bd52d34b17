// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "app/kiosk/choice_model.h"
#include "app/kiosk/journal.h"
#include "app/kiosk/procedure.h"
#include "renderer/base/random.h"

namespace obscura::app::kiosk {

/// A clock that moves only when it is told to. Its time begins at 2000-01-01T00:00:00Z, so that
/// nobody takes it for real.
class VirtualClock {
  public:
    void pass(double seconds) { now_s_ += seconds; }
    /// On to the next refresh of a display of kRefresh_hz, or to that at or after `earliest_s`.
    void pass_to_refresh(double earliest_s);
    [[nodiscard]] Moment now() const;

    static constexpr double kRefresh_hz = 60.0;

  private:
    double now_s_ = 0.0;
};

/// Goes through a new procedure from its start to the end on a virtual clock, as a participant
/// would: reads, looks for a while drawn from a log-normal distribution, waits out the grey
/// interval, answers as an Observer of `choices`. Its rows go through the journal before the next
/// screen, as in the kiosk. The plan's kind must be simulated. Throws failure when a row cannot be
/// saved.
void simulate_observer(Procedure& procedure, const ChoiceModel& choices, base::Random& random,
                       VirtualClock& clock, Journal& journal);

/// The machine that simulated sessions say they ran on.
[[nodiscard]] Machine simulated_machine();

}  // namespace obscura::app::kiosk
