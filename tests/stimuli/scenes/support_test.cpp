// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>
#include <vector>

#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/noise.h"
#include "stimuli/scenes/support/texture_maker.h"
#include "tests/stimuli/scenes/mesh_soundness.h"

namespace obscura::stimuli {
namespace {

using renderer::Mesh;
using renderer::Vertex;

/// The volume inside a closed mesh whose triangles face outwards; negative when they face inwards.
double volume_m3(const Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 a(mesh.vertices[mesh.indices[i]].position_m);
        const glm::dvec3 b(mesh.vertices[mesh.indices[i + 1]].position_m);
        const glm::dvec3 c(mesh.vertices[mesh.indices[i + 2]].position_m);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

/// That normals and tangents are unit length and perpendicular, and that triangles turn the way
/// their normals point.
void expect_well_formed(const Mesh& mesh) {
    for (const Vertex& vertex : mesh.vertices) {
        EXPECT_NEAR(glm::length(vertex.normal), 1.0F, 1e-4F);
        EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1.0F, 1e-4F);
        EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0.0F, 1e-3F);
        EXPECT_EQ(std::abs(vertex.tangent.w), 1.0F);
    }
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex& a = mesh.vertices[mesh.indices[i]];
        const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 area = glm::cross(b.position_m - a.position_m, c.position_m - a.position_m);
        EXPECT_GE(glm::dot(area, a.normal + b.normal + c.normal), 0.0F);
    }
}

TEST(MeshBuilder, BoxesFaceOutwards) {
    const Mesh box = bevelled_box({1.0F, 2.0F, 3.0F}, 0.0F);
    expect_well_formed(box);
    EXPECT_NEAR(volume_m3(box), 6.0, 1e-5);
    const Mesh cut = bevelled_box({1.0F, 2.0F, 3.0F}, 0.1F);
    EXPECT_LT(volume_m3(cut), 6.0);
    EXPECT_GT(volume_m3(cut), 5.8);
}

TEST(MeshBuilder, PatchesThatComeToAPointAreClosedThereWithoutFlatTriangles) {
    PatchOptions options;
    options.columns = 12;
    options.rows = 6;
    options.closed_u = true;
    const Mesh ball = patch(options, [](float u, float v) {
        const float a = u < 1.0F ? glm::two_pi<float>() * u : 0.0F;
        const float b =
            glm::pi<float>() * (v - 0.5F);  // whose cosine is a little off 0 at the poles
        return glm::vec3(std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b));
    });
    EXPECT_EQ(ball.indices.size() / 3, 2U * 12U * 6U - 2U * 12U);
    EXPECT_TRUE(open_edges(ball).empty());
    EXPECT_TRUE(turned_triangles(ball).empty());
}

TEST(MeshBuilder, NormalsAreTurnedOutwardsWithTheirVertexSplitOnlyWhereNoOneNormalServes) {
    // Two slopes that meet in a ridge, with normals that point into the ground.
    Mesh tent;
    for (const glm::vec3& place : {glm::vec3(-1, 0, 0), glm::vec3(1, 0, 0), glm::vec3(0, 1, 0),
                                   glm::vec3(0, 1, -2), glm::vec3(-1, 0, -2)}) {
        Vertex vertex;
        vertex.position_m = place;
        vertex.normal = {0.0F, -1.0F, 0.0F};
        tent.vertices.push_back(vertex);
    }
    tent.indices = {0, 2, 3, 0, 3, 4, 1, 3, 2};
    ASSERT_EQ(turned_triangles(tent).size(), 3U);
    turn_normals_outwards(tent);
    expect_sound(tent);
    EXPECT_TRUE(turned_triangles(tent).empty());
    EXPECT_EQ(tent.vertices.size(), 5U) << "the mean serves both slopes";
    // A blade so sharp that its sides look away from each other and from their mean.
    Mesh blade = tent;
    blade.vertices[1].position_m = {-1.1F, 0.3F, 0.0F};
    blade.vertices[2].normal = {1.0F, 0.0F, 0.0F};
    turn_normals_outwards(blade);
    EXPECT_TRUE(turned_triangles(blade).empty());
    EXPECT_GT(blade.vertices.size(), 5U);
    const Mesh before = blade;
    turn_normals_outwards(blade);
    EXPECT_TRUE(same_mesh(before, blade)) << "what holds is left as it is";
}

