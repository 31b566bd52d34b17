// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace obscura::app::kiosk {

/// What nobody but the operator knows of a monitor. What is not given is not known.
struct DisplayFacts {
    std::optional<double> viewing_distance_cm;  ///< eye to screen, 1 to 2000
    std::optional<double> screen_width_cm;      ///< of what is lit, 1 to 1000
    std::optional<double> screen_height_cm;
    std::optional<double> luminance_cd_m2;  ///< of white, measured, above 0 to 100000
    std::optional<double> gamma;            ///< measured, 0.5 to 5

    /// Those of `given` where it has them, else these.
    [[nodiscard]] DisplayFacts with(const DisplayFacts& given) const;
    bool operator==(const DisplayFacts&) const = default;
};

/// Throws bad input naming the option and what is allowed.
void check(const DisplayFacts& facts);

/// `60x34` or `59.8x33.6`, in cm. Throws bad input naming --screen-size.
void set_screen_size(DisplayFacts& facts, const std::string& text);

/// What an operator entered once: by the monitor's name, and which monitor was used last.
struct KnownDisplays {
    std::string monitor;  ///< empty: none was chosen yet
    std::map<std::string, DisplayFacts> facts;
};
/// Of DATA/display.json; nothing known where it is not there. Throws bad input naming the file.
[[nodiscard]] KnownDisplays known_displays(const std::filesystem::path& data);
void keep(const std::filesystem::path& data, const KnownDisplays& displays);

/// 2 atan(size / (2 distance)) in degrees; both in one unit, above 0.
[[nodiscard]] double visual_angle_deg(double size, double distance);

/// Pixels.
struct PixelSize {
    int width = 0;
    int height = 0;
};

/// For SessionRecord::timing, as its `screen`: an object of JSON with the facts, and where distance
/// and size are known image_width_deg, image_height_deg and pixels_per_degree at the screen's
/// middle, of an image shown at 1:1; empty where nothing is known.
[[nodiscard]] std::string screen_json(const DisplayFacts& facts, PixelSize monitor,
                                      PixelSize image);

}  // namespace obscura::app::kiosk
