// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "renderer/base/error.h"
#include "stimuli/generate.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/study_reader.h"
#include "stimuli/study_warnings.h"
#include "tests/renderer/import/glb_maker.h"
#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tests::TemporaryFolder;

/// A floor of 20 m and a box on it, as the text of an OBJ file.
constexpr std::string_view kBox = R"(v -10 0 -10
v -10 0 10
v 10 0 10
v 10 0 -10
v -1 0 -1
v 1 0 -1
v 1 0 1
v -1 0 1
v -1 1 -1
v 1 1 -1
v 1 1 1
v -1 1 1
f 1 2 3 4
f 12 11 10 9
f 8 7 11 12
f 7 6 10 11
f 6 5 9 10
f 5 8 12 9
)";

/// Two conditions over a file's scene; `scene` are lines of the [[scene]] table, from line 12 on.
std::string study_text(std::string_view scene) {
    return fmt::format(R"([study]
name = "brought"
title = "t"
question = "q"
instructions = "i"
resolution = [64, 36]
seed = 3

[[scene]]
id = "box"
source = "models/box.obj"
{}

[[condition]]
id = "one"
scene = "box"
a = {{ technique = "none" }}
b = {{ technique = "blizzard", radius_m = 0.5 }}

[[condition]]
id = "two"
scene = "box"
a = {{ technique = "crytek" }}
b = {{ technique = "raymarch" }}
)",
                       scene);
}

class SceneStudy : public testing::Test {
  protected:
    void SetUp() override { base::write_file_atomically(folder_ / "models/box.obj", kBox); }

    [[nodiscard]] StudyReading read(std::string_view scene) const {
        return read_study(study_text(scene), test_catalogue(), folder_.path());
    }
    [[nodiscard]] std::string problems(std::string_view scene) const {
        return to_lines(read(scene).problems, "study");
    }

    TemporaryFolder folder_;
};

constexpr std::string_view kWhole =
    R"(camera = { position_m = [4, 3, 5], target_m = [0, 0.5, 0], vertical_fov_deg = 40, near_m = 0.2, far_m = 40 }
validity = "high"
scale = 0.5
exposure = 1.5
tone_mapping = "filmic"
white = 6
ambient = [0.5, 0.6, 0.7]
[[scene.light]]
direction = [0, -2, 0]
colour = [1, 0.5, 0.25]
irradiance = 4
[[scene.light]]
position_m = [0, 3, 0]
direction = [0, -1, 0]
cone_deg = 30
irradiance = 2)";

TEST_F(SceneStudy, EveryKeyOfASceneIsRead) {
    const StudyReading reading = read(kWhole);
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    const StudyScene& scene = reading.study.scenes.at(0);
    EXPECT_EQ(scene.source, "models/box.obj");
    EXPECT_EQ(scene.camera, kStudyCamera);
    const SceneSettings& settings = scene.settings;
    EXPECT_EQ(settings.scale, 0.5);
    ASSERT_TRUE(settings.camera.has_value());
    EXPECT_EQ(settings.camera->position_m, glm::vec3(4.0F, 3.0F, 5.0F));
    EXPECT_FLOAT_EQ(settings.camera->vertical_fov_rad, glm::radians(40.0F));
    EXPECT_FLOAT_EQ(settings.camera->far_m, 40.0F);
    EXPECT_EQ(settings.exposure, 1.5F);
    EXPECT_EQ(settings.white, 6.0F);
    EXPECT_EQ(settings.tone_curve, renderer::ToneCurve::kFilmic);
    EXPECT_EQ(settings.ambient, glm::vec3(0.5F, 0.6F, 0.7F));
    ASSERT_EQ(settings.lights.size(), 1U);
    EXPECT_EQ(settings.lights[0].towards_light, glm::vec3(0.0F, 1.0F, 0.0F));
    EXPECT_EQ(settings.lights[0].irradiance, glm::vec3(4.0F, 2.0F, 1.0F));
    ASSERT_EQ(settings.point_lights.size(), 1U);
    EXPECT_FLOAT_EQ(settings.point_lights[0].outer_cone_rad, glm::radians(30.0F));
    EXPECT_EQ(scene.files.size(), 1U);
}

