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
constexpr glm::vec3 kJacketColour{0.115F, 0.125F, 0.085F};
constexpr glm::vec3 kTrouserColour{0.25F, 0.20F, 0.135F};
constexpr glm::vec3 kLeatherColour{0.075F, 0.048F, 0.030F};
constexpr glm::vec3 kSkinColour{0.58F, 0.38F, 0.29F};

/// Joints of the pose: weight on the right leg, the left hand on the strap.
const glm::vec3 kHipRight{-0.092F, 0.930F, 0.000F}, kKneeRight{-0.112F, 0.505F, 0.020F},
    kAnkleRight{-0.118F, 0.085F, -0.020F};
const glm::vec3 kHipLeft{0.092F, 0.925F, 0.000F}, kKneeLeft{0.150F, 0.500F, 0.065F},
    kAnkleLeft{0.185F, 0.085F, 0.035F};
const glm::vec3 kShoulderRight{-0.188F, 1.452F, -0.015F}, kElbowRight{-0.272F, 1.172F, -0.045F},
    kWristRight{-0.275F, 0.930F, 0.050F};
const glm::vec3 kShoulderLeft{0.188F, 1.452F, -0.015F}, kElbowLeft{0.282F, 1.190F, 0.005F},
    kWristLeft{0.202F, 1.268F, 0.172F};

glm::vec3 along(const glm::vec3& a, const glm::vec3& b, float t) { return a + (b - a) * t; }

Sculpture torso(const Placed& at) {
    Sculpture s;
    const auto blob = [&](float x, float y, float z, const glm::vec3& radii, float blend) {
        s.add(ellipsoid(at(x, y, z), radii, at.axes), {blend, kJacketColour, true});
    };
    blob(0.0F, 1.300F, -0.008F, {0.186F, 0.190F, 0.122F}, 0.0F);
    blob(0.0F, 1.100F, 0.004F, {0.166F, 0.150F, 0.120F}, 0.06F);
    for (const float x : kSides) {
        blob(x * 0.082F, 1.350F, 0.066F, {0.088F, 0.070F, 0.050F}, 0.04F);
        blob(x * 0.090F, 1.340F, -0.075F, {0.085F, 0.110F, 0.055F}, 0.04F);
        s.add(round_cone(at(x * 0.080F, 1.478F, -0.030F), 0.062F, at(x * 0.185F, 1.452F, -0.015F),
                         0.066F),
              {0.04F, kJacketColour, true});
        s.add(round_cone(at(x * 0.040F, 1.535F, -0.040F), 0.040F, at(x * 0.140F, 1.485F, -0.030F),
                         0.045F),
              {0.03F, kJacketColour, true});
    }
    // The blouson hangs over its hem.
    blob(0.0F, 1.045F, 0.004F, {0.176F, 0.062F, 0.130F}, 0.03F);
    return s;
}

void add_sleeve(Sculpture& jacket, Sculpture& cuffs, const Placed& at, const glm::vec3& shoulder,
                const glm::vec3& elbow, const glm::vec3& wrist, float inner_rad,
                std::uint32_t seed) {
    const auto p = [&](const glm::vec3& q) { return at(q.x, q.y, q.z); };
    const float upper = glm::length(elbow - shoulder);
    const float lower = glm::length(wrist - elbow);
    const glm::vec3 cuff = along(elbow, wrist, 0.86F);
    const Curve arm = make_curve({{p(along(shoulder, elbow, -0.10F)), 0.062F, 0.0F},
                                  {p(along(shoulder, elbow, 0.25F)), 0.066F, 0.0F},
                                  {p(along(shoulder, elbow, 0.70F)), 0.058F, 0.0F},
                                  {p(elbow), 0.056F, 0.0F},
                                  {p(along(elbow, wrist, 0.30F)), 0.055F, 0.0F},
                                  {p(along(elbow, wrist, 0.68F)), 0.048F, 0.0F},
                                  {p(cuff), 0.044F, 0.0F}},
                                 7, at.axes[2]);
    jacket.add(
        tube(arm, folded({{1.12F * upper, 0.11F, inner_rad, 0.0070F, 0.062F, 0.30F},
                          {0.12F * upper, 0.10F, 2.4F, 0.0050F, 0.075F, 0.25F},
                          {0.60F * upper, 0.12F, inner_rad + 1.5F, 0.0036F, 0.090F, 0.40F},
                          {1.12F * upper + 0.70F * lower, 0.07F, 0.5F, 0.0042F, 0.040F, 0.60F}},
                         seed)),
        {0.022F, kJacketColour, true});
    // The cuff is finer than the jacket's cells: a mesh of its own.
    const Curve band = make_curve({{p(along(elbow, wrist, 0.80F)), 0.0450F, 0.0F},
                                   {p(along(elbow, wrist, 0.96F)), 0.0415F, 0.0F}},
                                  4, at.axes[2]);
    cuffs.add(tube(band), {0.0F, kJacketColour * 0.7F, true});
}

