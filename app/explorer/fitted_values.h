// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace obscura::app::explorer {

/// What `obscura measure --fit` found for a technique on a scene.
struct FittedValues {
    std::string scene;  ///< as stimuli::OpenedScene::id
    std::string technique;
    std::map<std::string, double> parameters;
    std::string rmse;  ///< on the cameras that it was found on, as the file says it
};

/// The values in a `fitted.csv` of a measurement; none where there is no such file. Throws bad
/// input naming file and line where one is not as `measure` writes it.
[[nodiscard]] std::vector<FittedValues> read_fitted_values(const std::filesystem::path& file);

}  // namespace obscura::app::explorer
