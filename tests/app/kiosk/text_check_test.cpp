// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/text_check.h"

#include <fontconfig/fontconfig.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "renderer/base/files.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app::kiosk {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A machine with no fonts but DejaVu.
class TextCheck : public testing::Test {
  protected:
    TextCheck() {
        const auto file = folder_.path() / "fonts.conf";
        base::write_file_atomically(
            file,
            "<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig>"
            "<dir>/usr/share/fonts/truetype/dejavu</dir><cachedir>" +
                (folder_.path() / "cache").string() + "</cachedir></fontconfig>");
        ::setenv("FONTCONFIG_FILE", file.c_str(), 1);
        FcInitReinitialize();
    }
    ~TextCheck() override {
        ::unsetenv("FONTCONFIG_FILE");
        FcInitReinitialize();
    }

  private:
    tests::TemporaryFolder folder_;
};

TEST_F(TextCheck, WhatTheFontsHaveCanBeSetHoweverItIsWritten) {
    for (const char* text :
         {"Which image looked the most realistic?", "Žluťoučký kůň\n\túpěl", "Ποια εικόνα;",
          "Какое изображение?", "Որ պատկերը", "რომელი", "« 20 °C — ½ ✓ » \u00A0",
          "Tiếng Việt ở đâu", "أي صورة؟ 1.", "cafe\u0301", "hy\u00ADphen", "a\u200Db\u202Ec"}) {
        EXPECT_THAT(problems_of_text(text), IsEmpty()) << text;
        EXPECT_THAT(problems_of_text(text, "ar"), IsEmpty()) << text;
    }
}

TEST_F(TextCheck, AControlCharacterIsNoText) {
    EXPECT_THAT(problems_of_text("bell\u0007"),
                ElementsAre(AllOf(HasSubstr("U+0007"), HasSubstr("take it out"))));
}

TEST_F(TextCheck, WhatNoFontOfTheMachineHasIsRefusedInEveryScript) {
    for (const char* text : {"कौन सा चित्र", "ภาพไหน", "ဘယ်ပုံ", "རྒྱ", "\U0001E900", "ᠮᠣᠩ"}) {
        EXPECT_THAT(problems_of_text(text),
                    ElementsAre(AllOf(HasSubstr("U+"), HasSubstr("install fonts-noto-core"))))
            << text;
    }
    EXPECT_THAT(problems_of_text("\U0001F9FF"),
                ElementsAre(AllOf(HasSubstr("U+1F9FF"), HasSubstr("fonts-noto-color-emoji"))));
}

TEST_F(TextCheck, WhatNoFontHasIsRefusedNamingThePackageThatHelps) {
    EXPECT_THAT(
        problems_of_text("どの画像ですか"),
        ElementsAre(AllOf(HasSubstr("no font of this machine"), HasSubstr("fonts-noto-cjk"),
                          HasSubstr("U+3069 HIRAGANA LETTER DO"), HasSubstr("and 1 more"))));
    EXPECT_THAT(problems_of_text("어느 것"), ElementsAre(HasSubstr("fonts-noto-cjk")));
    EXPECT_THAT(problems_of_text("የትኛው"), ElementsAre(HasSubstr("install fonts-noto-core")));
}

TEST_F(TextCheck, EveryTextOfAStudyIsLookedAtAndNamedByItsLineAndKey) {
    stimuli::Study study;
    study.shown_texts = {
        {"study: title", 3, "Study"}, {"study: question", 5, "ภาพไหน"}, {"texts: begin", 9, "कौन"}};
    const auto problems = problems_of_texts(study);
    EXPECT_THAT(stimuli::to_lines(problems, "a.toml"),
                AllOf(HasSubstr("a.toml:5: study: question: cannot be shown"),
                      HasSubstr("\na.toml:9: texts: begin: cannot be shown")));
    EXPECT_EQ(problems.size(), 2U);
}

TEST_F(TextCheck, TheKiosksOwnWordsAreLookedAtInTheLanguageOfTheStudy) {
    stimuli::Study study;
    EXPECT_THAT(problems_of_texts(study), IsEmpty());
    study.words = stimuli::Words("ja");
    const auto problems = problems_of_texts(study);
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_THAT(problems.front().message,
                AllOf(HasSubstr("language ja"), HasSubstr("install fonts-noto-cjk")));
    stimuli::Words::Texts own;
    for (const auto& [key, text] : study.words.all()) own[key] = "x";
    study.words = stimuli::Words("ja", own);
    EXPECT_THAT(problems_of_texts(study), IsEmpty()) << "all are the study's own";
}

}  // namespace
}  // namespace obscura::app::kiosk
