// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace obscura::stimuli {

/// What a new study file begins with.
struct StudyBeginning {
    std::string name;
    int width = 1280;
    int height = 720;
    int supersampling = 2;
    bool one_pair = false;  ///< its order is fixed until there are more
    std::uint64_t seed = 1;
};

/// The table [study] with a comment at each key, and how to go on; neither scenes nor conditions.
[[nodiscard]] std::string beginning_of(const StudyBeginning& study);

/// The text of a study file that runs as it is, with a comment at each key: for every scene and up
/// to two of its levels a pair without and with ambient occlusion and a pair of two techniques, an
/// attention check, a repeat, the hypotheses that follow, and a rule of exclusion. `sources` are
/// built-in scenes or files; what is found of their cameras and sizes is filled in. Throws bad
/// input for a name that is none of a study, and for a scene as open_scene does.
[[nodiscard]] std::string starter_study(const std::string& name,
                                        const std::vector<std::string>& sources);

}  // namespace obscura::stimuli