void add_placket_and_pockets(Figure& man, const Placed& at, const Sculpture& jacket) {
    const glm::vec3 back = at.axes * glm::vec3(0.0F, 0.0F, -1.0F);
    const auto put = [&](const char* name, const OverlayStyle& style,
                         const std::function<Beam(float, float)>& beam) {
        man.overlaid.push_back({name, Cloth::kJacket, 0.10F, overlay(jacket, style, beam)});
    };
    put("placket", {.columns = 6, .rows = 60, .thick_m = 0.0030F, .colour = kJacketColour * 0.92F},
        along_path({at(0.004F, 1.478F, 0.20F), at(0.004F, 1.25F, 0.22F), at(0.003F, 0.968F, 0.20F)},
                   back, 0.042F));
    for (const float x : kSides) {
        const auto patch_of = [&](float wide, float high, float y, float x_in) {
            return [=](float u, float v) {
                // The lower corners are rounded.
                const float cut = v > 0.85F ? 0.10F * (v - 0.85F) / 0.15F : 0.0F;
                const float side = (u - 0.5F) * (1.0F - cut) * wide;
                return Beam{
                    at(x * (x_in + 0.06F * (y - v * high - 1.33F)) + side, y - v * high, 0.22F),
                    back};
            };
        };
        put("pocket", {.columns = 10, .rows = 10, .thick_m = 0.0042F, .colour = kJacketColour},
            patch_of(0.092F, 0.112F, 1.385F, 0.0640F));
        put("pocket flap",
            {.columns = 10, .rows = 5, .thick_m = 0.0082F, .colour = kJacketColour * 0.90F},
            patch_of(0.098F, 0.040F, 1.393F, 0.0640F));
    }
}

Sculpture add_jacket(Figure& man, const Placed& at, const Sculpture& core) {
    Sculpture jacket = core;
    jacket.keep(half_space(at(0.0F, 0.985F, 0.0F), glm::vec3(0.0F, -1.0F, 0.0F)),
                {0.012F, kJacketColour, false});
    Sculpture hem;
    hem.add(ellipsoid(at(0.0F, 0.990F, 0.000F), {0.170F, 0.20F, 0.124F}, at.axes));
    hem.keep(rounded_box(at(0.0F, 0.985F, 0.0F), {0.3F, 0.030F, 0.3F}, 0.006F, at.axes),
             {0.004F, {}, false});
    jacket.add(as_shape(hem), {0.004F, kJacketColour * 0.7F, true});
    Sculpture cuffs;
    add_sleeve(jacket, cuffs, at, kShoulderRight, kElbowRight, kWristRight, 0.3F, 101);
    add_sleeve(jacket, cuffs, at, kShoulderLeft, kElbowLeft, kWristLeft, 0.9F, 202);
    man.part("cuffs", Cloth::kJacket, 0.0052F, 0.10F).solid = std::move(cuffs);
    jacket.carve(round_cone(at(0.0F, 1.50F, -0.02F), 0.062F, at(0.0F, 1.62F, 0.01F), 0.075F),
                 {0.006F, kJacketColour, false});
    jacket.displace(
        {[at](const glm::vec3& world) {
             const glm::vec3 p = (world - at.origin_m) * at.axes;
             const float waist = std::exp(-std::pow((p.y - 1.065F) / 0.070F, 2.0F));
             const float warp = gradient_noise(glm::vec3(p.x * 5.0F, p.y * 5.0F, p.z * 5.0F), 41);
             const float rolls = std::sin((p.y - 0.25F * std::abs(p.x)) * 135.0F + 4.0F * warp);
             const float drape =
                 gradient_noise(glm::vec3(p.x * 16.0F + p.y * 5.0F, p.y * 4.0F, p.z * 16.0F), 43);
             const float body = std::clamp((0.20F - std::abs(p.x)) / 0.05F, 0.0F, 1.0F) *
                                std::clamp((1.44F - p.y) / 0.05F, 0.0F, 1.0F);
             return body *
                    (0.0055F * waist * rolls * (0.6F + 0.8F * std::abs(warp)) + 0.0035F * drape);
         },
         0.010F});
    man.part("jacket", Cloth::kJacket, 0.0073F, 0.10F).solid = jacket;
    add_placket_and_pockets(man, at, jacket);
    add_collar(man, at, jacket,
               {.neck_m = {0.0F, 1.562F, -0.014F},
                .radius_m = 0.066F,
                .open_rad = 0.42F,
                .drop_m = 0.072F,
                .wide_m = 0.038F,
                .point_m = 0.066F},
               Cloth::kJacket, 0.10F, kJacketColour * 0.88F);
    return jacket;
}

