// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::figures {
namespace {

constexpr std::array kSides{-1.0F, 1.0F};
constexpr glm::vec3 kShirtColour{0.58F, 0.55F, 0.49F};
constexpr glm::vec3 kVestColour{0.16F, 0.075F, 0.045F};
constexpr glm::vec3 kTrouserColour{0.075F, 0.085F, 0.115F};
constexpr glm::vec3 kLeatherColour{0.11F, 0.062F, 0.035F};
constexpr glm::vec3 kSkinColour{0.60F, 0.40F, 0.31F};

/// Joints of the pose: weight on the left leg, the left hand on the hip.
const glm::vec3 kHipRight{-0.090F, 0.868F, 0.000F}, kKneeRight{-0.125F, 0.472F, 0.060F},
    kAnkleRight{-0.160F, 0.080F, 0.020F};
const glm::vec3 kHipLeft{0.092F, 0.876F, 0.000F}, kKneeLeft{0.085F, 0.475F, 0.012F},
    kAnkleLeft{0.070F, 0.080F, -0.025F};
const glm::vec3 kShoulderRight{-0.155F, 1.368F, -0.012F}, kElbowRight{-0.220F, 1.105F, -0.040F},
    kWristRight{-0.222F, 0.882F, 0.045F};
const glm::vec3 kShoulderLeft{0.155F, 1.372F, -0.012F}, kElbowLeft{0.335F, 1.165F, -0.075F},
    kWristLeft{0.207F, 1.002F, 0.030F};

glm::vec3 along(const glm::vec3& a, const glm::vec3& b, float t) { return a + (b - a) * t; }

Sculpture torso(const Placed& at) {
    Sculpture s;
    const auto blob = [&](float x, float y, float z, const glm::vec3& radii, float blend) {
        s.add(ellipsoid(at(x, y, z), radii, at.axes), {blend, kShirtColour, true});
    };
    blob(0.0F, 1.255F, -0.006F, {0.146F, 0.165F, 0.100F}, 0.0F);
    blob(0.0F, 1.085F, 0.000F, {0.122F, 0.130F, 0.092F}, 0.06F);
    blob(0.0F, 0.955F, -0.006F, {0.158F, 0.100F, 0.112F}, 0.06F);
    for (const float x : kSides) {
        blob(x * 0.070F, 1.250F, 0.074F, {0.064F, 0.062F, 0.056F}, 0.035F);
        blob(x * 0.075F, 1.270F, -0.062F, {0.070F, 0.100F, 0.045F}, 0.04F);
        s.add(round_cone(at(x * 0.065F, 1.388F, -0.024F), 0.050F, at(x * 0.152F, 1.368F, -0.012F),
                         0.053F),
              {0.035F, kShirtColour, true});
        s.add(round_cone(at(x * 0.032F, 1.435F, -0.034F), 0.034F, at(x * 0.115F, 1.395F, -0.024F),
                         0.036F),
              {0.03F, kShirtColour, true});
    }
    return s;
}

void add_sleeve(Sculpture& shirt, Sculpture& cuffs, const Placed& at, const glm::vec3& shoulder,
                const glm::vec3& elbow, const glm::vec3& wrist, float inner_rad,
                std::uint32_t seed) {
    const auto p = [&](const glm::vec3& q) { return at(q.x, q.y, q.z); };
    const float upper = glm::length(elbow - shoulder);
    const Curve arm = make_curve({{p(along(shoulder, elbow, -0.10F)), 0.042F, 0.0F},
                                  {p(along(shoulder, elbow, 0.25F)), 0.0515F, 0.0F},
                                  {p(along(shoulder, elbow, 0.70F)), 0.050F, 0.0F},
                                  {p(elbow), 0.048F, 0.0F},
                                  {p(along(elbow, wrist, 0.30F)), 0.046F, 0.0F}},
                                 7, at.axes[2]);
    shirt.add(tube(arm, folded({{1.08F * upper, 0.10F, inner_rad, 0.0056F, 0.056F, 0.35F},
                                {0.12F * upper, 0.10F, 2.6F, 0.0042F, 0.066F, 0.25F},
                                {0.60F * upper, 0.12F, inner_rad + 1.5F, 0.0036F, 0.084F, 0.40F}},
                               seed)),
              {0.018F, kShirtColour, true});
    // The sleeve is rolled up, two turns of cloth above the bare forearm: finer than the shirt's
    // cells, a mesh of its own.
    Sculpture turns;
    for (int i = 0; i < 2; ++i) {
        const float t = 0.24F + 0.13F * static_cast<float>(i);
        const Curve roll = make_curve(
            {{p(along(elbow, wrist, t)), 0.0500F - 0.002F * static_cast<float>(i), 0.0F},
             {p(along(elbow, wrist, t + 0.05F)), 0.0520F - 0.002F * static_cast<float>(i), 0.0F},
             {p(along(elbow, wrist, t + 0.10F)), 0.0490F - 0.002F * static_cast<float>(i), 0.0F}},
            4, at.axes[2]);
        turns.add(tube(roll, folded({{0.02F, 0.06F, 1.0F, 0.0022F, 0.050F, 0.7F}}, seed + 7)),
                  {0.005F, kShirtColour, true});
    }
    const glm::vec3 way = glm::normalize(p(wrist) - p(elbow));
    turns.keep(half_space(p(along(elbow, wrist, 0.505F)), way), {0.006F, kShirtColour, false});
    turns.carve(
        round_cone(p(along(elbow, wrist, 0.44F)), 0.0375F, p(along(elbow, wrist, 0.80F)), 0.040F),
        {0.005F, kShirtColour * 0.6F, true});
    cuffs.add(as_shape(std::move(turns)), {0.0F, kShirtColour, true});
}

Sculpture add_shirt(Figure& woman, const Placed& at, const Sculpture& core) {
    Sculpture shirt = core;
    shirt.keep(half_space(at(0.0F, 0.925F, 0.0F), glm::vec3(0.0F, -1.0F, 0.0F)),
               {0.004F, kShirtColour, false});
    Sculpture cuffs;
    add_sleeve(shirt, cuffs, at, kShoulderRight, kElbowRight, kWristRight, 0.4F, 505);
    add_sleeve(shirt, cuffs, at, kShoulderLeft, kElbowLeft, kWristLeft, 0.6F, 606);
    // Open neck with a turned-down collar.
    shirt.carve(round_cone(at(0.0F, 1.420F, 0.000F), 0.052F, at(0.0F, 1.500F, 0.020F), 0.062F),
                {0.005F, kShirtColour, false});
    shirt.carve(ellipsoid(at(0.0F, 1.360F, 0.105F), {0.024F, 0.068F, 0.050F}, at.axes),
                {0.006F, kShirtColour, false});
    shirt.displace(
        {[at](const glm::vec3& world) {
             const glm::vec3 p = (world - at.origin_m) * at.axes;
             const float waist = std::exp(-std::pow((p.y - 1.00F) / 0.075F, 2.0F));
             const float warp = gradient_noise(p * 6.0F, 61);
             const float rolls = std::sin((p.y + 0.30F * std::abs(p.x)) * 150.0F + 4.0F * warp);
             const float drape =
                 gradient_noise(glm::vec3(p.x * 18.0F - p.y * 6.0F, p.y * 4.0F, p.z * 18.0F), 63);
             const float body = std::clamp((0.165F - std::abs(p.x)) / 0.04F, 0.0F, 1.0F) *
                                std::clamp((1.28F - p.y) / 0.05F, 0.0F, 1.0F);
             return body * (0.0040F * waist * rolls * (0.5F + std::abs(warp)) + 0.0032F * drape);
         },
         0.008F});
    woman.part("cuffs", Cloth::kShirt, 0.0044F, 0.08F).solid = std::move(cuffs);
    woman.part("shirt", Cloth::kShirt, 0.0068F, 0.08F).solid = shirt;
    // Button band.
    const glm::vec3 back = at.axes * glm::vec3(0.0F, 0.0F, -1.0F);
    woman.overlaid.push_back(
        {"button band", Cloth::kShirt, 0.08F,
         overlay(shirt, {.columns = 6, .rows = 50, .thick_m = 0.0026F, .colour = kShirtColour},
                 along_path({at(0.004F, 1.318F, 0.20F), at(0.004F, 1.15F, 0.20F),
                             at(0.003F, 0.930F, 0.20F)},
                            back, 0.030F))});
    return shirt;
}

Sculpture add_vest(Figure& woman, const Placed& at, const Sculpture& core) {
    Sculpture vest;
    Sculpture body;
    body.add(grown(as_shape(core), 0.0150F), {0.0F, kVestColour, true});
    body.keep(half_space(at(0.0F, 1.015F, 0.0F), glm::vec3(0.0F, -1.0F, 0.0F)),
              {0.004F, {}, false});
    // Armholes, neck and the open front, which widens downwards.
    for (const float x : kSides) {
        body.carve(ellipsoid(at(x * 0.192F, 1.342F, -0.010F), {0.072F, 0.112F, 0.100F}, at.axes),
                   {0.010F, kVestColour, false});
    }
    body.carve(round_cone(at(0.0F, 1.400F, 0.02F), 0.072F, at(0.0F, 1.52F, 0.02F), 0.080F),
               {0.007F, kVestColour, false});
    body.carve(tube(make_curve({{at(0.0F, 1.42F, 0.10F), 0.052F, 0.08F},
                                {at(0.0F, 1.30F, 0.12F), 0.044F, 0.08F},
                                {at(0.0F, 1.15F, 0.12F), 0.038F, 0.08F},
                                {at(0.0F, 0.98F, 0.12F), 0.062F, 0.08F}},
                               6, at.axes[0])),
               {0.007F, kVestColour, false});
    vest.add(as_shape(body), {0.0F, kVestColour, true});
    woman.part("vest", Cloth::kLeather, 0.0058F, 0.12F).solid = vest;
    // Seams, pocket welts and a border along the front's edges.
    const glm::vec3 back = at.axes * glm::vec3(0.0F, 0.0F, -1.0F);
    const auto put = [&](const char* name, const OverlayStyle& style,
                         const std::vector<glm::vec3>& path, float wide) {
        woman.overlaid.push_back(
            {name, Cloth::kLeather, 0.12F, overlay(vest, style, along_path(path, back, wide))});
    };
    for (const float x : kSides) {
        put("seam", {.columns = 4, .rows = 36, .thick_m = 0.0018F, .colour = kVestColour * 0.85F},
            {at(x * 0.092F, 1.370F, 0.20F), at(x * 0.098F, 1.25F, 0.22F),
             at(x * 0.094F, 1.12F, 0.20F), at(x * 0.104F, 1.024F, 0.20F)},
            0.009F);
        put("welt", {.columns = 4, .rows = 12, .thick_m = 0.0042F, .colour = kVestColour * 0.85F},
            {at(x * 0.056F, 1.098F, 0.20F), at(x * 0.122F, 1.106F, 0.20F)}, 0.020F);
    }
    return vest;
}

void add_leg(Sculpture& s, const Placed& at, const glm::vec3& hip, const glm::vec3& knee,
             const glm::vec3& ankle, std::uint32_t seed) {
    const auto p = [&](const glm::vec3& q) { return at(q.x, q.y, q.z); };
    const float upper = glm::length(knee - hip);
    const glm::vec3 calf(0.0F, 0.0F, -0.014F);
    const Curve leg = make_curve({{p(along(hip, knee, -0.06F)), 0.092F, 0.0F},
                                  {p(along(hip, knee, 0.15F)), 0.092F, 0.0F},
                                  {p(along(hip, knee, 0.55F)), 0.076F, 0.0F},
                                  {p(knee), 0.058F, 0.0F},
                                  {p(along(knee, ankle, 0.28F) + calf), 0.057F, 0.0F},
                                  {p(along(knee, ankle, 0.52F) + calf), 0.050F, 0.0F}},
                                 7, at.axes[2]);
    s.add(tube(leg, folded({{0.05F, 0.075F, 0.0F, 0.0036F, 0.052F, 0.30F},
                            {1.02F * upper, 0.075F, 3.1F, 0.0045F, 0.042F, 0.30F},
                            {0.86F * upper, 0.06F, 0.2F, 0.0022F, 0.040F, 0.25F},
                            {0.50F * upper, 0.12F, 1.8F, 0.0022F, 0.080F, 0.40F}},
                           seed)),
          {0.02F, kTrouserColour, true});
}

Sculpture add_trousers(Figure& woman, const Placed& at) {
    Sculpture& s = woman.part("trousers", Cloth::kTrousers, 0.0078F, 0.06F).solid;
    s.add(ellipsoid(at(0.0F, 0.915F, -0.006F), {0.166F, 0.098F, 0.117F}, at.axes),
          {0.0F, kTrouserColour, true});
    s.keep(half_space(at(0.0F, 0.965F, 0.0F), glm::vec3(0.0F, 1.0F, 0.0F)),
           {0.006F, kTrouserColour, false});
    for (const float x : kSides) {
        s.add(ellipsoid(at(x * 0.076F, 0.868F, -0.052F), {0.088F, 0.090F, 0.082F}, at.axes),
              {0.04F, kTrouserColour, true});
    }
    add_leg(s, at, kHipRight, kKneeRight, kAnkleRight, 707);
    add_leg(s, at, kHipLeft, kKneeLeft, kAnkleLeft, 808);
    for (const float x : kSides) {
        s.carve(tube(make_curve({{at(x * 0.120F, 0.945F, 0.085F), 0.003F, 0.0F},
                                 {at(x * 0.150F, 0.905F, 0.060F), 0.003F, 0.0F},
                                 {at(x * 0.166F, 0.895F, 0.020F), 0.003F, 0.0F}},
                                5, at.axes[2])),
                {0.005F, kTrouserColour, false});
    }
    s.displace({[at](const glm::vec3& world) {
                    const glm::vec3 p = (world - at.origin_m) * at.axes;
                    const float seat = std::exp(-std::pow((p.y - 0.815F) / 0.050F, 2.0F));
                    const float rays =
                        std::sin(26.0F * std::atan2(p.y - 0.785F, std::abs(p.x) + 0.05F) +
                                 2.0F * gradient_noise(p * 9.0F, 71));
                    return 0.0020F * seat * rays;
                },
                0.005F});
    return s;
}

void add_belt(Figure& woman, const Placed& at, const Sculpture& clothes) {
    Sculpture& s = woman.part("belt", Cloth::kLeather, 0.0058F, 0.12F).solid;
    woman.overlaid.push_back(
        {"belt", Cloth::kLeather, 0.12F,
         overlay(clothes,
                 {.columns = 4,
                  .rows = 64,
                  .thick_m = 0.0050F,
                  .colour = kLeatherColour,
                  .stiff = 3,
                  .ring = true,
                  .sunk_m = 0.010F},
                 around_body(at, {0.0F, 0.950F, -0.006F}, {0.186F, 0.170F}, 0.038F, 0.0F))});
    woman.overlaid.push_back(
        {"hip belt", Cloth::kLeather, 0.12F,
         overlay(clothes,
                 {.columns = 4,
                  .rows = 64,
                  .thick_m = 0.0050F,
                  .colour = kLeatherColour * 0.7F,
                  .stiff = 4,
                  .ring = true,
                  .sunk_m = 0.010F},
                 around_body(at, {0.0F, 0.905F, -0.006F}, {0.192F, 0.175F}, 0.030F, -0.022F))});
    const glm::vec3 steel(0.46F, 0.45F, 0.43F);
    Sculpture buckle;
    buckle.add(rounded_box(at(0.0F, 0.950F, 0.124F), {0.025F, 0.022F, 0.007F}, 0.004F, at.axes));
    buckle.carve(rounded_box(at(0.0F, 0.950F, 0.124F), {0.016F, 0.013F, 0.02F}, 0.003F, at.axes));
    s.add(as_shape(buckle), {0.0F, steel, true});
    s.add(round_cone(at(-0.014F, 0.950F, 0.128F), 0.003F, at(0.022F, 0.950F, 0.128F), 0.0026F),
          {0.0F, steel, true});
    // A bag on the right hip, hanging from the second belt.
    const glm::mat3 axes =
        at.axes * axes_from(glm::normalize(glm::vec3(-0.95F, 0.0F, 0.30F)), {0.0F, 1.0F, 0.0F});
    s.add(rounded_box(at(-0.196F, 0.850F, 0.036F), {0.056F, 0.060F, 0.026F}, 0.016F, axes),
          {0.001F, kLeatherColour * 1.2F, true});
    s.add(rounded_box(at(-0.199F, 0.884F, 0.037F), {0.059F, 0.030F, 0.028F}, 0.012F, axes),
          {0.001F, kLeatherColour, true});
    s.add(ball(at(-0.228F, 0.858F, 0.046F), 0.006F), {0.001F, steel, true});
}

void add_arms(Figure& woman, const Placed& at, const glm::vec3& colour) {
    Sculpture& skin = woman.part("arms", Cloth::kSkin, 0.0026F, 0.06F).solid;
    const auto p = [&](const glm::vec3& q) { return at(q.x, q.y, q.z); };
    const auto forearm = [&](const glm::vec3& elbow, const glm::vec3& wrist) {
        const auto bone = [&](float from, float thick, float to, float thin) {
            skin.add(
                round_cone(p(along(elbow, wrist, from)), thick, p(along(elbow, wrist, to)), thin),
                {0.020F, colour, true});
        };
        bone(0.42F, 0.0340F, 0.60F, 0.0322F);
        bone(0.60F, 0.0315F, 1.00F, 0.0218F);
    };
    forearm(kElbowRight, kWristRight);
    const glm::vec3 down = at.axes * glm::normalize(glm::vec3(0.02F, -1.0F, 0.20F));
    add_hand(skin, {p(kWristRight), axes_from(down, at.axes * glm::vec3(-1.0F, 0.0F, 0.25F))},
             0.90F, 1.0F, {{0.20F, 0.34F, 0.22F}, 0.09F, 0.30F}, colour);
    forearm(kElbowLeft, kWristLeft);
    const glm::vec3 rest = at.axes * glm::normalize(glm::vec3(-0.50F, -0.42F, 0.72F));
    add_hand(skin, {p(kWristLeft), axes_from(rest, at.axes * glm::vec3(0.80F, 0.25F, 0.55F))},
             0.90F, -1.0F, {{0.20F, 0.42F, 0.25F}, 0.11F, -0.15F}, colour);
}

}  // namespace

