// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// A form filled in by mouse or finger alone: keys on the screen.
#include <gmock/gmock.h>

#include "app/kiosk/form_answers.h"
#include "tests/app/kiosk/shown_page.h"

namespace obscura::app::kiosk {
namespace {

using stimuli::FieldKind;

constexpr const char* kBack = "\u2190";

/// A form of texts and a code in one language, in a window of that size.
class KeypadPage {
  public:
    explicit KeypadPage(const std::string& language, Extent size = {1024, 720}, int texts = 2)
        : study_(study_in(language, texts)),
          display_(size.width, size.height),
          ui_(window_, study_.words, 128),
          page_(window_, ui_, [this] { return form_screen(ui_.fonts(), study_, form_); }) {
        page_.press(GLFW_KEY_END);
        page_.press(GLFW_KEY_HOME);
        page_.draw();
    }
    [[nodiscard]] ShownPage& page() { return page_; }
    [[nodiscard]] std::string typed(std::size_t field) {
        return answer_in(study_.form[field], form_.fields.at(field)).text;
    }
    [[nodiscard]] static bool shows_keys() { return ShownPage::place_of(kBack).has_value(); }
    /// Scrolls by the wheel, as far as it takes.
    void bring_into_view(const std::string& text) {
        page_.scroll(1000.0F);
        const auto lies_below = [&] {
            const auto place = ShownPage::place_of(text);
            return place && place->y > 0.5 * ImGui::GetIO().DisplaySize.y;
        };
        for (float before = -1.0F; lies_below() && before != ShownPage::scrolled();) {
            before = ShownPage::scrolled();
            page_.scroll(-1.0F);
        }
    }
    /// A field lies below its label, and begins at the same side.
    void click_field(const std::string& label) {
        bring_into_view(label);
        const auto place = ShownPage::place_of(label);
        ASSERT_TRUE(place.has_value()) << label;
        const double text_px = ImGui::GetFontSize();
        const bool at_left = place->x < 0.5 * ImGui::GetIO().DisplaySize.x;
        const PointerPlace field{place->x + (at_left ? 4.0 : -4.0) * text_px,
                                 place->y + 2.0 * text_px};
        page_.click(field, field);
    }
    void click_keys(const std::vector<std::string>& keys) {
        for (const std::string& key : keys) page_.click_on(key);
    }
    void click_blank() {
        const auto before = ShownPage::place_of("'");
        const auto after = ShownPage::place_of(".");
        ASSERT_TRUE(before && after);
        const PointerPlace blank{(before->x + after->x) / 2.0, before->y};
        page_.click(blank, blank);
    }
    [[nodiscard]] const std::string& keypad_letters() const {
        return study_.words("keypad_letters");
    }

  private:
    static stimuli::Study study_in(const std::string& language, int texts) {
        stimuli::Study study = small_study(2);
        study.words = stimuli::Words(language);
        for (int i = 1; i <= texts; ++i) {
            study.form.push_back({.id = fmt::format("t{}", i),
                                  .kind = FieldKind::kText,
                                  .label = fmt::format("T{}", i)});
        }
        study.form.push_back({.id = "c",
                              .kind = FieldKind::kCode,
                              .label = language == "ar" ? "\u0631\u0645\u0632" : "CODE"});
        return study;
    }

