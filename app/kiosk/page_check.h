// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stimuli/questions.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// A sentence for each page of a study that does not fit the smallest window that the kiosk opens
/// for it, so that it scrolls. Needs no display. Throws failure when there is no TrueType font.
[[nodiscard]] std::vector<std::string> notes_on_pages(const stimuli::Study& study,
                                                      const stimuli::Questions& questions = {});

}  // namespace obscura::app::kiosk
