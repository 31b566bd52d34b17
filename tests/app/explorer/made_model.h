// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "app/explorer/model.h"

namespace obscura::app::explorer {

/// One triangle with the cameras `front` and `side`, and light at two levels.
[[nodiscard]] std::shared_ptr<LoadedScene> made_wall();
/// Nothing against Blizzard over that source, 64x36.
[[nodiscard]] Choices made_choices(const std::string& source);
/// A model that shows the wall.
[[nodiscard]] Model made_model();
/// What a renderer would answer: flat values.
[[nodiscard]] Shot made_shot(const ShotRequest& request, char side);
void answer(Model& model, const ShotRequest& request, double now_s);

}  // namespace obscura::app::explorer
