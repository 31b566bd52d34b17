// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/measurement_table.h"
#include "analysis/conclusions/shown_image.h"
#include "analysis/statistics/preference_curve.h"

namespace obscura::analysis {

/// The two images of a condition, each with what was measured of it.
struct MeasuredPair {
    const ConditionResult* condition = nullptr;
    MeasuredSetting a;
    MeasuredSetting b;
    Possible<double> error_difference = Possible<double>::none("not measured");  ///< RMSE, B - A
    Possible<double> ms_difference = Possible<double>::none("not measured");     ///< ms, B - A
};

/// What relates the answers to the measurement: how the choice follows the difference in error and
/// in milliseconds.
struct PreferenceAndCost {
    std::string device;  ///< all rows joined come from one device at one size
    int width = 0;
    int height = 0;
    std::vector<MeasuredPair> pairs;
    std::vector<std::string> not_joined;  ///< a sentence for each condition left out
    PreferenceCurve by_error;             ///< over RMSE, B - A
    PreferenceCurve by_ms;                ///< over milliseconds, B - A
};

/// Joins each condition's two images with the rows of the same scene, camera, validity, technique
/// and samples; of several the one that the measurement says was shown in that condition, then the
/// one with the image's own filter, at full size and with the parameters as published. Devices and
/// sizes are never mixed: those that join most conditions are taken. `conditions`
/// must outlive what is given back.
[[nodiscard]] PreferenceAndCost preference_and_cost(const std::vector<ConditionResult>& conditions,
                                                    const std::vector<ShownImage>& images,
                                                    const MeasurementTable& measurement);

}  // namespace obscura::analysis
