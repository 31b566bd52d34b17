// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/measure/measured_settings.h"
#include "renderer/technique/technique.h"

namespace obscura::app {

/// A setting of an experiment, and what it came to: means over the views.
struct Outcome {
    std::string name;  ///< as the experiment calls it
    double ao_ms = 0.0;
    double filter_ms = 0.0;
    double frame_ms = 0.0;
    double rmse = 0.0;  ///< root of the mean of the views' squared errors; NaN: it has no error
    double bias = 0.0;
    std::map<std::string, double> house_ms = {};  ///< of the frame's other passes, by name
};

/// What an outcome says of the paper's conclusion.
struct Finding {
    std::string conclusion;  ///< the paper's, in a sentence
    bool agrees = false;
    std::string because;  ///< the figures
    /// By what share of the longer the two times differ that it rests on; 1: it rests on no two.
    double apart = 1.0;

    /// Times nearer than runs of one machine are to each other say neither that it is so nor that
    /// it is not.
    [[nodiscard]] bool is_undecided() const { return apart < 0.05; }
};

/// A paper's experiment, or `front` of our own, run on one view of each scene of the study.
struct Experiment {
    struct Setting {
        std::string name;
        renderer::Variant variant;  ///< lengths that it does not set are the study's on each scene
        Values values = Values::kPublished;
    };

    std::string name;  ///< as on the command line: sunet-5.3
    std::string title;
    std::vector<Setting> settings;
    /// Of the outcomes, one for each setting in its order; nullptr: no paper concludes anything.
    std::vector<Finding> (*judge)(const std::vector<Outcome>& outcomes) = nullptr;
    /// What cannot be judged here, in a sentence; empty: nothing.
    std::string silent_on;
    bool overview = false;  ///< also the table and chart of all settings
};

/// All, in the order of the papers.
[[nodiscard]] const std::vector<Experiment>& experiments();

/// The experiment of that name, or nullptr.
[[nodiscard]] const Experiment* find_experiment(const std::string& name);

/// What `--experiments` prints: each with its title.
[[nodiscard]] std::string experiments_text();

// What the experiments are written with.

/// A technique with samples, filter, and parameters and options as `key=value`; throws bad input
/// for what is wrong with them.
[[nodiscard]] renderer::Variant setting_of(const std::string& technique, int samples,
                                           const std::string& denoise,
                                           const std::vector<std::string>& values = {});

/// The outcome of that name; it must be there.
[[nodiscard]] const Outcome& outcome_of(const std::vector<Outcome>& outcomes,
                                        const std::string& name);

/// Of Finding::apart.
[[nodiscard]] double share_apart(double first_ms, double second_ms);

/// The names from the smallest value to the largest: `a 1.2, b 3.4`.
[[nodiscard]] std::string in_order(const std::vector<Outcome>& outcomes, double Outcome::*value);

[[nodiscard]] Experiment front();
[[nodiscard]] Experiment sunet_pipelines();
[[nodiscard]] Experiment sunet_depth();
[[nodiscard]] Experiment sunet_reconstruction();
[[nodiscard]] Experiment sunet_positions();
[[nodiscard]] Experiment sunet_normals();
[[nodiscard]] Experiment sunet_blur();
[[nodiscard]] Experiment sunet_methods();
[[nodiscard]] Experiment sunet_progressive();
[[nodiscard]] Experiment whinham_samples();
[[nodiscard]] Experiment hussain_performance();
[[nodiscard]] Experiment hussain_quality();
[[nodiscard]] Experiment jakobsen_order();

}  // namespace obscura::app
