// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "app/explorer/desk.h"

namespace obscura::app::explorer {

/// What keys and a gamepad do beside the panels, in the frame that Dear ImGui has begun. `frame_s`
/// is how long it was since the last one. Gives whether something is held, so that the next frame
/// should come soon.
bool keyboard_and_gamepad(Desk& desk, double frame_s);

/// Whether there is one: it sends no events and has to be looked at.
[[nodiscard]] bool has_gamepad();

}  // namespace obscura::app::explorer
