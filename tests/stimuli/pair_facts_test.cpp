// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What is measured of a pair's images: their error against the truth, and how bright they are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/files.h"
#include "stimuli/accuracy.h"
#include "stimuli/generate.h"
#include "stimuli/pairs.h"
#include "stimuli/study_reader.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scenes.h"

namespace obscura::stimuli {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

renderer::Scene build_paired_block() {
    renderer::Scene scene = tests::empty_scene();
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 0.5F, -4.0F});
    scene.cameras.push_back(tests::forward_camera());
    return scene;
}

renderer::Lighting light_of(Validity validity) {
    renderer::Lighting lighting;
    lighting.ambient = glm::vec3(0.6F);
    if (validity == Validity::kHigh) {
        lighting.tone_mapping = renderer::ToneMapping{};
        lighting.lights = {{glm::vec3(0.0F, 1.0F, 0.0F), glm::vec3(2.0F)}};
    }
    return lighting;
}

const std::vector<BuiltinScene>& block_catalogue() {
    static const std::vector<BuiltinScene> list = {BuiltinScene{"block",
                                                                "A block on a floor",
                                                                "nothing",
                                                                {Validity::kLow, Validity::kHigh},
                                                                {"forward"},
                                                                build_paired_block,
                                                                light_of}};
    return list;
}

class PairFacts : public testing::Test {
  protected:
    void SetUp() override {
        study_.name = "blocks";
        study_.width = 96;
        study_.height = 54;
        study_.scenes = {{"dim", "block", "forward", Validity::kLow},
                         {"lit", "block", "forward", Validity::kHigh}};
    }
    Condition& add(const std::string& id, const std::string& scene, const renderer::Variant& a,
                   const renderer::Variant& b) {
        Condition condition;
        condition.id = id;
        condition.scene = scene;
        condition.a = a;
        condition.b = b;
        study_.conditions.push_back(condition);
        return study_.conditions.back();
    }
    /// A hypothesis that b of these conditions is the more accurate image.
    void claim(std::vector<std::string> conditions) {
        Hypothesis hypothesis;
        hypothesis.id = "H";
        hypothesis.accuracy = true;
        hypothesis.conditions = std::move(conditions);
        study_.hypotheses.push_back(hypothesis);
    }
    Generated make() { return generate(study_, {}, folder_, true, block_catalogue()); }
    [[nodiscard]] Manifest manifest() const { return load_manifest(folder_ / "manifest.json"); }

    const renderer::Variant none_{"none"};
    const renderer::Variant blizzard_{"blizzard", 24, {}, "separable"};
    const renderer::Variant truth_{"reference", 256, {{"radius_m", 0.5}}, "none"};
    tests::TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path() / "images";
    Study study_;
};

TEST(SparseTruth, IsWhatTheWholeImagesPixelsShow) {
    const renderer::ReferenceScene rays(build_paired_block());
    const renderer::Camera camera = tests::forward_camera();
    const int width = 230;  // no multiple of the step
    const int height = 131;
    const SparseTruth sparse = sparse_truth(rays, camera, width, height, 0.5);
    ASSERT_EQ(sparse.step, 3);
    const renderer::ReferenceImage whole = rays.trace(camera, width, height, {.rays = 16});
    for (int y = 0; y < sparse.image.height; ++y) {
        for (int x = 0; x < sparse.image.width; ++x) {
            const float met =
                sparse.image.depth_m[static_cast<std::size_t>(y * sparse.image.width + x)];
            const float wanted = whole.depth_m[sparse.whole_pixel(x, y)];
            ASSERT_NEAR(met / wanted, 1.0, 1e-3) << x << ' ' << y;
        }
    }
}

TEST_F(PairFacts, TheTruthIsAskedForAtTheRadiusOfBElseOfA) {
    const Condition& both = add("both", "dim", truth_, blizzard_);
    EXPECT_EQ(truth_radius_m(both), blizzard_.all_parameters().at("radius_m"));
    EXPECT_EQ(truth_radius_m(add("first", "dim", truth_, none_)), 0.5);
    EXPECT_EQ(truth_radius_m(add("neither", "dim", none_, {"crytek", 24, {}, "none"})),
              std::nullopt);
}

