// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "renderer/base/random.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

/// Small triangles all around the origin, from 1 to 20 m away, those that follow each other near
/// each other.
Mesh crowd(std::uint64_t seed, std::size_t triangles) {
    base::Random random(seed);
    const auto number = [&](double size) {
        return static_cast<float>(random.uniform(-size, size));
    };
    Mesh mesh;
    glm::vec3 middle(0.0F);
    for (std::size_t i = 0; i < triangles; ++i) {
        if (i % kClusterTriangles == 0) {
            const glm::vec3 towards(number(1.0), number(1.0), number(1.0));
            middle = static_cast<float>(random.uniform(1.0, 20.0)) * glm::normalize(towards);
        }
        for (int corner = 0; corner < 3; ++corner) {
            Vertex vertex;
            vertex.position_m = middle + glm::vec3(number(0.8), number(0.8), number(0.8));
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back(vertex);
        }
    }
    return mesh;
}

Camera camera_of(std::uint64_t seed) {
    base::Random random(seed);
    const auto number = [&] { return static_cast<float>(random.uniform(-1.0, 1.0)); };
    Camera camera;
    camera.position_m = {number(), number(), number()};
    camera.target_m = camera.position_m + glm::vec3(number(), number(), number());
    camera.vertical_fov_rad = 0.9F + 0.5F * number();
    camera.far_m = 15.0F;
    camera.lens_shift = {number(), number()};
    return camera;
}

/// Whether all of the cluster's vertices lie beyond one side of the image, as the vertex shader
/// computes it.
bool beyond_a_side(const Mesh& mesh, const Cluster& cluster, const CameraMatrices& camera) {
    std::array<bool, 6> beyond;
    beyond.fill(true);
    for (std::size_t i = 0; i < cluster.index_count; ++i) {
        const Vertex& vertex = mesh.vertices[mesh.indices[cluster.first_index + i]];
        const glm::vec3 view =
            glm::mat3(camera.view_from_world) * (vertex.position_m - camera.eye_m);
        const glm::vec4 clip = camera.clip_from_view * glm::vec4(view, 1.0F);
        for (int axis = 0; axis < 3; ++axis) {
            const auto side = static_cast<std::size_t>(2 * axis);
            beyond[side] = beyond[side] && clip[axis] < -clip.w;
            beyond[side + 1] = beyond[side + 1] && clip[axis] > clip.w;
        }
    }
    return std::find(beyond.begin(), beyond.end(), true) != beyond.end();
}

TEST(Clusters, HoldEveryTriangleOnceInItsOrder) {
    const Mesh mesh = crowd(1, 3 * kClusterTriangles + 7);
    std::size_t next = 0;
    for (const Cluster& cluster : clusters_of(mesh)) {
        EXPECT_EQ(cluster.first_index, next);
        next += cluster.index_count;
    }
    EXPECT_EQ(next, mesh.indices.size());
    EXPECT_TRUE(clusters_of(Mesh{}).empty());
}

TEST(Clusters, ThatAreLeftOutAreOutOfView) {
    const Mesh mesh = crowd(2, 100 * kClusterTriangles);
    const std::vector<Cluster> clusters = clusters_of(mesh);
    int left_out = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const CameraMatrices camera = matrices_of(camera_of(seed), 160, 90);
        const Frustum view(camera);
        for (const Cluster& cluster : clusters) {
            if (view.may_show(cluster)) continue;
            ++left_out;
            ASSERT_TRUE(beyond_a_side(mesh, cluster, camera)) << seed;
        }
    }
    EXPECT_GT(left_out, 1000);
}

TEST(Clusters, WithoutFiniteCoordinatesAreAlwaysDrawn) {
    Mesh mesh = crowd(3, 5);
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        mesh.vertices[4].position_m.y = bad;
        const Cluster cluster = clusters_of(mesh).front();
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            EXPECT_TRUE(Frustum(matrices_of(camera_of(seed), 160, 90)).may_show(cluster));
        }
    }
}

TEST(Clusters, LeaveTheImageAsItIsToTheByte) {
    const HeadlessContext context;
    Renderer renderer;
    Scene scene = tests::empty_scene();
    scene.materials.resize(1);
    scene.materials[0].double_sided = true;
    scene.meshes = {crowd(4, 40 * kClusterTriangles)};
    // The same triangles in turn from everywhere: no cluster is out of view.
    Scene mixed = scene;
    Mesh& all = mixed.meshes[0];
    all.indices.clear();
    for (std::size_t first = 0; first < kClusterTriangles; ++first) {
        for (std::size_t i = first; i < 40 * kClusterTriangles; i += kClusterTriangles) {
            for (std::size_t corner = 0; corner < 3; ++corner) {
                all.indices.push_back(scene.meshes[0].indices[3 * i + corner]);
            }
        }
    }
    const GpuScene some(scene);
    const GpuScene whole(mixed);
    const Lighting lighting;
    std::size_t left_out = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        const Camera camera = camera_of(seed);
        const Frustum view(matrices_of(camera, 96, 64));
        for (const Cluster& cluster : some.draws().front().clusters) {
            left_out += view.may_show(cluster) ? 0 : 1;
        }
        const auto bytes = [&](const GpuScene& of) {
            return renderer.render({of, lighting, camera}, tests::choice_of("blizzard"), 96, 64)
                .read_bytes(Target::kDepth);
        };
        ASSERT_TRUE(bytes(some) == bytes(whole)) << seed;
    }
    EXPECT_GT(left_out, 100U);
}

}  // namespace
}  // namespace obscura::renderer