void add_undershirt(Figure& man, const Placed& at) {
    Sculpture& s = man.part("undershirt", Cloth::kShirt, 0.0100F, 0.08F).solid;
    const glm::vec3 colour(0.10F, 0.10F, 0.105F);
    s.add(ellipsoid(at(0.0F, 1.452F, -0.006F), {0.100F, 0.090F, 0.088F}, at.axes),
          {0.0F, colour, true});
    s.keep(
        half_space(at(0.0F, 1.512F, 0.04F), at.axes * glm::normalize(glm::vec3(0.0F, 1.0F, 0.55F))),
        {0.008F, colour, false});
}

void add_leg(Sculpture& s, const Placed& at, const glm::vec3& hip, const glm::vec3& knee,
             const glm::vec3& ankle, std::uint32_t seed) {
    const auto p = [&](const glm::vec3& q) { return at(q.x, q.y, q.z); };
    const float upper = glm::length(knee - hip);
    const float lower = glm::length(ankle - knee);
    const glm::vec3 calf(0.0F, 0.0F, -0.012F);
    const Curve leg = make_curve({{p(along(hip, knee, -0.06F)), 0.074F, 0.0F},
                                  {p(along(hip, knee, 0.06F)), 0.092F, 0.0F},
                                  {p(along(hip, knee, 0.18F)), 0.100F, 0.0F},
                                  {p(along(hip, knee, 0.55F)), 0.090F, 0.0F},
                                  {p(knee), 0.074F, 0.0F},
                                  {p(along(knee, ankle, 0.28F) + calf), 0.074F, 0.0F},
                                  {p(along(knee, ankle, 0.58F) + calf), 0.072F, 0.0F},
                                  {p(along(knee, ankle, 0.74F)), 0.070F, 0.0F}},
                                 7, at.axes[2]);
    s.add(tube(leg, folded({{0.06F, 0.08F, 0.0F, 0.0050F, 0.060F, 0.30F},
                            {1.04F * upper, 0.090F, 3.1F, 0.0070F, 0.058F, 0.30F},
                            {0.86F * upper, 0.07F, 0.3F, 0.0045F, 0.060F, 0.20F},
                            {0.48F * upper, 0.14F, 1.8F, 0.0050F, 0.110F, 0.40F},
                            {upper + 0.68F * lower, 0.075F, 0.6F, 0.0080F, 0.046F, 0.55F}},
                           seed)),
          {0.02F, kTrouserColour, true});
}