TEST_F(SceneStudy, MistakesAreReportedEachAtItsLine) {
    const std::vector<std::pair<std::string_view, std::string_view>> list = {
        {"camera = \"front\"\nvalidity = \"low\"",
         "study:12: scene \"box\": camera: \"front\" is unknown, allowed are overview"},
        {"validity = \"low\"\ncamera = { position_m = [0, 0], target_m = [0, 0, 0], "
         "vertical_fov_deg = 40 }",
         "study:13: scene \"box\", camera: position_m: allowed is an array of 3 numbers"},
        {"validity = \"low\"\ncamera = { position_m = [0, 0, 1], target_m = [0, 0, 1], "
         "vertical_fov_deg = 40 }",
         "target_m: is where the camera stands"},
        {"validity = \"low\"\ncamera = { position_m = [0, 0, 1], target_m = [0, 0, 0], "
         "vertical_fov_deg = 200 }",
         "200 is out of range, allowed is 1 to 170"},
        {"camera = \"overview\"\nvalidity = \"low\"\nscale = 0",
         "study:14: scene \"box\": scale: 0"},
        {"camera = \"overview\"\nvalidity = \"low\"\nscale = 1e6",
         "study:11: scene \"box\": source: "},
        {"camera = \"overview\"\nvalidity = \"low\"\nexposure = -1",
         "exposure: -1 is out of range"},
        {"camera = \"overview\"\nvalidity = \"low\"\ntone_mapping = \"filmc\"",
         "did you mean \"filmic\"?"},
        {"camera = \"overview\"\nvalidity = \"moderate\"\nenvironment = \"none.hdr\"",
         "study:14: scene \"box\": environment: "},
        {"camera = \"overview\"\nvalidity = \"high\"\n[[scene.light]]\nirradiance = 1",
         "study:14: light 1: direction is missing"},
        {"camera = \"overview\"\nvalidity = \"high\"\n[[scene.light]]\nirradiance = 1\n"
         "direction = [0, 0, 0]",
         "has no length"},
        {"camera = \"overview\"\nvalidity = \"low\"\nambient = -2", "-2 is out of range"},
        {"camera = \"overview\"\nvalidity = \"low\"\nenviroment = \"x.hdr\"",
         "did you mean \"environment\"?"},
    };
    for (const auto& [scene, fragment] : list) {
        EXPECT_THAT(problems(scene), HasSubstr(std::string(fragment))) << scene;
    }
}

TEST_F(SceneStudy, AFileThatIsMissingOrBrokenIsAProblemOfItsLine) {
    std::string text = study_text("camera = \"overview\"\nvalidity = \"low\"");
    text.replace(text.find("box.obj"), 7, "bux.obj");
    const auto missing = read_study(text, test_catalogue(), folder_.path()).problems;
    ASSERT_EQ(missing.size(), 1U);
    EXPECT_EQ(missing[0].line, 11);
    EXPECT_THAT(missing[0].message, HasSubstr("bux.obj: the file is missing"));
    base::write_file_atomically(folder_ / "models/box.obj", "v 1 2\n");
    EXPECT_THAT(problems("camera = \"overview\"\nvalidity = \"low\""),
                HasSubstr("box.obj:1: \"v 1 2\": a position wants"));
}

TEST_F(SceneStudy, FilesAreNotOpenedWhereTheyAreTrusted) {
    const std::string text = study_text("camera = \"wherever\"\nvalidity = \"low\"");
    const StudyReading reading =
        read_study(text, test_catalogue(), "/nowhere", SceneFiles::kTrusted);
    EXPECT_EQ(to_lines(reading.problems, "study"), "");
    EXPECT_EQ(reading.study.scenes[0].camera, "wherever");
}

