// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/variant_names.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "renderer/technique/technique.h"
#include "renderer/technique/variant_names.h"
#include "stimuli/study_reader.h"
#include "stimuli/view_names.h"
#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {
namespace {

using renderer::Variant;
using testing::ElementsAre;

Variant blizzard(int samples, std::map<std::string, double> parameters,
                 const std::string& denoise = "separable") {
    return {"blizzard", samples, std::move(parameters), denoise};
}

TEST(VariantNames, AreTechniqueAndSamplesWhereThatTellsThemApart) {
    EXPECT_THAT(
        renderer::variant_names(
            {{"none"}, blizzard(24, {}), blizzard(8, {}), blizzard(24, {}), {"raymarch", 30}}),
        ElementsAre("None", "Blizzard24", "Blizzard8", "Blizzard24", "RayMarching30"));
}

TEST(VariantNames, SayWhatDiffersAndNoMore) {
    EXPECT_THAT(renderer::variant_names({blizzard(8, {{"radius_m", .2}, {"power", 400}}),
                                         blizzard(8, {{"radius_m", .9}, {"power", 200}}),
                                         blizzard(24, {{"radius_m", .9}})}),
                ElementsAre("Blizzard8 R 0.2", "Blizzard8 R 0.9", "Blizzard24"));
    EXPECT_THAT(renderer::variant_names({blizzard(24, {}, "none"), blizzard(24, {})}),
                ElementsAre("Blizzard24 denoise none", "Blizzard24 denoise separable"));
    EXPECT_THAT(renderer::variant_names({blizzard(24, {{"radius_m", .1}}),
                                         blizzard(24, {{"radius_m", .3}, {"power", 400}}),
                                         blizzard(24, {{"radius_m", .3}, {"power", 500}})}),
                ElementsAre("Blizzard24 R 0.1", "Blizzard24 R 0.3 power 400",
                            "Blizzard24 R 0.3 power 500"));
}

TEST(VariantNames, AreTheSameForTheSameSettingsWhetherTheStandardIsNamedOrNot) {
    const renderer::Technique& technique = *renderer::find_technique("blizzard");
    const double standard = technique.find_parameter("radius_m")->standard;
    const auto names = renderer::variant_names({blizzard(24, {{"radius_m", standard}}),
                                                blizzard(24, {}), blizzard(24, {{"radius_m", 9}})});
    EXPECT_EQ(names[0], names[1]);
    EXPECT_NE(names[0], names[2]);
}

TEST(VariantNames, DifferWheneverAnySettingDoes) {
    std::vector<Variant> choices;
    for (const renderer::Technique& technique : renderer::techniques()) {
        for (const int samples : {technique.samples.low, technique.samples.high}) {
            for (const char* denoise : {"none", "separable"}) {
                choices.push_back({technique.name, samples, {}, denoise});
                for (const renderer::Parameter& parameter : technique.parameters) {
                    choices.push_back(
                        {technique.name, samples, {{parameter.name, parameter.low}}, denoise});
                    choices.push_back(
                        {technique.name, samples, {{parameter.name, parameter.high}}, denoise});
                }
            }
        }
    }
    const auto names = renderer::variant_names(choices);
    for (std::size_t i = 0; i < choices.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_EQ(names[i] == names[k], choices[i] == choices[k])
                << names[i] << ", " << names[k];
        }
    }
    auto turned = choices;
    std::reverse(turned.begin(), turned.end());
    auto expected = names;
    std::reverse(expected.begin(), expected.end());
    EXPECT_EQ(renderer::variant_names(turned), expected) << "the order of the list says nothing";
}

TEST(VariantNames, OfTheBuiltInStudySayWhichRadiusEachSceneHas) {
    const Study study = read_study(builtin_text(), test_catalogue()).study;
    const VariantNames names = variant_names(study);
    EXPECT_EQ(names.at({"II", 'a'}), "None");
    EXPECT_EQ(names.at({"II", 'b'}), "Blizzard24 R 0.8");
    EXPECT_EQ(names.at({"V", 'b'}), names.at({"III", 'b'}));
    EXPECT_EQ(names.at({"VII", 'b'}), "Blizzard24 R 0.35");
    EXPECT_EQ(names.at({"VI", 'a'}), "Crytek24 offset_scale 0.01");
    EXPECT_EQ(names.at({"IV", 'a'}), "Blizzard8");
}

TEST(ViewNames, AreTheSameWhereOnlyTheLightDiffers) {
    const Study study = read_study(builtin_text(), test_catalogue()).study;
    const auto views = view_names(study);
    EXPECT_EQ(views.at("atrium-moderate"), "atrium, camera nave");
    EXPECT_EQ(views.at("atrium-high"), views.at("atrium-moderate"));
    EXPECT_NE(views.at("figures-high"), views.at("atrium-high"));
    std::string text(kSmallStudy);
    text += R"([[scene]]
id = "left"
source = "atrium"
camera = { position_m = [1, 1, 1], target_m = [0, 1, 0] }
validity = "moderate"

[[scene]]
id = "left-high"
source = "atrium"
camera = { position_m = [1, 1, 1], target_m = [0, 1, 0] }
validity = "high"

[[scene]]
id = "right"
source = "atrium"
camera = { position_m = [2, 1, 1], target_m = [0, 1, 0] }
validity = "high"
)";
    const auto own = view_names(read_study(text, test_catalogue()).study);
    EXPECT_EQ(own.at("left"), own.at("left-high"));
    EXPECT_NE(own.at("left"), own.at("right"));
    EXPECT_NE(own.at("left"), own.at("court"));
}

}  // namespace
}  // namespace obscura::stimuli
