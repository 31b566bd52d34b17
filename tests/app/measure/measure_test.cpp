// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "app/measure/experiment.h"
#include "app/measure/fit_settings.h"
#include "app/measure/measure.h"
#include "app/measure/timing.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "stimuli/study_writer.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scenes.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;

/// Boxes on a floor before a wall, by two cameras.
renderer::Scene build_boxes() {
    renderer::Scene scene = tests::facing_wall(6.0F);
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -6.0F});
    tests::add_box(scene, {-0.5F, -1.0F, -5.0F}, {0.5F, 0.2F, -4.0F});
    scene.cameras = {tests::forward_camera(), tests::forward_camera()};
    scene.cameras[0].name = "left";
    scene.cameras[0].position_m.x = -0.4F;
    scene.cameras[1].name = "right";
    scene.cameras[1].position_m.x = 0.5F;
    return scene;
}

stimuli::BuiltinScene boxes(const std::string& id) {
    return {.id = id,
            .title = "boxes",
            .stands_in_for = "",
            .levels = {stimuli::Validity::kLow},
            .cameras = {"left", "right"},
            .build = build_boxes,
            .lighting = [](stimuli::Validity) { return renderer::Lighting{}; }};
}

stimuli::BuiltinScene empty(const std::string& id) {
    stimuli::BuiltinScene scene = boxes(id);
    scene.build = [] {
        renderer::Scene nothing = tests::empty_scene();
        nothing.cameras = build_boxes().cameras;
        return nothing;
    };
    return scene;
}

class Measure : public testing::Test {
  protected:
    MeasureRequest small_request() const {
        MeasureRequest request;
        request.scenes = {"boxes"};
        request.samples = {8, 24};
        request.filters = {"none", "separable"};
        request.width = 48;
        request.height = 27;
        request.rays = 32;
        request.runs = 2;
        request.out = folder_.path();
        request.cache = folder_.path() / "cache";
        request.quiet = true;
        return request;
    }

    tests::TemporaryFolder folder_;
    std::vector<stimuli::BuiltinScene> catalogue_{boxes("boxes"), empty("empty")};
};

TEST_F(Measure, GivesARowForEveryTechniqueSampleCountFilterAndCamera) {
    MeasureRequest request = small_request();
    request.techniques = {"none", "crytek", "blizzard"};
    const analysis::MeasurementReport report = measure(request, catalogue_).report;
    EXPECT_EQ(report.rows.size(), 2U * (1U + 2U * 2U * 2U));
    for (const analysis::MeasurementRow& row : report.rows) {
        ASSERT_TRUE(row.error.has_value()) << row.variant << ": " << row.error.reason;
        EXPECT_GT(row.error->rmse, 0.0) << row.variant;
        EXPECT_LT(row.error->rmse, 0.6) << row.variant;
        EXPECT_EQ(row.nonfinite, 0U);
        EXPECT_FALSE(row.device.empty());
        EXPECT_EQ(row.runs, 2);
        ASSERT_TRUE(row.image.has_value());
        EXPECT_GT(row.image->rmse, 0.0);
        EXPECT_EQ(row.cost.median_ms > 0.0, row.technique != "none");
        EXPECT_GT(row.frame.median_ms, row.cost.median_ms);
    }
    EXPECT_FALSE(report.timer_check.empty());
}

/// The rows of the first scene, as far as they do not depend on the others.
std::string rows_of_boxes(const Measured& measured) {
    std::vector<analysis::MeasurementRow> rows;
    for (const analysis::MeasurementRow& row : measured.report.rows) {
        if (row.scene == "boxes") rows.push_back(row);
    }
    return analysis::measurement_json(rows);
}

renderer::Scene build_interrupted() {
    std::raise(SIGINT);
    return build_boxes();
}

