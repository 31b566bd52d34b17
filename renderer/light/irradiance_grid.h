// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/light/environment.h"
#include "renderer/light/shadow.h"

namespace obscura::renderer {

/// Where probes stand.
struct ProbeLattice {
    glm::ivec3 count{1};  ///< along each axis, at least 1 and at most kMostProbesAlong
    glm::vec3 first_m{0.0F};
    glm::vec3 step_m{1.0F};  ///< from one to the next along each axis, > 0

    [[nodiscard]] std::size_t probes() const {
        return static_cast<std::size_t>(count.x) * static_cast<std::size_t>(count.y) *
               static_cast<std::size_t>(count.z);
    }
    [[nodiscard]] std::size_t index(const glm::ivec3& probe) const {
        return (static_cast<std::size_t>(probe.z) * static_cast<std::size_t>(count.y) +
                static_cast<std::size_t>(probe.y)) *
                   static_cast<std::size_t>(count.x) +
               static_cast<std::size_t>(probe.x);
    }
    [[nodiscard]] glm::vec3 position_m(const glm::ivec3& probe) const {
        return first_m + glm::vec3(probe) * step_m;
    }
};
inline constexpr int kMostProbesAlong = 256;

/// At most `most_probes` (> 0) in the middles of equal boxes, about as wide as they are high and
/// deep, that the bounds are parted into. Throws bad input for bounds that are not finite.
[[nodiscard]] ProbeLattice probes_over(const Bounds& bounds, int most_probes);

/// A probe with its weight among others: that of one within a solid is so small that it counts
/// where there are no others.
struct Probe {
    IrradianceSh weighted{};  ///< irradiance times the weight
    float weight = 1.0F;      ///< 1, or kWeightWithin
};
inline constexpr float kWeightWithin = 1.0F / 4096.0F;

/// Irradiance that depends on where one stands.
struct IrradianceGrid {
    ProbeLattice lattice;
    std::vector<Probe> probes;  ///< the x axis first, then y, then z

    /// Irradiance / pi on a surface there with that unit normal, trilinear between probes by their
    /// weights: of the place one step of the lattice further along the normal, so that no probe
    /// behind a surface that faces along an axis has any part in it. Beyond the outermost probes it
    /// is theirs.
    [[nodiscard]] glm::vec3 look_up(const glm::vec3& position_m, const glm::vec3& normal) const;
    /// Rounds all that is in it to half floats, as graphics cards get it.
    void round_to_halves();
};

/// Texels of four numbers that a probe takes: 27 of its coefficients, and its weight.
inline constexpr int kTexelsOfProbe = 7;

/// What a graphics card holds of such a lattice.
[[nodiscard]] std::size_t bytes_on_gpu(const ProbeLattice& lattice);

/// The probes as a block of texels, four half floats each: kTexelsOfProbe layers of all probes.
[[nodiscard]] std::vector<std::uint64_t> texels_of(const IrradianceGrid& grid);

}  // namespace obscura::renderer
