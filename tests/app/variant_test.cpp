// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/commands/variant_arguments.h"
#include "renderer/base/error.h"
#include "renderer/technique/technique.h"
#include "stimuli/variant_format.h"

namespace obscura::renderer {
namespace {

using stimuli::StudyProblem;
using testing::HasSubstr;

/// Every technique with nothing at its standard that can be otherwise.
std::vector<Variant> unusual_variants() {
    std::vector<Variant> list;
    for (const Technique& technique : techniques()) {
        Variant variant = standard_variant(technique);
        variant.samples = technique.samples.high;
        for (const Parameter& parameter : technique.parameters) {
            variant.parameters[parameter.name] =
                parameter.whole ? parameter.high : (2.0 * parameter.low + parameter.high) / 3.0;
        }
        if (technique.makes_accessibility()) variant.denoise = "box4";
        for (const VariantOption& option : variant_options()) {
            // Some techniques do not have every option.
            for (const std::string& word : option.allowed) {
                Variant other = variant;
                other.*option.value = word;
                if (problems_of(other).empty()) variant = other;
            }
        }
        list.push_back(variant);
    }
    return list;
}

/// As study files are read; nothing may be wrong.
Variant read(const std::string& inline_table) {
    const toml::table table = toml::parse("a = " + inline_table);
    std::vector<StudyProblem> problems;
    const Variant variant = stimuli::read_variant(*table["a"].as_table(), "a", problems);
    EXPECT_TRUE(problems.empty()) << inline_table << ": " << problems.front().message;
    return variant;
}

std::string problem_in(const std::string& inline_table) {
    const toml::table table = toml::parse("\n\na = " + inline_table);
    std::vector<StudyProblem> problems;
    (void)stimuli::read_variant(*table["a"].as_table(), "a", problems);
    if (problems.size() != 1) return "problems: " + std::to_string(problems.size());
    return std::to_string(problems[0].line) + ": " + problems[0].message;
}

TEST(Variant, EverySettingComesBackFromTomlJsonAndTheCommandLine) {
    for (const Variant& variant : unusual_variants()) {
        ASSERT_TRUE(problems_of(variant).empty()) << problems_of(variant).front().message;
        if (variant.samples > 0) {
            EXPECT_EQ(read(stimuli::to_toml(variant)), variant) << stimuli::to_toml(variant);
        }
        nlohmann::ordered_json json = nlohmann::ordered_json::object();
        stimuli::put_variant(json, variant);
        EXPECT_EQ(stimuli::variant_from(nlohmann::ordered_json::parse(json.dump())), variant);
        app::VariantArguments arguments{variant.technique, variant.samples, {}, variant.denoise};
        for (const auto& [name, value] : variant.parameters) {
            arguments.settings.push_back(fmt::format("{}={}", name, value));
        }
        for (const VariantOption& option : variant_options()) {
            arguments.settings.push_back(option.name + "=" + variant.*option.value);
        }
        EXPECT_EQ(app::variant_from(arguments), variant) << variant.in_words();
    }
}

TEST(Variant, DiffersFromOneThatDiffersInAnySetting) {
    for (const Variant& variant : unusual_variants()) {
        std::vector<Variant> others(3 + variant.parameters.size() + variant_options().size(),
                                    variant);
        auto other = others.begin();
        (other++)->technique += "x";
        (other++)->samples += 1;
        (other++)->denoise = "separable";
        for (const auto& [name, value] : variant.parameters) {
            (other++)->parameters[name] = value + 1.0;
        }
        for (const VariantOption& option : variant_options()) {
            std::string& value = (*other++).*option.value;
            value = value == option.standard() ? option.allowed.back() : option.standard();
        }
        for (const Variant& changed : others) EXPECT_NE(changed, variant) << changed.in_words();
    }
}

TEST(Variant, IsTheSameWhetherItsStandardsAreNamedOrNot) {
    for (const Technique& technique : techniques()) {
        const Variant unnamed = standard_variant(technique);
        Variant named = unnamed;
        named.parameters = unnamed.all_parameters();
        EXPECT_EQ(named.parameters.size(), technique.parameters.size());
        EXPECT_EQ(named, unnamed) << technique.name;
    }
}

TEST(Variant, IsWrittenAsItAlwaysWas) {
    const Variant variant{"crytek", 24, {}, "separable"};
    EXPECT_EQ(stimuli::to_toml(variant),
              R"({ technique = "crytek", samples = 24, denoise = "separable" })");
    nlohmann::ordered_json json = {{"before", 1}};
    stimuli::put_variant(json, variant);
    EXPECT_EQ(json.dump(), R"({"before":1,"technique":"crytek","samples":24,)"
                           R"("parameters":{"offset_scale":0.01},"denoise":"separable"})");
    EXPECT_EQ(variant.in_words(), "Crytek24, offset_scale 0.01, denoise separable");
}

TEST(Variant, NamesAnOptionOnlyWhereItIsNotAtItsStandard) {
    Variant variant{"crytek", 24, {}, "none"};
    variant.depth_format = "r16f";
    EXPECT_THAT(stimuli::to_toml(variant), HasSubstr(R"(, depth_format = "r16f" })"));
    EXPECT_THAT(variant.in_words(), testing::EndsWith(", depth_format r16f"));
    nlohmann::ordered_json json;
    stimuli::put_variant(json, variant);
    EXPECT_EQ(json["depth_format"], "r16f");
}

TEST(Variant, WithAWrongOptionNamesLineKeyValueAndWhatIsAllowed) {
    const std::string problem = problem_in(R"({ technique = "crytek", depth_format = "r8" })");
    for (const char* part : {"3: ", "depth_format", "\"r8\"", "r32f", "r16f"}) {
        EXPECT_THAT(problem, HasSubstr(part));
    }
    EXPECT_THAT(problem_in(R"({ technique = "crytek", depth_format = 16 })"),
                HasSubstr("depth_format"));
    EXPECT_THAT(problem_in(R"({ technique = "none", denoise = "box4" })"),
                HasSubstr("none has no buffer to smooth"));
}

std::string refusal_of(const app::VariantArguments& arguments) {
    try {
        (void)app::variant_from(arguments);
    } catch (const base::Error& error) {
        return error.what();
    }
    return "nothing is wrong";
}

TEST(Variant, OfACommandLineNamesTheOptionThatIsWrong) {
    EXPECT_THAT(refusal_of({"crytek", 24, {"depth_format=r8"}, "none"}),
                HasSubstr("--set depth_format: \"r8\" is unknown; allowed are r32f, r16f, d24"));
    EXPECT_THAT(refusal_of({"crytek", 24, {"offset_scale=wide"}, "none"}),
                HasSubstr("\"offset_scale=wide\" is not KEY=VALUE"));
    EXPECT_THAT(refusal_of({"crytek", 24, {"depth_format=r16f", "depth_format=r32f"}, "none"}),
                HasSubstr("\"depth_format\" is set twice"));
    EXPECT_THAT(refusal_of({"crytek", 7, {}, "box5"}),
                testing::AllOf(HasSubstr("--samples: 7"), HasSubstr("--denoise: \"box5\"")));
}

}  // namespace
}  // namespace obscura::renderer
