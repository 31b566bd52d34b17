// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "renderer/model/model.h"
#include "renderer/recipe/recipe.h"

namespace obscura::renderer {

/// One way to smooth the accessibility buffer. Its recipe reads `accessibility` and writes
/// `denoised`; without steps nothing is smoothed.
struct Denoise {
    std::string name;  ///< in files and on the command line
    std::string citation;
    Recipe recipe;
    DenoiseModel model = {};          ///< in double precision
    std::string edge_by_nature = "";  ///< why it leaks over depth edges; empty: it does not
};

// Each in a file of its own.
[[nodiscard]] std::vector<Admitted> box4_model(const SeenBuffers& buffers,
                                               std::span<const float> accessibility);
[[nodiscard]] std::vector<Admitted> separable_model(const SeenBuffers& buffers,
                                                    std::span<const float> accessibility);
[[nodiscard]] std::vector<Admitted> bilateral_model(const SeenBuffers& buffers,
                                                    std::span<const float> accessibility);
[[nodiscard]] std::vector<Admitted> known_error_model(const SeenBuffers& buffers,
                                                      std::span<const float> accessibility);
[[nodiscard]] std::vector<Admitted> gaussian_nd_model(const SeenBuffers& buffers,
                                                      std::span<const float> accessibility);

/// All denoise filters.
[[nodiscard]] const std::vector<Denoise>& denoise_filters();

/// The filter of that name, or nullptr.
[[nodiscard]] const Denoise* find_denoise(std::string_view name);

}  // namespace obscura::renderer
