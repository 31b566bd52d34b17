// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/measure/fit_settings.h"

namespace obscura::app {

/// A study with fitted values.
struct FittedStudy {
    std::string text;
    std::vector<std::string> notes;  ///< pairs that were left as they were, and why
};

/// The text of the request's study as it has to be at `write_study`, with the fitted values of each
/// side's technique on its scene. A pair whose sides would become equal stays as it was, and is
/// noted. The text is parsed and checked: throws bad input for what is wrong with it there, failure
/// where it would not say what was fitted.
[[nodiscard]] FittedStudy fitted_study(const MeasureRequest& request, const stimuli::Study& study,
                                       const std::vector<MeasuredView>& views,
                                       const std::vector<FittedChoice>& fitted);

}  // namespace obscura::app
