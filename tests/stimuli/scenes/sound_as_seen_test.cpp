// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/scenes/builtin_scene.h"
#include "tests/stimuli/scenes/seen_soundness.h"
#include "tests/support/test_scenes.h"

namespace obscura::stimuli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Sky above the horizon, which the scene's ground reaches.
bool upwards(const renderer::Camera&, const glm::vec3& way) { return way.y > -0.02F; }

renderer::Scene block_on_floor() {
    renderer::Scene scene = tests::empty_scene();
    scene.cameras = {tests::forward_camera()};
    tests::add_quad(scene, {-100.0F, -1.0F, 20.0F}, {200.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -100.0F});
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 0.5F, -4.0F});
    return scene;
}

TEST(SoundAsSeen, ABlockOnAFloorIs) {
    EXPECT_THAT(faults_as_seen(block_on_floor(), upwards), IsEmpty());
}

TEST(SoundAsSeen, AHoleIsFoundByWhatIsSeenThroughIt) {
    renderer::Scene scene = block_on_floor();
    scene.meshes.erase(scene.meshes.begin() + 1);  // the block's front
    EXPECT_THAT(faults_as_seen(scene, upwards), ElementsAre(HasSubstr("sees the back of quad")));
    scene.meshes.erase(scene.meshes.begin());  // the floor
    EXPECT_THAT(faults_as_seen(scene, upwards),
                ElementsAre(HasSubstr("sees out of the scene"), HasSubstr("sees the back")));
}

TEST(SoundAsSeen, FacesInOnePlaceAreFoundAndThoseBackToBackAreNot) {
    renderer::Scene scene = block_on_floor();
    tests::add_quad(scene, {-0.5F, -0.5F, -3.99995F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F});
    EXPECT_THAT(faults_as_seen(scene, upwards), ElementsAre(HasSubstr("in one place")));
    scene = block_on_floor();
    tests::add_box(scene, {-1.0F, 0.5F, -6.0F}, {1.0F, 0.8F, -4.0F});  // stands on the block
    EXPECT_THAT(faults_as_seen(scene, upwards), IsEmpty());
}

TEST(FloatingPieces, AreThoseThatTouchNothing) {
    renderer::Scene scene = tests::empty_scene();
    const auto box = [&](const glm::vec3& low, const char* name) {
        const std::size_t first = scene.meshes.size();
        tests::add_box(scene, low, low + 1.0F);
        for (std::size_t i = first + 1; i < scene.meshes.size(); ++i) {
            renderer::Mesh& whole = scene.meshes[first];
            const auto offset = static_cast<std::uint32_t>(whole.vertices.size());
            const renderer::Mesh& part = scene.meshes[i];
            whole.vertices.insert(whole.vertices.end(), part.vertices.begin(), part.vertices.end());
            for (const std::uint32_t index : part.indices) whole.indices.push_back(offset + index);
        }
        scene.meshes.resize(first + 1);
        scene.meshes[first].name = name;
    };
    box(glm::vec3(0.0F), "low");
    box({0.2F, 1.001F, 0.2F}, "on it");
    EXPECT_THAT(floating_pieces(scene), IsEmpty());
    box({0.0F, 2.2F, 0.0F}, "above");
    EXPECT_THAT(floating_pieces(scene), ElementsAre(HasSubstr("above floats: 1 times")));
}

TEST(FloatingPieces, AreNotThoseThatMeetAnotherEdgeToEdgeInOnePlane) {
    renderer::Scene scene = tests::empty_scene();
    const glm::vec3 back(0.0F, 0.0F, -1.0F);
    const auto slab = [&](const glm::vec3& corner, float size, const char* name) {
        tests::add_quad(scene, corner, {size, 0.0F, 0.0F}, size * back);
        scene.meshes.back().name = name;
    };
    slab(glm::vec3(0.0F), 4.0F, "large");
    slab({4.0005F, 0.0F, -1.5F}, 1.0F, "beside the middle of its edge");
    EXPECT_THAT(floating_pieces(scene), IsEmpty());
    slab({5.0105F, 0.0F, -1.5F}, 1.0F, "a centimetre off");
    EXPECT_THAT(floating_pieces(scene), ElementsAre(HasSubstr("a centimetre off floats: 1")));
}

}  // namespace
}  // namespace obscura::stimuli
