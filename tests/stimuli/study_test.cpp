// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/study.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "stimuli/study_reader.h"
#include "stimuli/table_reader.h"
#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

StudyReading read(std::string_view text) { return read_study(text, test_catalogue()); }

TEST(BuiltinStudy, IsTheTableOfTheThesis) {
    const StudyReading reading = read(builtin_text());
    ASSERT_EQ(to_lines(reading.problems, "built in"), "");
    const Study& study = reading.study;
    std::vector<std::string> rows;
    for (const Condition& condition : study.conditions) {
        const StudyScene& scene = study.scene_of(condition);
        rows.push_back(fmt::format("{} {} {} {} {} {} {}", condition.id, scene.id, scene.source,
                                   to_string(scene.validity), condition.a.variant_name(),
                                   condition.b.variant_name(), condition.hypothesis));
    }
    EXPECT_THAT(rows, ElementsAre("I relic-low relic low Crytek24 Blizzard24 H2",
                                  "II atrium-moderate atrium moderate None Blizzard24 H1",
                                  "III atrium-moderate atrium moderate Crytek24 Blizzard24 H2",
                                  "IV figures-moderate figures moderate Blizzard8 RayMarching30 H2",
                                  "V atrium-high atrium high None Blizzard24 H1",
                                  "VI atrium-high atrium high Crytek24 Blizzard24 H2",
                                  "VII figures-high figures high None Blizzard24 H1"));
}

TEST(BuiltinStudy, HasTheProcedureOfTheThesis) {
    const Study study = read(builtin_text()).study;
    EXPECT_EQ(study.name, "jakobsen2010");
    EXPECT_EQ(study.question, "Which image looked the most realistic?");
    EXPECT_EQ(study.width, 1280);
    EXPECT_EQ(study.height, 720);
    EXPECT_EQ(study.presentation.grey_ms, 2000);
    EXPECT_EQ(study.presentation.grey_level, 128);
    EXPECT_EQ(study.order, OrderKind::kLatinSquare);
    EXPECT_EQ(study.seed, 20100501U);
    EXPECT_NE(study.instructions, "");
    EXPECT_NE(study.thanks, "");
    EXPECT_EQ(study.sha256, base::sha256_hex(builtin_text()));
}

TEST(BuiltinStudy, HasNoProblemWithTheBuiltInScenes) {
    EXPECT_EQ(to_lines(problems_of_study(builtin_text()), "built in"), "");
    EXPECT_EQ(load_study("").conditions.size(), 7U);
}

TEST(BuiltinStudy, IsFoundByItsNameAndByNoName) {
    EXPECT_EQ(study_source("").text, builtin_text());
    EXPECT_EQ(study_source("jakobsen2010").text, builtin_text());
    EXPECT_EQ(study_source("").name, "jakobsen2010");
}

TEST(Study, OmittedKeysTakeTheirDocumentedValues) {
    const StudyReading reading = read(kSmallStudy);
    ASSERT_EQ(to_lines(reading.problems, "small"), "");
    const Study& study = reading.study;
    EXPECT_EQ(study.width, 1280);
    EXPECT_EQ(study.height, 720);
    EXPECT_EQ(study.presentation.grey_ms, 2000);
    EXPECT_EQ(study.presentation.grey_level, 128);
    EXPECT_EQ(study.thanks, "");
    const Condition& one = *study.find_condition("one");
    EXPECT_EQ(one.hypothesis, "");
    EXPECT_EQ(one.a.samples, 0);
    EXPECT_EQ(one.a.denoise, "none");
    EXPECT_EQ(one.b.samples, 24);  // the descriptor's standard
    EXPECT_EQ(one.b.denoise, "separable");
    EXPECT_EQ(one.b.parameters, (std::map<std::string, double>{{"radius_m", 0.8}}));
    EXPECT_EQ(study.find_condition("two")->a.samples, 32);
    EXPECT_EQ(study.find_condition("two")->b.samples, 30);
    EXPECT_EQ(study.find_condition("three"), nullptr);
}

TEST(Study, TextsKeepEveryLanguageAndTheLineEndsOfWindowsDoNotMatter) {
    std::string text(kSmallStudy);
    text.replace(text.find("\"Look.\""), 7, "\"\"\"見て。\r\nΚοίτα 🙂\"\"\"");
    const StudyReading reading = read(text);
    ASSERT_EQ(to_lines(reading.problems, "small"), "");
    EXPECT_EQ(reading.study.instructions, "見て。\nΚοίτα 🙂");
}