TEST(MeshBuilder, SurfacesOfRevolutionFaceOutwards) {
    const std::vector<glm::vec2> profile{{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 2.0F}, {0.0F, 2.0F}};
    const Mesh drum = revolve(profile, 256);
    expect_well_formed(drum);
    EXPECT_NEAR(volume_m3(drum), 2.0 * glm::pi<double>(), 0.01);
}

TEST(MeshBuilder, SweptProfilesFaceOutwardsAndAreClosed) {
    const std::vector<glm::vec2> square{{-0.5F, -0.5F}, {0.5F, -0.5F}, {0.5F, 0.5F}, {-0.5F, 0.5F}};
    const std::vector<glm::vec3> path{{0.0F, 0.0F, 0.0F}, {0.0F, 3.0F, 0.0F}, {0.0F, 5.0F, 0.0F}};
    const Mesh bar = sweep(square, frames_along(path, {0.0F, 0.0F, 1.0F}));
    expect_well_formed(bar);
    EXPECT_NEAR(volume_m3(bar), 5.0, 1e-4);
}

TEST(MeshBuilder, PatchNormalsAreThoseOfASphereUpToItsPoles) {
    PatchOptions options;
    options.columns = 64;
    options.rows = 32;
    options.closed_u = true;
    const Mesh sphere = patch(options, [](float u, float v) {
        const float around = u * glm::two_pi<float>();
        const float up = (v - 0.5F) * glm::pi<float>();
        return glm::vec3(std::sin(around) * std::cos(up), std::sin(up),
                         std::cos(around) * std::cos(up));
    });
    for (const Vertex& vertex : sphere.vertices) {
        EXPECT_GT(glm::dot(vertex.normal, glm::normalize(vertex.position_m)), 0.99F);
    }
    EXPECT_NEAR(volume_m3(sphere), 4.0 / 3.0 * glm::pi<double>(), 0.03);
}

TEST(MeshBuilder, AMirroredPartStillFacesOutwards) {
    Mesh whole;
    Placement placement;
    placement.transform = glm::scale(glm::mat4(1.0F), {-1.0F, 2.0F, 1.0F});
    append(whole, bevelled_box({1.0F, 1.0F, 1.0F}, 0.05F), placement);
    expect_well_formed(whole);
    EXPECT_GT(volume_m3(whole), 1.9);
}

TEST(MeshBuilder, BoxProjectionGivesMetresAndTangentsAlongU) {
    const Mesh box = bevelled_box({2.0F, 2.0F, 2.0F}, 0.0F);
    for (std::size_t i = 0; i < box.indices.size(); i += 3) {
        const Vertex& a = box.vertices[box.indices[i]];
        const Vertex& b = box.vertices[box.indices[i + 1]];
        const glm::vec3 edge_m = b.position_m - a.position_m;
        const glm::vec2 edge_uv = b.uv - a.uv;
        EXPECT_NEAR(glm::length(edge_m), glm::length(edge_uv), 1e-5F);
        EXPECT_NEAR(glm::dot(edge_m, glm::vec3(a.tangent)), edge_uv.x, 1e-5F);
        const glm::vec3 along_v = glm::cross(a.normal, glm::vec3(a.tangent)) * a.tangent.w;
        EXPECT_NEAR(glm::dot(edge_m, along_v), edge_uv.y, 1e-5F);
    }
}

TEST(Noise, RepeatsAfterItsPeriod) {
    const glm::ivec2 period(4, 6);
    for (int k = 0; k < 50; ++k) {
        const glm::vec2 p(static_cast<float>(k) * 0.37F, static_cast<float>(k) * 0.21F);
        const glm::vec2 q = p + glm::vec2(period);
        EXPECT_NEAR(fbm(p, 3, 5, period), fbm(q, 3, 5, period), 2e-3F);
        EXPECT_NEAR(value_noise(p, 3, period), value_noise(q, 3, period), 1e-4F);
        EXPECT_NEAR(cellular(p, 3, period).nearest, cellular(q, 3, period).nearest, 1e-4F);
    }
}