TEST_F(SceneStudy, ABuiltInSceneTakesLevelsThatTheStudyBringsTheLightFor) {
    const auto with = [](std::string_view scene) {
        std::string text(kSmallStudy);
        const std::string_view own =
            "source = \"atrium\"\ncamera = \"nave\"\nvalidity = \"high\"\n";
        text.replace(text.find(own), own.size(), scene);
        return to_lines(read_study(text, test_catalogue()).problems, "study");
    };
    EXPECT_EQ(with("source = \"atrium\"\ncamera = \"nave\"\nvalidity = \"low\"\nambient = 0.5\n"),
              "");
    EXPECT_THAT(with("source = \"atrium\"\ncamera = \"nave\"\nvalidity = \"low\"\n"),
                HasSubstr("has no light for \"low\""));
    EXPECT_THAT(with("source = \"atrium\"\ncamera = \"nave\"\nvalidity = \"high\"\nscale = 2\n"),
                HasSubstr("a built-in scene is in metres"));
}

TEST_F(SceneStudy, TheLevelDecidesWhatOfTheLightIsUsed) {
    SceneSettings settings = read(kWhole).study.scenes.at(0).settings;
    const OpenedScene opened = open_scene("models/box.obj", settings, folder_.path());
    EXPECT_EQ(opened.levels.size(), 3U);
    const renderer::Lighting low = opened.lighting(Validity::kLow);
    EXPECT_FALSE(low.environment);
    EXPECT_TRUE(low.lights.empty() && low.point_lights.empty());
    EXPECT_EQ(low.ambient, glm::vec3(0.5F, 0.6F, 0.7F));
    const renderer::Lighting moderate = opened.lighting(Validity::kModerate);
    EXPECT_TRUE(moderate.environment);
    EXPECT_TRUE(moderate.lights.empty() && moderate.point_lights.empty());
    const renderer::Lighting high = opened.lighting(Validity::kHigh);
    EXPECT_TRUE(high.environment);
    EXPECT_EQ(high.lights.size(), 1U);
    EXPECT_EQ(high.point_lights.size(), 1U);
    EXPECT_TRUE(high.normal_mapping);
    ASSERT_TRUE(high.tone_mapping.has_value());
    EXPECT_EQ(high.tone_mapping->curve, renderer::ToneCurve::kFilmic);
    EXPECT_EQ(high.tone_mapping->exposure, 1.5F);
}

TEST_F(SceneStudy, AFileWithoutLightsGetsASunOnlyAtTheHighestLevel) {
    const OpenedScene opened = open_scene("models/box.obj", {}, folder_.path());
    EXPECT_EQ(opened.lighting(Validity::kHigh).lights.size(), 1U);
    EXPECT_FALSE(opened.lighting(Validity::kModerate).tone_mapping);
    EXPECT_EQ(opened.id, "box");
    EXPECT_EQ(opened.camera().name, renderer::kOverviewCamera);
    EXPECT_THROW((void)opened.camera("nave"), base::Error);
    EXPECT_EQ(opened.level("high"), Validity::kHigh);
    EXPECT_THROW((void)opened.level("higher"), base::Error);
    EXPECT_THROW((void)open_scene("atrum"), base::Error);
    SceneSettings twice;
    twice.scale = 2.0;
    EXPECT_THROW((void)open_scene("relic", twice), base::Error);
}

TEST_F(SceneStudy, ImagesOfAFilesSceneAreMadeAndMadeAgainWhenTheFileChanges) {
    const std::string_view scene =
        "camera = { position_m = [4, 3, 5], target_m = [0, 0.5, 0], vertical_fov_deg = 40 }\n"
        "validity = \"low\"";
    const std::filesystem::path out = folder_ / "images";
    const auto make = [&] {
        const StudyReading reading = read(scene);
        EXPECT_EQ(to_lines(reading.problems, "study"), "");
        return generate(reading.study, {}, out, true, test_catalogue());
    };
    EXPECT_EQ(make().made, 4);
    EXPECT_EQ(make().kept, 4);
    const Study study = read(scene).study;
    EXPECT_THAT(problems_of_stimuli(study, out), testing::IsEmpty());
    const Manifest manifest = load_manifest(out / "manifest.json");
    ASSERT_EQ(manifest.images.at(0).scene_files.size(), 1U);
    EXPECT_EQ(manifest.images[0].scene_files[0].name, "box.obj");
    EXPECT_EQ(manifest.images[0].scene_files[0].sha256, study.scenes[0].files[0].sha256);
    EXPECT_THAT(manifest.images[0].settings, HasSubstr("position_m"));
    // The box can be seen: it is darker at its foot than without ambient occlusion.
    EXPECT_NE(base::read_file(out / "one-a.png"), base::read_file(out / "one-b.png"));

    base::write_file_atomically(folder_ / "models/box.obj", std::string(kBox) + "v 5 5 5\n");
    EXPECT_EQ(make().made, 4);
    // Another view is another image.
    Study other = study;
    other.scenes[0].settings.camera->position_m.x = 5.0F;
    EXPECT_THAT(problems_of_stimuli(other, out), Contains(HasSubstr("the study asks for")));
}

