// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "app/kiosk/display_facts.h"
#include "app/kiosk/response_box.h"
#include "app/kiosk/window.h"
#include "stimuli/questions.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

struct KioskOptions {
    std::filesystem::path folder;  ///< of the study's images and manifest
    std::string store_url;
    std::filesystem::path backups;  ///< folder for copies of an SQLite store
    std::string
        remedy;  ///< the command that makes the images, for the message that they are missing
    std::string monitor = {};  ///< its name or number; empty: the last one, at first 0
    bool windowed = false;
    std::string override_reason;  ///< why to go on where the start refuses; empty: it refuses
    std::filesystem::path data;   ///< where the last self-test lies
    DisplayFacts facts = {};      ///< that the operator gave this time
    ResponseBoxOptions response_box = {};
    bool photodiode = false;            ///< a square in a corner, white while an image is shown
    stimuli::Questions questions = {};  ///< that the study asks of each pair
};

/// A window with room for what the study shows.
[[nodiscard]] WindowOptions window_options(const stimuli::Study& study,
                                           const KioskOptions& options);

/// Runs participants through the study until the operator leaves.
/// Before anyone sits down, throws bad input when an image is missing or is not that of
/// the manifest, when the monitor is smaller than the images, or when the store cannot be used;
/// failure when there is no display or another kiosk is running on an SQLite store. Little disk, a
/// clock that ran backwards and, on a whole monitor, swapping that does not wait for the refresh
/// are failures too unless there is a reason to go on, which every answer then carries. Sessions
/// that were cut off come first: the operator continues or closes each. Throws failure at the end
/// when the operator left while something could not be saved.
void run_kiosk(const stimuli::Study& study, const KioskOptions& options);

}  // namespace obscura::app::kiosk
