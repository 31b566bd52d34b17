// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The pages in a window of an X server, with a keyboard and mouse of the test's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "app/kiosk/page_check.h"
#include "app/window/theme.h"
#include "tests/app/kiosk/shown_page.h"

namespace obscura::app::kiosk {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(Pages, ATextTallerThanTheWindowOpensAtItsTopAndIsLeftOnlyAfterItsEndWasSeen) {
    ShownPage page = show_instructions();
    EXPECT_EQ(ShownPage::scrolled(), 0.0F);
    EXPECT_FALSE(ShownPage::end_seen());
    int turned = 0;
    float before = 0.0F;
    while (!ShownPage::end_seen() && turned < 100) {
        page.press(GLFW_KEY_ENTER);
        EXPECT_EQ(page.event(), std::nullopt) << "the button only reads on";
        EXPECT_GT(ShownPage::scrolled(), before);
        before = ShownPage::scrolled();
        ++turned;
    }
    EXPECT_GT(turned, 1);
    page.press(GLFW_KEY_ENTER);
    const std::optional<Event> event = page.event();
    ASSERT_TRUE(event.has_value());
    EXPECT_TRUE(std::holds_alternative<InstructionsRead>(*event));
}

TEST_F(Pages, ATextScrollsByWheelArrowsPageKeysHomeAndEnd) {
    ShownPage page = show_instructions();
    const auto moved_by = [&](const std::function<void()>& action) {
        const float before = ShownPage::scrolled();
        action();
        return ShownPage::scrolled() - before;
    };
    EXPECT_GT(moved_by([&] { page.scroll(-1.0F); }), 0.0F);
    EXPECT_LT(moved_by([&] { page.scroll(1.0F); }), 0.0F);
    const float step = moved_by([&] { page.press(GLFW_KEY_DOWN); });
    EXPECT_GT(step, 0.0F);
    EXPECT_FLOAT_EQ(moved_by([&] { page.press(GLFW_KEY_UP); }), -step);
    const float turn = moved_by([&] { page.press(GLFW_KEY_PAGE_DOWN); });
    EXPECT_GT(turn, 3.0F * step);
    EXPECT_LT(turn, 720.0F) << "no line is passed over";
    EXPECT_FLOAT_EQ(moved_by([&] { page.press(GLFW_KEY_PAGE_UP); }), -turn);
    EXPECT_FALSE(ShownPage::end_seen());
    EXPECT_GT(moved_by([&] { page.press(GLFW_KEY_END); }), turn);
    EXPECT_TRUE(ShownPage::end_seen());
    EXPECT_EQ(moved_by([&] { page.press(GLFW_KEY_END); }), 0.0F) << "the end is the end";
    page.press(GLFW_KEY_HOME);
    EXPECT_EQ(ShownPage::scrolled(), 0.0F);
    EXPECT_TRUE(ShownPage::end_seen()) << "once seen is enough";
    EXPECT_EQ(page.event(), std::nullopt);
}

TEST_F(Pages, APageShownAnewBeginsAnew) {
    {
        ShownPage page = show_instructions();
        page.press(GLFW_KEY_END);
        ASSERT_TRUE(ShownPage::end_seen());
    }
    const ShownPage again = show_instructions();
    EXPECT_FALSE(ShownPage::end_seen());
    EXPECT_EQ(ShownPage::scrolled(), 0.0F);
}

TEST_F(Pages, ALongQuestionIsAnsweredOnlyAfterItsEndWasSeen) {
    study_.question = many_lines(40);
    ShownPage page = show([this] { return question_screen(ui_.fonts(), study_, {0, 3}); });
    EXPECT_FALSE(ShownPage::end_seen());
    page.press(GLFW_KEY_END);
    EXPECT_TRUE(ShownPage::end_seen());
}

/// The answer that a click gives, if any.
std::optional<Answered> answer_of(ShownPage& page, PointerPlace at, PointerPlace moved_on) {
    page.click(at, moved_on);
    const auto event = page.event();
    if (!event || !std::holds_alternative<Answered>(*event)) return std::nullopt;
    return std::get<Answered>(*event);
}

TEST_F(Pages, AnAnswerIsWhatThePointerWasOnWhenItWasPressedHoweverFastItMovesOn) {
    ShownPage page = show([this] { return question_screen(ui_.fonts(), study_, {0, 3}); });
    std::optional<PointerPlace> first;
    std::optional<PointerPlace> second;
    for (double y = 40.0; y < 700.0 && !(first && second); y += 25.0) {
        for (const double x : {300.0, 420.0, 512.0, 600.0, 720.0}) {
            const PointerPlace at{x, y};
            if (const auto answer = answer_of(page, at, at)) (answer->first ? first : second) = at;
        }
    }
    ASSERT_TRUE(first && second) << "no place gives an answer";
    for (int repetition = 0; repetition < 10; ++repetition) {
        const auto one = answer_of(page, *first, *second);
        ASSERT_TRUE(one.has_value());
        EXPECT_TRUE(one->first);
        const auto other = answer_of(page, *second, *first);
        ASSERT_TRUE(other.has_value());
        EXPECT_FALSE(other->first);
    }
}

/// The rectangles of the windows that the last frame drew.
std::vector<ImRect> drawn_windows() {
    std::vector<ImRect> rectangles;
    for (const ImGuiWindow* window : GImGui->Windows) {
        if (window->WasActive && !window->IsFallbackWindow) rectangles.push_back(window->Rect());
    }
    return rectangles;
}

class PagesOfEverySize : public testing::TestWithParam<Extent> {};

TEST_P(PagesOfEverySize, LieWithinTheWindowWithTheirFootInView) {
    const Extent size = GetParam();
    const VirtualDisplay display(size.width, size.height);
    Window window({0, false, {64, 64}});
    stimuli::Study study = small_study(64);
    Ui ui(window, study.words, 128);
    study.instructions = study.thanks = many_lines(60);
    study.question = many_lines(30);
    FormDraft form;
    const Trouble trouble{"This could not be saved", many_lines(20), many_lines(20)};
    const Fonts& fonts = ui.fonts();
    const std::vector<Draw> pages{
        [&] { return start_screen(fonts); },
        [&] { return form_screen(fonts, study, form); },
        [&] { return instructions_screen(fonts, study); },
        [&] {
            return pairs_screen(fonts, {40, 64});
        },
        [&] {
            return question_screen(fonts, study, {0, 64});
        },
        [&]() -> std::optional<Event> {
            thanks_screen(fonts, study, "All answers are saved.");
            return std::nullopt;
        },
        [&]() -> std::optional<Event> {
            OperatorView view;
            (void)operator_screen(fonts, view);
            return std::nullopt;
        },
        [&]() -> std::optional<Event> {
            (void)trouble_screen(fonts, trouble);
            return std::nullopt;
        },
    };
    for (std::size_t i = 0; i < pages.size(); ++i) {
        ShownPage page(window, ui, pages[i]);
        for (const bool at_end : {false, true}) {
            if (at_end) page.press(GLFW_KEY_END);
            const PageState& state = page_state();
            EXPECT_TRUE(state.end_seen || !at_end) << "page " << i;
            EXPECT_GT(state.foot_px, 0.0F);
            const auto windows = drawn_windows();
            ASSERT_FALSE(windows.empty());
            for (const ImRect& rectangle : windows) {
                EXPECT_GE(rectangle.Min.x, 0.0F) << "page " << i;
                EXPECT_GE(rectangle.Min.y, 0.0F) << "page " << i;
                EXPECT_LE(rectangle.Max.x, static_cast<float>(size.width)) << "page " << i;
                EXPECT_LE(rectangle.Max.y, static_cast<float>(size.height)) << "page " << i;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, PagesOfEverySize,
                         testing::Values(Extent{800, 600}, Extent{1024, 720}, Extent{1280, 800},
                                         Extent{1920, 1080}));

TEST_F(Pages, AListOfPairsOfAnyLengthIsWhollyInView) {
    for (const int count : {1, 7, 8, 20, 36, 64}) {
        const ShownPage page = show([&] { return pairs_screen(ui_.fonts(), {count - 1, count}); });
        EXPECT_TRUE(ShownPage::end_seen()) << count;
    }
}

TEST_F(Pages, NoTextIsFadedNotEvenThatOfPairsWhoseTurnHasNotCome) {
    using namespace window::theme;
    ShownPage page = show([&] { return pairs_screen(ui_.fonts(), {1, 3}); });
    page.draw();
    const auto& texts = page_state().tools.typesetter->uses();
    for (const Typesetter::Use& text : texts) {
        EXPECT_TRUE(std::ranges::any_of(
            std::array{kInk, kFaintInk, kOnAccent},
            [&](const ImVec4& ink) { return ImGui::ColorConvertFloat4ToU32(ink) == text.colour; }))
            << text.text;
    }
    EXPECT_GE(texts.size(), 6U) << "heading, hint, three pairs, how many are done";
}

TEST_F(Pages, TabGoesThroughTheFormAsEyesReadAndBack) {
    ShownPage page = show_form();
    const auto where = [] {
        for (const FocusStop& stop : page_state().stops) {
            if (stop.id == page_state().focus) return stop;
        }
        return FocusStop{};
    };
    const FocusStop first = where();
    EXPECT_TRUE(first.text) << "it starts at the age";
    const std::size_t count = page_state().stops.size();
    ASSERT_EQ(count, 11U);
    std::vector<unsigned> forward{first.id};
    FocusStop before = first;
    for (std::size_t i = 1; i < count; ++i) {
        page.press(GLFW_KEY_TAB);
        const FocusStop now = where();
        EXPECT_GE(now.top_px, before.top_px);
        forward.push_back(now.id);
        before = now;
    }
    EXPECT_TRUE(before.primary) << "it ends at the way on";
    EXPECT_EQ(std::set<unsigned>(forward.begin(), forward.end()).size(), count);
    for (std::size_t i = count - 1; i > 0; --i) {
        page.press(GLFW_KEY_TAB, GLFW_MOD_SHIFT);
        EXPECT_EQ(where().id, forward[i - 1]);
    }
    page.press(GLFW_KEY_DOWN);
    EXPECT_EQ(where().id, forward[1]) << "an arrow down goes to the next line's first";
    page.press(GLFW_KEY_RIGHT);
    EXPECT_EQ(where().id, forward[2]);
    page.press(GLFW_KEY_DOWN);
    EXPECT_EQ(where().id, forward[5]);
}

TEST_F(Pages, ChosenOwnWordsTakeTheTypingAtOnceAndKeepEveryScript) {
    ShownPage page = show_form();
    page.type(U"30");
    for (int i = 0; i < 3; ++i) page.press(GLFW_KEY_TAB);
    page.press(GLFW_KEY_SPACE);
    EXPECT_EQ(form_.gender, Gender::kOwnWords);
    page.type(U"\U0001F98A \u5973 \u0623\u0646\u062B\u0649");
    EXPECT_EQ(form_of(form_, study_).gender,
              "\xF0\x9F\xA6\x8A \xE5\xA5\xB3 \xD8\xA3\xD9\x86\xD8\xAB\xD9\x89");
    EXPECT_EQ(form_of(form_, study_).age_years, 30);
}

TEST_F(Pages, KeysThatCameFasterThanFramesGoWhereTheFocusWasThen) {
    ShownPage page = show_form();
    Input& input = window_.input();
    const auto press = [&](int key, char32_t character) {
        input.key_down({key, 0, 1.0});
        if (character != 0) input.types(character);
    };
    press(GLFW_KEY_4, U'4');
    press(GLFW_KEY_2, U'2');
    press(GLFW_KEY_TAB, 0);
    press(GLFW_KEY_SPACE, U' ');
    press(GLFW_KEY_7, U'7');
    page.draw();
    EXPECT_EQ(form_.age.utf8(), "42");
    EXPECT_EQ(form_.gender, Gender::kFemale);
}

TEST_F(Pages, RatherNotSayIsNotTheSameAsNoAnswer) {
    EXPECT_EQ(form_of(form_, study_).gender, "");
    form_.gender = Gender::kRatherNotSay;
    EXPECT_EQ(form_of(form_, study_).gender, "rather not say");
}

TEST_F(Pages, AFormThatLacksSomethingPutsTheKeyboardThere) {
    ShownPage page = show_form();
    page.press(GLFW_KEY_TAB);
    page.press(GLFW_KEY_ENTER);
    EXPECT_EQ(page.event(), std::nullopt);
    page.type(U"25");
    EXPECT_EQ(form_.age.utf8(), "25") << "at the age first";
    page.press(GLFW_KEY_ENTER);
    EXPECT_EQ(page.event(), std::nullopt);
    page.press(GLFW_KEY_SPACE);
    EXPECT_TRUE(form_.consent) << "then at the consent";
    page.press(GLFW_KEY_ENTER);
    const std::optional<Event> event = page.event();
    ASSERT_TRUE(event.has_value());
    EXPECT_EQ(std::get<FormSubmitted>(*event).form.age_years, 25);
}

/// Of the page's body, in pixels.
float visible_body_px() {
    for (const ImGuiWindow* window : GImGui->Windows) {
        if (std::string_view(window->Name).find("##body") != std::string_view::npos) {
            return window->Size.y;
        }
    }
    return 0.0F;
}

TEST_F(Pages, WhatTheKeyboardGoesToIsSeenWithItsQuestionAboveAndWhatIsSaidBelowIt) {
    constexpr int kFields = 12;
    for (int i = 0; i < kFields; ++i) {
        stimuli::FormField field;
        field.id = fmt::format("f{}", i);
        field.kind = stimuli::FieldKind::kText;
        field.label = "A question";
        study_.form.push_back(field);
    }
    ShownPage page = show_form();
    const float text_px = ImGui::GetFontSize();
    const auto expect_in_view = [&] {
        for (const FocusStop& stop : page_state().stops) {
            if (stop.id != page_state().focus || !stop.in_body) continue;
            EXPECT_GE(stop.top_px - text_px, ShownPage::scrolled());
            EXPECT_LE(
                std::min(stop.top_px + stop.height_px + text_px, std::floor(page_state().body_px)),
                ShownPage::scrolled() + visible_body_px());
        }
    };
    for (const int modifiers : {0, GLFW_MOD_SHIFT}) {
        for (int i = 0; i < kFields; ++i) {
            page.press(GLFW_KEY_TAB, modifiers);
            expect_in_view();
        }
    }
}

TEST_F(Pages, ThanksAreLeftByNoKeyOrClickOfAParticipant) {
    bool gave = false;
    ShownPage page = show([&]() -> std::optional<Event> {
        thanks_screen(ui_.fonts(), study_, "All answers are saved.");
        gave = gave || !page_state().stops.empty();
        return std::nullopt;
    });
    page.press(GLFW_KEY_ENTER);
    page.press(GLFW_KEY_SPACE);
    EXPECT_FALSE(gave) << "there is nothing to press";
}

TEST(PageCheck, SaysWhichPagesScrollInTheSmallestWindow) {
    stimuli::Study study = small_study(7);
    study.width = 320;
    study.height = 200;
    EXPECT_THAT(notes_on_pages(study), IsEmpty());
    study.instructions = many_lines(60);
    EXPECT_THAT(notes_on_pages(study),
                ElementsAre(testing::AllOf(HasSubstr("instructions"), HasSubstr("1024x720"))));
    study.question = many_lines(40);
    study.thanks = many_lines(40);
    EXPECT_THAT(notes_on_pages(study),
                ElementsAre(HasSubstr("instructions"), HasSubstr("question"), HasSubstr("thanks")));
    study.width = 3840;
    study.height = 2160;
    EXPECT_THAT(notes_on_pages(study).front(), HasSubstr("3840x2160"));
}

}  // namespace
}  // namespace obscura::app::kiosk
