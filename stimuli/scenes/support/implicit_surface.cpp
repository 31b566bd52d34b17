// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/implicit_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli {
namespace {

constexpr int kCells = 4;          ///< cells along an edge of a block
constexpr int kLocalCells = 16;    ///< size of a block for which nested sculptures are cut down
constexpr int kSide = kCells + 1;  ///< corners along an edge, those of the next blocks included
// Fields that are distances of first order only say too much: flat ellipsoids deep inside most.
constexpr float kSlackOutside = 1.5F;
constexpr float kSlackInside = 3.0F;

/// A corner whose edge along `axis` crosses the surface.
struct Crossing {
    std::uint8_t x, y, z, axis;
    bool outwards;  ///< the field grows along the axis
};

struct Block {
    glm::ivec3 origin{0};  ///< in cells
    std::vector<Sculpture::Part> parts;
    std::array<float, kCells * kCells * kCells> values{};  ///< at the corners it owns
    std::array<std::int32_t, kCells * kCells * kCells> vertex_of_cell{};
    std::vector<renderer::Vertex> vertices;
    std::vector<Crossing> crossings;
    std::uint32_t first_vertex = 0;
    std::vector<std::uint32_t> indices;
};

/// A cube of kLocalCells that the surface may pass through.
struct Region {
    glm::ivec3 origin{0};  ///< in cells
    std::vector<Sculpture::Part> parts;
    std::vector<ShapePtr> owners;  ///< of what stands in for parts here
    std::vector<Block> blocks;
};

constexpr int cell_index(int x, int y, int z) { return (z * kCells + y) * kCells + x; }
constexpr int corner_index(int x, int y, int z) { return (z * kSide + y) * kSide + x; }

std::uint64_t key_of(const glm::ivec3& origin) {
    const auto part = [](int value) { return static_cast<std::uint64_t>(value / kCells + 4096); };
    return (part(origin.z) << 40) | (part(origin.y) << 20) | part(origin.x);
}

class Mesher {
  public:
    Mesher(const Sculpture& sculpture, float cell_m, const Painter& painter)
        : sculpture_(sculpture), cell_m_(cell_m), painter_(painter) {}

    renderer::Mesh run() {
        find_blocks();
        for_each_block([this](Block& block) { sample(block); });
        for_each_block([this](Block& block) { place_vertices(block); });
        return assemble();
    }

  private:
    [[nodiscard]] glm::vec3 position(const glm::vec3& cells) const {
        return origin_m_ + cells * cell_m_;
    }

    void for_each_block(const std::function<void(Block&)>& work) {
        for_each_row(static_cast<int>(blocks_.size()),
                     [&](int i) { work(blocks_[static_cast<std::size_t>(i)]); });
    }

    /// Halves the bounding cube until blocks remain that the surface may pass through.
    void find_blocks() {
        const ShapeBounds bounds = sculpture_.bounds();
        origin_m_ = bounds.low - 2.0F * cell_m_;
        const glm::vec3 size = bounds.high - bounds.low + 4.0F * cell_m_;
        int cells = kLocalCells;
        while (static_cast<float>(cells) * cell_m_ < std::max({size.x, size.y, size.z})) cells *= 2;
        const auto parts = sculpture_.parts();
        divide(glm::ivec3(0), cells, {parts.begin(), parts.end()}, nullptr);
        for_each_row(static_cast<int>(regions_.size()), [this](int i) {
            Region& region = regions_[static_cast<std::size_t>(i)];
            divide(region.origin, kLocalCells, region.parts, &region);
        });
        for (Region& region : regions_) {
            for (Block& block : region.blocks) {
                index_[key_of(block.origin)] = blocks_.size();
                blocks_.push_back(std::move(block));
            }
        }
    }

