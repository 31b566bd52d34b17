// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/model/model.h"

namespace obscura::renderer {

/// The definition of `gtao` in double precision.
[[nodiscard]] PixelModel gtao_model(const SeenBuffers& buffers, const Variant& variant);

}  // namespace obscura::renderer
