// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

struct GLFWwindow;

namespace obscura::app::kiosk {

/// When a frame that was handed over is visible: where the driver has GLX_OML_sync_control (a
/// display's own count and time of swaps), that time; else when the driver has drawn all of it
/// after the swap, which is no later than the next refresh where swapping waits for it.
class SwapClock {
  public:
    /// Of the window whose context is current.
    explicit SwapClock(GLFWwindow* window);

    /// `GLX_OML_sync_control` or `glFinish after the swap`: how times come about.
    [[nodiscard]] const char* source() const;
    /// Right after the swap: waits until it is done; gives its time on the monotonic clock.
    [[nodiscard]] double shown_s();

  private:
    using WaitForSwap = int (*)(void* display, unsigned long drawable, std::int64_t target,
                                std::int64_t* time_us, std::int64_t* refreshes,
                                std::int64_t* swaps);

    void* display_ = nullptr;
    unsigned long drawable_ = 0;
    WaitForSwap wait_for_swap_ = nullptr;  ///< nullptr: the driver has no such clock
};

}  // namespace obscura::app::kiosk