TEST_F(PairFacts, BothImagesErrorsAndWhichIsTheMoreAccurateAreInTheManifest) {
    add("claimed", "dim", none_, truth_);
    EXPECT_THAT(make().warnings, IsEmpty());
    const Manifest made = manifest();
    const ManifestImage& a = *made.find("claimed", "a");
    const ManifestImage& b = *made.find("claimed", "b");
    ASSERT_TRUE(a.accuracy && b.accuracy);
    EXPECT_LT(b.accuracy->rmse, 0.03) << "the noise of 256 rays on both sides";
    EXPECT_NEAR(b.accuracy->bias, 0.0, 0.005);
    EXPECT_GT(a.accuracy->bias, 0.01) << "what computes no occlusion is too bright";
    EXPECT_EQ(a.accuracy->radius_m, 0.5);
    EXPECT_EQ(more_accurate(a, b), 'b');
    EXPECT_THAT(base::read_file(folder_ / "manifest.json"),
                AllOf(HasSubstr("\"more_accurate\": \"b\""), HasSubstr("\"contrast_change\": "),
                      HasSubstr("\"mean_luminance_change\": -")));
    EXPECT_THAT(facts_of(study_, made, made.pairs),
                ElementsAre(AllOf(HasSubstr("condition \"claimed\""),
                                  HasSubstr("% of the pixels differ noticeably"),
                                  HasSubstr("mean luminance"), HasSubstr("contrast"),
                                  HasSubstr("b is the more accurate by"))));
}

TEST_F(PairFacts, AClaimOfAccuracyIsHeldAgainstTheTruth) {
    renderer::Variant twin = blizzard_;
    twin.parameters["power"] = 1.02 * blizzard_.all_parameters().at("power");
    add("right", "dim", none_, truth_);
    add("reversed", "dim", truth_, none_);
    add("alike", "dim", blizzard_, twin);
    claim({"right", "reversed", "alike"});
    (void)make();
    const auto told = AllOf(HasSubstr("condition"), HasSubstr("hypothesis H"), HasSubstr("RMSE"));
    EXPECT_THAT(disordered_claims(study_, manifest()),
                ElementsAre(AllOf(told, HasSubstr("\"reversed\""), HasSubstr("a is")),
                            AllOf(told, HasSubstr("\"alike\""), HasSubstr("neither"))));
    study_.hypotheses[0].accuracy = false;
    EXPECT_THAT(disordered_claims(study_, manifest()), IsEmpty());
}

TEST_F(PairFacts, AMatchedPairIsEquallyBrightByAFactorThatTheManifestNames) {
    const renderer::Variant strong{"reference", 64, {{"radius_m", 3.0}}, "none"};
    add("dim", "dim", none_, strong);
    add("lit", "lit", none_, strong);
    (void)make();
    const Manifest before = manifest();
    study_.match_luminance = true;
    EXPECT_EQ(make().made, 2) << "the first images stay";
    const Manifest after = manifest();
    for (const std::string id : {"dim", "lit"}) {
        const ManifestImage& a = *after.find(id, "a");
        const ManifestImage& b = *after.find(id, "b");
        EXPECT_LT(*before.find(id, "b")->mean_luminance, 0.998 * *a.mean_luminance) << id;
        EXPECT_NEAR(*b.mean_luminance / *a.mean_luminance, 1.0, 0.0012) << id;
        EXPECT_EQ(a.sha256, before.find(id, "a")->sha256) << id;
        EXPECT_FALSE(a.exposure_factor) << id;
        ASSERT_TRUE(b.exposure_factor) << id;
        EXPECT_GT(*b.exposure_factor, 1.0) << id;
        EXPECT_EQ(*b.accuracy, *before.find(id, "b")->accuracy) << "accessibility is as it was";
    }
    EXPECT_THAT(problems_of_stimuli(study_, folder_), IsEmpty());
    EXPECT_THAT(verify(study_, {}, folder_, true, block_catalogue()).problems, IsEmpty());
    study_.match_luminance = false;
    EXPECT_EQ(problems_of_stimuli(study_, folder_).size(), 2U) << "the second images were exposed";
}

TEST_F(PairFacts, ASecondImageFollowsTheFirstThatItIsMatchedTo) {
    study_.match_luminance = true;
    add("dim", "dim", none_, blizzard_);
    (void)make();
    EXPECT_EQ(make().made, 0);
    study_.conditions[0].a = truth_;
    EXPECT_EQ(make().made, 2);
}

}  // namespace
}  // namespace obscura::stimuli
