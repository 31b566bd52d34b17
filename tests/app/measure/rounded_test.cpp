// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/model/rounded.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/base/random.h"

namespace obscura::renderer {
namespace {

TEST(RoundedNumbers, EncloseWhatSinglePrecisionMakesOfAFormula) {
    base::Random random(11);
    double closest = 0.0;
    for (int i = 0; i < 100'000; ++i) {
        const auto number = [&] {
            const double size = std::exp(random.uniform(-6.0, 6.0));
            return static_cast<float>(random.uniform(-1.0, 1.0) < 0.0 ? -size : size);
        };
        const float a = number();
        const float b = number();
        const float c = number();
        const float single = ((a * b - c) * a + b / c) * (a - b);
        const Rounded x(a);
        const Rounded y(b);
        const Rounded z(c);
        const Rounded bound = ((x * y - z) * x + y / z) * (x - y);
        const double off = std::abs(static_cast<double>(single) - bound.value);
        ASSERT_LE(off, bound.error) << a << ' ' << b << ' ' << c;
        if (bound.error > 0.0) closest = std::max(closest, off / bound.error);
    }
    EXPECT_GT(closest, 0.1) << "the bound is far from what happens: it would find nothing";
}

TEST(RoundedNumbers, EncloseRootsAndPowers) {
    base::Random random(12);
    for (int i = 0; i < 100'000; ++i) {
        const auto a = static_cast<float>(std::exp(random.uniform(-8.0, 0.0)));
        const auto power = static_cast<float>(random.uniform(0.0, 500.0));
        const Rounded root = inverse_sqrt(Rounded(a));
        ASSERT_LE(std::abs(static_cast<double>(1.0F / std::sqrt(a)) - root.value), root.error);
        const Rounded raised = pow(Rounded(a), Rounded(power));
        ASSERT_LE(std::abs(static_cast<double>(std::exp2(power * std::log2(a))) - raised.value),
                  raised.error)
            << a << ' ' << power;
    }
}

TEST(RoundedNumbers, AreComparedEitherWayOnlyWithinTheirErrors) {
    const Rounded third = Rounded(1.0) / Rounded(3.0);
    EXPECT_TRUE(may_be_less(third, Rounded(1.0 / 3.0)));
    EXPECT_TRUE(may_be_at_least(third, Rounded(1.0 / 3.0)));
    EXPECT_FALSE(may_be_less(Rounded(0.334), third));
    EXPECT_FALSE(may_be_at_least(third, Rounded(0.334)));
    EXPECT_FALSE(may_be_less(Rounded(2.0), Rounded(2.0))) << "floats that are exact";
    EXPECT_TRUE(may_be_at_least(Rounded(2.0), Rounded(2.0)));
    const Rounded unknown = Rounded(1.0) / (third - Rounded(1.0 / 3.0));
    EXPECT_TRUE(may_be_less(unknown, Rounded(0.0)));
    EXPECT_TRUE(may_be_at_least(unknown * Rounded(0.0), Rounded(1.0)));
}

}  // namespace
}  // namespace obscura::renderer
