// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/implicit_surface.h"

#include <gtest/gtest.h>
#include <sched.h>

#include <cmath>
#include <numbers>

#include "tests/stimuli/scenes/mesh_soundness.h"

namespace obscura::stimuli {
namespace {

Sculpture snowman() {
    Sculpture s;
    s.add(ball({0.0F, 0.0F, 0.0F}, 0.10F), {0.0F, {1.0F, 0.0F, 0.0F}, true});
    s.add(ball({0.0F, 0.13F, 0.0F}, 0.07F), {0.03F, {0.0F, 1.0F, 0.0F}, true});
    s.carve(ball({0.0F, 0.0F, 0.10F}, 0.04F), {0.01F, {0.0F, 0.0F, 1.0F}, true});
    return s;
}

double area_m2(const renderer::Mesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.vertices[mesh.indices[i]].position_m;
        const glm::vec3 b = mesh.vertices[mesh.indices[i + 1]].position_m;
        const glm::vec3 c = mesh.vertices[mesh.indices[i + 2]].position_m;
        sum += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return sum;
}

TEST(ImplicitSurface, ABallIsMeshedWhereItIsWithItsNormalsAndItsArea) {
    Sculpture s;
    const glm::vec3 centre(0.3F, -0.2F, 0.1F);
    s.add(ball(centre, 0.1F));
    const renderer::Mesh mesh = polygonise(s, 0.006F);
    expect_sound(mesh);
    EXPECT_TRUE(open_edges(mesh).empty());
    for (const renderer::Vertex& vertex : mesh.vertices) {
        const glm::vec3 out = vertex.position_m - centre;
        ASSERT_NEAR(glm::length(out), 0.1F, 2e-5F);
        ASSERT_GT(glm::dot(glm::normalize(out), vertex.normal), 0.9999F);
    }
    const double area = 4.0 * std::numbers::pi * 0.1 * 0.1;
    EXPECT_NEAR(area_m2(mesh), area, 0.005 * area);
}

TEST(ImplicitSurface, TrianglesAreCounterClockwiseFromOutside) {
    const renderer::Mesh mesh = polygonise(snowman(), 0.006F);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const renderer::Vertex& a = mesh.vertices[mesh.indices[i]];
        const renderer::Vertex& b = mesh.vertices[mesh.indices[i + 1]];
        const renderer::Vertex& c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 face = glm::cross(b.position_m - a.position_m, c.position_m - a.position_m);
        if (glm::dot(face, a.normal + b.normal + c.normal) <= 0.0F) ++wrong;
    }
    EXPECT_EQ(wrong, 0U);
}

TEST(ImplicitSurface, BlendedAndCarvedSolidsAreClosed) {
    const renderer::Mesh mesh = polygonise(snowman(), 0.004F);
    expect_sound(mesh);
    EXPECT_TRUE(open_edges(mesh).empty());
}

TEST(ImplicitSurface, StrokesBlendOnlyWithinTheirWidth) {
    const Sculpture s = snowman();
    const glm::vec3 low(0.0F, -0.15F, 0.0F);
    EXPECT_FLOAT_EQ(s.distance(low), 0.05F);
    EXPECT_LT(s.distance({0.0F, 0.085F, 0.055F}),
              ball({0.0F, 0.0F, 0.0F}, 0.10F)->distance({0.0F, 0.085F, 0.055F}));
    EXPECT_GT(s.distance({0.0F, 0.0F, 0.09F}), 0.0F) << "carved away";
}

TEST(ImplicitSurface, ColoursComeFromTheStrokeThatMadeTheSurface) {
    const Sculpture s = snowman();
    EXPECT_EQ(s.tint({0.0F, -0.1F, 0.0F}, s.parts()), glm::vec3(1.0F, 0.0F, 0.0F));
    EXPECT_EQ(s.tint({0.0F, 0.2F, 0.0F}, s.parts()), glm::vec3(0.0F, 1.0F, 0.0F));
    EXPECT_EQ(s.tint({0.0F, 0.0F, 0.06F}, s.parts()), glm::vec3(0.0F, 0.0F, 1.0F));
}

TEST(ImplicitSurface, ANestedSculptureIsMeshedAsIfItsStrokesWereItsParents) {
    Sculpture outer;
    outer.add(as_shape(snowman()), {0.0F, {1.0F, 0.0F, 0.0F}, true});
    const renderer::Mesh nested = polygonise(outer, 0.005F);
    EXPECT_TRUE(open_edges(nested).empty());
    const Sculpture plain = snowman();
    for (const renderer::Vertex& vertex : nested.vertices) {
        ASSERT_NEAR(plain.distance(vertex.position_m), 0.0F, 3e-4F);
    }
}

TEST(ImplicitSurface, OneThreadMakesTheSameMeshAsMany) {
    const renderer::Mesh many = polygonise(snowman(), 0.004F);
    cpu_set_t all;
    ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (std::size_t cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
        if (CPU_ISSET(cpu, &all)) {
            CPU_SET(cpu, &one);
            break;
        }
    }
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    const renderer::Mesh single = polygonise(snowman(), 0.004F);
    sched_setaffinity(0, sizeof all, &all);
    EXPECT_TRUE(same_mesh(many, single));
}

TEST(ImplicitShapes, DistancesOfRoundConesAndBoxesAreExact) {
    const ShapePtr cone = round_cone({0, 0, 0}, 0.2F, {0, 1, 0}, 0.2F);
    EXPECT_NEAR(cone->distance({0.5F, 0.5F, 0.0F}), 0.3F, 1e-6F);
    EXPECT_NEAR(cone->distance({0.0F, 1.5F, 0.0F}), 0.3F, 1e-6F);
    const ShapePtr box = rounded_box({0, 0, 0}, {0.1F, 0.2F, 0.3F}, 0.05F);
    EXPECT_NEAR(box->distance({0.2F, 0.0F, 0.0F}), 0.1F, 1e-6F);
    EXPECT_NEAR(box->distance({0.0F, 0.0F, 0.0F}), -0.1F, 1e-6F);
    const ShapePtr swallowed = round_cone({0, 0, 0}, 0.3F, {0.1F, 0, 0}, 0.1F);
    EXPECT_NEAR(swallowed->distance({0.0F, 0.4F, 0.0F}), 0.1F, 1e-6F);
}

TEST(ImplicitShapes, NoLowerBoundExceedsTheDistance) {
    const Curve curve = make_curve({{{0, 0, 0}, 0.05F, 0.01F},
                                    {{0.1F, 0.1F, 0}, 0.02F, 0.04F},
                                    {{0.2F, 0, 0.1F}, 0.03F, 0.0F}},
                                   5, {0, 1, 0});
    std::vector<ShapePtr> shapes = tube(curve);
    for (const ShapePtr& squarish : tube(curve, {true, nullptr, 0.0F})) shapes.push_back(squarish);
    shapes.push_back(ellipsoid({0.1F, 0, 0}, {0.02F, 0.1F, 0.05F}));
    shapes.push_back(grown(ball({0, 0, 0}, 0.05F), 0.02F));
    for (const ShapePtr& shape : shapes) {
        for (int i = 0; i < 200; ++i) {
            // Points on the surface, found along a ray from outside: the bound must not be above 0.
            const auto t = static_cast<float>(i);
            const glm::vec3 way = glm::normalize(
                glm::vec3(std::sin(t), std::cos(1.7F * t), std::sin(2.3F * t + 1.0F)));
            const ShapeBounds box = shape->bounds();
            glm::vec3 inside = 0.5F * (box.low + box.high);
            if (shape->distance(inside) > 0.0F) continue;
            glm::vec3 outside = inside + way * 0.6F;
            for (int step = 0; step < 40; ++step) {
                const glm::vec3 middle = 0.5F * (inside + outside);
                (shape->distance(middle) < 0.0F ? inside : outside) = middle;
            }
            ASSERT_LE(shape->lower_bound(outside), 1e-5F);
            ASSERT_TRUE(glm::all(glm::lessThanEqual(box.low - 1e-5F, outside)) &&
                        glm::all(glm::lessThanEqual(outside, box.high + 1e-5F)));
        }
    }
}

TEST(ImplicitShapes, ACurvesLengthsGrowAndItsNormalsStandAcrossIt) {
    const Curve curve = make_curve(
        {{{0, 0, 0}, 0.1F, 0.0F}, {{0, 1, 0}, 0.2F, 0.0F}, {{1, 1, 0}, 0.1F, 0.0F}}, 10, {0, 0, 1});
    ASSERT_EQ(curve.size(), 21U);
    EXPECT_EQ(curve.front().position_m, glm::vec3(0.0F));
    EXPECT_NEAR(curve[10].width_m, 0.2F, 1e-6F);
    EXPECT_EQ(curve[10].width_m, curve[10].height_m);
    for (std::size_t i = 1; i < curve.size(); ++i) {
        EXPECT_GT(curve[i].length_m, curve[i - 1].length_m);
        EXPECT_NEAR(glm::length(curve[i].normal), 1.0F, 1e-5F);
    }
}

}  // namespace
}  // namespace obscura::stimuli
