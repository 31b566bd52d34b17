// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/measurement/row.h"

namespace obscura::analysis {

/// The thesis (Jakobsen 2010, 5.2) takes accuracy to rise from Crytek over Blizzard to ray
/// marching. What the rows of one view say of that.
struct OrderOfTechniques {
    std::string view;
    bool fitted = false;
    std::vector<std::string> by_error;  ///< variants, smallest RMSE first
    std::vector<double> rmse;           ///< as many, ascending
    bool as_assumed = false;            ///< ray marching <= Blizzard <= Crytek in RMSE
    std::string sentence;               ///< the same for a reader
};

/// For every view in `rows`, as published and fitted where both are there: Crytek24, Blizzard24 and
/// RayMarching30 with the filter `denoise`. A view where one of the three is missing gives none.
[[nodiscard]] std::vector<OrderOfTechniques> orders_of_techniques(
    const std::vector<MeasurementRow>& rows, const std::string& denoise);

/// One sentence over all views: in how many the assumed order holds, as published and fitted.
[[nodiscard]] std::string order_in_a_sentence(const std::vector<OrderOfTechniques>& orders);

}  // namespace obscura::analysis
