// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Pairs whose two images nobody could tell apart: found, told with the likely reason, and refused
// unless the study means them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "stimuli/generate.h"
#include "stimuli/pairs.h"
#include "stimuli/png.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scenes.h"

namespace obscura::stimuli {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A block on a floor, all of it `scale` times as large as in metres; of glass where `glass`.
renderer::Scene build_scaled_block(float scale, bool glass) {
    renderer::Scene scene = tests::empty_scene();
    tests::add_quad(scene, scale * glm::vec3(-20.0F, -1.0F, 0.0F), {40.0F * scale, 0.0F, 0.0F},
                    {0.0F, 0.0F, -40.0F * scale});
    tests::add_box(scene, scale * glm::vec3(-1.0F, -1.0F, -6.0F),
                   scale * glm::vec3(1.0F, 0.5F, -4.0F));
    if (glass) {
        scene.materials[0].name = "ghost";
        scene.materials[0].coverage = renderer::Coverage::kBlended;
        scene.materials[0].opacity = 0.0F;
    }
    renderer::Camera camera = tests::forward_camera();
    camera.far_m *= scale;
    scene.cameras.push_back(camera);
    camera.name = "away";
    camera.target_m = {0.0F, 0.0F, 1.0F};
    scene.cameras.push_back(camera);
    camera.name = "short";
    camera.target_m = {0.0F, 1.0F, -1.0F};
    camera.near_m = 1e-4F;
    camera.far_m = 2e-3F;
    scene.cameras.push_back(camera);
    return scene;
}

const std::vector<BuiltinScene>& alike_catalogue() {
    const auto entry = [](const char* id, renderer::Scene (*build)()) {
        return BuiltinScene{id,
                            "A block on a floor",
                            "nothing",
                            {Validity::kLow},
                            {"forward", "away", "short"},
                            build,
                            [](Validity) { return renderer::Lighting{}; }};
    };
    static const std::vector<BuiltinScene> list = {
        entry("metres", [] { return build_scaled_block(1.0F, false); }),
        entry("centimetres", [] { return build_scaled_block(100.0F, false); }),
        entry("glass", [] { return build_scaled_block(1.0F, true); })};
    return list;
}

class AlikePairs : public testing::Test {
  protected:
    void SetUp() override {
        study_.name = "blocks";
        study_.width = 96;
        study_.height = 54;
        add("seen", "metres", "forward");
    }
    /// A pair without and with occlusion.
    Condition& add(const std::string& id, const std::string& source, const std::string& camera) {
        study_.scenes.push_back({id, source, camera, Validity::kLow});
        Condition condition;
        condition.id = id;
        condition.scene = id;
        condition.b = {"blizzard", 24, {}, "separable"};
        study_.conditions.push_back(condition);
        return study_.conditions.back();
    }
    Generated make() { return generate(study_, {}, folder_, true, alike_catalogue()); }
    [[nodiscard]] std::vector<std::string> told() const {
        return warnings_of(study_, compared_pairs(study_, folder_));
    }

