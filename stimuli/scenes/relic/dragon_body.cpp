// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "stimuli/scenes/relic/dragon.h"

namespace obscura::stimuli::relic {
namespace {

constexpr float kTurnHalf = std::numbers::pi_v<float>;
constexpr int kScalesAround = 12;
constexpr float kScaleLength = 0.95F;  ///< of a row, in widths of a scale
constexpr float kScaleHigh_m = 0.031F;

float smooth(float low, float high, float value) {
    const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
    return t * t * (3.0F - 2.0F * t);
}

/// How many rows of scales lie between the start of the curve and a length along it: rows shrink
/// with the body's girth.
class RowsAlong {
  public:
    RowsAlong(const Curve& curve, int around) : step_m_(curve.back().length_m / kSteps) {
        float rows = 0.0F;
        std::size_t next = 1;
        for (int step = 0; step <= kSteps; ++step) {
            const float along_m = step_m_ * static_cast<float>(step);
            while (next + 1 < curve.size() && curve[next].length_m < along_m) ++next;
            rows_.push_back(rows);
            rows += step_m_ / (kScaleLength * 2.0F * kTurnHalf * curve[next].width_m /
                               static_cast<float>(around));
        }
    }
    [[nodiscard]] float at(float along_m) const {
        const float step = std::clamp(along_m / step_m_, 0.0F, kSteps - 0.001F);
        const auto i = static_cast<std::size_t>(step);
        return rows_[i] + (rows_[i + 1] - rows_[i]) * (step - static_cast<float>(i));
    }

  private:
    static constexpr int kSteps = 400;
    float step_m_;
    std::vector<float> rows_;
};

/// Overlapping scales, their free edges towards the tail: the highest of the scales of three rows.
float scale_height(float around, float row) {
    float highest = 0.0F;
    const int nearest = static_cast<int>(row + 0.5F);
    for (int j = nearest - 1; j <= nearest + 1; ++j) {
        // Shifted so that the truncation rounds to the nearest scale.
        const float shifted = around + (j % 2 == 0 ? 64.0F : 63.5F);
        const float x = shifted - static_cast<float>(static_cast<int>(shifted + 0.5F));
        const float y = row - static_cast<float>(j);
        const float out = std::sqrt(x * x / (0.51F * 0.51F) + y * y / (0.90F * 0.90F));
        const float lift = 0.60F - 0.40F * y;
        const float keel = 0.16F * smooth(0.16F, 0.0F, std::abs(x));
        if (out >= 1.0F) continue;
        highest = std::max(highest, smooth(1.0F, 0.70F, out) * (lift + keel));
    }
    return highest;
}

/// Broad plates across the belly, each overlapping the next.
float plate_height(float row) {
    const float part = row * 0.55F - std::floor(row * 0.55F);
    return (1.0F - 0.75F * part) * smooth(0.0F, 0.16F, part);
}

}  // namespace

TubeStyle scales(const Curve& curve, int around, float high_m, bool plates) {
    const RowsAlong rows(curve, around);
    const float thickest =
        std::max_element(curve.begin(), curve.end(), [](const CurvePoint& a, const CurvePoint& b) {
            return a.width_m < b.width_m;
        })->width_m;
    const Relief relief = [=](const TubePoint& at) {
        const float size = std::clamp(at.radius_m / thickest, 0.15F, 1.0F);
        const float row = rows.at(at.along_m);
        const float side = std::abs(at.angle_rad);
        const float belly = plates ? smooth(2.12F, 2.22F, side) : 0.0F;
        const float seam = plates ? smooth(0.0F, 0.09F, std::abs(side - 2.17F)) : 1.0F;
        const float turn = at.angle_rad / (2.0F * kTurnHalf) * static_cast<float>(around);
        const float height = belly < 1.0F ? scale_height(turn, row) : 0.0F;
        const float plate = belly > 0.0F ? plate_height(row) : 0.0F;
        return high_m * size * (height + (plate * 1.1F - height) * belly) * (0.35F + 0.65F * seam);
    };
    return {false, relief, 1.2F * high_m};
}

Curve spine() {
    struct Bone {
        glm::vec3 position_m;
        float radius_m;
        glm::vec3 back;  ///< roughly the way its back faces
    };
    const std::vector<Bone> bones{
        {{0.415F, 0.660F, -0.02F}, 0.007F, {1.0F, 0.2F, 0.0F}},
        {{0.475F, 0.585F, -0.03F}, 0.017F, {1.0F, 0.3F, 0.0F}},
        {{0.465F, 0.470F, -0.05F}, 0.028F, {1.0F, 0.2F, 0.0F}},
        {{0.395F, 0.350F, -0.06F}, 0.038F, {1.0F, 0.6F, 0.0F}},
        {{0.375F, 0.245F, 0.04F}, 0.047F, {1.0F, 0.7F, 0.1F}},
        {{0.270F, 0.205F, 0.22F}, 0.058F, {0.4F, 1.0F, 0.4F}},
        {{0.020F, 0.215F, 0.31F}, 0.071F, {0.0F, 1.0F, 0.5F}},
        {{-0.245F, 0.235F, 0.21F}, 0.083F, {-0.4F, 1.0F, 0.3F}},
        {{-0.330F, 0.265F, -0.05F}, 0.092F, {-0.6F, 1.0F, 0.0F}},
        {{-0.180F, 0.320F, -0.25F}, 0.097F, {-0.3F, 1.0F, -0.4F}},
        {{0.090F, 0.375F, -0.24F}, 0.101F, {0.2F, 1.0F, -0.4F}},
        {{0.255F, 0.430F, -0.04F}, 0.103F, {0.6F, 1.0F, 0.0F}},
        {{0.160F, 0.490F, 0.15F}, 0.103F, {0.4F, 0.9F, -0.2F}},
        {{-0.060F, 0.560F, 0.18F}, 0.099F, {0.7F, 0.6F, -0.4F}},
        {{-0.110F, 0.680F, 0.11F}, 0.088F, {1.0F, 0.1F, -0.4F}},
        {{0.020F, 0.785F, 0.03F}, 0.077F, {1.0F, -0.2F, -0.3F}},
        {{0.095F, 0.880F, 0.01F}, 0.068F, {1.0F, 0.3F, -0.3F}},
        {{0.040F, 0.965F, 0.04F}, 0.062F, {0.5F, 1.0F, -0.2F}},
        {{-0.060F, 0.970F, 0.09F}, 0.060F, {0.2F, 1.0F, 0.0F}},
        {{-0.120F, 0.950F, 0.12F}, 0.054F, {0.0F, 1.0F, 0.0F}},
    };
    constexpr int kSteps = 12;
    std::vector<Knot> knots;
    for (const Bone& bone : bones) knots.push_back({bone.position_m, bone.radius_m, 0.0F});
    Curve curve = make_curve(knots, kSteps, glm::vec3(0.0F, 1.0F, 0.0F));
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const std::size_t bone = std::min(i / kSteps, bones.size() - 2);
        const float t = static_cast<float>(i - bone * kSteps) / kSteps;
        curve[i].normal =
            glm::mix(glm::normalize(bones[bone].back), glm::normalize(bones[bone + 1].back), t);
    }
    rebuild_frames(curve);
    return curve;
}