class InterruptedMeasure : public Measure {
  protected:
    /// Of boxes, by two cameras, and of a scene at whose opening Ctrl-C is pressed, if it is to be.
    Measured run(bool interrupted) const {
        MeasureRequest request = small_request();
        request.scenes = {"boxes", "trap"};
        request.techniques = {"none", "hbao"};
        request.samples = {8};
        request.filters = {"none"};
        request.kept_views = kept_;
        stimuli::BuiltinScene trap = boxes("trap");
        trap.build = interrupted ? build_interrupted : build_boxes;
        return measure(request, {boxes("boxes"), trap});
    }
    std::size_t files() const {
        const std::filesystem::directory_iterator kept(kept_);
        return static_cast<std::size_t>(std::distance(begin(kept), end(kept)));
    }

    std::filesystem::path kept_ = folder_.path() / "kept";
};

TEST_F(InterruptedMeasure, GoesOnBehindTheViewsThatWereFinished) {
    const Measured before = run(true);
    EXPECT_TRUE(before.interrupted);
    EXPECT_EQ(files(), 2U);
    const Measured whole = run(false);
    EXPECT_FALSE(whole.interrupted);
    // Times and all: it was not measured again.
    EXPECT_TRUE(rows_of_boxes(whole) == rows_of_boxes(before));
    EXPECT_EQ(whole.report.rows.size(), 2 * before.report.rows.size());
    EXPECT_THAT(whole.notes, testing::Contains(HasSubstr("2 of 4 views, with their times")));
    EXPECT_EQ(files(), 0U);
    EXPECT_FALSE(rows_of_boxes(run(false)) == rows_of_boxes(before));
}

TEST_F(InterruptedMeasure, MeasuresAgainWhatWasDamagedMeanwhile) {
    const Measured before = run(true);
    for (const auto& entry : std::filesystem::directory_iterator(kept_)) {
        std::string bytes = base::read_file(entry.path());
        bytes.back() = static_cast<char>(bytes.back() + 1);
        base::write_file_atomically(entry.path(), bytes);
    }
    const Measured whole = run(false);
    EXPECT_FALSE(rows_of_boxes(whole) == rows_of_boxes(before));
    EXPECT_THAT(whole.notes, testing::Not(testing::Contains(HasSubstr("of a run before"))));
}

TEST_F(Measure, APapersExperimentHasARowForEachSettingAndJudgesEachConclusion) {
    for (const std::string name :
         {"sunet-5.2", "sunet-5.5", "sunet-5.6", "sunet-5.8", "sunet-5.9"}) {
        const Experiment& experiment = *find_experiment(name);
        MeasureRequest request = small_request();
        request.samples = {};
        request.filters = {};
        request.experiment = name;
        const analysis::MeasurementReport report = measure(request, catalogue_).report;
        EXPECT_EQ(report.rows.size(), experiment.settings.size());
        int judged = 0;
        for (const std::string& finding : report.findings) {
            const bool yes = finding.find(" Here too: ") != std::string::npos;
            const bool no = finding.find(" Here not: ") != std::string::npos;
            const bool open = finding.find(" Here undecided, ") != std::string::npos;
            judged += yes || no || open ? 1 : 0;
        }
        EXPECT_GE(judged, 2) << name;
        for (const analysis::MeasurementRow& row : report.rows) {
            EXPECT_EQ(row.error.has_value(), row.technique != "unsharp") << row.error.reason;
        }
        EXPECT_THAT(analysis::report_text(report), HasSubstr("The paper: "));
    }
}

TEST(PapersFindings, AreUndecidedWhereTwoTimesAreNearerThanRunsAreToEachOther) {
    const auto found = [](double triangles_ms, double inverse_ms) {
        std::vector<Outcome> outcomes(2);
        outcomes[0].name = "similar triangles";
        outcomes[0].ao_ms = triangles_ms;
        outcomes[1].name = "inverse projection";
        outcomes[1].ao_ms = inverse_ms;
        return find_experiment("sunet-5.4")->judge(outcomes).at(1);
    };
    for (const auto& [triangles_ms, inverse_ms] : {std::pair(10.0, 10.4), std::pair(10.4, 10.0)}) {
        EXPECT_TRUE(found(triangles_ms, inverse_ms).is_undecided());
    }
    EXPECT_FALSE(found(10.0, 11.0).is_undecided());
    EXPECT_TRUE(found(10.0, 11.0).agrees);
    EXPECT_FALSE(found(11.0, 10.0).is_undecided());
    EXPECT_FALSE(found(11.0, 10.0).agrees);
}

