// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/explorer/model.h"

namespace obscura::app::explorer {

/// What both images cost, a line each, with the device, the view and every setting.
[[nodiscard]] std::string cost_text(const Model& model, const std::string& device);

}  // namespace obscura::app::explorer
