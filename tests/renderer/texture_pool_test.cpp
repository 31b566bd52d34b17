// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/texture_pool.h"

#include <gtest/gtest.h>

#include "renderer/gl/context.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {
namespace {

PlannedTarget target_of(const char* format, int width) {
    PlannedTarget target;
    target.name = format;
    target.format = format;
    target.width = width;
    target.height = 8;
    return target;
}

TEST(TexturePool, GivesWhatCameBackToWhoAsksForTheSameAndFreesTheRest) {
    const HeadlessContext context;
    TexturePool pool;
    std::shared_ptr<gl::Texture> first = pool.take(target_of("r32f", 16));
    const std::shared_ptr<gl::Texture> meanwhile = pool.take(target_of("r32f", 16));
    EXPECT_NE(first->name(), meanwhile->name());
    const GLuint name = first->name();
    first.reset();
    EXPECT_NE(pool.take(target_of("r32f", 17))->name(), name);
    EXPECT_NE(pool.take(target_of("r16f", 16))->name(), name);
    EXPECT_EQ(pool.take(target_of("r32f", 16))->name(), name);
    EXPECT_TRUE(glIsTexture(name));
    pool.free_unused();
    EXPECT_FALSE(glIsTexture(name));
}

TEST(TexturePool, MayGoBeforeItsTextures) {
    const HeadlessContext context;
    std::shared_ptr<gl::Texture> texture;
    {
        TexturePool pool;
        texture = pool.take(target_of("r8", 16));
    }
    const GLuint name = texture->name();
    EXPECT_TRUE(glIsTexture(name));
    texture.reset();
    EXPECT_FALSE(glIsTexture(name));
}

TEST(TexturePool, WhatFramesLeaveInTexturesIsSeenInNoOtherImage) {
    const HeadlessContext context;
    Scene scene = tests::empty_scene();
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 1.0F, -4.0F});
    const GpuScene gpu(scene);
    Renderer used;
    const auto image = [&](Renderer& renderer, const std::string& technique) {
        return renderer
            .render({gpu, {}, tests::forward_camera()}, tests::choice_of(technique), 61, 43)
            .read_display();
    };
    const GpuScene wall(tests::facing_wall(2.0F));
    for (const Technique& technique : techniques()) {
        if (technique.ray_traced) continue;
        // The textures that come next are full of a surface everywhere.
        (void)used.render({wall, {}, tests::forward_camera()}, tests::choice_of(technique.name), 61,
                          43);
        Renderer fresh;
        EXPECT_EQ(image(used, technique.name), image(fresh, technique.name)) << technique.name;
    }
}

}  // namespace
}  // namespace obscura::renderer
