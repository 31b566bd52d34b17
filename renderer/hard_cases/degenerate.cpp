// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <functional>
#include <limits>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

Scene zero_area() {
    Scene scene = shapes::clutter();
    Mesh line = scene.meshes.front();
    for (Vertex& vertex : line.vertices) vertex.position_m = {0.5F, 0.0F, -4.0F};
    scene.meshes.push_back(line);
    return scene;
}

Scene coincident() {
    Scene scene = shapes::clutter();
    scene.meshes.push_back(scene.meshes.front());
    return scene;
}

Scene with_nan() {
    Scene scene = shapes::clutter();
    Mesh broken = scene.meshes[3];
    broken.vertices.front().position_m.x = std::numeric_limits<float>::quiet_NaN();
    broken.vertices.back().normal.y = std::numeric_limits<float>::infinity();
    scene.meshes.push_back(broken);
    return scene;
}

Scene around_camera() {
    Scene scene = shapes::empty();
    shapes::add_box(scene, {-1.0F, -1.0F, -1.0F}, {1.0F, 1.0F, 1.0F});
    return scene;
}

/// Case 14. A clear message or a sound image; a row that is refused holds, with the message.
void run_degenerate(Bench& bench, const Technique& technique) {
    const std::pair<const char*, Scene> scenes[] = {{"triangles without area", zero_area()},
                                                    {"coincident faces", coincident()},
                                                    {"a vertex that is not a number", with_nan()},
                                                    {"no triangle at all", shapes::empty()},
                                                    {"camera inside a box", around_camera()}};
    const int size = bench.options().size_px / 2;
    for (const auto& [what, scene] : scenes) {
        try {
            bench.expect_sound(what, bench.shoot(what, scene, shapes::camera(5.0F),
                                                 Bench::settings(technique, 0.3), size, size));
        } catch (const base::Error& error) {
            const std::string message = error.what();
            bench.expect(std::string(what) + ": refused with a message", 1.0,
                         message.empty() ? 0.0 : 1.0, 0.0, message);
        }
    }
}

}  // namespace

HardCase degenerate_case() { return {14, "degenerate geometry", run_degenerate}; }

}  // namespace obscura::renderer