TEST_F(SceneStudy, WhatOfAFileIsNotShownIsWarnedOfAndRecorded) {
    base::write_file_atomically(folder_ / "models/box.obj",
                                "mtllib absent.mtl\n" + std::string(kBox));
    const StudyReading reading = read("camera = \"overview\"\nvalidity = \"high\"\nambient = 0.5");
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    const std::vector<std::string> warnings = warnings_of(reading.study);
    EXPECT_THAT(warnings, testing::Contains(HasSubstr("absent.mtl: the file is missing")));
    EXPECT_THAT(warnings, testing::Contains(HasSubstr("ambient light has no effect at the "
                                                      "validity high")));
    const std::filesystem::path out = folder_ / "images";
    (void)generate(reading.study, {}, out, true, test_catalogue());
    const Manifest manifest = load_manifest(out / "manifest.json");
    EXPECT_THAT(manifest.images.at(0).scene_notes, testing::Contains(HasSubstr("absent.mtl")));
    EXPECT_THAT(warnings_of(load_study("jakobsen2010")), testing::IsEmpty());
}

TEST(StudyWarnings, OfAFileAreSaidOnceHoweverManyScenesShowIt) {
    Study study;
    for (const auto& [id, file] :
         {std::pair("dusk", "hall.glb"), {"day", "hall.glb"}, {"night", "other.glb"}}) {
        StudyScene& scene = study.scenes.emplace_back();
        scene.id = id;
        scene.source = file;
        scene.notes = {"no reflections"};
    }
    EXPECT_THAT(warnings_of(study),
                testing::ElementsAre("scenes \"dusk\", \"day\": hall.glb: no reflections",
                                     "scene \"night\": other.glb: no reflections"));
}

TEST_F(SceneStudy, WhatACameraSeesFromBehindIsWarnedOfForTheCameraInUse) {
    const auto warnings_from = [this](const char* position) {
        const StudyReading reading = read(fmt::format(
            "camera = {{ position_m = {}, target_m = [0, 0.5, 0], vertical_fov_deg = 40 }}\n"
            "validity = \"low\"",
            position));
        EXPECT_EQ(to_lines(reading.problems, "study"), "");
        return warnings_of(reading.study);
    };
    EXPECT_THAT(warnings_from("[4, 3, 5]"), testing::Each(testing::Not(HasSubstr("behind"))));
    // From below the floor.
    EXPECT_THAT(
        warnings_from("[4, -3, 5]"),
        Contains(HasSubstr("seen from behind, where they are lit as from the front: 100 %")));
}

TEST_F(SceneStudy, TheExampleOverTheOriginalScenesLacksNothingButItsFiles) {
    const std::filesystem::path file =
        std::filesystem::path(OBSCURA_SOURCE_DIR) / "stimuli/studies/original-scenes.toml";
    const std::string text = base::read_file(file);
    EXPECT_EQ(to_lines(read_study(text, test_catalogue(), {}, SceneFiles::kTrusted).problems, "x"),
              "");
    for (const StudyProblem& problem :
         read_study(text, test_catalogue(), folder_.path()).problems) {
        EXPECT_THAT(problem.message, HasSubstr("the file is missing"));
    }
}

}  // namespace
}  // namespace obscura::stimuli