Sculpture add_trousers(Figure& man, const Placed& at) {
    FigurePart& part = man.part("trousers", Cloth::kTrousers, 0.0080F, 0.08F);
    Sculpture& s = part.solid;
    s.add(ellipsoid(at(0.0F, 0.955F, -0.004F), {0.164F, 0.115F, 0.120F}, at.axes),
          {0.0F, kTrouserColour, true});
    for (const float x : kSides) {
        s.add(ellipsoid(at(x * 0.075F, 0.915F, -0.055F), {0.088F, 0.095F, 0.078F}, at.axes),
              {0.04F, kTrouserColour, true});
    }
    s.keep(half_space(at(0.0F, 0.984F, 0.0F), glm::vec3(0.0F, 1.0F, 0.0F)),
           {0.006F, kTrouserColour, false});
    add_leg(s, at, kHipRight, kKneeRight, kAnkleRight, 303);
    add_leg(s, at, kHipLeft, kKneeLeft, kAnkleLeft, 404);
    // Cargo pockets with flaps, outside on the thighs; slant pockets.
    for (const float x : kSides) {
        const glm::vec3 hip = x < 0.0F ? kHipRight : kHipLeft;
        const glm::vec3 knee = x < 0.0F ? kKneeRight : kKneeLeft;
        const glm::vec3 middle = along(hip, knee, 0.58F) + glm::vec3(x * 0.070F, 0.0F, 0.012F);
        const glm::mat3 axes = at.axes * axes_from(glm::normalize(glm::vec3(x * 0.9F, 0.05F, 0.3F)),
                                                   glm::normalize(hip - knee));
        s.add(rounded_box(at(middle.x, middle.y, middle.z), {0.062F, 0.080F, 0.020F}, 0.016F, axes),
              {0.016F, kTrouserColour, true});
        const glm::vec3 flap = along(hip, knee, 0.45F) + glm::vec3(x * 0.074F, 0.0F, 0.012F);
        s.add(rounded_box(at(flap.x, flap.y, flap.z), {0.066F, 0.024F, 0.022F}, 0.012F, axes),
              {0.008F, kTrouserColour * 0.88F, true});
        s.carve(tube(make_curve({{at(x * 0.150F, 0.985F, 0.075F), 0.0035F, 0.0F},
                                 {at(x * 0.168F, 0.900F, 0.045F), 0.0035F, 0.0F}},
                                4, at.axes[2])),
                {0.006F, kTrouserColour, false});
    }
    s.displace({[at](const glm::vec3& world) {
                    const glm::vec3 p = (world - at.origin_m) * at.axes;
                    // Tension folds run from the crotch out to the hips.
                    const float seat = std::exp(-std::pow((p.y - 0.86F) / 0.055F, 2.0F));
                    const float rays =
                        std::sin(26.0F * std::atan2(p.y - 0.83F, std::abs(p.x) + 0.05F) +
                                 2.0F * gradient_noise(p * 9.0F, 51));
                    return 0.0034F * seat * rays;
                },
                0.006F});
    return s;
}

void add_straps(Figure& man, const Placed& at, const Sculpture& clothes) {
    const glm::vec3 back = at.axes * glm::vec3(0.0F, 0.0F, -1.0F);
    const auto put = [&](const char* name, const OverlayStyle& style,
                         const std::function<Beam(float, float)>& beam) {
        man.overlaid.push_back({name, Cloth::kLeather, 0.12F, overlay(clothes, style, beam)});
    };
    const OverlayStyle strap{
        .columns = 4, .rows = 44, .thick_m = 0.0042F, .colour = kLeatherColour};
    for (const float x : kSides) {
        // Over the shoulder, down the chest to the belt, and as far on the back.
        put("strap", strap,
            along_path({at(x * 0.128F, 1.520F, 0.12F), at(x * 0.126F, 1.40F, 0.20F),
                        at(x * 0.120F, 1.25F, 0.20F), at(x * 0.104F, 1.10F, 0.20F),
                        at(x * 0.096F, 0.950F, 0.20F)},
                       back, 0.036F));
        put("back strap", {.columns = 4, .rows = 24, .thick_m = 0.0042F, .colour = kLeatherColour},
            along_path({at(x * 0.128F, 1.520F, -0.16F), at(x * 0.110F, 1.25F, -0.22F),
                        at(x * 0.080F, 0.955F, -0.22F)},
                       -back, 0.036F));
        put("shoulder strap",
            {.columns = 4, .rows = 10, .thick_m = 0.0042F, .colour = kLeatherColour},
            along_path({at(x * 0.128F, 1.62F, 0.075F), at(x * 0.128F, 1.62F, -0.115F)},
                       at.axes * glm::vec3(0.0F, -1.0F, 0.0F), 0.036F));
    }
    put("chest strap",
        {.columns = 4, .rows = 30, .thick_m = 0.0070F, .colour = kLeatherColour, .stiff = 2},
        along_path({at(-0.122F, 1.262F, 0.22F), at(0.0F, 1.256F, 0.22F), at(0.122F, 1.262F, 0.22F)},
                   back, 0.030F));
    put("belt",
        {.columns = 4,
         .rows = 72,
         .thick_m = 0.0060F,
         .colour = kLeatherColour,
         .stiff = 3,
         .ring = true,
         .sunk_m = 0.012F},
        around_body(at, {0.0F, 0.958F, -0.004F}, {0.212F, 0.190F}, 0.046F, 0.0F));
}

