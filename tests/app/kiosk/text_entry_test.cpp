// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/text_entry.h"

#include <gtest/gtest.h>

#include <string_view>

namespace obscura::app::kiosk {
namespace {

void type_text(TextEntry& entry, std::u32string_view text) {
    for (const char32_t character : text) entry.type(character);
}

TEST(TextEntry, KeepsEveryScriptAsItWasTyped) {
    // Latin with a combining accent, Greek, Arabic, Hebrew, Hindi, Chinese, a joined family and a
    // flag of emoji, the last character that there is.
    const std::u32string text =
        U"e\u0301 \u03BB \u0623\u0646\u062B\u0649 \u05D0\u05D9\u05E9 \u0939\u093F "
        U"\u5973 \U0001F468\u200D\U0001F469\u200D\U0001F467 \U0001F1E9\U0001F1F0 \U0010FFFD";
    TextEntry entry(100);
    type_text(entry, text);
    EXPECT_EQ(entry.text(), text);
    EXPECT_EQ(entry.utf8(),
              "e\xCC\x81 \xCE\xBB \xD8\xA3\xD9\x86\xD8\xAB\xD9\x89 \xD7\x90\xD7\x99\xD7\xA9 "
              "\xE0\xA4\xB9\xE0\xA4\xBF \xE5\xA5\xB3 "
              "\xF0\x9F\x91\xA8\xE2\x80\x8D\xF0\x9F\x91\xA9\xE2\x80\x8D\xF0\x9F\x91\xA7 "
              "\xF0\x9F\x87\xA9\xF0\x9F\x87\xB0 \xF4\x8F\xBF\xBD");
    EXPECT_EQ(entry.note(), TextEntry::Note::kNone);
}

TEST(TextEntry, LeavesOutWhatIsTooMuchAndSaysSoUntilTheTextChanges) {
    TextEntry entry(3);
    type_text(entry, U"\U0001F600b\u5973");
    EXPECT_EQ(entry.note(), TextEntry::Note::kNone) << "characters are counted, not bytes";
    type_text(entry, U"d");
    EXPECT_EQ(entry.text(), U"\U0001F600b\u5973");
    EXPECT_EQ(entry.note(), TextEntry::Note::kFull);
    entry.erase_before();
    EXPECT_EQ(entry.note(), TextEntry::Note::kNone);
    type_text(entry, U"d");
    EXPECT_EQ(entry.text(), U"\U0001F600bd");
}

TEST(TextEntry, ANumberTakesDigitsOnlyAndSaysSo) {
    TextEntry entry(3, TextEntry::Takes::kDigits);
    type_text(entry, U"-2a.");
    EXPECT_EQ(entry.utf8(), "2");
    EXPECT_EQ(entry.note(), TextEntry::Note::kOnlyDigits);
    type_text(entry, U"991");
    EXPECT_EQ(entry.utf8(), "299");
    EXPECT_EQ(entry.note(), TextEntry::Note::kFull);
}

TEST(TextEntry, ControlCharactersAndWhatIsNoCharacterAreLeftOut) {
    TextEntry entry(10);
    for (const std::uint32_t code :
         {0x0U, 0x7U, 0xAU, 0x1BU, 0x7FU, 0x85U, 0xD800U, 0xDFFFU, 0x110000U, 0xFFFFFFFFU}) {
        entry.type(static_cast<char32_t>(code));
    }
    EXPECT_TRUE(entry.text().empty());
    EXPECT_EQ(entry.note(), TextEntry::Note::kNone);
}

TEST(TextEntry, IsEditedAtItsCaret) {
    TextEntry entry(10);
    entry.erase_before();
    entry.erase_after();
    type_text(entry, U"abd");
    entry.move(-1);
    type_text(entry, U"c");
    EXPECT_EQ(entry.utf8(), "abcd");
    entry.move_to(0);
    entry.erase_before();
    entry.erase_after();
    EXPECT_EQ(entry.utf8(), "bcd");
    entry.move(-5);
    EXPECT_EQ(entry.caret(), 0U);
    entry.move(50);
    EXPECT_EQ(entry.caret(), 3U);
    entry.move_to(99);
    entry.erase_after();
    entry.erase_before();
    EXPECT_EQ(entry.utf8(), "bc");
}

}  // namespace
}  // namespace obscura::app::kiosk
