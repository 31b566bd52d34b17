// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::renderer {

/// How the steps of techniques and filters are run. The same shader serves both: it computes the
/// same, to what two compilers make of it.
enum class StepsBy {
    kFragments,  ///< drawn; steps with a function for the processor are computed there
    kCompute,    ///< compute shaders, those that trace rays too
};

/// What the environment variable OBSCURA_STEPS says (`fragments`, `compute`); without it compute
/// shaders on a GPU, fragments where a processor draws. Needs a current context. Throws bad input
/// for another value.
[[nodiscard]] StepsBy steps_by_device();

/// As people are told: `compute shaders`.
[[nodiscard]] const char* in_words(StepsBy steps);

}  // namespace obscura::renderer
