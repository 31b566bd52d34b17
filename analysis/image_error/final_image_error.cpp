// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/image_error/final_image_error.h"

#include <array>
#include <cmath>
#include <vector>

#include "renderer/base/error.h"
#include "renderer/images/images.h"

namespace obscura::analysis {
namespace {

/// Display light of each code value, in [0, 1] (IEC 61966-2-1).
std::array<float, 256> linear_of_code() {
    std::array<float, 256> table{};
    for (std::size_t code = 0; code < table.size(); ++code) {
        const double encoded = static_cast<double>(code) / 255.0;
        table[code] = static_cast<float>(
            encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
    return table;
}

std::vector<float> values_of(std::span<const std::uint8_t> codes,
                             const std::array<float, 256>& value_of_code) {
    std::vector<float> values;
    values.reserve(codes.size());
    for (const std::uint8_t code : codes) values.push_back(value_of_code[code]);
    return values;
}

}  // namespace

FinalImageError final_image_error(std::span<const std::uint8_t> image,
                                  std::span<const std::uint8_t> truth, int width, int height,
                                  const Viewing& viewing) {
    const std::size_t expected = width > 0 && height > 0 ? 3 * static_cast<std::size_t>(width) *
                                                               static_cast<std::size_t>(height)
                                                         : 0;
    if (expected == 0 || image.size() != expected || truth.size() != expected) {
        throw base::bad_input("image error: {} and {} code values for an image of {}x{}",
                              image.size(), truth.size(), width, height);
    }
    std::array<float, 256> identity{};
    for (std::size_t code = 0; code < identity.size(); ++code) {
        identity[code] = static_cast<float>(code) / 255.0F;
    }
    FinalImageError error;
    const images::Difference difference = images::library().difference(
        values_of(image, identity).data(), values_of(truth, identity).data(), width, height);
    error.rmse = difference.rms;
    error.max = difference.max;

    // The metric wants linear light.
    const std::array<float, 256> linear = linear_of_code();
    const int failed = images::library().yee_failed(
        values_of(image, linear).data(), values_of(truth, linear).data(), width, height,
        static_cast<float>(viewing.luminance_cd_m2),
        static_cast<float>(viewing.horizontal_field_deg));
    error.yee_failed = static_cast<double>(failed) / static_cast<double>(expected / 3);
    return error;
}

}  // namespace obscura::analysis
