// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/closed_forms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace obscura::renderer {
namespace {

// Values of the documentation's table, integrated numerically there.
TEST(ClosedForms, AgreeWithValuesThatWereIntegratedNumerically) {
    EXPECT_NEAR(corner_within_radius(0.0), 0.5, 1e-12);
    EXPECT_NEAR(corner_within_radius(0.1), 0.563556, 1e-6);
    EXPECT_NEAR(corner_within_radius(0.25), 0.657481, 1e-6);
    EXPECT_NEAR(corner_within_radius(0.5), 0.804499, 1e-6);
    EXPECT_NEAR(corner_within_radius(0.75), 0.927853, 1e-6);
    EXPECT_EQ(corner_within_radius(1.0), 1.0);
    EXPECT_EQ(corner_within_radius(7.0), 1.0);
    EXPECT_NEAR(corner_with_linear_falloff(0.1), 0.690767, 1e-6);
    EXPECT_NEAR(corner_with_linear_falloff(0.25), 0.831786, 1e-6);
    EXPECT_NEAR(corner_with_linear_falloff(0.5), 0.948035, 1e-6);
}

TEST(ClosedForms, AgreeWithEachOtherWhereTheirScenesCoincide) {
    EXPECT_NEAR(wedge(std::numbers::pi), 1.0, 1e-12);
    EXPECT_NEAR(wedge(0.5 * std::numbers::pi), corner_within_radius(0.0), 1e-12);
    EXPECT_EQ(corner_with_linear_falloff(0.0), 0.5);
    EXPECT_NEAR(under_disk(3.0, 4.0), 0.64, 1e-12);
    // A pit's floor sees a disk-shaped hole; under a disk one sees what is left.
    EXPECT_NEAR(in_pit(3.0, 4.0), 1.0 - under_disk(3.0, 4.0), 1e-12);
    EXPECT_NEAR(beside_sphere(1.0, 0.0), 0.0, 1e-12);
    EXPECT_EQ(between_plates(2.0), 1.0);
}

TEST(ClosedForms, AreMetByTheReferenceAt4096Rays) {
    for (const ClosedForm& form : closed_forms()) {
        const ClosedFormCheck check = check_closed_form(form, 4096, 20260501);
        EXPECT_TRUE(check.holds) << check.name << ": " << check.measured << " +- "
                                 << check.standard_error << ", pixel rms " << check.pixel_rms
                                 << ", analytic " << check.analytic;
    }
}

TEST(ClosedForms, AreMissedByAReferenceThatLooksTooFar) {
    int missed = 0;
    for (ClosedForm form : closed_forms()) {
        if (!form.name.starts_with("corner within R, c = 0.5")) continue;
        form.options.radius_m *= 1.02;
        EXPECT_FALSE(check_closed_form(form, 4096, 1).holds);
        ++missed;
    }
    EXPECT_EQ(missed, 1);
}

TEST(ClosedForms, ErrorFallsFasterThanTheSevenTenthsPowerOfTheRays) {
    std::vector<ClosedForm> forms;
    for (ClosedForm& form : closed_forms()) {
        // The balls take long to build.
        if (!form.name.starts_with("ball")) forms.push_back(std::move(form));
    }
    const Convergence measured = measure_convergence(forms, 3, 4);
    EXPECT_GE(measured.order, 0.7);
    EXPECT_LT(measured.order, 1.6);
    EXPECT_TRUE(measured.holds);
}

// Over many pixels the spread between a pixel's parts must not fall below the error it stands for;
// that it lies above by up to 8^(1/4) and more is documented.
TEST(ClosedForms, StandardErrorsAreNotTooLow) {
    for (const ClosedForm& form : closed_forms()) {
        if (form.name.starts_with("ball")) continue;
        for (const int rays : {16, 64, 256}) {
            const ClosedFormCheck check = check_closed_form(form, rays, 11, 16);
            EXPECT_LE(check.pixel_rms, 1.25 * check.pixel_error + 2e-5)
                << check.name << ", " << rays << " rays";
            EXPECT_LE(check.pixel_error, 12.0 * check.pixel_rms + 2e-5)
                << check.name << ", " << rays << " rays";
        }
    }
}

}  // namespace
}  // namespace obscura::renderer