Figure make_woman(const Placed& at) {
    Figure woman;
    woman.name = "woman";
    const Sculpture core = torso(at);
    Sculpture clothes;
    clothes.add(as_shape(add_shirt(woman, at, core)));
    Sculpture above = clothes;
    above.add(as_shape(add_vest(woman, at, core)));
    add_collar(woman, at, above,
               {.neck_m = {0.0F, 1.462F, -0.010F},
                .radius_m = 0.056F,
                .open_rad = 0.50F,
                .drop_m = 0.060F,
                .wide_m = 0.030F,
                .point_m = 0.062F},
               Cloth::kShirt, 0.08F, kShirtColour);
    clothes.add(as_shape(add_trousers(woman, at)));
    add_belt(woman, at, clothes);
    constexpr Shaft kShaft{0.33F, 0.0607F};
    Sculpture boots;
    add_boot(woman, boots, at, kAnkleRight, kKneeRight, {-0.42F, 1.0F}, 0.92F, kShaft,
             kLeatherColour);
    add_boot(woman, boots, at, kAnkleLeft, kKneeLeft, {0.25F, 1.0F}, 0.92F, kShaft, kLeatherColour);
    FigurePart& worn = woman.part("boots", Cloth::kLeather, 0.0061F, 0.12F);
    worn.solid = std::move(boots);
    worn.painted_shade = 0.4F;
    add_arms(woman, at, kSkinColour);
    const glm::vec3 gaze = at.axes * glm::normalize(glm::vec3(-0.16F, 0.0F, 1.0F));
    const Placed head{at(0.0F, 1.578F, 0.026F),
                      axes_from(gaze, at.axes * glm::vec3(-0.05F, 1.0F, 0.0F))};
    FaceTraits traits;
    traits.skin = kSkinColour;
    traits.lip = {0.47F, 0.20F, 0.175F};
    traits.brow = -0.2F;
    traits.jaw = 0.90F;
    traits.hollow = 0.0F;
    traits.lips = 1.04F;
    traits.nose = 0.80F;
    traits.nose_length = 0.92F;
    traits.cheeks = 1.0F;
    traits.nose_width = 0.80F;
    traits.age = 0.15F;
    traits.slant = 2.2F;
    traits.brow_weight = 0.72F;
    traits.neck = 0.84F;
    traits.throat = 0.0F;
    traits.eyelids = 1.18F;
    traits.brows = {0.11F, 0.062F, 0.035F};
    traits.iris = {0.10F, 0.16F, 0.12F};
    traits.hair = {0.15F, 0.075F, 0.038F};
    traits.hairline = long_hairline;
    add_head(woman, head, 0.945F, traits);
    add_ponytail(woman, head, 0.945F, traits.hair);
    return woman;
}

}  // namespace obscura::stimuli::figures
