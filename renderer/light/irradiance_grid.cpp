// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/light/irradiance_grid.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "renderer/base/check.h"

namespace obscura::renderer {

ProbeLattice probes_over(const Bounds& bounds, int most_probes) {
    base::check_range("probes_over", "most_probes", most_probes, 1, 1'000'000);
    const glm::dvec3 extent = glm::max(glm::dvec3(bounds.high_m) - glm::dvec3(bounds.low_m), 1e-3);
    for (int axis = 0; axis < 3; ++axis) {
        base::check_range("probes_over", "metres across the scene", extent[axis], 0.0, 1e9);
    }
    const auto count_at = [&extent](double step) {
        return glm::ivec3(glm::clamp(glm::round(extent / step), 1.0, double{kMostProbesAlong}));
    };
    double step = std::cbrt(extent.x * extent.y * extent.z / most_probes);
    constexpr double kWider = 1.01;
    while (ProbeLattice{count_at(step)}.probes() > static_cast<std::size_t>(most_probes)) {
        step *= kWider;
    }
    ProbeLattice lattice;
    lattice.count = count_at(step);
    lattice.step_m = glm::vec3(extent / glm::dvec3(lattice.count));
    lattice.first_m = bounds.low_m + 0.5F * lattice.step_m;
    return lattice;
}

glm::vec3 IrradianceGrid::look_up(const glm::vec3& position_m, const glm::vec3& normal) const {
    const glm::vec3 last(lattice.count - 1);
    const glm::vec3 at =
        glm::clamp((position_m - lattice.first_m) / lattice.step_m + normal, glm::vec3(0.0F), last);
    const glm::ivec3 low = glm::min(glm::ivec3(at), glm::max(lattice.count - 2, 0));
    const glm::vec3 part = at - glm::vec3(low);
    IrradianceSh between{};
    float weights = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::vec3 share = glm::mix(1.0F - part, part, glm::vec3(side));
        const float part_of_it = share.x * share.y * share.z;
        if (!(part_of_it > 0.0F)) continue;  // also what would lie beyond a single layer
        const Probe& probe = probes[lattice.index(low + side)];
        weights += part_of_it * probe.weight;
        for (std::size_t i = 0; i < 9; ++i) between[i] += part_of_it * probe.weighted[i];
    }
    return evaluate_irradiance(between, normal) / weights;
}

void IrradianceGrid::round_to_halves() {
    constexpr float kMostHalf = 65504.0F;
    for (Probe& probe : probes) {
        for (glm::vec3& value : probe.weighted) {
            for (int i = 0; i < 3; ++i) {
                value[i] = glm::unpackHalf1x16(
                    glm::packHalf1x16(std::clamp(value[i], -kMostHalf, kMostHalf)));
            }
        }
    }
}

std::size_t bytes_on_gpu(const ProbeLattice& lattice) {
    return lattice.probes() * kTexelsOfProbe * sizeof(std::uint64_t);
}

std::vector<std::uint64_t> texels_of(const IrradianceGrid& grid) {
    std::vector<std::uint64_t> texels;
    texels.reserve(grid.probes.size() * kTexelsOfProbe);
    for (int texel = 0; texel < kTexelsOfProbe; ++texel) {
        for (const Probe& probe : grid.probes) {
            glm::vec4 four(probe.weight);
            for (int i = 0; i < 4; ++i) {
                const int number = 4 * texel + i;
                if (number < 27)
                    four[i] = probe.weighted[static_cast<std::size_t>(number / 3)][number % 3];
            }
            texels.push_back(glm::packHalf4x16(four));
        }
    }
    return texels;
}

}  // namespace obscura::renderer
