// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <glm/glm.hpp>
#include <string>

#include "app/explorer/model.h"

namespace obscura::app::explorer {

/// Everything that is known of a pixel of the image (from its upper left corner): depth, normal,
/// accessibility of A and B, truth with its standard error, colours of A and B. Empty outside.
[[nodiscard]] std::string pixel_text(const Model& model, const glm::vec2& at_px);

}  // namespace obscura::app::explorer
