// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <thread>

#include "app/explorer/colour_scale.h"
#include "app/explorer/fields.h"
#include "app/explorer/history.h"
#include "app/explorer/layout.h"
#include "app/explorer/pacer.h"
#include "app/explorer/presets.h"
#include "app/explorer/remembered.h"
#include "app/explorer/truth.h"
#include "app/explorer/truth_worker.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "stimuli/paper_configurations.h"
#include "tests/app/explorer/made_model.h"

namespace obscura::app::explorer {
namespace {

using testing::HasSubstr;

TEST(ExplorerHistory, EveryChangeCanBeUndoneAndRedone) {
    History<int> history(0);
    for (int i = 1; i <= 10; ++i) history.change(i, "");
    for (int i = 9; i >= 0; --i) {
        history.go_back();
        EXPECT_EQ(history.now(), i);
    }
    EXPECT_FALSE(history.can_go_back());
    for (int i = 1; i <= 10; ++i) {
        history.go_forward();
        EXPECT_EQ(history.now(), i);
    }
    EXPECT_FALSE(history.can_go_forward());
}

TEST(ExplorerHistory, ADragIsOneStepAndTheNextDragAnother) {
    History<int> history(0);
    for (int i = 1; i <= 5; ++i) history.change(i, "a radius_m");
    history.settle();
    for (int i = 6; i <= 9; ++i) history.change(i, "a radius_m");
    history.go_back();
    EXPECT_EQ(history.now(), 5);
    history.go_back();
    EXPECT_EQ(history.now(), 0);
}

TEST(ExplorerHistory, AChangeAfterGoingBackForgetsWhatCameLater) {
    History<int> history(0);
    history.change(1, "");
    history.change(2, "");
    history.go_back();
    history.change(3, "");
    EXPECT_FALSE(history.can_go_forward());
    history.go_back();
    EXPECT_EQ(history.now(), 1);
}

TEST(ExplorerPacer, ASlowSceneIsDrawnSmallerAndAQuickOneLarger) {
    Pacer pacer(55.0, false);
    for (int i = 0; i < 20; ++i) pacer.took(pacer.divisor(), 200.0 / pacer.divisor());
    EXPECT_EQ(pacer.divisor(), 4);
    pacer.forget();
    for (int i = 0; i < 20; ++i) pacer.took(pacer.divisor(), 10.0 / pacer.divisor());
    EXPECT_EQ(pacer.divisor(), 1);
}

TEST(ExplorerPacer, TwoSizesDoNotTakeTurns) {
    // 1/2 takes 40 ms, the whole 100: it stays at 1/2 but for a rare try.
    Pacer pacer(55.0, false);
    int changes = 0;
    int before = pacer.divisor();
    for (int i = 0; i < 200; ++i) {
        pacer.took(pacer.divisor(), pacer.divisor() == 1 ? 100.0 : 40.0);
        if (pacer.divisor() != before) ++changes;
        before = pacer.divisor();
    }
    EXPECT_LE(changes, 6);
}

TEST(ExplorerPacer, OnAGraphicsCardTheSizeIsAlwaysWhole) {
    Pacer pacer(55.0, true);
    for (int i = 0; i < 20; ++i) pacer.took(1, 500.0);
    EXPECT_EQ(pacer.divisor(), 1);
    pacer.took(1, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(pacer.divisor(), 1);
}

TEST(ExplorerLayout, NonsenseBecomesWhatCanBeShown) {
    Layout layout;
    layout.split = std::numeric_limits<float>::quiet_NaN();
    layout.flicker_hz = 1e9;
    layout.zoom = -3.0F;
    layout.error_range = 0.0F;
    layout.panes[2] = {'q', "no such layer"};
    const Layout sane = layout.sane();
    EXPECT_EQ(sane.split, 0.5F);
    EXPECT_EQ(sane.flicker_hz, kMostFlicker_hz);
    EXPECT_GE(sane.zoom, 0.0F);
    EXPECT_GT(sane.error_range, 0.0F);
    EXPECT_EQ(sane.panes[2].side, 'a');
    EXPECT_EQ(sane.panes[2].layer, layer::kImage);
}

TEST(ExplorerLayout, FlickerShowsAAndBInTurnAtItsRate) {
    Layout layout;
    layout.arrangement = Arrangement::kFlicker;
    layout.flicker_hz = 2.0;
    EXPECT_EQ(layout.visible(0.1).front().side, 'a');
    EXPECT_EQ(layout.visible(0.6).front().side, 'b');
    EXPECT_EQ(layout.visible(1.1).front().side, 'a');
    EXPECT_EQ(layout.ever_visible().size(), 2U);
}

TEST(ExplorerLayout, ZoomStepsGoFromTheWholeImageToLargePixelsAndBack) {
    for (const float whole : {0.01F, 0.3F, 0.5F, 0.7F, 1.0F, 3.0F, kMostZoom}) {
        float zoom = 0.0F;
        for (int i = 0; i < 30; ++i) {
            const float next = next_zoom(zoom, true, whole);
            EXPECT_TRUE(next > std::max(zoom, whole) || next == kMostZoom) << whole;
            zoom = next;
        }
        EXPECT_EQ(zoom, kMostZoom);
        for (int i = 0; i < 30; ++i) zoom = next_zoom(zoom, false, whole);
        EXPECT_EQ(zoom, 0.0F);
    }
}

TEST(ExplorerScales, LightnessRisesAlongViridisAndFallsFromTheErrorsMiddle) {
    const auto lightness = [](const Rgb& c) {
        return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    };
    for (int i = 1; i <= 50; ++i) {
        const float low = static_cast<float>(i - 1) / 50.0F;
        const float high = static_cast<float>(i) / 50.0F;
        EXPECT_GT(lightness(viridis(high)), lightness(viridis(low)) - 0.5);
        EXPECT_LT(lightness(orange_to_blue(high)), lightness(orange_to_blue(low)) + 0.5);
        EXPECT_LT(lightness(orange_to_blue(-high)), lightness(orange_to_blue(-low)) + 0.5);
    }
}

TEST(ExplorerScales, TheErrorsTwoSignsDifferForPeopleWithoutRedOrGreenCones) {
    // What dichromats keep is mostly blue against yellow: the blue channel less the mean of the
    // others tells the signs apart at every size of error.
    const auto blueness = [](const Rgb& c) { return c[2] - 0.5 * (c[0] + c[1]); };
    for (const float size : {0.2F, 0.4F, 0.6F, 0.8F, 1.0F}) {
        EXPECT_GT(blueness(orange_to_blue(size)), blueness(orange_to_blue(-size)) + 20.0) << size;
    }
}

TEST(ExplorerScales, WhatIsNoNumberHasAColourOfItsOwn) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(grey(nan), kNotANumber);
    EXPECT_EQ(viridis(nan), kNotANumber);
    EXPECT_EQ(orange_to_blue(nan), kNotANumber);
}

TEST(ExplorerTruth, TilesNearThePointerComeFirstAndEveryTileOnceARound) {
    Truth truth(200, 100);
    std::vector<int> seen;
    for (int i = 0; i < 28; ++i) {
        const auto tile = truth.take_tile(150.0, 50.0);
        ASSERT_TRUE(tile);
        EXPECT_EQ(tile->round, 0);
        seen.push_back(tile->number);
    }
    EXPECT_EQ(seen.front(), 1 * 7 + 4);
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(std::unique(seen.begin(), seen.end()), seen.end());
    EXPECT_EQ(truth.take_tile(0.0, 0.0)->round, 1);
}

TEST(ExplorerTruth, ItsMeanAndErrorAreThoseOfItsRounds) {
    Truth truth(3, 2);
    const std::vector<float> first{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F};
    const std::vector<float> second{0.3F, 0.2F, 0.3F, 0.4F, 0.5F, 1.0F};
    const std::vector<float> error(6, 0.1F);
    for (const auto* values : {&first, &second}) {
        truth.add(*truth.take_tile(0.0, 0.0), *values, error);
    }
    EXPECT_NEAR(truth.accessibility(0), 0.2, 1e-6);
    EXPECT_NEAR(truth.accessibility(5), 0.8, 1e-6);
    EXPECT_NEAR(truth.standard_error(0), 0.1 / std::sqrt(2.0), 1e-6);
    EXPECT_EQ(truth.least_rays(), 2 * Truth::kRaysOfRound);
}

TEST(ExplorerTruth, ItEndsAfterItsMostRays) {
    Truth truth(1, 1);
    for (int i = 0; i < Truth::kMostRounds; ++i) {
        truth.add(*truth.take_tile(0.0, 0.0), {0.5F}, {0.1F});
    }
    EXPECT_FALSE(truth.take_tile(0.0, 0.0));
    EXPECT_TRUE(truth.done());
}

TEST(ExplorerTruth, TheThreadsEndThoughMostOfTheirWorkIsLeft) {
    TruthWorker worker([] {}, 2);
    const auto scene = made_wall();
    // Billions of rays: nobody would wait for them.
    worker.start({1, scene, scene->opened().scene->cameras.front(), 2048, 2048, 0.5});
    while (!worker.snapshot(1)) std::this_thread::yield();
    EXPECT_LT(worker.snapshot(1)->mean_rays(), Truth::kRaysOfRound);
    EXPECT_FALSE(worker.snapshot(2)) << "it is of another view";
}

/// The wall, and a floor before it.
std::shared_ptr<LoadedScene> wall_and_floor() {
    stimuli::OpenedScene opened = made_wall()->opened();
    renderer::Scene scene = *opened.scene;
    renderer::Mesh floor = scene.meshes.front();
    floor.vertices[0].position_m = {-2.0F, -0.2F, 0.0F};
    floor.vertices[1].position_m = {0.0F, -0.2F, 3.0F};
    floor.vertices[2].position_m = {2.0F, -0.2F, 0.0F};
    scene.meshes.push_back(floor);
    opened.scene = std::make_shared<renderer::Scene>(std::move(scene));
    return std::make_shared<LoadedScene>(std::move(opened));
}

TEST(ExplorerTruth, ItIsTheReferencesWithinBothStandardErrors) {
    const auto scene = wall_and_floor();
    const renderer::Camera& camera = scene->opened().scene->cameras.front();
    TruthWorker worker([] {}, 2);
    worker.start({7, scene, camera, 32, 18, 0.5});
    while (!worker.snapshot(7) || worker.snapshot(7)->least_rays() < 256) std::this_thread::yield();
    const auto truth = worker.snapshot(7);
    renderer::ReferenceOptions options;
    options.radius_m = 0.5;
    options.rays = 1024;
    options.seed = 4242;
    const auto reference = scene->rays().trace(camera, 32, 18, options);
    int occluded = 0;
    for (std::size_t i = 0; i < reference.accessibility.size(); ++i) {
        const double error = std::hypot(truth->standard_error(i), reference.standard_error[i]);
        EXPECT_NEAR(truth->accessibility(i), reference.accessibility[i], 5.0 * error + 1e-6) << i;
        occluded += reference.accessibility[i] < 0.95F ? 1 : 0;
    }
    EXPECT_GT(occluded, 20) << "the scene shows a corner";
}

TEST(ExplorerFields, WhatIsTypedMustBeANumberOfTheRange) {
    const NumberField field{"radius_m", "", "m", 0.01, 10.0, 0.5, false, 0.5};
    std::string problem;
    EXPECT_EQ(typed_number(field, " 0.25 ", problem), 0.25);
    EXPECT_EQ(typed_number(field, "+1e0", problem), 1.0);
    for (const char* text : {"", " ", "nan", "inf", "-1", "1e400", "0.5 m", "1,5", "abc", "11"}) {
        problem.clear();
        EXPECT_FALSE(typed_number(field, text, problem)) << text;
        EXPECT_THAT(problem, HasSubstr("radius_m"));
        EXPECT_THAT(problem, HasSubstr("0.01 to 10 m"));
    }
    const NumberField whole{"samples", "", "", 1.0, 64.0, 24.0, true, 24.0};
    EXPECT_FALSE(typed_number(whole, "2.5", problem));
    EXPECT_THAT(problem, HasSubstr("whole number"));
}

TEST(ExplorerRemembered, WhatIsKeptComesBack) {
    Remembered kept{1234, 567, "a \"b\" \\ c.glb", 1.5F, false, {}};
    kept.layout.arrangement = Arrangement::kFour;
    kept.layout.panes[3] = {'b', layer::kDepth};
    kept.layout.error_range = 0.5F;
    const Remembered back = remembered_from(to_json(kept));
    EXPECT_EQ(back.window_width, 1234);
    EXPECT_EQ(back.window_height, 567);
    EXPECT_EQ(back.what, kept.what);
    EXPECT_EQ(back.text_scale, 1.5F);
    EXPECT_FALSE(back.panels);
    EXPECT_EQ(back.layout, kept.layout);
}

TEST(ExplorerRemembered, NonsenseIsAsIfNothingHadBeenKept) {
    for (const char* text : {"", "{", "[]", "null", "{\"window\": [1e99, \"x\"], \"layout\": 3}",
                             "{\"window\": [-5, 99999999], \"layout\": {\"panes\": [1, {}, "
                             "{\"side\": 4}], \"split\": \"x\"}, \"text_scale\": 1e30}"}) {
        const Remembered back = remembered_from(text);
        EXPECT_GE(back.window_width, 0) << text;
        EXPECT_LE(back.window_height, 16384) << text;
        EXPECT_LE(back.text_scale, 3.0F) << text;
        EXPECT_EQ(back.layout, Layout{}.sane()) << text;
    }
}

TEST(ExplorerPresets, AreThosePapersCompareWithTheRadiusOfTheScene) {
    std::size_t found = 0;
    for (const renderer::Technique& technique : renderer::techniques()) {
        renderer::Variant now = renderer::standard_variant(technique);
        if (technique.find_parameter("radius_m") != nullptr) now.parameters["radius_m"] = 0.3125;
        for (const Preset& preset : presets_of(now, std::nullopt)) {
            EXPECT_TRUE(renderer::problems_of(preset.variant).empty()) << preset.name;
            EXPECT_EQ(preset.variant.technique, technique.name);
            const auto radius = preset.variant.parameters.find("radius_m");
            if (radius != preset.variant.parameters.end()) {
                EXPECT_EQ(radius->second, 0.3125);
            }
            if (preset.name.find(" 20") != std::string::npos) ++found;
        }
    }
    EXPECT_EQ(found, stimuli::paper_configurations().size());
}

TEST(ExplorerPresets, AreWhatAFitFoundOnThisScene) {
    const std::vector<FittedValues> fitted = {{"atrium", "blizzard", {{"power", 12.5}}, "0.1"},
                                              {"relic", "blizzard", {{"power", 3.0}}, "0.2"}};
    const auto now = renderer::standard_variant(*renderer::find_technique("blizzard"));
    int found = 0;
    for (const Preset& preset : presets_of(now, std::nullopt, fitted, "atrium")) {
        if (preset.name != "fitted on atrium") continue;
        ++found;
        EXPECT_EQ(preset.variant.parameters.at("power"), 12.5);
    }
    EXPECT_EQ(found, 1);
}

TEST(ExplorerPresets, OfAFitAreReadAsMeasureWritesThemAndRefusedWithTheirLineOtherwise) {
    const auto file =
        std::filesystem::temp_directory_path() / fmt::format("obscura-fitted-{}.csv", ::getpid());
    EXPECT_TRUE(read_fitted_values(file).empty());
    const std::string head =
        "scene_id,scene,technique,samples,blur,parameter,published,fitted,"
        "training_rmse_published,training_rmse_fitted,evaluations,same_view\n";
    base::write_file_atomically(file, head +
                                          "a,atrium,hbao,16,none,bias,0.5,0.25,0.2,0.1,50,false\n"
                                          "a,atrium,hbao,16,none,power,1,2,0.2,0.1,50,false\n");
    const auto values = read_fitted_values(file);
    ASSERT_EQ(values.size(), 1U);
    EXPECT_EQ(values[0].parameters, (std::map<std::string, double>{{"bias", 0.25}, {"power", 2}}));
    base::write_file_atomically(file,
                                head + "a,atrium,hbao,16,none,bias,0.5,nan,0.2,0.1,5,false\n");
    try {
        (void)read_fitted_values(file);
        ADD_FAILURE() << "nan was read";
    } catch (const base::Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr(":2: fitted is \"nan\""));
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace obscura::app::explorer
