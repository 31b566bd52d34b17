// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "renderer/base/error.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/closed_forms.h"
#include "tests/renderer/reference/corner.h"

namespace obscura::renderer {
namespace {

using tests::corner_view;
using tests::CornerView;
using tests::rays_within;

TEST(Reference, IsTheSameWhateverTheNumberOfThreads) {
    const CornerView view = corner_view();
    const ReferenceScene scene(view.scene);
    ReferenceOptions options = rays_within(1.0, 33);
    options.threads = 1;
    const ReferenceImage one = scene.trace(view.camera, 67, 41, options);
    for (const int threads : {2, 7}) {
        options.threads = threads;
        const ReferenceImage many = scene.trace(view.camera, 67, 41, options);
        EXPECT_EQ(one.accessibility, many.accessibility);
        EXPECT_EQ(one.standard_error, many.standard_error);
        EXPECT_EQ(one.depth_m, many.depth_m);
    }
}

TEST(Reference, AnotherSeedGivesOtherErrorsAroundTheSameMean) {
    const CornerView view = corner_view();
    const ReferenceScene scene(view.scene);
    ReferenceOptions options = rays_within(1.0, 64);
    const ReferenceImage one = scene.trace(view.camera, 48, 48, options);
    options.seed = 2;
    const ReferenceImage two = scene.trace(view.camera, 48, 48, options);
    EXPECT_NE(one.accessibility, two.accessibility);
    EXPECT_NEAR(tests::mean_of(one.accessibility), tests::mean_of(two.accessibility), 2e-3);
}

TEST(Reference, EmptyPixelsAreExactlyOpenAndWithoutError) {
    CornerView view;
    add_ball(view.scene, {0.5, 0.0, 0.0}, 0.3, 24);
    const ReferenceImage image =
        ReferenceScene(view.scene).trace(view.camera, 64, 48, rays_within(1.0));
    int empty = 0;
    for (std::size_t i = 0; i < image.depth_m.size(); ++i) {
        if (image.depth_m[i] != kBackgroundDepth_m) continue;
        ++empty;
        ASSERT_EQ(image.accessibility[i], 1.0F);
        ASSERT_EQ(image.standard_error[i], 0.0F);
    }
    EXPECT_GT(empty, 1000);
    EXPECT_LT(empty, 64 * 48 - 100);
}

TEST(Reference, FalloffOccludesLessAndTheQuadraticOneLiesBetween) {
    const CornerView view = corner_view();
    const ReferenceScene scene(view.scene);
    ReferenceOptions options = rays_within(1.0, 64);
    const double none = tests::mean_of(scene.trace(view.camera, 32, 32, options).accessibility);
    options.falloff = Falloff::kLinear;
    const double linear = tests::mean_of(scene.trace(view.camera, 32, 32, options).accessibility);
    options.falloff = Falloff::kQuadratic;
    const double square = tests::mean_of(scene.trace(view.camera, 32, 32, options).accessibility);
    EXPECT_LT(none, square - 0.005);
    EXPECT_LT(square, linear - 0.005);
}

TEST(Reference, OneRayTellsNoErrorAndSaysTheMostThereCanBe) {
    const CornerView view = corner_view();
    const ReferenceImage image =
        ReferenceScene(view.scene).trace(view.camera, 16, 16, rays_within(1.0, 1));
    EXPECT_THAT(image.standard_error, testing::Each(0.5F));
    EXPECT_THAT(image.accessibility, testing::Each(testing::AnyOf(0.0F, 1.0F)));
}

TEST(Reference, StopsWhenAskedAndSaysSo) {
    const CornerView view = corner_view();
    int asked = 0;
    const auto stop = [&asked](double share) {
        ++asked;
        return share < 0.0;
    };
    try {
        (void)ReferenceScene(view.scene).trace(view.camera, 64, 64, rays_within(1.0), stop);
        FAIL() << "it went on";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kFailed);
        EXPECT_THAT(error.what(), testing::HasSubstr("stopped"));
    }
    EXPECT_EQ(asked, 1);
}

TEST(Reference, ProgressGrowsToOne) {
    const CornerView view = corner_view();
    double last = 0.0;
    const auto tell = [&last](double share) {
        EXPECT_GE(share, last);
        last = share;
        return true;
    };
    (void)ReferenceScene(view.scene).trace(view.camera, 64, 64, rays_within(1.0), tell);
    EXPECT_EQ(last, 1.0);
}

TEST(Reference, RefusesOptionsThatMeanNothing) {
    const CornerView view = corner_view();
    const ReferenceScene scene(view.scene);
    const auto refused = [&](const ReferenceOptions& options, int width = 4, int height = 4) {
        try {
            (void)scene.trace(view.camera, width, height, options);
        } catch (const base::Error& error) {
            return error.code() == base::ExitCode::kBadInput;
        }
        return false;
    };
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double radius_m : {0.0, -1.0, -infinity, std::nan("")}) {
        EXPECT_TRUE(refused(rays_within(radius_m))) << radius_m;
    }
    for (const int rays : {0, -1, kMostReferenceRays + 1}) {
        EXPECT_TRUE(refused(rays_within(1.0, rays))) << rays;
    }
    ReferenceOptions endless = rays_within(infinity);
    EXPECT_FALSE(refused(endless));
    endless.falloff = Falloff::kLinear;
    EXPECT_TRUE(refused(endless));
    EXPECT_TRUE(refused(rays_within(1.0), 0, 4));
    EXPECT_TRUE(refused(rays_within(1.0), 4, 20000));
}

TEST(Reference, RefusesACameraThatLooksNowhere) {
    CornerView view = corner_view();
    const ReferenceScene scene(view.scene);
    view.camera.target_m = view.camera.position_m;
    EXPECT_THROW((void)scene.trace(view.camera, 4, 4, rays_within(1.0)), base::Error);
    view.camera.target_m.x = std::nanf("");
    EXPECT_THROW((void)scene.trace(view.camera, 4, 4, rays_within(1.0)), base::Error);
}

}  // namespace
}  // namespace obscura::renderer
