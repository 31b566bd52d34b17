// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What somebody meant who wrote another key, one message for one mistake, and what a colleague
// asks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/pairs.h"
#include "stimuli/study_reader.h"
#include "stimuli/study_warnings.h"
#include "stimuli/table_reader.h"
#include "tests/stimuli/attentive_study.h"

namespace obscura::stimuli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The study's text with every `from` replaced.
std::string with_all(std::string text, const std::string& from, const std::string& to) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

/// The messages of reading that text, in order of their lines.
std::vector<std::string> messages_of(const std::string& text) {
    std::vector<std::string> messages;
    for (const StudyProblem& problem : read_study(text, test_catalogue()).problems) {
        messages.push_back(problem.message);
    }
    return messages;
}

/// The one message that the edit of the attentive study makes.
std::string only_message(const std::string& from, const std::string& to) {
    const auto messages = messages_of(with_all(attentive_text(), from, to));
    EXPECT_EQ(messages.size(), 1U) << testing::PrintToString(messages);
    return messages.empty() ? "" : messages.front();
}

Study study_of(const std::string& text) { return read_study(text, test_catalogue()).study; }

TEST(MeantKey, IsANearOneAPartOfOneOrAnotherWordForOne) {
    const std::vector<std::string> camera{"position_m", "target_m", "vertical_fov_deg", "near_m"};
    EXPECT_EQ(meant_key("fov_deg", camera), "vertical_fov_deg");
    EXPECT_EQ(meant_key("fov", camera), "vertical_fov_deg");
    EXPECT_EQ(meant_key("look_at", camera), "target_m");
    EXPECT_EQ(meant_key("position", camera), "position_m");
    EXPECT_EQ(meant_key("near", camera), "near_m");
    EXPECT_EQ(meant_key("colour", camera), std::nullopt);
    EXPECT_EQ(meant_key("blur", {"denoise", "samples"}), "denoise");
    EXPECT_EQ(meant_key("blur", {"samples"}), std::nullopt) << "nobody asks for denoise here";
}

TEST(MeantKey, IsGuessedAtEveryLevelAndLeavesNothingElseToSay) {
    const auto guessed = [](const std::string& key) { return "did you mean \"" + key + "\"?"; };
    EXPECT_THAT(only_message("repeats = \"one\"", "repeat = \"one\""),
                HasSubstr(guessed("repeats")));
    EXPECT_THAT(only_message("catch = \"b\"", "expected = \"b\""), HasSubstr(guessed("catch")));
    EXPECT_THAT(only_message("[exclusion]", "[exclude]"), HasSubstr(guessed("exclusion")));
    EXPECT_THAT(only_message("min_catch_correct", "catch_correct"),
                HasSubstr(guessed("min_catch_correct")));
    EXPECT_THAT(only_message("question =", "questoin ="), HasSubstr(guessed("question")));
    EXPECT_THAT(only_message("source =", "file ="), HasSubstr(guessed("source")));
    EXPECT_THAT(only_message("[[condition]]", "[[conditions]]"), HasSubstr(guessed("condition")));
    EXPECT_THAT(only_message("[[scene]]", "[[scenes]]"), HasSubstr(guessed("scene")));
    EXPECT_THAT(
        only_message("camera = \"nave\"",
                     "camera = { position_m = [0, 1, 2], target_m = [0, 0, 0], fov_deg = 40 }"),
        HasSubstr(guessed("vertical_fov_deg")));
}

TEST(MeantKey, OfAnotherTechniqueIsNamedWithItsTechniques) {
    EXPECT_THAT(only_message("samples = 32", "samples = 32, radius_m = 0.2"),
                testing::AllOf(HasSubstr("\"radius_m\" is a setting of "), HasSubstr("blizzard")));
}

TEST(OneMistake, IsOneMessageWhereSeveralConditionsNameIt) {
    const std::string message = only_message("scene = \"court\"", "scene = \"cuort\"");
    EXPECT_THAT(message, testing::AllOf(HasSubstr("did you mean \"court\"?"),
                                        HasSubstr("; the same in condition \"two\" (line "),
                                        HasSubstr("), condition \"check\" (line ")));
}

TEST(OneMistake, InAKeyOfSeveralSidesListsTheAllowedKeysOnceAndEveryLine) {
    std::string text = with_all(attentive_text(), "{ technique = \"none\" }",
                                "{ technique = \"crytek\", sampels = 24 }");
    text = with_all(text, "radius_m = 0.8", "sampels = 24");
    EXPECT_THAT(messages_of(text),
                ElementsAre(testing::AllOf(
                    HasSubstr("condition \"one\", a: \"sampels\" is an unknown key"),
                    HasSubstr("did you mean \"samples\"?; the same in condition \"one\", b (line "
                              "19), condition \"check\", a (line 31)"))));
}

TEST(OneMistake, InAValueIsOneOnlyWhereTheSameValueWasWritten) {
    const std::string alike = with_all(with_all(attentive_text(), "samples = 32", "samples = 999"),
                                       "samples = 64", "samples = 999");
    EXPECT_THAT(messages_of(alike), testing::SizeIs(1));
    EXPECT_THAT(messages_of(with_all(alike, "technique = \"none\"",
                                     "technique = \"crytek\", samples = 998")),
                testing::SizeIs(2));
}

TEST(OneMistake, InTheNameOfASceneIsNoMistakeOfItsConditions) {
    EXPECT_THAT(only_message("id = \"court\"", "id = \"my court\""),
                HasSubstr("cannot be part of a file name"));
}

TEST(OneMistake, InAnAttentionCheckIsNoneOfTheRule) {
    EXPECT_THAT(only_message("catch = \"b\"", "catch = true"),
                HasSubstr("allowed are \"a\", \"b\": the side that an attentive observer picks"));
}

TEST(Colleague, AsksAboutPairsThatDifferInOneSettingAndRulesThatLeaveNobodyOut) {
    EXPECT_THAT(notes_on(study_of(attentive_text())), IsEmpty());
    std::string text = with_all(attentive_text(), "{ technique = \"raymarch\" }",
                                "{ technique = \"crytek\", samples = 24 }");
    text = with_all(text, "min_repeat_agreement = 0.5", "min_repeat_agreement = 0");
    EXPECT_THAT(notes_on(study_of(text)),
                ElementsAre("condition \"two\": a and b differ in one setting only, samples (32 : "
                            "24)",
                            "exclusion: min_repeat_agreement = 0 leaves nobody out"));
    EXPECT_THAT(notes_on(study_of(builtin_text())), IsEmpty());
}

TEST(Colleague, AsksAboutPairsThatHardlyDifferAndChecksThatAreHardToSee) {
    const Study study = study_of(attentive_text());
    const auto pair = [](const char* condition, double visible) {
        return ManifestPair{condition, "a", "b", {.1, .001, visible, 3.0}, ""};
    };
    EXPECT_THAT(faint_pairs(study, {pair("one", 10.0 * kLeastVisible), pair("check", kObvious)}),
                IsEmpty());
    EXPECT_THAT(faint_pairs(study, {pair("one", .5 * kLeastVisible)}), IsEmpty())
        << "alike_pairs() says that";
    EXPECT_THAT(
        faint_pairs(study, {pair("one", 5.0 * kLeastVisible), pair("check", .9 * kObvious)}),
        ElementsAre(testing::AllOf(HasSubstr("condition \"one\""), HasSubstr("will guess")),
                    testing::AllOf(HasSubstr("condition \"check\""), HasSubstr("hard to see"))));
}

}  // namespace
}  // namespace obscura::stimuli
