// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <map>
#include <set>

#include "app/measure/measure.h"
#include "app/measure/measured_settings.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "stimuli/study_writer.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A floor, a wall and a box.
constexpr const char* kObject = R"(o yard
v -9 -1 -6
v 9 -1 -6
v 9 9 -6
v -9 9 -6
f 1 2 3 4
v -9 -1 4
v 9 -1 4
f 5 6 2 1
v -0.5 -1 -4
v 0.5 -1 -4
v 0.5 0.2 -4
v -0.5 0.2 -4
v -0.5 -1 -5
v 0.5 -1 -5
v 0.5 0.2 -5
v -0.5 0.2 -5
f 7 8 9 10
f 12 11 14 13
f 11 7 10 14
f 8 12 13 9
f 10 9 13 14
)";

std::string scene_of(const std::string& id, const std::string& validity, double x) {
    return fmt::format(R"([[scene]]
id = "{}"
source = "yard.obj"   # beside the study
camera = {{ position_m = [{}, 0.4, 1.0], target_m = [0, -0.5, -5], vertical_fov_deg = 50 }}
validity = "{}"
)",
                       id, x, validity);
}

std::string blizzard(const std::string& settings) {
    return "{ technique = \"blizzard\"" + settings + " }";
}

std::string condition_of(const std::string& id, const std::string& scene, const std::string& a,
                         const std::string& b) {
    return fmt::format("[[condition]]\nid = \"{}\"\nscene = \"{}\"\na = {}\nb = {}\n", id, scene,
                       blizzard(a), blizzard(b));
}

class MeasuredStudy : public testing::Test {
  protected:
    MeasuredStudy() { base::write_file_atomically(folder_ / "study" / "yard.obj", kObject); }

    /// Writes the study of those tables and gives its file.
    std::string study(const std::string& tables) const {
        const std::string file = (folder_ / "study" / "study.toml").string();
        base::write_file_atomically(file, R"([study]
name = "yards"
title = "Yards"
question = "Which?"
instructions = "Look."
order = "fixed"
resolution = [64, 36]
seed = 1
)" + tables);
        return file;
    }

