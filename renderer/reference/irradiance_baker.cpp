// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/irradiance_baker.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "renderer/base/check.h"
#include "renderer/base/parallel.h"
#include "renderer/light/irradiance_parts.h"
#include "renderer/reference/probe_rays.h"

namespace obscura::renderer {

/// A probe that takes its neighbours' mean, in the order in which that is possible.
struct FilledProbe {
    std::size_t probe;
    std::vector<std::size_t> neighbours;
};

namespace {

/// From it, of all the directions of a probe, those that meet backs: it stands inside of something,
/// or outside of a room whose walls look inwards. Beside the corner of one that is a thirtieth.
constexpr double kMostBacks = 0.02;

std::vector<std::size_t> neighbours_of(const ProbeLattice& lattice, const glm::ivec3& probe) {
    std::vector<std::size_t> list;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            glm::ivec3 other = probe;
            other[axis] += side;
            if (other[axis] < 0 || other[axis] >= lattice.count[axis]) continue;
            list.push_back(lattice.index(other));
        }
    }
    return list;
}

template <typename Act>
void for_each_probe(const ProbeLattice& lattice, const Act& act) {
    for (int z = 0; z < lattice.count.z; ++z) {
        for (int y = 0; y < lattice.count.y; ++y) {
            for (int x = 0; x < lattice.count.x; ++x) act(glm::ivec3(x, y, z));
        }
    }
}

/// From those that see into the open inwards, one layer after the other.
std::vector<FilledProbe> filling_of(const ProbeLattice& lattice, std::vector<bool> known) {
    std::vector<FilledProbe> order;
    for (bool more = true; more;) {
        std::vector<bool> next = known;
        for_each_probe(lattice, [&](const glm::ivec3& at) {
            const std::size_t probe = lattice.index(at);
            if (known[probe]) return;
            std::vector<std::size_t> from = neighbours_of(lattice, at);
            std::erase_if(from, [&known](std::size_t other) { return !known[other]; });
            if (from.empty()) return;
            next[probe] = true;
            order.push_back({probe, std::move(from)});
        });
        more = next != known;
        known = std::move(next);
    }
    return order;
}

void fill(const std::vector<FilledProbe>& order, std::vector<IrradianceSh>& probes) {
    for (const FilledProbe& one : order) {
        IrradianceSh mean{};
        for (const std::size_t other : one.neighbours) {
            for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += probes[other][i];
        }
        for (glm::vec3& value : mean) value /= static_cast<float>(one.neighbours.size());
        probes[one.probe] = mean;
    }
}

void add(IrradianceSh& sum, const IrradianceSh& more, float factor = 1.0F) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * more[i];
}

void add(IrradianceSh& sum, const std::array<float, 9>& of_one, const glm::vec3& radiance) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += radiance * of_one[i];
}

/// Whether a probe and the next one along each axis see each other.
using SeesNext = std::array<bool, 3>;

/// The mean with the neighbours along each axis by weights of 1 2 1, which gives the directions of
/// either of two neighbours the same share.
void smooth(const ProbeLattice& lattice, const std::vector<SeesNext>& sees_next,
            std::vector<IrradianceSh>& probes) {
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<IrradianceSh> sums(probes.size());
        glm::ivec3 step(0);
        step[axis] = 1;
        for_each_probe(lattice, [&](const glm::ivec3& at) {
            IrradianceSh& sum = sums[lattice.index(at)];
            float weight = 2.0F;
            add(sum, probes[lattice.index(at)], weight);
            const auto take = [&](const glm::ivec3& first, const glm::ivec3& other) {
                if (!sees_next[lattice.index(first)][static_cast<std::size_t>(axis)]) return;
                add(sum, probes[lattice.index(other)]);
                weight += 1.0F;
            };
            if (at[axis] > 0) take(at - step, at - step);
            if (at[axis] + 1 < lattice.count[axis]) take(at, at + step);
            for (glm::vec3& value : sum) value /= weight;
        });
        probes = std::move(sums);
    }
}

/// Of DirectionCells: neighbours along any axis have different ones.
int stratum_of(const glm::ivec3& probe) {
    return (probe.x & 1) + 2 * (probe.y & 1) + 4 * (probe.z & 1);
}

}  // namespace

/// What the probes' rays meet, whatever the light.
struct IrradianceBaker::Traced {
    Traced(const Scene& scene, const ProbeOptions& options);

    ProbeRays rays;
    ProbeLattice lattice;
    DirectionCells cells;
    std::vector<ProbeHit> hits;  ///< of each probe's cells in turn
    std::vector<SeesNext> sees_next;
    std::vector<FilledProbe> filling;

    /// Of what each probe has for itself.
    [[nodiscard]] std::vector<Probe> settled(std::vector<IrradianceSh> irradiance) const;
    [[nodiscard]] const ProbeHit* hits_of(int probe) const {
        return &hits[static_cast<std::size_t>(probe) * static_cast<std::size_t>(cells.size())];
    }
};

