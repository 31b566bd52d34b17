// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "app/kiosk/input.h"
#include "app/kiosk/procedure.h"

namespace obscura::app::kiosk {

/// The key (GLFW_KEY_...) that a study file calls so.
[[nodiscard]] int key_named(const std::string& name);

/// Whether a study file calls the key so that went down; a digit or Enter of the key pad too.
[[nodiscard]] bool is_key(const KeyPress& press, const std::string& name);

/// The answer that the key stands for on that page, by the study's keys or else the kiosk's: the
/// digits; of the two images also the arrows, each towards its button. Nothing: it is for none.
[[nodiscard]] std::optional<int> answer_of(const KeyPress& press, const stimuli::Study& study,
                                           const AskedPage& page);

/// The key of an answer as its button shows it, a letter, digit or arrow; empty: it has none such,
/// or its label says it.
[[nodiscard]] std::string shown_key(const AskedPage& page, int answer);

}  // namespace obscura::app::kiosk
