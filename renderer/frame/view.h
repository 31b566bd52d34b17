// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "renderer/frame/gpu_scene.h"
#include "renderer/frame/plan.h"
#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// Gives the accessibility of every pixel, upper row first, for a technique that is ray traced.
using TracedAccessibility = std::function<std::vector<float>(const Camera& camera, int width,
                                                             int height, const Variant& choice)>;

/// Gives the triangles of the view's scene for rays; made when they are first asked for.
using RaysOfScene = std::function<const ReferenceScene&()>;

/// Thrown where an image that was begun is wanted no more.
struct Stopped {};

/// All of an image but its variant and its size. What it refers to must outlive it.
struct View {
    const GpuScene& scene;
    const Lighting& lighting;
    const Camera& camera;
    FrameOptions options = {};
    TracedAccessibility traced = {};  ///< nothing: a technique that is ray traced is refused
    RaysOfScene rays = {};            ///< nothing: a recipe with a step on the processor is refused
    /// In place of what scene and light ask for: needs_of_everything.
    std::optional<SceneNeeds> needs = {};
    /// False: no pass is waited for before the next one, which is quicker, and all times are 0.
    bool timed = true;
    /// Asked between passes and in the midst of long ones; false ends the image with Stopped. What
    /// is drawn is waited for each time, which a pass takes some hundredths longer for.
    std::function<bool()> go_on = {};
};

/// The plan of an image of the view. Throws as plan_frame does.
[[nodiscard]] FramePlan plan_of(const View& view, const Variant& choice, int width, int height);

}  // namespace obscura::renderer