    tests::TemporaryFolder temporary_;
    std::filesystem::path folder_ = temporary_.path() / "images";
    Study study_;
};

TEST_F(AlikePairs, APairThatDiffersIsNotToldOfAndItsDifferenceIsInTheManifest) {
    EXPECT_THAT(make().warnings, IsEmpty());
    const Manifest manifest = load_manifest(folder_ / "manifest.json");
    ASSERT_EQ(manifest.pairs.size(), 1U);
    const ManifestPair& pair = manifest.pairs.front();
    EXPECT_EQ(pair.condition, "seen");
    EXPECT_EQ(pair.a_sha256, manifest.find("seen", "a")->sha256);
    EXPECT_EQ(pair.b_sha256, manifest.find("seen", "b")->sha256);
    EXPECT_EQ(pair.reason, "");
    EXPECT_TRUE(pair.difference.can_be_seen());
    const auto image = [&](const char* file) {
        return decode_png(base::read_file(folder_ / file), file);
    };
    EXPECT_EQ(pair.difference, difference_of(image("seen-a.png"), image("seen-b.png")));
}

TEST_F(AlikePairs, ARadiusOfNoPixelIsToldWithTheScenesSize) {
    add("unit", "centimetres", "forward");
    const auto sentence =
        ElementsAre(AllOf(HasSubstr("condition \"unit\""), HasSubstr("the same to the byte"),
                          HasSubstr("radius_m 0.5 of b covers"), HasSubstr("4e+03 x 150 x 4e+03 m"),
                          HasSubstr("scale")));
    EXPECT_THAT(make().warnings, sentence);
    EXPECT_THAT(told(), sentence) << "from the manifest, without rendering";
    EXPECT_THAT(make().warnings, sentence) << "of images that were kept";
    EXPECT_THAT(verify(study_, {}, folder_, true, alike_catalogue()).warnings, sentence);
}

TEST_F(AlikePairs, ACameraThatSeesNothingIsToldWithWhereTheSceneIs) {
    add("behind", "metres", "away");
    add("near", "metres", "short");
    EXPECT_THAT(make().warnings,
                ElementsAre(AllOf(HasSubstr("condition \"behind\""), HasSubstr("sees no surface"),
                                  HasSubstr("behind it")),
                            AllOf(HasSubstr("condition \"near\""), HasSubstr("sees no surface"))));
}

TEST_F(AlikePairs, InvisibleSurfacesAreToldByMaterialAndOpacity) {
    add("glass", "glass", "forward");
    EXPECT_THAT(make().warnings,
                ElementsAre(AllOf(HasSubstr("condition \"glass\""), HasSubstr("transparent"),
                                  HasSubstr("\"ghost\" 0"))));
}

TEST_F(AlikePairs, TheSameAccessibilityOnBothSidesIsTold) {
    Condition& condition = add("twins", "metres", "forward");
    condition.a = condition.b;
    condition.a.parameters["no_threshold_m"] = 1e4;  // beyond all there is, as the standard is
    condition.b.parameters["no_threshold_m"] = 9e3;
    EXPECT_THAT(make().warnings, ElementsAre(AllOf(HasSubstr("condition \"twins\""),
                                                   HasSubstr("have the same accessibility"))));
}

TEST_F(AlikePairs, APairThatIsMeantToBeAlikeIsNotToldOf) {
    add("away", "metres", "away").identical = true;
    EXPECT_THAT(make().warnings, IsEmpty());
    EXPECT_THAT(alike_pairs(study_, compared_pairs(study_, folder_)), IsEmpty());
}

TEST_F(AlikePairs, APairThatIsMeantToBeAlikeAndDiffersIsTold) {
    study_.conditions[0].identical = true;
    const auto sentence =
        ElementsAre(AllOf(HasSubstr("condition \"seen\""), HasSubstr("marked as identical"),
                          HasSubstr("% of the pixels")));
    EXPECT_THAT(make().warnings, sentence);
    EXPECT_THAT(told(), sentence);
    EXPECT_THAT(alike_pairs(study_, compared_pairs(study_, folder_)), IsEmpty());
}

TEST_F(AlikePairs, AHandfulOfPixelsOneCodeValueApartIsToldWithWhatWasMeasured) {
    make();
    Manifest manifest = load_manifest(folder_ / "manifest.json");
    RgbImage image = decode_png(base::read_file(folder_ / "seen-a.png"), "seen-a.png");
    for (std::size_t i = 0; i < 30; ++i) image.rgb[i] ^= 1;
    const std::string bytes = encode_png(image);
    base::write_file_atomically(folder_ / "seen-b.png", bytes);
    manifest.images[1].sha256 = base::sha256_hex(bytes);
    save_manifest(folder_ / "manifest.json", manifest);  // its pair is of other images
    EXPECT_THAT(told(), ElementsAre(AllOf(HasSubstr("differ less than anyone can see"),
                                          HasSubstr("0.193 % of their pixels differ"),
                                          HasSubstr("just-noticeable 2.3"),
                                          HasSubstr("visible is 0.01 %"))));
}

TEST_F(AlikePairs, ImagesThatTheStudyNoLongerAsksForAreNotCompared) {
    add("unit", "centimetres", "forward");
    make();
    study_.conditions[1].b.parameters["radius_m"] = 50.0;
    EXPECT_THAT(told(), IsEmpty());
}

}  // namespace
}  // namespace obscura::stimuli
