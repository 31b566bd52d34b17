// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/image_error/accessibility_error.h"
#include "analysis/image_error/final_image_error.h"
#include "analysis/measurement/time_summary.h"
#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// One setting of one technique on one view of one scene: what it costs and how far it is from the
/// truth.
struct MeasurementRow {
    std::string scene_id;  ///< the study's name of the view's scene; else the scene's own
    std::string scene;     ///< built-in scene or file
    std::string camera;    ///< of that scene
    std::string validity;  ///< low, moderate, high
    std::string technique;
    std::string variant;  ///< as the thesis names it, with what differs: Blizzard24 R 0.2
    int samples = 0;
    std::string denoise;    ///< filter of the accessibility buffer, or none
    double ao_scale = 1.0;  ///< size of the accessibility buffer over that of the image
    std::string depth_format;
    std::string noise;    ///< how samples are turned from pixel to pixel
    std::string options;  ///< of the variant that are not at their standard; empty where all are
    int width = 0;
    int height = 0;
    std::string device;  ///< OpenGL's name of what rendered
    std::string timer;   ///< clock or queries: what the times were taken with
    bool fitted = false;
    /// Where the values come from: published (the study's for that scene), standard (the
    /// technique's own), start (another scene of the study), fitted.
    std::string values = "published";
    std::string published;  ///< conditions of the study that show just this setting; may be empty
    std::map<std::string, double> parameters;

    double reference_radius_m = 0.0;  ///< R of the truth it is held against
    double truth_stderr = 0.0;        ///< root mean square standard error of that truth
    TimeSummary cost;                 ///< accessibility and filter together
    TimeSummary accessibility;
    TimeSummary filter;      ///< the denoise filter alone
    TimeSummary frame;       ///< every pass of the image
    int runs = 0;            ///< that were timed, after those that were thrown away
    double layer_ms = 0.0;   ///< median of a second layer's geometry, which is none of `cost`
    int fetches_per_px = 0;  ///< the most texture reads that one pixel may make
    std::size_t bytes = 0;   ///< of the buffers that technique, filter and second layer write

    std::size_t nonfinite = 0;  ///< values of the float buffers that are NaN or infinite
    Possible<AccessibilityError> error = AccessibilityError{};     ///< surfaces only
    Possible<AccessibilityError> interior = AccessibilityError{};  ///< without the border
    std::optional<FinalImageError> image;
    bool on_front = false;
};

/// The table: the columns that README.md of this folder lists, a header line first. A value that
/// does not exist is an empty cell.
[[nodiscard]] std::string measurement_csv(const std::vector<MeasurementRow>& rows);

/// The same rows as a JSON array, numbers in full; what does not exist is null with NAME_reason.
[[nodiscard]] std::string measurement_json(const std::vector<MeasurementRow>& rows);

/// Marks, for each view of a scene on a device at a size, the rows that no other row beats in both
/// median cost and RMSE.
void mark_front(std::vector<MeasurementRow>& rows);

/// Where variants of a view have one name and differ in parameters, adds what differs to the names:
/// `Blizzard24 R 0.2`, and as many parameters more as it takes.
void name_variants_apart(std::vector<MeasurementRow>& rows);

/// Whether both are of the same view of the same scene, at the same size, on the same device.
[[nodiscard]] bool same_view(const MeasurementRow& a, const MeasurementRow& b);

/// `scene_id, camera, validity`, as titles and sentences name a row's view.
[[nodiscard]] std::string view_name(const MeasurementRow& row);

}  // namespace obscura::analysis
