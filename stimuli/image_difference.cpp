// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/image_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "renderer/base/error.h"

namespace obscura::stimuli {
namespace {

/// CIELAB of sRGB code values. Its cube roots are looked up: a pair is compared in milliseconds,
/// and no value is off by more than 0.06.
class Lab {
  public:
    Lab() {
        for (std::size_t code = 0; code < light_.size(); ++code) {
            const double encoded = static_cast<double>(code) / 255.0;  // IEC 61966-2-1
            light_[code] = static_cast<float>(
                encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
        }
        for (std::size_t i = 0; i < root_.size(); ++i) {
            const double t = static_cast<double>(i) / kSteps;  // CIE 15:2018, 8.2.1
            root_[i] = static_cast<float>(
                t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0);
        }
    }
    /// Relative luminance Y.
    [[nodiscard]] float luminance(const std::uint8_t* code) const {
        return 0.2126F * light_[code[0]] + 0.7152F * light_[code[1]] + 0.0722F * light_[code[2]];
    }
    [[nodiscard]] glm::vec3 operator()(const std::uint8_t* code) const {
        const float r = light_[code[0]];
        const float g = light_[code[1]];
        const float b = light_[code[2]];
        // To XYZ as a share of the white D65 (IEC 61966-2-1).
        const float x = root(0.433877F * r + 0.376223F * g + 0.189900F * b);
        const float y = root(0.212600F * r + 0.715200F * g + 0.072200F * b);
        const float z = root(0.017723F * r + 0.109458F * g + 0.872819F * b);
        return {116.0F * y - 16.0F, 500.0F * (x - y), 200.0F * (y - z)};
    }

  private:
    static constexpr int kSteps = 1 << 16;
    [[nodiscard]] float root(float t) const {
        return root_[static_cast<std::size_t>(std::clamp(t, 0.0F, 1.0F) * kSteps + 0.5F)];
    }
    std::array<float, 256> light_{};
    std::array<float, kSteps + 1> root_{};
};

const Lab& lab() {
    static const Lab tables;
    return tables;
}

}  // namespace

Brightness brightness_of(const RgbImage& image) {
    if (image.rgb.empty()) throw base::bad_input("an image without pixels has no luminance");
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const auto luminance = static_cast<double>(lab().luminance(&image.rgb[i]));
        sum += luminance;
        squares += luminance * luminance;
    }
    const auto pixels = static_cast<double>(image.rgb.size() / 3);
    const double mean = sum / pixels;
    if (mean <= 0.0) return {};
    return {mean, std::sqrt(std::max(0.0, squares / pixels - mean * mean)) / mean};
}

ImageDifference difference_of(const RgbImage& a, const RgbImage& b) {
    if (a.width != b.width || a.height != b.height || a.rgb.size() != b.rgb.size() ||
        a.rgb.empty()) {
        throw base::bad_input("two images to compare have {}x{} and {}x{} pixels", a.width,
                              a.height, b.width, b.height);
    }
    std::size_t differing = 0;
    std::size_t over = 0;
    double thresholds = 0.0;
    float largest = 0.0F;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        if (std::equal(&a.rgb[i], &a.rgb[i] + 3, &b.rgb[i])) continue;
        ++differing;
        const float delta_e = glm::distance(lab()(&a.rgb[i]), lab()(&b.rgb[i]));
        largest = std::max(largest, delta_e);
        if (delta_e < kJustNoticeable_delta_e) continue;
        ++over;
        thresholds += delta_e / kJustNoticeable_delta_e;
    }
    const auto pixels = static_cast<double>(a.rgb.size() / 3);
    return {static_cast<double>(differing) / pixels, static_cast<double>(over) / pixels,
            thresholds / pixels, largest};
}

}  // namespace obscura::stimuli