IrradianceBaker::Traced::Traced(const Scene& scene, const ProbeOptions& options)
    : rays(scene),
      lattice(probes_over(bounds_of(scene), options.most_probes)),
      cells(options.rows) {
    const auto directions = static_cast<std::size_t>(cells.size());
    std::vector<glm::ivec3> places;
    for_each_probe(lattice, [&](const glm::ivec3& at) { places.push_back(at); });
    hits.resize(lattice.probes() * directions);
    std::vector<char> in_the_open(lattice.probes());
    base::in_parallel(static_cast<int>(lattice.probes()), options.threads, [&](int i) {
        const auto probe = static_cast<std::size_t>(i);
        const glm::vec3 from_m = lattice.position_m(places[probe]);
        const std::vector<glm::vec3>& ways = cells.ways(stratum_of(places[probe]));
        std::size_t backs = 0;
        for (std::size_t d = 0; d < directions; ++d) {
            ProbeHit& hit = hits[probe * directions + d];
            hit = rays.trace(from_m, ways[d]);
            if (hit.kind == ProbeHit::Kind::kBack) ++backs;
        }
        in_the_open[probe] =
            static_cast<double>(backs) < kMostBacks * static_cast<double>(directions) ? 1 : 0;
    });
    const auto may_see = [&](const glm::ivec3& at, int axis) {
        glm::ivec3 next = at;
        glm::vec3 way(0.0F);
        next[axis] += 1;
        way[axis] = 1.0F;
        return next[axis] < lattice.count[axis] && in_the_open[lattice.index(at)] != 0 &&
               in_the_open[lattice.index(next)] != 0 &&
               rays.sees(lattice.position_m(at), way, lattice.step_m[axis]);
    };
    for (const glm::ivec3& at : places) {
        sees_next.push_back({may_see(at, 0), may_see(at, 1), may_see(at, 2)});
    }
    filling = filling_of(lattice, {in_the_open.begin(), in_the_open.end()});
}

std::vector<Probe> IrradianceBaker::Traced::settled(std::vector<IrradianceSh> irradiance) const {
    smooth(lattice, sees_next, irradiance);
    fill(filling, irradiance);
    std::vector<Probe> probes(irradiance.size());
    for (const FilledProbe& one : filling) probes[one.probe].weight = kWeightWithin;
    for (std::size_t i = 0; i < probes.size(); ++i) {
        add(probes[i].weighted, irradiance[i], probes[i].weight);
    }
    return probes;
}

IrradianceBaker::IrradianceBaker(std::shared_ptr<const Scene> scene, const ProbeOptions& options)
    : scene_(std::move(scene)), options_(options) {
    if (options.rows % 2 != 0) {
        throw base::bad_input("probes: rows is {}, allowed are even numbers", options.rows);
    }
    base::check_range("probes", "bounces", options.bounces, 0, 64);
}

IrradianceBaker::~IrradianceBaker() = default;

std::shared_ptr<const IrradianceGrid> IrradianceBaker::bake(const Lighting& light) {
    if (!light.environment) throw base::bad_input("probes: the light has no environment");
    if (!traced_) traced_ = std::make_unique<Traced>(*scene_, options_);
    const Traced& traced = *traced_;
    const std::vector<IrradiancePart> parts = irradiance_parts(*light.environment, traced.cells);
    const int count = static_cast<int>(traced.lattice.probes());
    const int directions = traced.cells.size();
    auto grid = std::make_shared<IrradianceGrid>();
    grid->lattice = traced.lattice;
    std::vector<IrradianceSh> first(traced.lattice.probes());  // without light between surfaces
    base::in_parallel(count, options_.threads, [&](int probe) {
        IrradianceSh& sum = first[static_cast<std::size_t>(probe)];
        const ProbeHit* hit = traced.hits_of(probe);
        for (int d = 0; d < directions; ++d, ++hit) {
            const IrradiancePart& part = parts[static_cast<std::size_t>(d)];
            if (hit->kind == ProbeHit::Kind::kNothing) {
                add(sum, part.of_environment);
            } else if (hit->kind == ProbeHit::Kind::kFront) {
                add(sum, part.of_one,
                    hit->emitted +
                        hit->albedo * traced.rays.direct_light(light, hit->point_m, hit->normal));
            }
        }
    });
    grid->probes = traced.settled(first);
    for (int bounce = 0; bounce < options_.bounces; ++bounce) {
        std::vector<IrradianceSh> next = first;
        base::in_parallel(count, options_.threads, [&](int probe) {
            IrradianceSh& sum = next[static_cast<std::size_t>(probe)];
            const ProbeHit* hit = traced.hits_of(probe);
            for (int d = 0; d < directions; ++d, ++hit) {
                if (hit->kind != ProbeHit::Kind::kFront) continue;
                add(sum, parts[static_cast<std::size_t>(d)].of_one,
                    hit->albedo * grid->look_up(hit->point_m, hit->normal));
            }
        });
        grid->probes = traced.settled(std::move(next));
    }
    grid->round_to_halves();
    return grid;
}

ProbeLattice probes_of(const Scene& scene) {
    return probes_over(bounds_of(scene), ProbeOptions{}.most_probes);
}

}  // namespace obscura::renderer
