// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "renderer/light/irradiance_grid.h"
#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

struct ProbeOptions {
    int most_probes = 2500;  ///< 1 to a million
    int rows = 10;           ///< of directions that a probe looks in, even; 4 / pi times its square
    int bounces = 3;         ///< of light between surfaces, at least 0
    int threads = 0;         ///< 0: one a core. The probes do not depend on it.
};

/// Irradiance of a scene's probes by ray tracing: what each sees of the environment, and light that
/// comes from there, from the lights and from surfaces that send out their own, once it was
/// reflected diffusely. A probe and its neighbours look past each other, and each takes the mean
/// with those that it sees, which leaves no stains where few rays find a small window. What rays
/// meet is traced once, when the first light is baked, and serves every other light. The same bytes
/// twice and on any number of threads. Embree runs the same kernels on every machine with AVX,
/// without fused multiplications, which decide otherwise about rays that graze an edge; distances
/// are computed here, and what is left is rounded to half floats.
class IrradianceBaker {
  public:
    explicit IrradianceBaker(std::shared_ptr<const Scene> scene, const ProbeOptions& options = {});
    ~IrradianceBaker();
    IrradianceBaker(const IrradianceBaker&) = delete;
    IrradianceBaker& operator=(const IrradianceBaker&) = delete;

    /// A quarter or more of what a probe meets turned away from it, it stands inside of something:
    /// it takes the mean of its neighbours, as often as it needs, and has hardly any weight. Throws
    /// bad input for a light without environment, a scene without a surface that rays could meet,
    /// or one without end. One thread at a time.
    [[nodiscard]] std::shared_ptr<const IrradianceGrid> bake(const Lighting& light);

  private:
    struct Traced;
    std::shared_ptr<const Scene> scene_;
    ProbeOptions options_;
    std::unique_ptr<Traced> traced_;
};

/// The lattice of a baker with the usual options, which needs no rays.
[[nodiscard]] ProbeLattice probes_of(const Scene& scene);

}  // namespace obscura::renderer
