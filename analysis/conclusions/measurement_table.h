// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// One row of a measurement: what one setting of a technique costs on one view of a scene, and how
/// far its accessibility is from the ray-traced truth.
struct MeasuredSetting {
    std::string scene_id = {};  ///< the study's name of the view's scene; empty: not said
    std::string scene;
    std::string camera;
    std::string validity;
    std::string technique;
    int samples = 0;
    std::string denoise;  ///< filter of the accessibility buffer, or none; empty: not said
    std::string depth_format = "r32f";
    double ao_scale = 1.0;  ///< size of the accessibility buffer over that of the image
    int width = 0;          ///< pixels; 0: not said
    int height = 0;
    std::string device;
    bool fitted = false;    ///< parameters were fitted to the truth; false: as published
    bool on_front = false;  ///< no other setting of the view is both faster and nearer the truth
    Possible<double> ms_median = Possible<double>::none("not measured");
    Possible<double> rmse = Possible<double>::none("not measured");  ///< of accessibility
    Possible<double> bias = Possible<double>::none("not measured");  ///< signed mean
    std::map<std::string, double> parameters;  ///< of the technique; empty: not said
    std::string published;  ///< conditions of the study that show just this setting; may be empty
};

struct MeasurementTable {
    std::string source;  ///< the file
    std::vector<MeasuredSetting> rows;
};

/// The CSV table of `obscura measure`, columns in any order: scene, camera, validity, technique,
/// samples, ms_median and rmse are needed; scene_id, denoise, depth_format, ao_scale, width,
/// height, device, fitted, bias, on_front, parameters and published are read where they are there,
/// the others passed over. An empty cell is a value that was not measured. Throws bad input that
/// lists what is wrong as `file:line: column, value, what is allowed`.
[[nodiscard]] MeasurementTable read_measurement(const std::filesystem::path& file);

/// The same for text; `name` stands for it in messages.
[[nodiscard]] MeasurementTable parse_measurement(std::string_view text, const std::string& name);

}  // namespace obscura::analysis
