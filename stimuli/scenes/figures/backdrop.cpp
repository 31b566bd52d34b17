// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/noise.h"
#include "stimuli/scenes/support/parts.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli::figures {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

constexpr float kFace_m = -5.2F;  ///< z of the house's front
constexpr float kHigh_m = 5.2F;

/// Lime plaster with stains below ledges and patches of repair. Covers 4 m.
Texel plaster(vec2 uv) {
    const float broad = shared_noise(uv);
    const float medium = shared_noise(uv * 5.0F + 0.3F);
    const float fine = shared_noise(uv * 31.0F);
    const float run = glm::smoothstep(0.15F, 0.55F, shared_noise(uv * vec2(7.0F, 1.0F) + 0.6F));
    const float patch_edge = glm::smoothstep(0.30F, 0.32F, shared_noise(uv * 2.0F + 0.8F));
    Texel texel;
    texel.albedo =
        glm::mix(colour<0xb8a482>(), colour<0xcfc0a0>(), glm::clamp(0.5F + broad, 0.0F, 1.0F));
    texel.albedo *= (1.0F + 0.08F * medium + 0.10F * fine) * (1.0F - 0.22F * run);
    texel.albedo = glm::mix(texel.albedo, colour<0xb9ae98>(), 0.6F * patch_edge);
    texel.height_m = 0.002F * medium + 0.0008F * fine + 0.001F * patch_edge;
    return texel;
}

/// Painted boards, the grain along v. Covers 1 m.
Texel timber(vec2 uv) {
    const float grain = fbm(uv * vec2(50.0F, 3.0F), 82, 3, {50, 3});
    const float worn =
        glm::smoothstep(0.1F, 0.5F, shared_noise(uv * vec2(3.0F, 1.0F)) + 0.3F * grain);
    Texel texel;
    texel.albedo =
        glm::mix(colour<0x4d6460>(), colour<0x8d8672>(), 0.7F * worn) * (1.0F + 0.12F * grain);
    texel.height_m = 0.0006F * grain - 0.0004F * worn;
    return texel;
}

/// One mesh a material of the front.
class Front {
  public:
    explicit Front(renderer::Scene& scene) : scene_(scene) {
        plaster_.material = add_material(
            scene, {.name = "plaster", .specular_intensity = 0.02F, .specular_power = 8.0F},
            {"plaster", 1024, 1024, vec2(4.0F), plaster});
        timber_.material = add_material(
            scene, {.name = "timber", .specular_intensity = 0.05F, .specular_power = 14.0F},
            {"timber", 384, 384, vec2(1.0F), timber});
        glass_.material = static_cast<std::uint32_t>(scene.materials.size());
        scene.materials.push_back({.name = "pane",
                                   .albedo = vec3(0.035F, 0.042F, 0.048F),
                                   .specular_intensity = 0.5F,
                                   .specular_power = 120.0F});
        stone_.material = static_cast<std::uint32_t>(Cloth::kBlock);
        plaster_.name = "house plaster";
        timber_.name = "house timber";
        glass_.name = "house panes";
        stone_.name = "house stone";
    }

    void plaster_part(const Mesh& part) { append(plaster_, part, {.uv_scale = vec2(0.25F)}); }
    void timber_box(const vec3& size, const vec3& at, float shade = 1.0F) {
        append(timber_, bevelled_box(size, 0.006F),
               {.transform = moved(at), .uv_offset = {at.x * 1.7F, at.y}, .tint = vec3(shade)});
    }
    void stone_box(const vec3& size, const vec3& at) {
        const auto seed =
            static_cast<std::uint32_t>(std::lround(100.0F * (at.x + 3.0F * at.y + 50.0F)));
        append(stone_, bevelled_box(size, 0.016F),
               {.transform = moved(at),
                .uv_scale = vec2(1.0F / 1.6F),
                .uv_offset = {0.37F * at.x, 0.21F * at.y},
                .tint = shade_of(seed, 0.25F)});
    }
    void pane(const vec3& size, const vec3& at) {
        append(glass_, bevelled_box(size, 0.0F), {.transform = moved(at)});
    }
    void timber_part(const Mesh& part, float shade) {
        append(timber_, part, {.tint = vec3(shade)});
    }

    void finish() {
        for (Mesh* mesh : {&plaster_, &timber_, &glass_, &stone_}) {
            scene_.meshes.push_back(std::move(*mesh));
        }
    }

  private:
    renderer::Scene& scene_;
    Mesh plaster_;
    Mesh timber_;
    Mesh glass_;
    Mesh stone_;
};