void add_harness(Figure& man, const Placed& at) {
    FigurePart& part = man.part("harness", Cloth::kLeather, 0.0056F, 0.12F);
    Sculpture& s = part.solid;
    const StrokeStyle leather{0.001F, kLeatherColour, true};
    struct Pouch {
        glm::vec3 middle;
        float turn;
        glm::vec3 half;
    };
    for (const Pouch& pouch :
         {Pouch{{0.105F, 0.940F, 0.124F}, 0.50F, {0.034F, 0.045F, 0.026F}},
          Pouch{{0.178F, 0.936F, 0.062F}, 1.15F, {0.034F, 0.047F, 0.026F}},
          Pouch{{-0.172F, 0.934F, 0.066F}, -1.05F, {0.040F, 0.052F, 0.028F}}}) {
        const glm::vec3 out(std::sin(pouch.turn), 0.0F, std::cos(pouch.turn));
        const glm::mat3 axes = at.axes * axes_from(out, {0.0F, 1.0F, 0.0F});
        const glm::vec3 m = pouch.middle;
        s.add(rounded_box(at(m.x, m.y, m.z), pouch.half, 0.015F, axes),
              {0.004F, kLeatherColour * 1.25F, true});
        const glm::vec3 lid = m + glm::vec3(0.0F, 0.55F * pouch.half.y, 0.0F) + out * 0.004F;
        s.add(rounded_box(at(lid.x, lid.y, lid.z), pouch.half * glm::vec3(1.06F, 0.46F, 1.02F),
                          0.010F, axes),
              {0.004F, kLeatherColour * 1.1F, true});
        const glm::vec3 stud =
            m + out * (pouch.half.z + 0.005F) + glm::vec3(0.0F, 0.12F * pouch.half.y, 0.0F);
        s.add(ball(at(stud.x, stud.y, stud.z), 0.0055F),
              {0.001F, glm::vec3(0.42F, 0.36F, 0.22F), true});
    }
    const glm::vec3 brass(0.45F, 0.38F, 0.22F);
    Sculpture buckle;
    buckle.add(rounded_box(at(0.0F, 0.958F, 0.138F), {0.031F, 0.027F, 0.008F}, 0.004F, at.axes));
    buckle.carve(rounded_box(at(0.0F, 0.958F, 0.138F), {0.021F, 0.017F, 0.02F}, 0.003F, at.axes));
    s.add(as_shape(buckle), {0.0F, brass, true});
    s.add(round_cone(at(-0.022F, 0.958F, 0.142F), 0.0032F, at(0.028F, 0.958F, 0.142F), 0.0028F),
          {0.0F, brass, true});
    // Holster strap round the right thigh.
    const glm::vec3 thigh = along(kHipRight, kKneeRight, 0.27F);
    Sculpture band;
    band.add(round_cone(at(thigh.x, thigh.y, thigh.z), 0.112F,
                        at(kKneeRight.x, kKneeRight.y, kKneeRight.z), 0.085F));
    band.keep(
        rounded_box(at(thigh.x, thigh.y - 0.015F, thigh.z), {0.2F, 0.018F, 0.2F}, 0.004F, at.axes),
        {0.002F, {}, false});
    s.add(as_shape(band), leather);
    s.add(rounded_box(at(thigh.x - 0.118F, thigh.y + 0.02F, thigh.z), {0.020F, 0.085F, 0.045F},
                      0.014F, at.axes),
          {0.004F, kLeatherColour, true});
    s.add(
        rounded_box(at(thigh.x - 0.120F, thigh.y + 0.105F, thigh.z - 0.016F),
                    {0.014F, 0.045F, 0.022F}, 0.008F,
                    at.axes * axes_from(glm::vec3(0.0F, 0.3F, 1.0F), glm::vec3(0.0F, 1.0F, -0.3F))),
        {0.002F, kLeatherColour * 0.5F, true});
}