TEST(Noise, ATileIsTheNoiseItWasMadeFromAndRepeatsAtOne) {
    const NoiseTile tile(5, 8, 3);
    for (int k = 0; k < 50; ++k) {
        const glm::vec2 uv(static_cast<float>(k * 37 % 512) / 512.0F,
                           static_cast<float>(k * 91 % 512) / 512.0F);
        EXPECT_NEAR(tile.at(uv), fbm(uv * 8.0F, 5, 3, {8, 8}), 1e-4F);
        EXPECT_NEAR(tile.at(uv), tile.at(uv + glm::vec2(2.0F, -1.0F)), 1e-3F);
    }
}

TEST(Noise, StaysInItsRangeAndVaries) {
    float low = 1e9F;
    float high = -1e9F;
    for (int k = 0; k < 4000; ++k) {
        const glm::vec3 p(static_cast<float>(k) * 0.173F, static_cast<float>(k % 71) * 0.311F,
                          static_cast<float>(k % 13) * 0.7F);
        const float value = fbm(p, 9, 4);
        low = std::min(low, value);
        high = std::max(high, value);
        EXPECT_GE(ridged(p, 9, 4), -0.1F);
        EXPECT_LE(ridged(p, 9, 4), 1.0F);
        EXPECT_LE(cellular(p, 9).nearest, cellular(p, 9).second);
    }
    EXPECT_GT(low, -1.2F);
    EXPECT_LT(high, 1.2F);
    EXPECT_LT(low, -0.3F);
    EXPECT_GT(high, 0.3F);
}

TEST(TextureMaker, NormalsLeanAwayFromTheSlope) {
    TextureRecipe recipe;
    recipe.name = "slope";
    recipe.width = recipe.height = 64;
    recipe.at = [](glm::vec2 uv) {
        Texel texel;  // rises along +u in the first half, falls in the second
        texel.albedo = glm::vec3(0.5F, 0.25F, 1.0F);
        texel.height_m = 0.5F - std::abs(uv.x - 0.5F);
        return texel;
    };
    const BakedTextures baked = bake(recipe);
    const auto texel = [&](int x, int channel) {
        return baked.normal.rgba[static_cast<std::size_t>(4 * (32 * 64 + x) + channel)];
    };
    EXPECT_EQ(texel(16, 0), 128 - 90);  // -1 / sqrt(2)
    EXPECT_EQ(texel(48, 0), 128 + 90);
    EXPECT_EQ(texel(16, 1), 128);
    EXPECT_EQ(texel(16, 2), 128 + 90);
    EXPECT_EQ(baked.albedo.rgba[0], 188);  // 0.5 linear
    EXPECT_EQ(baked.albedo.rgba[2], 255);
    EXPECT_TRUE(baked.albedo.srgb);
    EXPECT_FALSE(baked.normal.srgb);
    EXPECT_FALSE(baked.roughness.has_value());
    recipe.roughness = true;
    const BakedTextures rough = bake(recipe);
    ASSERT_TRUE(rough.roughness.has_value());
    EXPECT_FALSE(rough.roughness->srgb);
    EXPECT_EQ(rough.roughness->rgba[1], 255);  // nothing said: fully rough
    EXPECT_EQ(rough.roughness->rgba[2], 0);    // and no metal
}

TEST(TextureMaker, SrgbCodesAreThoseOfTheStandardAndSurviveTheRoundTrip) {
    // IEC 61966-2-1: code / 255 / 12.92 up to .04045, ((code / 255 + .055) / 1.055)^2.4 above.
    EXPECT_NEAR(linear_from_srgb(10).z, 0.003035270, 1e-7);
    EXPECT_NEAR(linear_from_srgb(188).z, 0.502886458, 1e-6);
    for (std::uint32_t code = 0; code < 256; ++code) {
        EXPECT_EQ(encode_srgb(linear_from_srgb(code).z), code);
    }
}

}  // namespace
}  // namespace obscura::stimuli
