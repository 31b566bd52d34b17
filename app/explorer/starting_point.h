// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "app/explorer/model.h"

namespace obscura::app::explorer {

/// What a name leads to.
struct StartingPoint {
    std::optional<OpenStudy> study;  ///< nothing: the name is a scene's
    Choices choices;
    std::string camera;                          ///< of the scene; empty: its first
    std::optional<renderer::Camera> own_camera;  ///< that the study describes itself
};

/// A built-in scene, a scene's file, a study file or a built-in study. Scenes start with the pair
/// that the built-in study shows of them, where it does; else with `before`'s. Throws bad input
/// naming what it is and what is allowed.
[[nodiscard]] StartingPoint starting_point(const std::string& what, const Choices& before);

/// A pair of the study, as it shows it. The condition must exist.
[[nodiscard]] StartingPoint starting_point(const OpenStudy& study, const std::string& condition,
                                           const Choices& before);

/// The study of that name with the hash of its text. Throws bad input for what is wrong with it.
[[nodiscard]] OpenStudy open_study(const std::string& file_or_name);

}  // namespace obscura::app::explorer
