// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "stimuli/scenes/figures/figure.h"

namespace obscura::stimuli::figures {
namespace {

/// A digit: three bones, each bent further towards the palm, knuckles between them.
void add_digit(Sculpture& skin, glm::vec3 joint, glm::vec3 along, const glm::vec3& back,
               const std::array<float, 3>& curl_rad, float long_m, float thick_m,
               const glm::vec3& colour) {
    constexpr std::array kShares{0.46F, 0.30F, 0.24F};
    constexpr std::array kThinner{0.88F, 0.90F, 0.86F};
    // Blood shows through at the joints and the tips.
    const glm::vec3 red = colour * glm::vec3(1.0F, 0.86F, 0.83F);
    glm::vec3 up = back;
    float thick = thick_m;
    for (std::size_t bone = 0; bone < 3; ++bone) {
        const float c = std::cos(curl_rad[bone]);
        const float s = std::sin(curl_rad[bone]);
        const glm::vec3 bent = along * c - up * s;
        up = up * c + along * s;
        along = bent;
        const glm::vec3 next = joint + along * (kShares[bone] * long_m);
        const float thin = kThinner[bone] * thick;
        skin.add(round_cone(joint, thick, next, thin), {0.0014F, bone == 2 ? red : colour, true});
        if (bone < 2) {
            skin.add(ellipsoid(next + up * (0.22F * thin),
                               {0.98F * thin, 0.86F * thin, 1.05F * thin}, axes_from(along, up)),
                     {0.0016F, red, true});
        } else {
            // The nail, paler, set off by an edge.
            skin.add(ellipsoid(next + up * (0.66F * thin) - along * (0.10F * thin),
                               {0.66F * thin, 0.34F * thin, 1.02F * thin}, axes_from(along, up)),
                     {0.0004F, glm::min(colour * glm::vec3(1.22F, 1.16F, 1.14F), glm::vec3(1.0F)),
                      true});
        }
        joint = next;
        thick = thin;
    }
}

}  // namespace

void add_hand(Sculpture& skin, const Placed& at, float scale, float thumb_side,
              const HandPose& pose, const glm::vec3& colour) {
    const auto place = [&](float x, float y, float z) {
        return at(scale * thumb_side * x, scale * y, scale * z);
    };
    const StrokeStyle flesh{scale * 0.012F, colour, true};
    // x runs from the little finger to the thumb.
    skin.add(round_cone(place(0.0F, 0.0F, -0.004F), scale * 0.0265F, place(0.0F, 0.0F, 0.02F),
                        scale * 0.026F),
             flesh);
    skin.add(ellipsoid(place(0.0F, -0.002F, 0.052F), scale * glm::vec3(0.041F, 0.0145F, 0.054F),
                       at.axes),
             flesh);
    skin.add(round_cone(place(-0.026F, -0.003F, 0.022F), scale * 0.016F,
                        place(-0.031F, -0.002F, 0.078F), scale * 0.0115F),
             flesh);
    skin.add(round_cone(place(0.020F, -0.006F, 0.018F), scale * 0.019F,
                        place(0.036F, -0.008F, 0.052F), scale * 0.014F),
             flesh);
    constexpr std::array kRoots{-0.031F, -0.011F, 0.010F, 0.030F};
    constexpr std::array kLengths{0.063F, 0.081F, 0.088F, 0.079F};
    constexpr std::array kThick{0.0074F, 0.0084F, 0.0088F, 0.0085F};
    for (std::size_t i = 0; i < 4; ++i) {
        const float t = static_cast<float>(i) - 1.5F;
        const float fan = t * pose.spread_rad;
        const glm::vec3 along =
            at.axes * glm::vec3(thumb_side * std::sin(fan), 0.0F, std::cos(fan));
        const float last = 0.096F - 0.0035F * t * t;
        std::array<float, 3> curl = pose.curl_rad;
        for (float& joint : curl) joint *= 1.0F - 0.10F * t;
        // The knuckle, and the sinew that runs to it from the wrist.
        skin.add(ball(place(kRoots[i], 0.0035F, last), scale * kThick[i] * 1.10F),
                 {scale * 0.005F, colour * glm::vec3(1.0F, 0.88F, 0.85F), true});
        skin.add(round_cone(place(0.35F * kRoots[i], 0.0090F, 0.030F), scale * 0.0020F,
                            place(kRoots[i], 0.0085F, last - 0.008F), scale * 0.0024F),
                 {scale * 0.008F, colour, true});
        add_digit(skin, place(kRoots[i], 0.001F, last), along, at.axes[1], curl,
                  scale * kLengths[i], scale * kThick[i], colour);
    }
    const float in = pose.thumb_in;
    const glm::vec3 along = at.axes * glm::normalize(glm::vec3(thumb_side * (0.75F - 0.75F * in),
                                                               -0.35F - 0.45F * in, 0.80F));
    const glm::vec3 nail =
        at.axes * glm::normalize(glm::vec3(thumb_side * (0.8F), 0.55F - 0.3F * in, 0.0F));
    const glm::vec3 up = glm::normalize(nail - along * glm::dot(nail, along));
    add_digit(skin, place(0.036F, -0.008F, 0.044F), along, up,
              {0.0F, 0.25F + 0.2F * in, 0.30F + 0.2F * in}, scale * 0.074F, scale * 0.0112F,
              colour);
}

}  // namespace obscura::stimuli::figures
