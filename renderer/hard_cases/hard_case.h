// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/frame/renderer.h"

namespace obscura::renderer {

/// Whether a hard case holds for a technique.
enum class Outcome {
    kHolds,
    kByNature,  ///< no, as the technique's definition says
    kFails,     ///< no, and nothing explains it
};

/// One quantity of one hard case on one technique.
struct HardCaseResult {
    std::string name;       ///< number and title of the case
    std::string technique;  ///< a technique's name, `reference`, a filter's, or `all`
    std::string quantity;
    double expected = 0.0;
    double measured = 0.0;
    double tolerance = 0.0;
    Outcome outcome = Outcome::kFails;
    std::string note;  ///< why it fails by nature, or what a reader should know
};

struct HardCaseOptions {
    std::vector<std::string> techniques;  ///< empty: all that compute a buffer, and the reference
    int size_px = 128;                    ///< of the square images of most cases, 32 to 1024
    bool timing = true;                   ///< also the case that compares times
    int vectors = 1'000'000;  ///< random vectors of the case about rotations, 1 to 10 million
    /// Called after each case on each technique, with the share done.
    std::function<void(const std::string& what)> progress;
};

class Bench;

/// One of the list in the techniques' definition: numerical stability.
struct HardCase {
    int number = 0;
    const char* title = "";
    bool once = false;  ///< of no technique in particular: run one time, for `all`
    void (*run)(Bench& bench, const std::string& technique) = nullptr;
};

/// All cases, by number.
[[nodiscard]] const std::vector<HardCase>& hard_cases();

/// How many steps run_hard_cases reports to `progress`.
[[nodiscard]] std::size_t hard_case_steps(const HardCaseOptions& options);

/// Every case on every technique. Needs a current OpenGL context. What a technique does with a
/// scene that it refuses is a row with the message. Throws bad input for an unknown technique or an
/// option that is out of range.
[[nodiscard]] std::vector<HardCaseResult> run_hard_cases(const HardCaseOptions& options);

// One line a case; each is defined in a file of its own.
HardCase planes_case();
HardCase separated_cube_case();
HardCase thin_occluder_case();
HardCase border_case();
HardCase close_up_case();
HardCase not_a_number_case();
HardCase rotations_case();
HardCase background_case();
HardCase units_case();
HardCase projections_case();
HardCase denoise_case();
HardCase quantisation_case();
HardCase odd_sizes_case();
HardCase degenerate_case();

}  // namespace obscura::renderer
