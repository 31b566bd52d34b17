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

TEST_F(TextCheck, WhatIsWrittenOneGlyphALetterFromLeftToRightCanBeSet) {
    for (const char* text : {"Which image looked the most realistic?", "Žluťoučký kůň\n\túpěl",
                             "Ποια εικόνα;", "Какое изображение?", "Որ պատկերը", "რომელი",
                             "« 20 °C — ½ ✓ » \u00A0", "Tiếng Việt ở đâu"}) {
        EXPECT_THAT(problems_of_text(text), IsEmpty()) << text;
    }
}

TEST_F(TextCheck, WhatRunsFromRightToLeftIsRefusedNamingTheScriptAndTheCharacters) {
    EXPECT_THAT(problems_of_text("أي صورة؟ 1."),
                ElementsAre(AllOf(HasSubstr("Arabic"), HasSubstr("right to left"),
                                  HasSubstr("U+0635 ARABIC LETTER SAD"))))
        << "whether a font has its letters or not";
    EXPECT_THAT(problems_of_text("Image איזו?"),
                ElementsAre(AllOf(HasSubstr("Hebrew"), HasSubstr("U+05D0 HEBREW LETTER ALEF"))));
    for (const char* text : {"ܫܠܡܐ", "ދިވެހި", "ߒߞߏ", "\U0001E900"}) {
        EXPECT_THAT(problems_of_text(text), ElementsAre(HasSubstr("right to left"))) << text;
    }
}

TEST_F(TextCheck, WhatChangesBesideOtherLettersIsRefusedNamingTheScript) {
    const std::vector<std::pair<const char*, const char*>> cases{{"कौन सा चित्र", "Devanagari"},
                                                                 {"কোন ছবি", "Bengali"},
                                                                 {"எந்த படம்", "Tamil"},
                                                                 {"ภาพไหน", "Thai"},
                                                                 {"ຮູບ", "Lao"},
                                                                 {"ဘယ်ပုံ", "Myanmar"},
                                                                 {"រូបភាព", "Khmer"},
                                                                 {"གཟུགས", "Tibetan"},
                                                                 {"ᠮᠣᠩᠭᠣᠯ", "Mongolian"}};
    for (const auto& [text, script] : cases) {
        EXPECT_THAT(problems_of_text(text), ElementsAre(AllOf(HasSubstr(script), HasSubstr("U+"))))
            << text;
    }
}

TEST_F(TextCheck, MarksInvisibleSignsAndPartsOfSyllablesAreRefusedSayingHowToWriteThem) {
    EXPECT_THAT(problems_of_text("cafe\u0301"),
                ElementsAre(AllOf(HasSubstr("U+0301 COMBINING ACUTE ACCENT"), HasSubstr("NFC"))));
    EXPECT_THAT(problems_of_text("caf\u00E9"), IsEmpty());
    EXPECT_THAT(problems_of_text("hy\u00ADphen"),
                ElementsAre(AllOf(HasSubstr("U+00AD SOFT HYPHEN"), HasSubstr("take it out"))));
    EXPECT_THAT(problems_of_text("a\u200Db\u202Ec"), ElementsAre(HasSubstr("U+202E")));
    EXPECT_THAT(problems_of_text("\u2714\uFE0F"),
                ElementsAre(HasSubstr("U+FE0F VARIATION SELECTOR-16")));
    EXPECT_THAT(problems_of_text("bell\u0007"), ElementsAre(HasSubstr("U+0007")));
    EXPECT_THAT(problems_of_text("\u1112\u1161\u11AB"), ElementsAre(HasSubstr("whole syllables")));
}

TEST_F(TextCheck, WhatLiesBeyondSixteenBitsIsRefused) {
    EXPECT_THAT(problems_of_text("well done \U0001F600"),
                ElementsAre(AllOf(HasSubstr("U+1F600 GRINNING FACE"), HasSubstr("U+FFFF"))));
    EXPECT_THAT(problems_of_text("\U00020B9F"), ElementsAre(HasSubstr("U+20B9F")));
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
    const auto problems =
        problems_of_texts({{"title", 3, "Study"}, {"question", 5, "איזו?"}, {"thanks", 9, "شكرا"}});
    EXPECT_THAT(stimuli::to_lines(problems, "a.toml"),
                AllOf(HasSubstr("a.toml:5: study: question: cannot be shown"),
                      HasSubstr("\na.toml:9: study: thanks: cannot be shown")));
    EXPECT_EQ(problems.size(), 2U);
}

}  // namespace
}  // namespace obscura::app::kiosk
