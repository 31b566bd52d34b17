// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::app::explorer {

/// Dear ImGui's style for the explorer, in the colours of every window: dark text on light panels.
/// `text_px` is the height of the text.
void set_look(float text_px);

}  // namespace obscura::app::explorer
