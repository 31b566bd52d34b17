// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/frame/renderer.h"

namespace obscura::renderer {

/// Whether a hard case holds for a technique.
enum class Outcome {
    kHolds,
    kByNature,   ///< no: the image is what the technique's definition gives, and that is not the
                 ///< truth
    kUndecided,  ///< times that were taken on a machine too busy to tell
    kFails,      ///< no, and nothing explains it
};

/// What a row holds a measurement against.
enum class Against {
    kTruth,      ///< a closed form, or what any sound image has
    kDefinition  ///< the technique's own, in double precision: nothing excuses it
};

/// One quantity of one hard case on one technique.
struct HardCaseResult {
    std::string name;       ///< number and title of the case
    std::string technique;  ///< a technique's name, or `all`
    std::string quantity;
    Against against = Against::kTruth;
    double expected = 0.0;
    std::optional<double>
        definition;  ///< the quantity as the definition has it, where there is one
    double measured = 0.0;
    double tolerance = 0.0;
    Outcome outcome = Outcome::kFails;
    std::string note;  ///< why it fails by nature, or what a reader should know
};

struct HardCaseOptions {
    std::vector<std::string> techniques;  ///< empty: all that compute a buffer
    std::vector<int> cases;               ///< by number; empty: all
    int size_px = 128;                    ///< of the square images of most cases, 32 to 1024
    bool timing = true;                   ///< also the row that compares times
    int vectors = 1'000'000;  ///< random vectors of the case about rotations, 1 to 10 million
    /// Called after each case on each technique, with the share done.
    std::function<void(const std::string& what)> progress;
};

class Bench;

/// One of the list in the techniques' definition: numerical stability. One of the two functions is
/// there.
struct HardCase {
    int number = 0;
    const char* title = "";
    void (*run)(Bench& bench, const Technique& technique) = nullptr;
    void (*run_once)(Bench& bench) = nullptr;  ///< of no technique in particular
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
