// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/coarse_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace obscura::app::explorer {
namespace {

/// The six sides of a cube of 2 m, each a bulge of `cells` x `cells` squares with vertices of its
/// own: what meets at an edge of the cube has other normals there.
renderer::Scene cube(int cells, float bulge_m) {
    renderer::Scene scene;
    scene.materials.resize(1);
    scene.textures.push_back({"t", 4, 4, true, std::vector<std::uint8_t>(64, 255)});
    renderer::Mesh mesh;
    for (int side = 0; side < 6; ++side) {
        const float sign = side % 2 == 0 ? 1.0F : -1.0F;
        glm::vec3 normal(0.0F);
        normal[side / 2] = sign;
        glm::vec3 u(0.0F);
        u[(side / 2 + 1) % 3] = 1.0F;
        const glm::vec3 v = glm::cross(normal, u);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int y = 0; y <= cells; ++y) {
            for (int x = 0; x <= cells; ++x) {
                const glm::vec2 at = 2.0F * glm::vec2(x, y) / static_cast<float>(cells) - 1.0F;
                const glm::vec2 wave = bulge_m * glm::cos(0.5F * glm::pi<float>() * at);
                renderer::Vertex vertex;
                vertex.position_m = (1.0F + wave.x * wave.y) * normal + at.x * u + at.y * v;
                vertex.normal = normal;
                vertex.uv = at;
                mesh.vertices.push_back(vertex);
            }
        }
        const auto row = static_cast<std::uint32_t>(cells) + 1;
        for (std::uint32_t y = 0; y + 1 < row; ++y) {
            for (std::uint32_t x = 0; x + 1 < row; ++x) {
                const std::uint32_t at = first + y * row + x;
                for (const std::uint32_t i : {0U, 1U, row + 1, 0U, row + 1, row}) {
                    mesh.indices.push_back(at + i);
                }
            }
        }
    }
    scene.meshes = {mesh};
    return scene;
}

TEST(CoarseScene, HasFewTrianglesNearTheSurface) {
    const renderer::Scene scene = cube(40, 0.3F);
    const auto coarse = coarser(scene, 1500);
    ASSERT_TRUE(coarse);
    EXPECT_LE(coarse->scene.triangle_count(), 1500U);
    EXPECT_GT(coarse->scene.triangle_count(), 100U);
    EXPECT_GT(coarse->error_m, 0.0F);
    EXPECT_LT(coarse->error_m, 0.05F);
    for (const renderer::Vertex& vertex : coarse->scene.meshes.at(0).vertices) {
        const bool there = std::any_of(
            scene.meshes[0].vertices.begin(), scene.meshes[0].vertices.end(),
            [&](const renderer::Vertex& of) { return of.position_m == vertex.position_m; });
        ASSERT_TRUE(there) << "a vertex that the scene has not";
        ASSERT_NEAR(glm::length(vertex.normal), 1.0F, 1e-4F);
    }
}

TEST(CoarseScene, KeepsTheEdgesOfABoxSharpAndItsSidesWhole) {
    // Sixteenths are exact: the sides meet to the bit.
    const auto coarse = coarser(cube(16, 0.0F), 100);
    ASSERT_TRUE(coarse);
    const renderer::Mesh& mesh = coarse->scene.meshes.at(0);
    float area_m2 = 0.0F;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
        const glm::vec3 across = glm::cross(corner(1).position_m - corner(0).position_m,
                                            corner(2).position_m - corner(0).position_m);
        area_m2 += 0.5F * glm::length(across);
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(glm::dot(corner(k).normal, glm::normalize(across)), 1.0F, 1e-4F);
        }
    }
    EXPECT_NEAR(area_m2, 24.0F, 1e-3F);
}

/// Tiles of 1 m with a chamfer of 1 cm on every side, whose normals are the mean of what meets, and
/// each with a piece of the texture of its own.
renderer::Scene tiles(int side) {
    renderer::Scene scene;
    scene.materials.resize(1);
    renderer::Mesh mesh;
    for (int tile = 0; tile < side * side; ++tile) {
        const glm::vec3 low(tile % side, 0.0F, tile / side);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const std::array at{0.0F, 0.01F, 0.99F, 1.0F};
        for (int y = 0; y < 4; ++y) {
            for (int x = 0; x < 4; ++x) {
                const bool rim = x % 3 == 0 || y % 3 == 0;
                renderer::Vertex vertex;
                vertex.position_m = low + glm::vec3(at[x], rim ? -0.005F : 0.0F, at[y]);
                vertex.normal = glm::normalize(glm::vec3(x == 0 ? -1.0F : (x == 3 ? 1.0F : 0.0F),
                                                         1.0F, y == 0 ? -1.0F : y == 3));
                vertex.uv = glm::vec2(at[x], at[y]) + 0.37F * static_cast<float>(tile * 13 % 7);
                mesh.vertices.push_back(vertex);
            }
        }
        for (std::uint32_t y = 0; y < 3; ++y) {
            for (std::uint32_t x = 0; x < 3; ++x) {
                for (const std::uint32_t i : {0U, 4U, 5U, 0U, 5U, 1U}) {
                    mesh.indices.push_back(first + 4 * y + x + i);
                }
            }
        }
    }
    scene.meshes = {mesh};
    return scene;
}

TEST(CoarseScene, IsShadedAsItsTrianglesLieAndTearsNoTexture) {
    const renderer::Scene scene = tiles(12);
    const auto coarse = coarser(scene, scene.triangle_count() / 6);
    ASSERT_TRUE(coarse);
    const renderer::Mesh& mesh = coarse->scene.meshes.at(0);
    ASSERT_FALSE(mesh.indices.empty());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.indices[i + k]]; };
        const glm::vec3 face =
            glm::normalize(glm::cross(corner(1).position_m - corner(0).position_m,
                                      corner(2).position_m - corner(0).position_m));
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_GT(glm::dot(corner(k).normal, face), 0.7F) << i;
            const auto& from = corner(k);
            const auto& to = corner((k + 1) % 3);
            const float metres = glm::distance(from.position_m, to.position_m);
            // One unit of the texture is a metre.
            EXPECT_LT(glm::distance(from.uv, to.uv), 2.0F * metres) << i;
        }
    }
}

TEST(CoarseScene, HasTheMaterialsAndTheSizesOfTheTextures) {
    const renderer::Scene scene = cube(20, 0.1F);
    const auto coarse = coarser(scene, 500);
    ASSERT_TRUE(coarse);
    EXPECT_EQ(coarse->scene.materials.size(), scene.materials.size());
    ASSERT_EQ(coarse->scene.textures.size(), 1U);
    EXPECT_EQ(coarse->scene.textures[0].width, 4);
    EXPECT_TRUE(coarse->scene.textures[0].rgba.empty());
}

TEST(CoarseScene, IsNotMadeOfFewTrianglesOrOfNothingOrWhereNobodyWantsIt) {
    const renderer::Scene scene = cube(12, 0.1F);
    EXPECT_FALSE(coarser(scene, scene.triangle_count()));
    EXPECT_FALSE(coarser(renderer::Scene{}, 0));
    EXPECT_FALSE(coarser(scene, 10, [] { return false; }));
    renderer::Scene bad = scene;
    bad.meshes[0].vertices[0].position_m.x = std::nanf("");
    (void)coarser(bad, 10);  // comes back, whatever it makes of it
}

}  // namespace
}  // namespace obscura::app::explorer
