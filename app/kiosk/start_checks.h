// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "analysis/store/store.h"
#include "app/kiosk/pace.h"
#include "app/kiosk/window.h"
#include "stimuli/manifest.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

// What a kiosk refuses to start with. Each throws an error that says what to do.

/// Images that are missing or altered; `remedy` is the command that makes them.
void refuse_incomplete_stimuli(const stimuli::Study& study, const std::filesystem::path& folder,
                               const std::string& remedy);
/// Nobody is asked to choose between images that nobody can tell apart, unless the study means it.
void refuse_alike_pairs(const stimuli::Study& study, const stimuli::Manifest& manifest,
                        const std::filesystem::path& folder);
/// A session must not end for want of room: 100 MB.
void refuse_full_disk(const std::string& store_url);
/// Times of day are stored with the answers, and order them.
void refuse_clock_that_ran_backwards(analysis::Store& store);
/// What is shown and for how long is known only where swapping waits for the display.
void refuse_loose_pace(const Pace& pace, const Window& window);

/// Where the operator has a reason to go on, a refusal of `check` is only said.
void unless_overridden(const std::string& reason, const std::function<void()>& check);

}  // namespace obscura::app::kiosk