void add_hands(Figure& man, const Placed& at, const glm::vec3& colour) {
    Sculpture& skin = man.part("hands", Cloth::kSkin, 0.0026F, 0.06F).solid;
    for (const auto& [elbow, wrist] :
         {std::pair{kElbowRight, kWristRight}, std::pair{kElbowLeft, kWristLeft}}) {
        const glm::vec3 inside = along(elbow, wrist, 0.80F);
        skin.add(round_cone(at(inside.x, inside.y, inside.z), 0.029F, at(wrist.x, wrist.y, wrist.z),
                            0.0265F),
                 {0.010F, colour, true});
    }
    const glm::vec3 down = at.axes * glm::normalize(glm::vec3(0.02F, -1.0F, 0.22F));
    add_hand(skin,
             {at(kWristRight.x, kWristRight.y, kWristRight.z),
              axes_from(down, at.axes * glm::vec3(-1.0F, 0.0F, 0.12F))},
             1.0F, 1.0F, {{0.26F, 0.42F, 0.28F}, 0.08F, 0.40F}, colour);
    const glm::vec3 grip = at.axes * glm::normalize(glm::vec3(-0.66F, 0.60F, -0.10F));
    add_hand(skin,
             {at(kWristLeft.x, kWristLeft.y, kWristLeft.z),
              axes_from(grip, at.axes * glm::vec3(0.25F, 0.35F, 1.0F))},
             1.0F, 1.0F, {{0.85F, 1.25F, 0.8F}, 0.02F, 0.6F}, colour);
}

}  // namespace

Figure make_man(const Placed& at) {
    Figure man;
    man.name = "man";
    const Sculpture core = torso(at);
    Sculpture clothes;
    clothes.add(as_shape(add_jacket(man, at, core)));
    add_undershirt(man, at);
    clothes.add(as_shape(add_trousers(man, at)));
    add_harness(man, at);
    add_straps(man, at, clothes);
    Sculpture boots;
    // So low and narrow that no fold of the trousers over it lets it through.
    constexpr Shaft kShaft{0.215F, 0.054F};
    add_boot(man, boots, at, kAnkleRight, kKneeRight, {-0.30F, 1.0F}, 1.06F, kShaft,
             kLeatherColour * 0.9F);
    add_boot(man, boots, at, kAnkleLeft, kKneeLeft, {0.38F, 1.0F}, 1.06F, kShaft,
             kLeatherColour * 0.9F);
    FigurePart& worn = man.part("boots", Cloth::kLeather, 0.0061F, 0.12F);
    worn.solid = std::move(boots);
    worn.painted_shade = 0.4F;
    add_hands(man, at, kSkinColour);
    const glm::vec3 gaze = at.axes * glm::normalize(glm::vec3(0.16F, -0.02F, 1.0F));
    const Placed head{at(0.0F, 1.680F, 0.030F),
                      axes_from(gaze, at.axes * glm::vec3(0.03F, 1.0F, 0.0F))};
    FaceTraits traits;
    traits.beard = 1.0F;
    traits.lips = 0.84F;
    traits.lip = {0.46F, 0.25F, 0.20F};
    traits.skin = kSkinColour;
    traits.brow = 1.3F;
    traits.jaw = 1.02F;
    traits.neck = 1.06F;
    traits.nose_width = 0.92F;
    traits.hair = {0.085F, 0.052F, 0.032F};
    traits.cheeks = 0.25F;
    traits.hairline = short_hairline;
    add_head(man, head, 1.0F, traits);
    add_short_hair(man, head, 1.0F, traits.hair);
    return man;
}

}  // namespace obscura::stimuli::figures
