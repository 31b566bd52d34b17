// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// What `bitmask` and `layered` have in common.
[[nodiscard]] std::vector<Parameter> bitmask_parameters();

/// The definition of both in double precision.
[[nodiscard]] PixelModel bitmask_model(const SeenBuffers& buffers, const Variant& variant);

}  // namespace obscura::renderer
