// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/frame/frame.h"

namespace obscura::renderer {

/// The shadow maps of those alone: what another image of the same scene and light may take over,
/// whatever its camera, size and options.
[[nodiscard]] ViewBuffers shadows_of(const ViewBuffers& buffers);

}  // namespace obscura::renderer
