// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

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

/// A wall on a floor, which takes no time to build, and a view of it.
std::string step_in(const tests::TemporaryFolder& folder, const std::string& name = "step.obj") {
    base::write_file_atomically(folder / name,
                                "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nv 0 1 -2\nv 4 1 -2\n"
                                "v 4 0 -2\nv 0 0 -2\nf 1 2 3 4\nf 8 7 6 5\n");
    return "ao --scene " + name + " --position 2,0.6,-0.4 --look-at 2,0.6,-2 ";
}

TEST(AoCommand, HoldsSeveralTechniquesAndCamerasAgainstTheTruthOverSurfacesAlone) {
    const tests::TemporaryFolder folder;
    const std::string view = step_in(folder) + "--size 48x27 --radius 0.5 ";
    const ProgramRun run =
        run_program(folder, view +
                                "--technique none,blizzard,reference --samples 8 "
                                "--against reference --rays 8 --out out --json");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto rows = nlohmann::json::parse(run.out);
    ASSERT_EQ(rows.size(), 3U);
    const auto rmse = [&](int row) { return rows[row]["surfaces"]["rmse"].get<double>(); };
    EXPECT_EQ(rmse(2), 0.0) << "the truth against itself";
    EXPECT_GT(rmse(0), rmse(1)) << "nothing is worse than something";
    EXPECT_GT(rows[0]["surfaces"]["bias"].get<double>(), 0.0) << "no occlusion is too light";
    EXPECT_LT(rows[0]["surfaces"]["pixels"].get<int>(), 48 * 27) << "empty pixels do not count";
    EXPECT_LT(rows[0]["inside"]["pixels"].get<int>(), rows[0]["surfaces"]["pixels"].get<int>());
    for (const auto& file : rows[1]["files"]) {
        EXPECT_TRUE(std::filesystem::exists(folder / file.get<std::string>())) << file;
    }
    const FloatImage difference = renderer::decode_exr(
        base::read_file(folder / rows[0]["files"][1].get<std::string>()), "difference");
    ASSERT_NE(difference.find("difference.Y"), nullptr);
}

TEST(AoCommand, TakesAFileAsTheTruthOfTheSameViewAndOfNoOther) {
    const tests::TemporaryFolder folder;
    const std::string step = step_in(folder) + "--size 32x18 ";
    step_in(folder, "other.obj");
    ASSERT_EQ(run_program(folder, step + "--technique reference --samples 4 --radius 0.12 "
                                         "--out truth.exr")
                  .exit_code,
              0);
    const ProgramRun same = run_program(
        folder, step + "--technique reference --samples 4 --radius 0.12 --against truth.exr");
    EXPECT_EQ(same.exit_code, 0) << same.err;
    EXPECT_THAT(same.out, HasSubstr("0.0000"));
    const ProgramRun radius =
        run_program(folder, step + "--technique blizzard --radius 0.2 --against truth.exr");
    EXPECT_THAT(radius.out, HasSubstr("truth.exr is of the radius 0.12 m, the buffer of 0.2 m"));
    for (const auto& [words, names] :
         {std::pair{"--scene step.obj --position 2,0.6,-0.4 --look-at 2,0.6,-2 --size 16x9",
                    "32x18"},
          {"--scene step.obj --position 1,1,1 --look-at 0,0,0 --size 32x18", "camera"},
          {"--scene other.obj --position 2,0.6,-0.4 --look-at 2,0.6,-2 --size 32x18", "scene"}}) {
        const ProgramRun run =
            run_program(folder, std::string("ao --technique none --against truth.exr ") + words);
        EXPECT_EQ(run.exit_code, 2) << words;
        EXPECT_THAT(run.err, HasSubstr(names)) << words;
    }
    base::write_file_atomically(folder / "no.exr", "no image");
    EXPECT_EQ(run_program(folder, step + "--technique none --against no.exr").exit_code, 2);
    EXPECT_EQ(run_program(folder, step + "--technique none,blizzard --out both.exr").exit_code, 2);
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
