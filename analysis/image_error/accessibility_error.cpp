// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/image_error/accessibility_error.h"

#include <algorithm>
#include <cmath>

#include "analysis/statistics/quantile.h"
#include "renderer/base/error.h"

namespace obscura::analysis {

Possible<AccessibilityError> accessibility_error(std::span<const float> measured,
                                                 std::span<const float> truth,
                                                 std::span<const std::uint8_t> counted) {
    if (measured.size() != truth.size() || measured.size() != counted.size()) {
        throw base::bad_input("accessibility error: {} values, {} of the truth and {} of the mask",
                              measured.size(), truth.size(), counted.size());
    }
    AccessibilityError error;
    std::vector<double> off;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        const bool finite = std::isfinite(measured[i]);
        if (!finite) ++error.nonfinite;
        if (counted[i] == 0 || !finite || !std::isfinite(truth[i])) continue;
        const double difference = static_cast<double>(measured[i]) - static_cast<double>(truth[i]);
        sum += difference;
        sum_of_squares += difference * difference;
        off.push_back(std::abs(difference));
    }
    if (off.empty()) {
        return Possible<AccessibilityError>::none("no pixel shows a surface that can be compared");
    }
    const auto count = static_cast<double>(off.size());
    error.pixels = off.size();
    error.bias = sum / count;
    error.rmse = std::sqrt(sum_of_squares / count);
    for (const double value : off) error.mae += value / count;
    error.p99 = quantile(off, 0.99);
    error.psnr_db = error.rmse > 0.0
                        ? Possible<double>(-20.0 * std::log10(error.rmse))
                        : Possible<double>::none("there is no error: the ratio has no bound");
    return error;
}

std::vector<std::uint8_t> interior_mask(int width, int height, double margin) {
    const int x_margin = static_cast<int>(margin * width);
    const int y_margin = static_cast<int>(margin * height);
    std::vector<std::uint8_t> mask;
    mask.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            mask.push_back(x >= x_margin && x < width - x_margin && y >= y_margin &&
                           y < height - y_margin);
        }
    }
    return mask;
}

}  // namespace obscura::analysis
