// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stimuli/scenes/list.h"
#include "stimuli/scenes/room/parts.h"

namespace obscura::stimuli {
namespace {

/// What of a rectangle is covered by triangles, seen along -Z: a bit for each cell's middle.
class Cover {
  public:
    Cover(glm::vec2 low_m, glm::vec2 high_m, float cell_m)
        : low_m_(low_m), cell_m_(cell_m), size_(glm::ivec2((high_m - low_m) / cell_m)) {
        covered_.resize(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y));
    }
    void add(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c) {
        const glm::ivec2 first = glm::max(cell(glm::min(a, glm::min(b, c))), glm::ivec2(0));
        const glm::ivec2 last = glm::min(cell(glm::max(a, glm::max(b, c))), size_ - 1);
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                const glm::vec2 p = low_m_ + (glm::vec2(x, y) + 0.5F) * cell_m_;
                const float u = side(a, b, p);
                const float v = side(b, c, p);
                const float w = side(c, a, p);
                if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0)) {
                    covered_[static_cast<std::size_t>(y * size_.x + x)] = true;
                }
            }
        }
    }
    [[nodiscard]] std::vector<glm::vec2> holes() const {
        std::vector<glm::vec2> places;
        for (int y = 0; y < size_.y; ++y) {
            for (int x = 0; x < size_.x; ++x) {
                if (covered_[static_cast<std::size_t>(y * size_.x + x)]) continue;
                places.push_back(low_m_ + (glm::vec2(x, y) + 0.5F) * cell_m_);
            }
        }
        return places;
    }

  private:
    [[nodiscard]] glm::ivec2 cell(const glm::vec2& p) const {
        return glm::ivec2(glm::floor((p - low_m_) / cell_m_));
    }
    static float side(const glm::vec2& a, const glm::vec2& b, const glm::vec2& p) {
        return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    }
    glm::vec2 low_m_;
    float cell_m_;
    glm::ivec2 size_;
    std::vector<bool> covered_;
};

TEST(Bookcase, ShowsNothingOfTheWallThroughItsBackItsJointsItsTopOrItsFoot) {
    constexpr float kCornice_m = 2.17F;  // its lower edge
    Cover back({room::kShelfLeft, 0.001F}, {room::kShelfRight, kCornice_m}, 0.0005F);
    const renderer::Scene scene = make_room().build();
    const auto wood = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                   [](const auto& mesh) { return mesh.name == "wood"; });
    ASSERT_NE(wood, scene.meshes.end());
    // Of the back alone: what stands on the shelves or lies before it hides no gap from the side.
    constexpr float kBehindTheShelves_m = room::kBack + 0.03F;
    for (std::size_t i = 0; i < wood->indices.size(); i += 3) {
        const auto place = [&](std::size_t k) {
            return wood->vertices[wood->indices[i + k]].position_m;
        };
        if (std::max({place(0).z, place(1).z, place(2).z}) > kBehindTheShelves_m) continue;
        back.add(place(0), place(1), place(2));
    }
    const std::vector<glm::vec2> holes = back.holes();
    EXPECT_TRUE(holes.empty()) << holes.size() << " holes, the first at " << holes.front().x << ' '
                               << holes.front().y;
}

TEST(Bookcase, HasShelvesThatReachTheUprights) {
    const renderer::Scene scene = make_room().build();
    const auto wood = std::find_if(scene.meshes.begin(), scene.meshes.end(),
                                   [](const auto& mesh) { return mesh.name == "wood"; });
    ASSERT_NE(wood, scene.meshes.end());
    for (const float shelf_m : room::kShelf_m) {
        float left_m = room::kShelfRight;
        float right_m = room::kShelfLeft;
        for (const renderer::Vertex& vertex : wood->vertices) {
            const glm::vec3& p = vertex.position_m;
            const bool on_shelf = std::abs(p.y - shelf_m) < 1e-3F && p.z < room::kBack + 0.31F &&
                                  p.z > room::kBack && p.x > room::kShelfLeft - 0.01F &&
                                  p.x < room::kShelfRight + 0.01F;
            if (!on_shelf) continue;
            left_m = std::min(left_m, p.x);
            right_m = std::max(right_m, p.x);
        }
        EXPECT_LE(left_m, room::kShelfLeft) << shelf_m;
        EXPECT_GE(right_m, room::kShelfRight) << shelf_m;
    }
}

}  // namespace
}  // namespace obscura::stimuli