    stimuli::Study study_;
    FormDraft form_;
    VirtualDisplay display_;
    Window window_{{0, false, {64, 64}}};
    Ui ui_;
    ShownPage page_;
};

TEST(Keypad, LettersDigitsCapitalsBlanksAndMarksAreTypedByMouse) {
    KeypadPage form("en");
    EXPECT_FALSE(KeypadPage::shows_keys());
    form.click_field("T1");
    const auto capitals = ShownPage::place_of("Aa");
    ASSERT_TRUE(capitals.has_value());
    EXPECT_NEAR(capitals->y, ShownPage::place_of("-")->y, 0.5 * ImGui::GetFontSize())
        << "on one line";
    form.click_keys({"Aa", "J", "o"});
    form.click_blank();
    form.click_keys({"o", "'", "Aa", "B", "1", "9", kBack, "0", "-", "."});
    EXPECT_EQ(form.typed(0), "Jo o'B10-.");
    form.click_field("T2");
    form.click_keys({"x"});
    EXPECT_EQ(form.typed(1), "x");
    EXPECT_EQ(form.typed(0), "Jo o'B10-.") << "the keys are for the field that was pressed last";
}

TEST(Keypad, AnotherAlphabetHasItsLettersAndTheLatinOnesAreAKeyAway) {
    KeypadPage form("ar");
    form.click_field("T1");
    form.click_keys({"\u0633", "\u0644", "\u0627", "\u0645"});
    EXPECT_EQ(form.typed(0), "\u0633\u0644\u0627\u0645");
    form.click_keys({"ABC", "a", "Aa", "B"});
    EXPECT_EQ(form.typed(0), "\u0633\u0644\u0627\u0645aB");
    form.click_keys({"\u0636\u0635\u062B", "\u0628"});
    EXPECT_EQ(form.typed(0), "\u0633\u0644\u0627\u0645aB\u0628");
}

TEST(Keypad, ALanguageInLatinHasItsOwnLettersAmongTheOthers) {
    KeypadPage form("de");
    form.click_field("T1");
    form.click_keys({"Aa", "\u00DC", "\u00DF"});
    EXPECT_EQ(form.typed(0), "\u00DC\u00DF");
}

TEST(Keypad, ASoundMarkGoesOntoTheKanaBeforeIt) {
    KeypadPage form("ja");
    form.click_field("T1");
    form.click_keys({"\u304B", "\u309B", "\u306F", "\u309C", "\u3042", "\u309B"});
    EXPECT_EQ(form.typed(0), "\u304C\u3071\u3042\u309B");
    form.click_keys({kBack, kBack});
    EXPECT_EQ(form.typed(0), "\u304C\u3071");
}

TEST(Keypad, ACodeBeginsWithLatinLettersInEveryLanguage) {
    for (const char* language : {"en", "ja", "ar"}) {
        KeypadPage form(language);
        form.click_field(std::string(language) == "ar" ? "\u0631\u0645\u0632" : "CODE");
        form.click_keys({"k", "7"});
        EXPECT_EQ(form.typed(2), "k7") << language;
    }
}

TEST(Keypad, WhoTypesOnAKeyboardSeesNoKeysUnlessTheFieldIsPressedOnceMore) {
    KeypadPage form("en");
    form.click_field("T1");
    EXPECT_TRUE(KeypadPage::shows_keys());
    form.page().type(U"a");
    EXPECT_FALSE(KeypadPage::shows_keys());
    EXPECT_EQ(form.typed(0), "a") << "the field kept the keyboard";
    form.click_field("T2");
    EXPECT_FALSE(KeypadPage::shows_keys()) << "the mouse only points";
    form.page().type(U"b");
    EXPECT_EQ(form.typed(1), "b");
    form.click_field("T2");
    EXPECT_TRUE(KeypadPage::shows_keys());
    form.click_keys({"c"});
    EXPECT_EQ(form.typed(1), "bc");
}

TEST(Keypad, ThePagesWayOnStaysUnderThePointerWhileKeysAreShown) {
    KeypadPage form("en");
    form.click_field("T1");
    form.click_keys({"a"});
    form.bring_into_view("I agree to take part\u00A0*");
    form.page().click_on("I agree to take part\u00A0*");
    EXPECT_TRUE(KeypadPage::shows_keys()) << "nothing moves away from below the pointer";
    form.bring_into_view("b");
    form.click_keys({"b"});
    EXPECT_EQ(form.typed(0), "ab");
    form.page().click_on("Continue");
    const auto event = form.page().event();
    ASSERT_TRUE(event.has_value());
    EXPECT_EQ(std::get<FormSubmitted>(*event).form.fields.at(0).text, "ab");
}

TEST(Keypad, AllKeysAreInViewWithTheFieldThatWasPressedAboveThem) {
    constexpr int kTexts = 5;
    for (const Extent size : {Extent{800, 600}, Extent{1280, 800}}) {
        KeypadPage form("ja", size, kTexts);
        for (int field = 1; field <= kTexts; ++field) {
            const std::string label = fmt::format("T{}", field);
            form.click_field(label);
            for (const std::string& text : {label, std::string("0"), std::string(kBack)}) {
                const auto place = ShownPage::place_of(text);
                ASSERT_TRUE(place.has_value()) << text;
                EXPECT_GT(place->y, 24.0) << label << ' ' << text;
                EXPECT_LT(place->y, size.height - 24.0) << label << ' ' << text;
            }
        }
        form.click_keys({"0"});
        EXPECT_EQ(form.typed(kTexts - 1), "0");
    }
}

}  // namespace
}  // namespace obscura::app::kiosk
