// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "renderer/base/error.h"
#include "stimuli/embedded.h"

namespace obscura::stimuli {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<PoEntry> entries_of(const std::string& language) {
    return parse_po(embedded("words/" + language + ".po"), language);
}

TEST(KioskWords, ATimeInATextFromTheRightKeepsItsOwnOrder) {
    const std::string time = "2026-11-27T09:01:59.189Z";
    const auto told = [&](const char* language) {
        return Words(language)("cut_off_text", {{"session", "s-1"}, {"time", time}});
    };
    EXPECT_THAT(told("ar"), testing::HasSubstr("\u2068" + time + "\u2069"));
    EXPECT_THAT(told("ja"), testing::HasSubstr(time));
    EXPECT_THAT(told("ja"), testing::Not(testing::HasSubstr("\u2068")));
}

TEST(KioskWords, EveryLanguageHasEveryWordOfTheEnglishAsItStandsThere) {
    ASSERT_THAT(word_languages(),
                testing::UnorderedElementsAre("en", "de", "fr", "es", "da", "ja", "ar"));
    EXPECT_EQ(word_languages().front(), "en");
    const auto english = entries_of("en");
    ASSERT_GT(english.size(), 60U);
    for (const PoEntry& entry : english) EXPECT_EQ(entry.text, entry.source) << entry.context;
    for (const std::string& language : word_languages()) {
        EXPECT_THAT(missing_words(language), IsEmpty()) << language;
        const auto entries = entries_of(language);
        ASSERT_EQ(entries.size(), english.size()) << language;
        for (std::size_t i = 0; i < entries.size(); ++i) {
            EXPECT_EQ(entries[i].context, english[i].context) << language;
            EXPECT_EQ(entries[i].source, english[i].source)
                << language << ": the English has changed since it was translated";
        }
    }
}

TEST(KioskWords, EveryTranslationFillsInTheSamePlaces) {
    for (const std::string& language : word_languages()) {
        for (const PoEntry& entry : entries_of(language)) {
            EXPECT_EQ(placeholders_of(entry.text), placeholders_of(entry.source))
                << language << ": " << entry.context;
        }
    }
}

TEST(KioskWords, TranslationsNameTheSameKeysAsTheEnglish) {
    for (const std::string& language : word_languages()) {
        const Words words(language);
        EXPECT_THAT(words("operators_key"), HasSubstr("Ctrl+Shift+Q")) << language;
        EXPECT_THAT(words("thanks_keys"), HasSubstr("Ctrl+Shift+N")) << language;
        EXPECT_THAT(words("op_keys"), HasSubstr("L")) << language;
        EXPECT_THAT(words("abandon_keys"), HasSubstr("C")) << language;
        EXPECT_THAT(words("question_hint"), testing::AllOf(HasSubstr("1"), HasSubstr("2")));
    }
}

TEST(KioskWords, ARegionTakesTheWordsOfItsLanguageAndALanguageWithoutAnyTheEnglish) {
    EXPECT_EQ(Words("de-AT")("yes"), "Ja");
    EXPECT_EQ(Words("sv")("yes"), "Yes");
    EXPECT_THAT(missing_words("sv"), testing::AllOf(Contains("yes"), Contains("begin")));
    EXPECT_EQ(missing_words("sv").size(), catalogue_words("en").size());
}

TEST(KioskWords, AStudyReplacesAnyOfThem) {
    const Words words("da", {{"begin", "Kom i gang"}});
    EXPECT_EQ(words("begin"), "Kom i gang");
    EXPECT_EQ(words("yes"), "Ja");
    EXPECT_THROW((void)words("no such word"), std::out_of_range);
}

TEST(KioskWords, ValuesStandWhereTheyAreNamedInAnyOrder) {
    EXPECT_EQ(Words("en")("done", {{"count", "7"}, {"done", "3"}}), "3 of 7 done");
    EXPECT_EQ(Words("en", {{"done", "{count} {done} {count} {other} {"}})(
                  "done", {{"done", "{count}"}, {"count", "7"}}),
              "7 {count} 7 {other} {")
        << "a value is not filled in itself";
}

TEST(KioskWords, LanguagesFromTheRightAreKnownWhetherTheirWordsAreOrNot) {
    for (const char* language : {"ar", "ar-EG", "he", "fa", "ur", "az-Arab"}) {
        EXPECT_TRUE(Words(language).right_to_left()) << language;
    }
    for (const char* language : {"en", "ja", "de-AT", "zh-Hant-TW", "az"}) {
        EXPECT_FALSE(Words(language).right_to_left()) << language;
    }
}

TEST(KioskWords, ATagThatIsNoLanguageIsNone) {
    for (const char* tag : {"en", "de-AT", "zh-Hant-TW", "sr-Latn", "haw"}) {
        EXPECT_TRUE(is_language(tag)) << tag;
    }
    for (const char* tag : {"", "english", "e", "de_AT", "xx", "12", "de-", "German", "en us"}) {
        EXPECT_FALSE(is_language(tag)) << tag;
    }
}

TEST(PoFile, ATextOverSeveralLinesIsOneAndSignsAreTakenByTheirEscapes) {
    const auto entries = parse_po(
        "# note\nmsgid \"\"\nmsgstr \"Language: xx\\n\"\n\nmsgctxt \"a\"\nmsgid \"A\"\nmsgstr "
        "\"\"\n"
        "\"one \"\n\"two\\n\\\"three\\\" \\\\\"\n\nmsgctxt \"b\"\nmsgid \"B\"\nmsgstr \"\"",
        "x.po");
    ASSERT_EQ(entries.size(), 2U);
    EXPECT_EQ(entries[0].context, "a");
    EXPECT_EQ(entries[0].text, "one two\n\"three\" \\");
    EXPECT_EQ(entries[1].source, "B");
    EXPECT_EQ(entries[1].text, "");
}

TEST(PoFile, WhatIsNoEntryIsRefusedWithItsLine) {
    for (const char* text : {"msgctxt \"a\"\nmsgstr \"A\"\n", "msgctxt \"a\"\nmsgid \"A\n",
                             "msgctxt \"a\"\nmsgid \"A\"\nmsgid_plural \"As\"\n",
                             "msgctxt \"a\"\nwords\n", "msgctxt \"a\"\nmsgid \"\\q\"\n",
                             "msgctxt \"a\"\nmsgid \"A\"x\n", "msgctxt \"a\"\nmsgid \"A\"\n"}) {
        try {
            (void)parse_po(text, "x.po");
            ADD_FAILURE() << text;
        } catch (const base::Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("x.po:"));
        }
    }
}

}  // namespace
}  // namespace obscura::stimuli
