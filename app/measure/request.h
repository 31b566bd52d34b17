// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace obscura::app {

/// What a measurement is asked to do. Empty lists, and what has no value, stand for the defaults.
struct MeasureRequest {
    std::string study;                 ///< file or built-in name; empty: jakobsen2010
    std::vector<std::string> scenes;   ///< scenes in place of the study's views
    double scale = 1.0;                ///< metres of one unit of their files
    std::vector<std::string> cameras;  ///< of all views those by these cameras
    std::vector<std::string> techniques;
    std::vector<int> samples;  ///< of each technique, those that it allows
    std::vector<std::string> filters;
    std::vector<std::string> settings;  ///< KEY=VALUE, of every technique that has the key
    std::optional<double> radius_m;     ///< of every technique that has one, and of the truth
    std::optional<int> width;
    std::optional<int> height;
    std::optional<int> rays;  ///< of the truth, a pixel
    std::optional<int> runs;  ///< timed, after kDiscardedRuns
    bool quick = false;       ///< small images, few rays and settings where none were asked for
    bool fit = false;
    bool growth = false;                ///< how cost grows, in place of the sweep
    bool hard_cases = false;            ///< the hard cases, in place of the sweep
    std::string experiment;             ///< a paper's, in place of the sweep
    std::filesystem::path write_study;  ///< with `fit`: a copy of the study with fitted values
    std::filesystem::path out;
    std::filesystem::path cache;       ///< of ray-traced truths
    std::filesystem::path kept_views;  ///< of a run that is ended half-way; empty: none are kept
    bool quiet = false;
};

/// Throws bad input naming the option, the value and what is allowed for anything that is wrong
/// with techniques, samples, filters, sizes, rays, runs or what excludes each other. The request
/// has its defaults.
void check_request(const MeasureRequest& request);

/// What a measurement takes where nothing else is asked for; `quick` the second.
struct MeasureSize {
    int width = 640;
    int height = 360;
    int rays = 256;
    int runs = 5;
};
inline constexpr MeasureSize kUsualSize{};
inline constexpr MeasureSize kQuickSize{256, 144, 64, 3};

/// Runs of each setting whose times are thrown away: the first compiles shaders.
inline constexpr int kDiscardedRuns = 3;

/// The filter of the plots' lines, of fits and of settings that the study shows without saying one.
inline constexpr const char* kPlottedFilter = "separable";

}  // namespace obscura::app
