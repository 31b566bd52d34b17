// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "renderer/reference/exr.h"
#include "tests/app/commands/run_program.h"

namespace obscura::app {
namespace {

using renderer::FloatImage;
using testing::HasSubstr;

TEST(AoCommand, WritesTheReferenceWithItsErrorAndSaysWhatItIs) {
    const tests::TemporaryFolder folder;
    const ProgramRun run =
        run_program(folder,
                    "ao --scene atrium --technique reference --samples 16 --set radius_m=0.25 "
                    "--size 48x27 --out made/ao.exr");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const FloatImage image = renderer::decode_exr(base::read_file(folder / "made/ao.exr"), "ao");
    EXPECT_EQ(image.width, 48);
    EXPECT_EQ(image.height, 27);
    ASSERT_NE(image.find("ao.Y"), nullptr);
    ASSERT_NE(image.find("ao.stderr"), nullptr);
    EXPECT_EQ(image.texts.at("obscura:scene"), "atrium");
    EXPECT_EQ(image.texts.at("obscura:camera"), "nave");
    EXPECT_EQ(image.texts.at("obscura:technique"), "reference");
    EXPECT_EQ(image.texts.at("obscura:samples"), "16");
    EXPECT_EQ(image.texts.at("obscura:radius_m"), "0.25");
    EXPECT_EQ(image.texts.at("obscura:falloff"), "0");
    EXPECT_EQ(image.matrices.at("obscura:projection")[11], -1.0F);
    EXPECT_EQ(image.matrices.at("obscura:view")[15], 1.0F);
}

TEST(AoCommand, WritesATechniquesBuffer) {
    const tests::TemporaryFolder folder;
    const ProgramRun run = run_program(
        folder, "ao --scene atrium --technique blizzard --denoise box4 --size 48x27 --out ao.exr");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const FloatImage image = renderer::decode_exr(base::read_file(folder / "ao.exr"), "ao");
    ASSERT_NE(image.find("ao.Y"), nullptr);
    EXPECT_EQ(image.find("ao.stderr"), nullptr);
    EXPECT_EQ(image.texts.at("obscura:denoise"), "box4");
    EXPECT_EQ(image.texts.at("obscura:samples"), "24");
}

TEST(AoCommand, RefusesBadInputBeforeAnyWorkAndNamesIt) {
    const tests::TemporaryFolder folder;
    struct Case {
        const char* arguments;
        const char* names;
    };
    for (const Case& bad : std::initializer_list<Case>{
             {"--technique reference --out ao.exr", "--scene"},
             {"--scene castle --technique reference --out ao.exr", "castle"},
             {"--scene relic --technique magic --out ao.exr", "magic"},
             {"--scene relic --technique reference --camera back --out ao.exr", "back"},
             {"--scene relic --technique reference --samples 0 --out ao.exr", "0 is out of range"},
             {"--scene relic --technique reference --set radius_m=0 --out ao.exr", "radius_m"},
             {"--scene relic --technique reference --set radius_m=nan --out ao.exr", "radius_m"},
             {"--scene relic --technique reference --set radius_m=1m --out ao.exr", "radius_m=1m"},
             {"--scene relic --technique reference --set falloff=0.5 --out ao.exr", "whole"},
             {"--scene relic --technique none --denoise box4 --out ao.exr", "box4"},
             {"--scene relic --technique reference --size 0x9 --out ao.exr", "width"},
             {"--scene relic --technique reference --out /proc/none/ao.exr", "--out"}}) {
        const ProgramRun run = run_program(folder, std::string("ao ") + bad.arguments);
        EXPECT_EQ(run.exit_code, 2) << bad.arguments << "\n" << run.err;
        EXPECT_THAT(run.err, HasSubstr(bad.names)) << bad.arguments;
        EXPECT_FALSE(std::filesystem::exists(folder / "ao.exr")) << bad.arguments;
    }
}

}  // namespace
}  // namespace obscura::app
