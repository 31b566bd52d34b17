// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/gl/context.h"
#include "stimuli/stimulus.h"

namespace obscura::stimuli {
namespace {

using renderer::Frame;
using renderer::Phase;
using renderer::PlannedTarget;
using renderer::Target;

/// The targets that may differ within a pair: what follows from accessibility.
bool follows_from_accessibility(const PlannedTarget& target) {
    return target.is(Target::kAccessibility) || target.is("denoise step") ||
           target.is(Target::kDenoised) || target.is(Target::kHdr) || target.is(Target::kDisplay) ||
           target.is(Target::kResolved);
}

/// What the composite multiplied the ambient light by; 1 everywhere without a technique.
std::vector<float> accessibility_of(const Frame& frame) {
    if (frame.plan().has(Phase::kTechnique)) {
        return frame.read_floats(frame.plan().final_accessibility());
    }
    return std::vector<float>(
        static_cast<std::size_t>(frame.plan().image_width) * frame.plan().image_height, 1.0F);
}

/// The thesis's study, at a quarter of its width so that it is quick.
Study small_study() {
    Study study = load_study("jakobsen2010");
    study.width = 320;
    study.height = 180;
    return study;
}

void expect_shared_targets_equal(const Frame& a, const Frame& b, const std::string& pair) {
    int shared = 0;
    for (const PlannedTarget& planned : a.plan().targets) {
        if (follows_from_accessibility(planned) || b.plan().find(planned) == nullptr ||
            planned.is(Target::kShadow)) {
            continue;
        }
        ++shared;
        EXPECT_TRUE(a.read_bytes(planned) == b.read_bytes(planned))
            << pair << ": " << planned.name << " differs";
    }
    EXPECT_GE(shared, 3) << pair;
}

/// Returns how many samples were equally open.
std::size_t expect_equal_pixels_where_equally_open(const Frame& a, const Frame& b,
                                                   const std::string& pair) {
    const std::vector<float> open_a = accessibility_of(a);
    const std::vector<float> open_b = accessibility_of(b);
    // Of each sample, before those of a pixel are averaged.
    const std::vector<float> image_a = a.read_components(Target::kDisplay, 3);
    const std::vector<float> image_b = b.read_components(Target::kDisplay, 3);
    const renderer::FramePlan& plan = a.plan();
    // A sample may take the accessibility of any pixel around it.
    const auto equally_open = [&](int column, int row) {
        for (int y = std::max(row - 1, 0); y <= std::min(row + 1, plan.image_height - 1); ++y) {
            for (int x = std::max(column - 1, 0); x <= std::min(column + 1, plan.image_width - 1);
                 ++x) {
                const auto i = static_cast<std::size_t>(y) * plan.image_width + x;
                if (open_a[i] != open_b[i]) return false;
            }
        }
        return true;
    };
    std::size_t equal = 0;
    std::size_t differing = 0;
    for (int y = 0; y < plan.height; ++y) {
        for (int x = 0; x < plan.width; ++x) {
            const auto i = 3 * (static_cast<std::size_t>(y) * plan.width + x);
            const bool same = std::equal(&image_a[i], &image_a[i] + 3, &image_b[i]);
            if (equally_open(x / plan.options.supersampling, y / plan.options.supersampling)) {
                ++equal;
                EXPECT_TRUE(same) << pair << ": sample " << x << ' ' << y;
                if (!same) return equal;
            } else if (!same) {
                ++differing;
            }
        }
    }
    EXPECT_GT(differing, 1000U) << pair << ": the two images are one";
    return equal;
}

void expect_finite(const Frame& frame, const std::string& file) {
    for (const PlannedTarget& planned : frame.plan().targets) {
        if (!planned.is(Target::kAccessibility) && !planned.is(Target::kDenoised)) {
            continue;
        }
        for (const float value : frame.read_floats(planned)) {
            ASSERT_TRUE(std::isfinite(value) && value >= 0.0F && value <= 1.0F) << file;
        }
    }
}

TEST(Pairs, OfTheThesisDifferInNothingButTheirAmbientOcclusion) {
    const renderer::HeadlessContext context;
    const Study study = small_study();
    StimulusRenderer renderer(study);
    ASSERT_EQ(study.conditions.size(), 7U);
    for (const Condition& condition : study.conditions) {
        const Frame a = renderer.render({&condition, 'a'});
        const Frame b = renderer.render({&condition, 'b'});
        expect_shared_targets_equal(a, b, condition.id);
        // IV fills the image, and its two techniques' radii leave no pixel at one value: there it
        // is the buffers that they share which tell.
        const std::size_t seen = expect_equal_pixels_where_equally_open(a, b, condition.id);
        if (condition.id != "IV") {
            EXPECT_GT(seen, 100U) << condition.id << ": too little seen";
        }
        expect_finite(a, condition.id + "-a");
        expect_finite(b, condition.id + "-b");
    }
}

TEST(Pairs, TheRelicUnderCrytekHasNeitherNormalNorLightTargets) {
    const renderer::HeadlessContext context;
    const Study study = small_study();
    StimulusRenderer renderer(study);
    const Frame frame = renderer.render({study.find_condition("I"), 'a'});
    for (const renderer::Buffer& absent :
         {Target::kNormal, Target::kAmbient, Target::kDirect, Target::kShadow, Target::kHdr}) {
        EXPECT_EQ(frame.plan().find(absent), nullptr) << absent.name;
    }
    EXPECT_FALSE(frame.plan().has(Phase::kLight));
}

}  // namespace
}  // namespace obscura::stimuli