TEST(Study, WhatTomlCanWriteInTwoWaysMeansTheSame) {
    std::string text(kSmallStudy);
    const std::string_view inlined = "b = { technique = \"blizzard\", radius_m = 1 }";
    text.replace(text.find("radius_m = 0.8"), 14, "radius_m = 1");
    const Study one = read(text).study;
    text.replace(text.find(inlined), inlined.size(),
                 "[condition.b]\ntechnique = 'blizzard'\nradius_m = 1.0");
    const StudyReading other = read(text);
    ASSERT_EQ(to_lines(other.problems, "small"), "");
    EXPECT_EQ(other.study.conditions[0].b.parameters, one.conditions[0].b.parameters);
}

TEST(Study, AByteOrderMarkAtTheStartIsNoProblem) {
    EXPECT_EQ(to_lines(read("\xEF\xBB\xBF" + std::string(kSmallStudy)).problems, "small"), "");
}

TEST(Study, OneConditionIsAStudyOnlyInFixedOrder) {
    std::string text(kSmallStudy.substr(0, kSmallStudy.rfind("[[condition]]")));
    EXPECT_THAT(to_lines(read(text).problems, "one"),
                HasSubstr("one:15: order \"latin-square\" needs at least two conditions"));
    text.replace(text.find("latin-square"), 12, "fixed");
    EXPECT_EQ(to_lines(read(text).problems, "one"), "");
}

TEST(Study, AllProblemsOfOneFileAreReportedTogetherAndByLine) {
    const StudyReading reading = read(R"([study]
name = "a/b"
titel = "x"
question = 5
instructions = " "
grey_ms = 70000
seed = -1
[[scene]]
id = "s"
source = "relic"
camera = "fronte"
validity = "high"
[[condition]]
id = "I"
scene = "q"
a = { technique = "crytek", samples = 12, radius_m = 3 }
b = { technique = "blizard" }
[[condition]]
id = "I"
scene = "s"
a = { technique = "none", samples = 1 }
b = { technique = "blizzard", radius_m = nan, full_threshold_m = -1 }
)");
    std::vector<int> lines;
    for (const StudyProblem& problem : reading.problems) lines.push_back(problem.line);
    EXPECT_THAT(lines, ElementsAre(2, 3, 4, 5, 6, 7, 11, 12, 15, 16, 16, 17, 19, 21, 22, 22))
        << to_lines(reading.problems, "bad");
}

TEST(Study, ParsingThrowsBadInputThatListsEveryProblemWithNameAndLine) {
    try {
        (void)parse_study("[study]\nseed = 1\nsed = 1\ngrey_ms = -1\n", "my.toml");
        FAIL() << "nothing was thrown";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        EXPECT_THAT(error.what(), HasSubstr("my.toml:3: "));
        EXPECT_THAT(error.what(), HasSubstr("\nmy.toml:4: "));
    }
}

TEST(Study, AFileThatIsNotThereIsNamedBesideTheBuiltInStudies) {
    for (const char* name : {"/nowhere/at-all.toml", "jakobsen2011"}) {
        try {
            (void)load_study(name);
            FAIL() << "nothing was thrown";
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
            EXPECT_THAT(error.what(), HasSubstr(name));
            EXPECT_THAT(error.what(), HasSubstr("built in are jakobsen2010"));
        }
    }
}

TEST(Study, AFolderOrAnUnreadableFileIsBadInput) {
    EXPECT_THROW((void)load_study(testing::TempDir()), base::Error);
}

TEST(Nearest, GivesTheLikelyNameAndNothingFarFetched) {
    const std::vector<std::string> names{"grey_ms", "grey_level", "radius_m", "samples"};
    EXPECT_EQ(nearest("grey_sm", names), "grey_ms");
    EXPECT_EQ(nearest("smaples", names), "samples");
    EXPECT_EQ(nearest("radius", names), "radius_m");
    EXPECT_EQ(nearest("colour", names), std::nullopt);
    EXPECT_EQ(nearest("", names), std::nullopt);
}

TEST(Quotes, ShowAnyValueOnOneLine) {
    EXPECT_EQ(in_quotes("a\nb\x7f"), "\"a\\x0ab\\x7f\"");
    EXPECT_EQ(in_quotes(std::string(59, 'x') + "éé"), "\"" + std::string(59, 'x') + "é...\"");
}

}  // namespace
}  // namespace obscura::stimuli