    MeasureRequest request_of(const std::string& file) const {
        MeasureRequest request;
        request.study = file;
        request.techniques = {"blizzard"};
        request.width = 48;
        request.height = 27;
        request.rays = 16;
        request.runs = 1;
        request.quick = true;
        request.out = folder_ / "out";
        request.cache = folder_ / "cache";
        request.quiet = true;
        return request;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(MeasuredStudy, GivesEachViewOfOneFileItsOwnRowsAndPlots) {
    const std::string file = study(scene_of("left", "high", -2.0) + scene_of("right", "low", 2.0) +
                                   condition_of("I", "left", "", ", radius_m = 0.2") +
                                   condition_of("II", "right", "", ", radius_m = 0.2"));
    const analysis::MeasurementReport report = measure(request_of(file)).report;
    std::map<std::string, std::set<double>> errors;
    for (const analysis::MeasurementRow& row : report.rows) {
        EXPECT_EQ(row.scene, "yard");
        EXPECT_EQ(row.camera, "study");
        errors[row.scene_id].insert(row.error->rmse);
    }
    ASSERT_EQ(errors.size(), 2U);
    EXPECT_NE(errors["left"], errors["right"]) << "one view was measured for both";
    std::filesystem::create_directories(folder_ / "out");
    std::set<std::string> plots;
    for (const auto& path : analysis::write_report(report, folder_ / "out")) {
        const std::string name = path.filename().string();
        if (!name.starts_with("error-over-time")) continue;
        EXPECT_TRUE(plots.insert(name).second) << name;
    }
    for (const char* view : {"left-study-high", "right-study-low"}) {
        EXPECT_TRUE(
            std::filesystem::exists(folder_ / "out" / fmt::format("error-over-time-{}.dat", view)));
    }
    std::set<std::string> maps;
    for (const analysis::ErrorMap& map : report.maps) {
        EXPECT_TRUE(maps.insert(map.name).second) << map.name;
    }
    EXPECT_EQ(maps.size(), 4U);
}

TEST_F(MeasuredStudy, GivesEverySettingThatIsShownARowHeldAgainstItsOwnRadius) {
    const std::string file = study(
        scene_of("yard", "low", 0.5) +
        condition_of("I", "yard", ", radius_m = 0.1", ", radius_m = 0.3") +
        condition_of("II", "yard", ", radius_m = 0.3", ", radius_m = 0.9, power = 30") +
        condition_of("III", "yard", ", radius_m = 0.3, denoise = \"none\"", ", radius_m = 0.3"));
    for (const bool quick : {true, false}) {
        MeasureRequest request = request_of(file);
        request.quick = quick;
        const analysis::MeasurementReport report = measure(request).report;
        std::map<std::string, std::string> shown;
        for (const analysis::MeasurementRow& row : report.rows) {
            if (row.published.empty()) continue;
            EXPECT_TRUE(shown.emplace(row.variant + ' ' + row.denoise, row.published).second)
                << row.variant;
            EXPECT_EQ(row.reference_radius_m, row.parameters.at("radius_m"));
            EXPECT_EQ(row.values, "published");
        }
        EXPECT_THAT(
            shown, testing::ElementsAre(std::pair("Blizzard24 R 0.1 separable", "I a"),
                                        std::pair("Blizzard24 R 0.3 none", "III a"),
                                        std::pair("Blizzard24 R 0.3 separable", "I b, II a, III b"),
                                        std::pair("Blizzard24 R 0.9 separable", "II b")));
    }
}

TEST_F(MeasuredStudy, RendersWhatTheStudyAsksOfItsImages) {
    const std::string file =
        study(scene_of("yard", "low", 0.5) + condition_of("I", "yard", "", ", radius_m = 0.1"));
    stimuli::Study loaded = stimuli::load_study(file);
    loaded.occluding_opacity = 0.9F;
    loaded.supersampling = 2;
    const std::vector<MeasuredView> views =
        views_of(with_defaults(request_of(file)), loaded, stimuli::builtin_scenes());
    ASSERT_EQ(views.size(), 1U);
    EXPECT_EQ(views[0].options.occluding_opacity, 0.9F);
    EXPECT_EQ(views[0].options.supersampling, 2);
}

TEST(MeasureRequests, KeepEveryNumberThatWasGivenWhenQuick) {
    MeasureRequest request;
    request.quick = true;
    request.width = 640;
    request.height = 360;
    request.rays = 256;
    request.runs = 5;
    MeasureRequest full = with_defaults(request);
    EXPECT_EQ(full.width, 640);
    EXPECT_EQ(full.height, 360);
    EXPECT_EQ(full.rays, 256);
    EXPECT_EQ(full.runs, 5);
    request = {};
    request.quick = true;
    full = with_defaults(request);
    EXPECT_EQ(full.width, 256);
    EXPECT_EQ(full.rays, 64);
    EXPECT_EQ(with_defaults({}).width, 640);
    EXPECT_EQ(with_defaults({}).runs, 5);
}

TEST_F(MeasuredStudy, IsFittedIntoAStudyThatRunsFromWhereItIsWritten) {
    const std::string file = study(scene_of("left", "high", -2.0) + scene_of("right", "low", 2.0) +
                                   condition_of("I", "left", ", radius_m = 0.2", "") +
                                   condition_of("II", "right", ", radius_m = 0.2", "") +
                                   condition_of("same", "left", ", power = 30", ", power = 300"));
    MeasureRequest request = request_of(file);
    request.samples = {24};
    request.fit = true;
    request.write_study = folder_ / "elsewhere" / "deep" / "fitted.toml";
    std::filesystem::create_directories(request.write_study.parent_path());
    const Measured measured = measure(request);
    const stimuli::Study written =
        stimuli::parse_study(measured.fitted_study, "fitted.toml", folder_ / "elsewhere" / "deep");
    EXPECT_EQ(written.scenes[0].source, "../../study/yard.obj");
    EXPECT_THAT(measured.fitted_study, HasSubstr("# beside the study"));
    const stimuli::Study before = stimuli::load_study(file);
    for (const char* id : {"I", "II"}) {
        const stimuli::Condition& now = *written.find_condition(id);
        EXPECT_NE(now.a.parameters, before.find_condition(id)->a.parameters) << id;
        EXPECT_NE(now.a.parameters, now.b.parameters) << id;
    }
    const stimuli::Condition& same = *written.find_condition("same");
    EXPECT_EQ(same.a.parameters, before.find_condition("same")->a.parameters);
    EXPECT_EQ(same.b.parameters, before.find_condition("same")->b.parameters);
    ASSERT_EQ(measured.notes.size(), 1U);
    EXPECT_THAT(measured.notes[0], HasSubstr("condition same"));
}

TEST_F(MeasuredStudy, SaysWhereAFitIsReportedOnItsOwnView) {
    const std::string file =
        study(scene_of("yard", "low", 0.5) + condition_of("I", "yard", "", ", radius_m = 0.1"));
    MeasureRequest request = request_of(file);
    request.samples = {24};
    request.fit = true;
    analysis::MeasurementReport report = measure(request).report;
    ASSERT_FALSE(report.fitted.empty());
    const bool only = report.fitted[0].training_cameras == report.fitted[0].reported_cameras;
    const std::string said = "fitted and reported on the same view";
    EXPECT_EQ(only, analysis::report_text(report).find(said) != std::string::npos);
    report.fitted[0].training_cameras = report.fitted[0].reported_cameras = {"only"};
    EXPECT_THAT(analysis::report_text(report), HasSubstr(said));
    EXPECT_THAT(analysis::fitted_csv(report.fitted), HasSubstr(",true\n"));
    for (analysis::Fitted& fit : report.fitted) fit.training_cameras = {"another"};
    EXPECT_THAT(analysis::report_text(report), Not(HasSubstr(said)));
}

constexpr const char* kText = R"(# begins
[[scene]]
id = "s"
source = "a/b \" c.obj"  # a file
environment = 'sky.hdr'
[[scene]]
id = "t"
source = "atrium"
[[scene]]
id = "u"
source = "/abs/olute.glb"
[[condition]]
id = "I"
a = { technique = "blizzard", power = 1e1, label = "é" }   # keep
b = { technique = "crytek" }
[[condition]]
id = "II"
[condition.a]
technique = "blizzard"
radius_m = 0.5 # half
[condition.b]
technique = "none"
)";

TEST(StudyTexts, HaveParametersReplacedOrAddedAndNothingElseTouched) {
    const std::string changed =
        stimuli::with_variants(kText, "study",
                               {{"II", 'a', {{"power", 7.0}, {"radius_m", 0.25}}},
                                {"I", 'a', {{"power", 3.0}, {"radius_m", 0.1}}},
                                {"I", 'b', {{"offset_scale", 0.02}}}});
    EXPECT_THAT(changed, HasSubstr("a = { technique = \"blizzard\", power = 3.0, label = \"é\", "
                                   "radius_m = 0.1 }   # keep"));
    EXPECT_THAT(changed, HasSubstr("b = { technique = \"crytek\", offset_scale = 0.02 }"));
    EXPECT_THAT(changed, HasSubstr("radius_m = 0.25\npower = 7.0 # half"));
    EXPECT_THAT(changed, HasSubstr("# begins"));
    EXPECT_EQ(stimuli::with_variants(kText, "study", {}), kText);
    const auto refused = [](const std::vector<stimuli::VariantChange>& changes) {
        EXPECT_THROW((void)stimuli::with_variants(kText, "study", changes), base::Error);
    };
    refused({{"III", 'a', {}}});
    refused({{"I", 'c', {}}});
    refused({{"I", 'a', {{"power", 1.0}}}, {"I", 'a', {{"power", 2.0}}}});
}

TEST(StudyTexts, NameTheirFilesFromAnotherFolder) {
    const std::string moved = stimuli::with_paths_from(kText, "study", "/home/one", "/home/two/x");
    EXPECT_THAT(moved, HasSubstr(R"(source = "../../one/a/b \" c.obj"  # a file)"));
    EXPECT_THAT(moved, HasSubstr("environment = \"../../one/sky.hdr\""));
    EXPECT_THAT(moved, HasSubstr("source = \"atrium\""));
    EXPECT_THAT(moved, HasSubstr("source = \"/abs/olute.glb\""));
    EXPECT_EQ(stimuli::with_paths_from(kText, "study", "/home/one", "/home/two/../one"), kText);
    EXPECT_EQ(stimuli::with_paths_from(kText, "study", "", ""), kText);
}

}  // namespace
}  // namespace obscura::app