/// A casement with stone jambs, a sill, and shutters folded back against the wall.
void add_window(Front& front, float x) {
    const float z = kFace_m;
    constexpr float kLow = 1.05F;
    constexpr float kTop = 2.55F;
    const float middle = 0.5F * (kLow + kTop);
    front.pane({1.0F, kTop - kLow, 0.02F}, {x, middle, z - 0.12F});
    for (const float side : {-1.0F, 1.0F}) {
        for (int i = 0; i < 5; ++i) {
            const float wide = i % 2 == 0 ? 0.22F : 0.15F;
            front.stone_box({wide, 0.296F, 0.30F},
                            {x + side * (0.5F + 0.5F * wide),
                             kLow + 0.15F + 0.3F * static_cast<float>(i), z - 0.105F});
        }
        // Behind the stones, so that no plaster shows where their corners are cut.
        front.stone_box({0.144F, kTop - kLow - 0.06F, 0.28F},
                        {x + side * 0.575F, middle, z - 0.115F});
        front.timber_box({0.06F, kTop - kLow, 0.07F}, {x + side * 0.47F, middle, z - 0.09F}, 1.0F);
        front.timber_box({0.05F, kTop - kLow, 0.06F}, {x + side * 0.028F, middle, z - 0.085F},
                         1.0F);
        for (const float y : {kLow + 0.04F, middle - 0.22F, middle + 0.25F, kTop - 0.04F}) {
            front.timber_box({0.46F, 0.045F, 0.05F}, {x + side * 0.24F, y, z - 0.085F}, 1.0F);
        }
        // A shutter of slats.
        const float out = x + side * 0.98F;
        for (const float edge : {-0.22F, 0.22F})
            front.timber_box({0.06F, 1.5F, 0.04F}, {out + edge, middle, z + 0.055F}, 0.8F);
        for (const float y : {kLow + 0.04F, middle, kTop - 0.04F})
            front.timber_box({0.40F, 0.08F, 0.054F}, {out, y, z + 0.055F}, 0.8F);
        for (int i = 0; i < 26; ++i) {
            const float y = kLow + 0.11F + 0.052F * static_cast<float>(i);
            if (std::abs(y - middle) < 0.035F) continue;
            Mesh slat;
            // As high as it takes to leave no strip of wall in sight between two of them.
            append(slat, bevelled_box({0.40F, 0.068F, 0.008F}, 0.0F),
                   {.transform = moved(out, y, z + 0.055F) * about_x(0.75F)});
            front.timber_part(slat, 0.72F);
        }
    }
    front.stone_box({1.52F, 0.10F, 0.40F}, {x, kLow - 0.05F, z - 0.06F});
    front.stone_box({1.52F, 0.26F, 0.32F}, {x, kTop + 0.13F, z - 0.10F});
}

void add_door(Front& front, float x) {
    const float z = kFace_m;
    for (int i = 0; i < 6; ++i)
        front.timber_box({0.162F, 2.3F, 0.05F},
                         {x - 0.41F + 0.164F * static_cast<float>(i), 1.20F, z - 0.17F},
                         0.72F + 0.06F * static_cast<float>(i % 3));
    for (const float y : {0.45F, 1.15F, 1.9F})
        front.timber_box({0.96F, 0.12F, 0.03F}, {x, y, z - 0.135F}, 0.65F);
    for (const float side : {-1.0F, 1.0F}) {
        for (int i = 0; i < 6; ++i) {
            const float wide = i % 2 == 0 ? 0.28F : 0.20F;
            front.stone_box({wide, 0.366F, 0.40F},
                            {x + side * (0.5F + 0.5F * wide), 0.30F + 0.37F * static_cast<float>(i),
                             z - 0.14F});
        }
        front.stone_box({0.194F, 2.15F, 0.38F}, {x + side * 0.60F, 1.20F, z - 0.145F});
    }
    front.stone_box({1.5F, 0.32F, 0.42F}, {x, 2.44F, z - 0.14F});
    front.stone_box({1.5F, 0.14F, 0.55F}, {x, 0.06F, z + 0.08F});
}

}  // namespace

void add_backdrop(renderer::Scene& scene) {
    Front front(scene);
    constexpr float kDoor = 2.05F;
    constexpr float kWindow = -1.75F;
    // The wall between the openings.
    const auto wall = [&](float x0, float x1, float y0, float y1) {
        front.plaster_part(
            rectangle({x0, y0, kFace_m}, {x1 - x0, 0.0F, 0.0F}, {0.0F, y1 - y0, 0.0F}, 0.5F));
    };
    wall(-7.5F, kWindow - 0.5F, 0.0F, kHigh_m);
    wall(kWindow + 0.5F, kDoor - 0.5F, 0.0F, kHigh_m);
    wall(kDoor + 0.5F, 7.5F, 0.0F, kHigh_m);
    wall(kWindow - 0.5F, kWindow + 0.5F, 0.0F, 1.02F);
    wall(kWindow - 0.5F, kWindow + 0.5F, 2.55F, kHigh_m);
    add_window(front, kWindow);
    wall(kDoor - 0.5F, kDoor + 0.5F, 2.35F, kHigh_m);  // from behind the lintel
    add_door(front, kDoor);
    // A plinth of stones, a string course and a gutter pipe.
    for (int row = 0; row < 2; ++row) {
        for (int i = 0; i < 22; ++i) {
            const float x = -7.4F + 0.68F * (static_cast<float>(i) + (row == 0 ? 0.0F : 0.5F));
            if (std::abs(x - kDoor) < 1.12F) continue;
            front.stone_box({0.67F, 0.31F, 0.26F},
                            {x, 0.15F + 0.315F * static_cast<float>(row), kFace_m - 0.075F});
        }
    }
    front.stone_box({15.0F, 0.16F, 0.34F}, {0.0F, 3.25F, kFace_m - 0.06F});
    front.stone_box({15.0F, 0.08F, 0.24F}, {0.0F, 3.13F, kFace_m - 0.06F});
    Mesh gutter =
        rod({0.35F, 0.05F, kFace_m + 0.13F}, {0.35F, kHigh_m, kFace_m + 0.13F}, 0.05F, 20);
    for (const float y : {0.9F, 2.3F})
        append(gutter, ring(0.055F, 0.012F, 28), {.transform = moved(0.35F, y, kFace_m + 0.13F)});
    front.timber_part(gutter, 0.55F);
    front.finish();
}

}  // namespace obscura::stimuli::figures
