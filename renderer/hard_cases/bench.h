// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "renderer/hard_cases/hard_case.h"

namespace obscura::renderer {

/// The buffers of one image that a hard case looks at; upper row first, one value a pixel.
struct Shot {
    int width = 0;
    int height = 0;
    std::vector<float> depth_m;
    std::vector<float> accessibility;  ///< as the technique wrote it
    std::vector<float> denoised;       ///< after the filter; the same where there is none
    double accessibility_ms = 0.0;     ///< of the technique's pass

    [[nodiscard]] bool is_surface(std::size_t pixel) const;
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// What the cases share: rendering with any technique, and writing rows.
class Bench {
  public:
    Bench(const HardCaseOptions& options, std::vector<HardCaseResult>& rows)
        : options_(options), rows_(rows) {}

    [[nodiscard]] const HardCaseOptions& options() const { return options_; }
    void begin(const HardCase& hard_case);

    /// `technique` with lengths that fit R: radius R, a full threshold of R/25, no occluders beyond
    /// R, and a curve that knows no other unit of length.
    [[nodiscard]] static TechniqueChoice settings(const std::string& technique, double radius);

    /// One image. `reference` is traced with 64 rays within the choice's radius.
    [[nodiscard]] Shot shoot(const Scene& scene, const Camera& camera,
                             const TechniqueChoice& choice, int width, int height);

    /// A row that holds where |measured - expected| <= tolerance; NaN never does. Where it does not
    /// and `nature` gives a reason, the row fails by nature.
    void expect(const std::string& technique, const std::string& quantity, double expected,
                double measured, double tolerance, const std::string& nature = "",
                const std::string& note = "");

    /// A row that counts values that are NaN, infinite or outside [0, 1]: none is expected.
    void expect_sound(const std::string& technique, const std::string& quantity, const Shot& shot,
                      const std::string& note = "");

  private:
    [[nodiscard]] Shot trace(const Scene& scene, const Camera& camera, double radius, int width,
                             int height);

    const HardCaseOptions& options_;
    std::vector<HardCaseResult>& rows_;
    std::string name_;
    Renderer renderer_;
};

inline constexpr const char* kReference = "reference";

/// Why `crytek` gives no 1 on a flat surface; empty for the others.
[[nodiscard]] std::string not_white_by_nature(const std::string& technique);
/// The same, and why techniques that compare with P darken what is tilted or round.
[[nodiscard]] std::string tilted_by_nature(const std::string& technique);
/// Why a technique misses what lies outside the image.
[[nodiscard]] std::string border_by_nature(const std::string& technique);

/// What a technique gives on a wall that faces the camera: 0.75 for `crytek`, else 1.
[[nodiscard]] double facing_wall_value(const std::string& technique);

/// The value farthest from `expected` among the surfaces at least `margin` (fraction of the size)
/// from the border; `expected` where there are none.
[[nodiscard]] double farthest(const Shot& shot, std::span<const float> values, double expected,
                              double margin);

}  // namespace obscura::renderer