TEST_F(Measure, AnExperimentThatThereIsNotOrThatIsToldWhatToMeasureIsRefused) {
    MeasureRequest request = small_request();
    request.experiment = "sunet-9.9";
    EXPECT_THROW((void)measure(request, catalogue_), base::Error);
    request.experiment = "sunet-5.6";
    EXPECT_THROW((void)measure(request, catalogue_), base::Error) << "samples are asked for";
    for (const Experiment& experiment : experiments()) {
        EXPECT_THAT(experiments_text(), HasSubstr(experiment.name));
        for (const Experiment::Setting& setting : experiment.settings) {
            EXPECT_TRUE(renderer::problems_of(setting.variant).empty()) << experiment.name;
        }
    }
}

TEST_F(Measure, ASceneWithoutAStudyIsPrintedWithNothingOfTheThesisAndCallsForeignValuesStart) {
    MeasureRequest request = small_request();
    request.techniques = {"crytek", "blizzard", "raymarch"};
    request.samples = {};
    request.quick = true;
    const analysis::MeasurementReport report = measure(request, catalogue_).report;
    const std::string text = analysis::report_text(report);
    for (const analysis::MeasurementRow& row : report.rows) {
        EXPECT_THAT(text, HasSubstr(row.variant));
        EXPECT_EQ(row.scene_id, "boxes");
        EXPECT_EQ(row.published, "");
        EXPECT_EQ(row.values, "start") << row.variant;
    }
    EXPECT_THAT(text, testing::Not(HasSubstr("thesis")));
    EXPECT_THAT(text, testing::Not(HasSubstr("published")));
    std::filesystem::create_directories(request.out);
    (void)analysis::write_report(report, request.out);
    EXPECT_THAT(base::read_file(request.out / "measure.html"), testing::Not(HasSubstr("thesis")));
}

TEST_F(Measure, AFitLowersTheErrorOnItsTrainingCameraAndIsReportedOnAnother) {
    MeasureRequest request = small_request();
    request.techniques = {"blizzard"};
    request.samples = {24};
    request.filters = {"separable"};
    request.fit = true;
    request.quick = true;
    const analysis::MeasurementReport report = measure(request, catalogue_).report;
    ASSERT_EQ(report.fitted.size(), 1U);
    const analysis::Fitted& fitted = report.fitted[0];
    EXPECT_LT(fitted.training_rmse_after, fitted.training_rmse_before);
    EXPECT_EQ(fitted.training_cameras, std::vector<std::string>{"left"});
    EXPECT_EQ(fitted.reported_cameras, std::vector<std::string>{"right"});
    EXPECT_EQ(fitted.samples, 24);
    EXPECT_NE(fitted.before, fitted.after);
    EXPECT_EQ(std::count_if(report.rows.begin(), report.rows.end(),
                            [](const auto& row) { return row.fitted; }),
              2);
}

