// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/explorer/layout.h"

namespace obscura::app::explorer {

/// What the explorer keeps from one time to the next.
struct Remembered {
    int window_width = 0;  ///< 0: nothing is known
    int window_height = 0;
    std::string what;  ///< study, scene or file that was open
    float text_scale = 1.0F;
    bool panels = true;
    Layout layout;
};

/// As JSON, and back; what is missing or nonsense is as if it had not been kept.
[[nodiscard]] std::string to_json(const Remembered& remembered);
[[nodiscard]] Remembered remembered_from(const std::string& json);

/// `explorer.json` in the data folder. Nothing where it is not there or cannot be read.
[[nodiscard]] std::optional<Remembered> load_remembered(const std::filesystem::path& data);
/// Throws failure where it cannot be written.
void save_remembered(const std::filesystem::path& data, const Remembered& remembered);

}  // namespace obscura::app::explorer