    /// Whether the surface may pass through a cube of `half` cells to each side.
    [[nodiscard]] bool may_cross(const glm::vec3& centre, float half,
                                 std::span<const Sculpture::Part> parts) const {
        const float radius_m = std::sqrt(3.0F) * half * cell_m_;
        const float high_m = sculpture_.relief_high(parts);
        const float middle = sculpture_.distance(centre, parts);
        return middle <= kSlackOutside * radius_m + high_m &&
               middle >= -kSlackInside * radius_m - high_m;
    }

    /// Adds regions, or within one its blocks.
    void divide(const glm::ivec3& origin, int cells, const std::vector<Sculpture::Part>& above,
                Region* region) {
        const float half = 0.5F * static_cast<float>(cells);
        const glm::vec3 centre = position(glm::vec3(origin) + half);
        const float radius_m = std::sqrt(3.0F) * half * cell_m_ + cell_m_;  // gradients look on
        auto parts = sculpture_.near(centre, radius_m, above);
        if (parts.empty() || !may_cross(centre, half, parts)) return;
        if (cells == kLocalCells) {
            if (region == nullptr) {
                regions_.push_back({origin, std::move(parts), {}, {}});
                return;
            }
            sculpture_.localise(centre, 2.0F * radius_m, parts, region->owners);
        }
        if (cells == kCells) {
            bool crossed = false;
            for (int child = 0; child < 8 && !crossed; ++child) {
                const glm::vec3 off(child & 1, (child >> 1) & 1, child >> 2);
                crossed = may_cross(centre + (off - 0.5F) * (half * cell_m_), 0.5F * half, parts);
            }
            if (!crossed) return;
            Block& block = region->blocks.emplace_back();
            block.origin = origin;
            block.parts = std::move(parts);
            return;
        }
        const int step = cells / 2;
        for (int child = 0; child < 8; ++child) {
            divide(origin + step * glm::ivec3(child & 1, (child >> 1) & 1, child >> 2), step, parts,
                   region);
        }
    }

    void sample(Block& block) const {
        for (int z = 0; z < kCells; ++z) {
            for (int y = 0; y < kCells; ++y) {
                for (int x = 0; x < kCells; ++x) {
                    block.values[static_cast<std::size_t>(cell_index(x, y, z))] =
                        sculpture_.distance(position(glm::vec3(block.origin + glm::ivec3(x, y, z))),
                                            block.parts);
                }
            }
        }
    }

    [[nodiscard]] const Block* find(const glm::ivec3& origin) const {
        const auto found = index_.find(key_of(origin));
        return found == index_.end() ? nullptr : &blocks_[found->second];
    }

    /// The block's own corners and the first ones of the seven blocks after it, so that two blocks
    /// never disagree about a corner that they share.
    [[nodiscard]] std::array<float, kSide * kSide * kSide> corners(const Block& block) const {
        std::array<const Block*, 8> next{};
        for (int i = 0; i < 8; ++i) {
            const glm::ivec3 step(i & 1, (i >> 1) & 1, i >> 2);
            next[static_cast<std::size_t>(i)] =
                i == 0 ? &block : find(block.origin + kCells * step);
        }
        std::array<float, kSide * kSide * kSide> result{};
        for (int z = 0; z < kSide; ++z) {
            for (int y = 0; y < kSide; ++y) {
                for (int x = 0; x < kSide; ++x) {
                    const int which = x / kCells + 2 * (y / kCells) + 4 * (z / kCells);
                    const Block* owner = next[static_cast<std::size_t>(which)];
                    const int own = cell_index(x % kCells, y % kCells, z % kCells);
                    result[static_cast<std::size_t>(corner_index(x, y, z))] =
                        owner != nullptr
                            ? owner->values[static_cast<std::size_t>(own)]
                            : sculpture_.distance(
                                  position(glm::vec3(block.origin + glm::ivec3(x, y, z))),
                                  block.parts);
                }
            }
        }
        return result;
    }

