// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <signal.h>

namespace obscura::base {

/// While it lives, the first Ctrl-C asks the work to stop; the second ends the program.
class StopOnInterrupt {
  public:
    StopOnInterrupt();
    ~StopOnInterrupt();
    StopOnInterrupt(const StopOnInterrupt&) = delete;
    StopOnInterrupt& operator=(const StopOnInterrupt&) = delete;

    /// Whether it was asked to.
    [[nodiscard]] bool asked() const;

  private:
    struct sigaction before_ = {};
};

}  // namespace obscura::base
