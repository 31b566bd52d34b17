// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Practice and the presentation in a study file.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/study_reader.h"
#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {
namespace {

using testing::HasSubstr;

/// The small study with more keys in [study], and more at its end.
StudyReading read_with(const std::string& keys, const std::string& end = "") {
    std::string text(kSmallStudy);
    text.insert(text.find("seed = 7\n"), keys + "\n");
    return read_study(text + end, test_catalogue());
}

std::string problems_with(const std::string& keys, const std::string& end = "") {
    return to_lines(read_with(keys, end).problems, "study");
}

constexpr const char* kTrial =
    "\n[[condition]]\nid = \"try\"\nscene = \"court\"\npractice = true\n"
    "a = { technique = \"none\" }\nb = { technique = \"crytek\", samples = 8 }\n";

TEST(PresentationOfStudy, WhatIsNotSaidIsTheThesissWay) {
    const Presentation shown = read_with("").study.presentation;
    EXPECT_EQ(shown.layout, Layout::kSequential);
    EXPECT_EQ(shown.interval, Interval::kGrey);
    EXPECT_EQ(shown.exposure_ms, 0);
    EXPECT_EQ(shown.min_view_ms, 0);
    EXPECT_EQ(shown.break_after, 0);
    EXPECT_EQ(to_words(shown), "one after the other, with a grey screen for 2 s between them");
}

TEST(PresentationOfStudy, EveryKeyIsReadAndSaidInWords) {
    const StudyReading reading = read_with(
        "interval = \"mask\"\ngrey_ms = 500\nexposure_ms = 250\nmin_response_ms = 200\n"
        "break_after = 10\nbreak_min_s = 60\npairs_page = \"next\"");
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    const Presentation& shown = reading.study.presentation;
    EXPECT_EQ(shown.min_response_ms, 200);
    EXPECT_EQ(shown.break_after, 10);
    EXPECT_EQ(shown.break_min_s, 60);
    EXPECT_TRUE(reading.study.has_next_button());
    EXPECT_EQ(to_words(shown),
              "one after the other, each for 0.25 s, with a mask of noise for 0.5 s between them");
    EXPECT_EQ(to_words(read_with("presentation = \"side-by-side\"").study.presentation),
              "side by side");
}

TEST(PresentationOfStudy, KeysThatWouldHaveNoEffectAreRefused) {
    EXPECT_THAT(problems_with("presentation = \"side-by-side\"\ninterval = \"mask\""),
                HasSubstr("study:8: study: interval: has no effect beside presentation"));
    EXPECT_THAT(problems_with("exposure_ms = 100\nmin_view_ms = 50"),
                HasSubstr("min_view_ms: has no effect beside exposure_ms"));
    EXPECT_THAT(problems_with("break_min_s = 10"),
                HasSubstr("break_min_s: has no effect without break_after"));
    EXPECT_THAT(problems_with("interval = \"gray\""), HasSubstr("did you mean \"grey\"?"));
}

TEST(PresentationOfStudy, MoreThanTwentyPairsHaveOneButton) {
    std::string pairs;
    for (int i = 3; i <= 21; ++i) {
        pairs += fmt::format(
            "\n[[condition]]\nid = \"c{}\"\nscene = \"court\"\na = {{ technique = \"none\" }}\n"
            "b = {{ technique = \"crytek\", samples = {} }}\n",
            i, i);
    }
    EXPECT_TRUE(read_with("", pairs).study.has_next_button());
    EXPECT_FALSE(read_with("pairs_page = \"list\"", pairs).study.has_next_button());
    EXPECT_FALSE(read_with("", kTrial).study.has_next_button());
}

TEST(PracticeInStudy, IsNoPartOfTheOrderAndOfNoHypothesis) {
    std::string text(kSmallStudy);
    text.insert(text.find("[[condition]]"), std::string(kTrial).substr(1) + "\n");
    const StudyReading reading = read_study(text, test_catalogue());
    ASSERT_EQ(to_lines(reading.problems, "study"), "");
    const Study& study = reading.study;
    EXPECT_EQ(study.pair_count(), 2);
    ASSERT_EQ(study.conditions.size(), 3U);
    EXPECT_EQ(study.conditions[0].id, "one");
    EXPECT_EQ(study.conditions[2].id, "try");
    EXPECT_EQ(study.session_order(0).conditions.size(), 2U);
    EXPECT_FALSE(study.conditions[2].is_votable());
}

TEST(PracticeInStudy, CannotBeWhatCounts) {
    std::string labelled(kTrial);
    labelled.replace(labelled.find("practice"), 0, "hypothesis = \"H1\"\n");
    EXPECT_THAT(problems_with("", labelled),
                HasSubstr("hypothesis: is not allowed beside practice"));
    EXPECT_THAT(
        problems_with("", std::string(kTrial) + "\n[[condition]]\nid = \"r\"\nrepeats = \"try\"\n"),
        HasSubstr("\"try\" is practice, allowed are one, two"));
    std::string check(kTrial);
    check.replace(check.find("practice"), 0, "catch = \"b\"\n");
    EXPECT_EQ(problems_with("", check), "");
    EXPECT_THAT(problems_with("", check + "\n[exclusion]\nmin_catch_correct = 0.5\n"),
                HasSubstr("no condition has the key catch"));
    std::string all(kSmallStudy);
    for (auto at = all.find("scene = \"court\"\n"); at != std::string::npos;
         at = all.find("scene = \"court\"\n", at + 20)) {
        all.insert(at, "practice = true\n");
    }
    EXPECT_THAT(to_lines(read_study(all, test_catalogue()).problems, "study"),
                HasSubstr("every [[condition]] is practice"));
}

}  // namespace
}  // namespace obscura::stimuli
