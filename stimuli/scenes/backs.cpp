// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/backs.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/base/error.h"
#include "renderer/reference/backs.h"

namespace obscura::stimuli {

std::string note_on_backs(const OpenedScene& opened, std::vector<renderer::Camera> cameras) {
    constexpr std::size_t kMostCameras = 32;
    constexpr std::size_t kMostTriangles = 4'000'000;  // a second or two of building
    if (opened.builtin) return "";
    if (opened.scene->triangle_count() > kMostTriangles) {
        return fmt::format(
            "of more than {} triangles it is not looked at whether they are seen "
            "from behind",
            kMostTriangles);
    }
    if (cameras.size() > kMostCameras) cameras.resize(kMostCameras);
    const renderer::Backs backs =
        opened.has_sides ? renderer::Backs::kOfSingleSided : renderer::Backs::kAll;
    std::vector<double> shares;
    try {
        shares = renderer::shares_of_backs(*opened.scene, cameras, backs);
    } catch (const base::Error& error) {
        // What is wrong with a camera is for those to say who read it.
        if (error.code() != base::ExitCode::kBadInput) throw;
        return "";
    }
    std::vector<std::string> much;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        if (shares[i] < kMuchFromBehind) continue;
        much.push_back(fmt::format("{:.0f} % from camera {}", 100.0 * shares[i], cameras[i].name));
    }
    if (much.empty()) return "";
    return fmt::format("surfaces are seen from behind, {}: {}",
                       opened.has_sides ? "where they are single-sided and not drawn"
                                        : "where they are lit as from the front",
                       fmt::join(much, ", "));
}

}  // namespace obscura::stimuli