TEST_F(Measure, WhatIsWrongWithARequestIsSaidBeforeAnyWork) {
    const auto message_of = [&](const std::function<void(MeasureRequest&)>& change) {
        MeasureRequest request = small_request();
        change(request);
        try {
            (void)measure(request, catalogue_);
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            return std::string(error.what());
        }
        return std::string("nothing was refused");
    };
    EXPECT_THAT(message_of([](auto& r) { r.techniques = {"crytec"}; }), HasSubstr("crytec"));
    EXPECT_THAT(message_of([](auto& r) { r.techniques = {"reference"}; }), HasSubstr("truth"));
    EXPECT_THAT(message_of([](auto& r) { r.scenes = {"sponza"}; }), HasSubstr("sponza"));
    EXPECT_THAT(message_of([](auto& r) { r.filters = {"blur"}; }), HasSubstr("blur"));
    EXPECT_THAT(message_of([](auto& r) { r.samples = {12}; }), HasSubstr("multiples of 8"));
    EXPECT_THAT(message_of([](auto& r) { r.samples = {0}; }), HasSubstr("--samples"));
    EXPECT_THAT(message_of([](auto& r) { r.width = 0; }), HasSubstr("--size"));
    EXPECT_THAT(message_of([](auto& r) { r.rays = 0; }), HasSubstr("--rays"));
    EXPECT_THAT(message_of([](auto& r) { r.runs = 0; }), HasSubstr("--runs"));
    EXPECT_THAT(message_of([](auto& r) { r.scenes = {"empty"}; }), HasSubstr("triangle"));
    EXPECT_THAT(message_of([](auto& r) { r.write_study = "x.toml"; }), HasSubstr("--fit"));
    EXPECT_THAT(message_of([](auto& r) { r.growth = r.hard_cases = true; }),
                HasSubstr("--growth and --hard-cases exclude each other"));
    EXPECT_THAT(message_of([](auto& r) { r.growth = r.fit = true; }), HasSubstr("--growth"));
}

TEST(Timers, TheClockIsUsedWhereTheQueriesDisagreeOrTheRendererIsSoftware) {
    EXPECT_FALSE(judge_timers(77.0, 1.0, true).use_queries);
    EXPECT_FALSE(judge_timers(77.0, 77.0, true).use_queries);
    EXPECT_FALSE(judge_timers(30.0, 26.0, false).use_queries);
    EXPECT_THAT(judge_timers(30.0, 26.0, false).sentence, HasSubstr("more than 10 %"));
    EXPECT_TRUE(judge_timers(30.0, 29.0, false).use_queries);
    EXPECT_FALSE(judge_timers(2.0, 2.0, false).use_queries) << "too short to be held against";
    EXPECT_FALSE(judge_timers(0.0, 0.0, false).use_queries);
}

TEST(Fits, VaryWhatTheDescriptorLetsThemAndNeverSamples) {
    renderer::Variant choice;
    choice.technique = "blizzard";
    choice.samples = 24;
    choice.parameters["radius_m"] = 100.0;
    std::vector<std::string> names;
    for (const analysis::Unknown& unknown : unknowns_of(choice)) {
        names.push_back(unknown.name);
        EXPECT_GE(unknown.start, unknown.low);
        EXPECT_LE(unknown.start, unknown.high);
        if (unknown.name == "radius_m") {
            EXPECT_EQ(unknown.high, 1000.0) << "the descriptor's end";
        }
    }
    EXPECT_THAT(names,
                testing::ElementsAre("radius_m", "full_threshold_m", "no_threshold_m", "power"));
}

TEST(StudyWriter, ReplacesOneSideAndLeavesTheRestOfTheTextAlone) {
    const std::string text = stimuli::study_source("").text;
    const std::map<std::string, double> values{{"radius_m", 0.123456789012345}, {"power", 3.0}};
    const stimuli::Condition before = *stimuli::load_study("").find_condition("IV");
    const std::string changed = stimuli::with_variants(text, "study", {{"IV", 'a', values}});
    const stimuli::Study study = stimuli::parse_study(changed, "changed");
    std::map<std::string, double> expected = before.a.parameters;
    for (const auto& [name, value] : values) expected[name] = value;
    EXPECT_EQ(study.find_condition("IV")->a.parameters, expected);
    EXPECT_EQ(study.find_condition("VI")->b.parameters,
              stimuli::load_study("").find_condition("VI")->b.parameters);
    EXPECT_THAT(changed, HasSubstr("# The techniques of a pair reach over the same area"));
}

}  // namespace
}  // namespace obscura::app
