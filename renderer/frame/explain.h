// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "renderer/frame/frame.h"

namespace obscura::renderer {

/// The passes and steps (ms), buffers (bytes) and omissions of a rendered image, a line each.
[[nodiscard]] std::string explanation_of(const Frame& frame);

}  // namespace obscura::renderer