void add_body(Sculpture& sculpture, const Curve& spine) {
    sculpture.add(tube(spine, scales(spine, kScalesAround, kScaleHigh_m, true)),
                  {0.0F, kJade, true});
    // A tuft of flames ends the tail.
    const glm::vec3 tip = spine.front().position_m;
    const glm::vec3 away = glm::normalize(tip - spine[6].position_m);
    const glm::vec3 side = glm::normalize(glm::cross(away, glm::vec3(0.0F, 0.0F, 1.0F)));
    for (int i = -3; i <= 3; ++i) {
        const auto lean = static_cast<float>(i) / 3.0F;
        const glm::vec3 out = glm::normalize(away + side * (0.75F * lean));
        const float long_m = 0.13F - 0.05F * std::abs(lean);
        const glm::vec3 bend = side * (0.028F * (i % 2 == 0 ? 1.0F : -1.0F));
        const glm::vec3 depth(0.0F, 0.0F, 0.012F * static_cast<float>((i + 3) % 3 - 1));
        const Curve flame =
            make_curve({{tip - away * 0.03F, 0.010F, 0.007F},
                        {tip + out * (0.35F * long_m) + bend * 0.5F + depth, 0.017F, 0.009F},
                        {tip + out * (0.75F * long_m) - bend * 0.3F + depth, 0.010F, 0.006F},
                        {tip + out * long_m + bend * 0.4F + depth, 0.002F, 0.002F}},
                       5, side);
        sculpture.add(tube(flame), {0.006F, kPale, true});
    }
}

void add_crest(Sculpture& sculpture, const Curve& spine) {
    float next_m = 0.16F;
    for (std::size_t i = 1; i + 14 < spine.size(); ++i) {
        const CurvePoint& at = spine[i];
        if (at.length_m < next_m) continue;
        next_m = at.length_m + 0.018F + 0.32F * at.width_m;
        const glm::vec3 forward = glm::normalize(spine[i + 1].position_m - spine[i - 1].position_m);
        const float high = 0.022F + 0.55F * at.width_m;
        const glm::vec3 root = at.position_m + at.normal * (at.width_m - 0.008F);
        const Curve fin = make_curve(
            {{root + forward * (0.10F * high), 0.34F * high, 0.0088F},
             {root + at.normal * (0.55F * high) - forward * (0.12F * high), 0.25F * high, 0.0075F},
             {root + at.normal * (0.95F * high) - forward * (0.50F * high), 0.12F * high, 0.0062F},
             {root + at.normal * (1.05F * high) - forward * (0.95F * high), 0.0042F, 0.0042F}},
            4, forward);
        sculpture.add(tube(fin), {0.008F, kDeep, true});
    }
}

}  // namespace obscura::stimuli::relic