    void place_vertices(Block& block) const {
        const auto values = corners(block);
        const auto value = [&](int x, int y, int z) {
            return values[static_cast<std::size_t>(corner_index(x, y, z))];
        };
        block.vertex_of_cell.fill(-1);
        for (int z = 0; z < kCells; ++z) {
            for (int y = 0; y < kCells; ++y) {
                for (int x = 0; x < kCells; ++x) {
                    const float here = value(x, y, z);
                    const std::array<float, 3> ahead{value(x + 1, y, z), value(x, y + 1, z),
                                                     value(x, y, z + 1)};
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        if ((here < 0.0F) != (ahead[axis] < 0.0F)) {
                            block.crossings.push_back(
                                {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                                 static_cast<std::uint8_t>(z), static_cast<std::uint8_t>(axis),
                                 here < 0.0F});
                        }
                    }
                    std::array<float, 8> cube{};
                    for (int i = 0; i < 8; ++i) {
                        cube[static_cast<std::size_t>(i)] =
                            value(x + (i & 1), y + ((i >> 1) & 1), z + (i >> 2));
                    }
                    glm::vec3 middle(0.0F);
                    if (!middle_of_crossings(cube, middle)) continue;
                    block.vertex_of_cell[static_cast<std::size_t>(cell_index(x, y, z))] =
                        static_cast<std::int32_t>(block.vertices.size());
                    block.vertices.push_back(
                        vertex_at(position(glm::vec3(block.origin + glm::ivec3(x, y, z)) + middle),
                                  cube, block));
                }
            }
        }
    }

    /// The mean of the points where the surface crosses the cell's edges, in [0, 1]^3.
    static bool middle_of_crossings(const std::array<float, 8>& cube, glm::vec3& middle) {
        float count = 0.0F;
        for (int corner = 0; corner < 8; ++corner) {
            for (int axis = 0; axis < 3; ++axis) {
                const int other = corner | (1 << axis);
                if (other == corner) continue;
                const float a = cube[static_cast<std::size_t>(corner)];
                const float b = cube[static_cast<std::size_t>(other)];
                if ((a < 0.0F) == (b < 0.0F)) continue;
                glm::vec3 point(corner & 1, (corner >> 1) & 1, corner >> 2);
                point[axis] += a / (a - b);
                middle += point;
                count += 1.0F;
            }
        }
        if (count == 0.0F) return false;
        middle /= count;
        return true;
    }

    /// From four taps at the corners of a tetrahedron.
    [[nodiscard]] glm::vec3 gradient(const glm::vec3& p, const Block& block) const {
        const float h = 0.4F * cell_m_;
        constexpr std::array<glm::vec3, 4> kTaps{glm::vec3(1, -1, -1), glm::vec3(-1, -1, 1),
                                                 glm::vec3(-1, 1, -1), glm::vec3(1, 1, 1)};
        glm::vec3 sum(0.0F);
        for (const glm::vec3& tap : kTaps) {
            sum += tap * sculpture_.distance(p + h * tap, block.parts);
        }
        return sum / (4.0F * h);
    }

