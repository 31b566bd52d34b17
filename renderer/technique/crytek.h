// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/model/model.h"

namespace obscura::renderer {

/// `crytek` in double precision.
[[nodiscard]] PixelModel crytek_model(const SeenBuffers& buffers, const Variant& variant);

}  // namespace obscura::renderer