    /// Moves the mean of the crossings onto the surface, along the slope between the cell's
    /// corners.
    [[nodiscard]] renderer::Vertex vertex_at(const glm::vec3& start,
                                             const std::array<float, 8>& cube,
                                             const Block& block) const {
        glm::vec3 slope(0.0F);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            slope += sign * cube[static_cast<std::size_t>(corner)];
        }
        slope /= 4.0F * cell_m_;
        const float value = sculpture_.distance(start, block.parts);
        const float steep2 = std::max(glm::dot(slope, slope), 0.25F);
        glm::vec3 step = -slope * (value / steep2);
        const float longest = 0.3F * cell_m_;
        if (glm::length(step) > longest) step *= longest / glm::length(step);
        renderer::Vertex vertex;
        vertex.position_m = start + step;
        slope = gradient(vertex.position_m, block);
        const float length = glm::length(slope);
        vertex.normal = length > 1e-6F ? slope / length : glm::vec3(0.0F, 1.0F, 0.0F);
        const glm::vec3 hint = std::abs(vertex.normal.y) < 0.9F ? glm::vec3(0.0F, 1.0F, 0.0F)
                                                                : glm::vec3(0.0F, 0.0F, 1.0F);
        vertex.tangent = glm::vec4(glm::normalize(glm::cross(hint, vertex.normal)), 1.0F);
        glm::vec3 colour = sculpture_.tint(vertex.position_m, block.parts);
        if (painter_) colour = painter_(vertex.position_m, vertex.normal, colour);
        vertex.color =
            glm::u8vec4(glm::clamp(colour, glm::vec3(0.0F), glm::vec3(1.0F)) * 255.0F + 0.5F, 255);
        return vertex;
    }

    [[nodiscard]] std::int64_t vertex_of(const glm::ivec3& cell) const {
        const glm::ivec3 inside((cell.x % kCells + kCells) % kCells,
                                (cell.y % kCells + kCells) % kCells,
                                (cell.z % kCells + kCells) % kCells);
        const Block* block = find(cell - inside);
        if (block == nullptr) return -1;
        const std::int32_t local = block->vertex_of_cell[static_cast<std::size_t>(
            cell_index(inside.x, inside.y, inside.z))];
        return local < 0 ? -1 : static_cast<std::int64_t>(block->first_vertex) + local;
    }

    renderer::Mesh assemble() {
        renderer::Mesh mesh;
        for (Block& block : blocks_) {
            block.first_vertex = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.vertices.insert(mesh.vertices.end(), block.vertices.begin(), block.vertices.end());
        }
        for_each_block([&](Block& block) {
            for (const Crossing& crossing : block.crossings) add_quad(mesh, block, crossing);
        });
        for (const Block& block : blocks_) {
            mesh.indices.insert(mesh.indices.end(), block.indices.begin(), block.indices.end());
        }
        turn_normals_outwards(mesh);
        return mesh;
    }

    /// The four cells around a crossed edge, split along the shorter diagonal.
    void add_quad(const renderer::Mesh& mesh, Block& block, const Crossing& crossing) const {
        const glm::ivec3 cell = block.origin + glm::ivec3(crossing.x, crossing.y, crossing.z);
        glm::ivec3 u(0);
        glm::ivec3 v(0);
        u[(crossing.axis + 1) % 3] = 1;
        v[(crossing.axis + 2) % 3] = 1;
        std::array<std::int64_t, 4> at{vertex_of(cell - u - v), vertex_of(cell - v),
                                       vertex_of(cell), vertex_of(cell - u)};
        if (std::any_of(at.begin(), at.end(), [](std::int64_t i) { return i < 0; })) return;
        if (!crossing.outwards) std::swap(at[1], at[3]);
        const auto place = [&](std::size_t i) {
            return mesh.vertices[static_cast<std::size_t>(at[i])].position_m;
        };
        const std::size_t first =
            glm::distance(place(0), place(2)) <= glm::distance(place(1), place(3)) ? 0 : 1;
        for (const std::array<std::size_t, 3>& corners_of :
             {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
            std::array<std::size_t, 3> corner{};
            for (std::size_t i = 0; i < 3; ++i) corner[i] = (first + corners_of[i]) % 4;
            const bool flat = place(corner[0]) == place(corner[1]) ||
                              place(corner[1]) == place(corner[2]) ||
                              place(corner[2]) == place(corner[0]);
            if (flat) continue;
            for (const std::size_t i : corner) {
                block.indices.push_back(static_cast<std::uint32_t>(at[i]));
            }
        }
    }

    const Sculpture& sculpture_;
    float cell_m_;
    const Painter& painter_;
    glm::vec3 origin_m_{0.0F};
    std::vector<Block> blocks_;
    std::vector<Region> regions_;
    std::unordered_map<std::uint64_t, std::size_t> index_;
};

}  // namespace

renderer::Mesh polygonise(const Sculpture& sculpture, float cell_m, const Painter& painter) {
    return Mesher(sculpture, cell_m, painter).run();
}

}  // namespace obscura::stimuli
