// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The pages in every language of the catalogue, and texts of any script on them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

#include "app/kiosk/page_check.h"
#include "app/kiosk/screens.h"
#include "app/kiosk/stage.h"
#include "app/kiosk/text_check.h"
#include "app/kiosk/widgets.h"
#include "tests/app/kiosk/small_study.h"
#include "tests/app/kiosk/virtual_display.h"

namespace obscura::app::kiosk {
namespace {

using testing::IsEmpty;

constexpr Extent kSize{1024, 720};

/// Asks everything that a study can ask.
stimuli::Study asking_study(const std::string& language) {
    stimuli::Study study = small_study(9);
    study.words = stimuli::Words(language);
    study.question = "?";
    study.instructions = "!";
    study.information = "i";
    study.consent = stimuli::Consent{"1", "c", {"x", "y"}};
    study.presentation.layout = stimuli::Layout::kSideBySide;
    using stimuli::FieldKind;
    study.form = {{.id = "a", .kind = FieldKind::kText, .label = "1", .required = true},
                  {.id = "b", .kind = FieldKind::kNumber, .label = "2", .min = 1, .max = 9},
                  {.id = "c", .kind = FieldKind::kNumber, .label = "3", .min = 1},
                  {.id = "d", .kind = FieldKind::kNumber, .label = "4", .max = 9},
                  {.id = "e", .kind = FieldKind::kNumber, .label = "5", .unit = "m"},
                  {.id = "f", .kind = FieldKind::kCode, .label = "6", .generate = true}};
    return study;
}

/// The kiosk's own form with something wrong in each field, or the study's.
FormDraft wrong_draft(const stimuli::Study& study) {
    FormDraft draft;
    draft.submitted = draft.asked_for_consent = true;
    draft.gender = Gender::kOwnWords;
    for (int i = 0; i < 4; ++i) draft.age.type(U'7');
    draft.own_words.type(U'\U0010FFFD');
    draft.fields.resize(study.form.size());
    const std::vector<std::u32string> typed{U"", U"0", U"0", U"10", U"ten", U""};
    for (std::size_t i = 0; i < draft.fields.size(); ++i) {
        for (const char32_t letter : typed[i]) draft.fields[i].entry.type(letter);
    }
    return draft;
}

stimuli::Study study_in(const std::string& language) {
    stimuli::Study study = small_study(9);
    study.words = stimuli::Words(language);
    study.question = "?";
    study.instructions = "!";
    return study;
}

/// The kiosk's window with the pages of one language.
class Kiosks {
  public:
    explicit Kiosks(const stimuli::Study& study)
        : display_(kSize.width, kSize.height), ui_(window_, study.words, 128) {}

    /// The texts of a page that stands still.
    std::vector<std::string> texts_of(const std::function<void(const Fonts&)>& page) {
        draw_first_frame(ui_, [&] { page(ui_.fonts()); });
        window_.present();
        std::vector<std::string> texts;
        for (const auto& use : page_state().tools.typesetter->uses()) texts.push_back(use.text);
        return texts;
    }
    /// Whether a click there answers that the first image was chosen; nothing: it answers nothing.
    std::optional<bool> answer_at(PointerPlace at, const stimuli::Study& study) {
        std::optional<Event> event;
        const auto page = [&] {
            auto pressed = question_screen(ui_.fonts(), study, {0, 9});
            if (pressed) event = std::move(pressed);
        };
        draw_first_frame(ui_, page);
        Input& input = window_.input();
        input.forget();
        input.open_at(0.0);
        input.pointer_moves(at);
        input.button_down(GLFW_MOUSE_BUTTON_LEFT, ++time_s_);
        input.button_up(GLFW_MOUSE_BUTTON_LEFT, ++time_s_);
        for (int frame = 0; frame < 6 || input.more(); ++frame) ui_.draw(page);
        if (!event) return std::nullopt;
        return std::get<Answered>(*event).first;
    }

  private:
    double time_s_ = 0.0;
    VirtualDisplay display_;
    Window window_{{0, false, {64, 64}}};
    Ui ui_;
};

/// The operator's page with all that it can say.
void draw_operator(const Fonts& fonts, const stimuli::Words& words, OperatorView::Page page) {
    OperatorView view;
    view.page = page;
    view.wait_s = 3.5;
    view.sessions = {"(reason)"};
    view.chosen = "(reason)";
    for (const char* key : {"op_sessions", "op_next", "op_checks", "op_disk", "op_timing",
                            "op_selftest", "op_no_selftest", "op_backed_up", "op_withdrawn",
                            "op_screen", "op_no_screen", "op_keys_free"}) {
        view.lines.push_back(words(key));
    }
    view.note = words("op_server_backs_up");
    (void)operator_screen(fonts, view);
}

/// Every page of the kiosk.
std::vector<std::function<void(const Fonts&)>> pages_of(const stimuli::Study& study,
                                                        FormDraft& draft,
                                                        const stimuli::Study& asking,
                                                        FormDraft& asked) {
    const auto& words = study.words;
    const Trouble trouble{words("not_saved"), "(reason)", words("not_saved_text")};
    const Trouble moved{words("store_moved"), "(reason)", words("store_moved_text")};
    const Trouble silent{words("store_silent"), "(reason)", words("store_silent_text")};
    const Trouble no_image{words("no_image"), "(reason)", words("no_image_text")};
    const CutOffSession session{"s-1", "2026-01-01T00:00:00Z", 3, 9, ""};
    const CutOffSession all{"s-1", "2026-01-01T00:00:00Z", 9, 9, ""};
    const CutOffSession refused{"s-1", "2026-01-01T00:00:00Z", 3, 9, "(reason)"};
    const std::string saved = words("all_saved_in", {{"file", "a.sqlite"}});
    return {
        [](const Fonts& fonts) { (void)start_screen(fonts); },
        [&](const Fonts& fonts) { (void)form_screen(fonts, study, draft); },
        [&](const Fonts& fonts) { (void)information_screen(fonts, asking); },
        [&](const Fonts& fonts) { (void)consent_screen(fonts, *asking.consent, asked); },
        [&](const Fonts& fonts) { (void)form_screen(fonts, asking, asked); },
        [](const Fonts& fonts) { (void)known_code_screen(fonts, "K7"); },
        [&](const Fonts& fonts) { (void)instructions_screen(fonts, study); },
        [](const Fonts& fonts) {
            (void)pairs_screen(fonts, {0, 9});
        },
        [](const Fonts& fonts) {
            (void)pairs_screen(fonts, {5, 9});
        },
        [](const Fonts& fonts) {
            (void)pairs_screen(fonts, {1, 9, true}, true);
        },
        [&](const Fonts& fonts) {
            (void)question_screen(fonts, study, {1, 9, true});
        },
        [&](const Fonts& fonts) {
            (void)question_screen(fonts, asking, {1, 9});
        },
        [](const Fonts& fonts) { (void)feedback_screen(fonts, true); },
        [](const Fonts& fonts) { (void)feedback_screen(fonts, false); },
        [](const Fonts& fonts) { (void)practice_over_screen(fonts, 9); },
        [](const Fonts& fonts) {
            (void)break_screen(fonts, {3, 9}, 12.5);
        },
        [&](const Fonts& fonts) {
            (void)question_screen(fonts, study, {2, 9});
        },
        [&](const Fonts& fonts) {
            // A key without a letter stands on no button.
            static const stimuli::Question kWithNone{"none",
                                                     stimuli::QuestionKind::kChoiceOrNone,
                                                     "?",
                                                     {},
                                                     {{"space"}, {"enter"}, {"page-up"}}};
            (void)question_screen(fonts, study, {2, 9}, {&kWithNone, 0});
        },
        [&](const Fonts& fonts) { thanks_screen(fonts, study, words("all_saved")); },
        [&, saved](const Fonts& fonts) { thanks_screen(fonts, study, saved); },
        [=](const Fonts& fonts) { draw_operator(fonts, study.words, OperatorView::Page::kPin); },
        [=](const Fonts& fonts) {
            draw_operator(fonts, study.words, OperatorView::Page::kOverview);
        },
        [=](const Fonts& fonts) {
            draw_operator(fonts, study.words, OperatorView::Page::kSessions);
        },
        [=](const Fonts& fonts) { draw_operator(fonts, study.words, OperatorView::Page::kSure); },
        [](const Fonts& fonts) {
            OperatorView none;
            none.page = OperatorView::Page::kSessions;
            (void)operator_screen(fonts, none);
        },
        [](const Fonts& fonts) {
            OperatorView view;
            view.session_open = true;
            (void)operator_screen(fonts, view);
        },
        [=](const Fonts& fonts) { (void)cut_off_screen(fonts, session); },
        [=](const Fonts& fonts) { (void)cut_off_screen(fonts, all); },
        [=](const Fonts& fonts) { (void)cut_off_screen(fonts, refused); },
        [=](const Fonts& fonts) { (void)abandon_screen(fonts, session); },
        [=](const Fonts& fonts) { (void)trouble_screen(fonts, trouble); },
        [=](const Fonts& fonts) { (void)trouble_screen(fonts, moved); },
        [=](const Fonts& fonts) { (void)trouble_screen(fonts, silent); },
        [=](const Fonts& fonts) { (void)trouble_screen(fonts, no_image); },
        [](const Fonts& fonts) { hidden_screen(fonts, Sight::kLostFocus, "(reason)"); },
        [](const Fonts& fonts) { hidden_screen(fonts, Sight::kResized, "(reason)"); },
        [](const Fonts& fonts) { saving_screen(fonts); }};
}

/// A text of the catalogue with anything where it has a {name}.
bool is_made_from(const std::string& text, const std::string& word) {
    std::size_t at = 0;
    std::size_t from = 0;
    while (true) {
        const auto open = word.find('{', from);
        const std::string part = word.substr(from, open == std::string::npos ? open : open - from);
        const auto found = text.find(part, at);
        if (found == std::string::npos || (from == 0 && found != 0)) return false;
        at = found + part.size();
        if (open == std::string::npos) return at == text.size() || part.empty();
        from = word.find('}', open) + 1;
    }
}

TEST(Languages, NoPageSaysAWordThatIsNotOfItsLanguageAndEveryWordIsOnAPage) {
    for (const std::string language : {"de", "ar"}) {
        const stimuli::Study study = study_in(language);
        Kiosks kiosk(study);
        const stimuli::Study asking = asking_study(language);
        FormDraft draft = wrong_draft(study);
        FormDraft asked = wrong_draft(asking);
        std::set<std::string> seen;
        for (const auto& page : pages_of(study, draft, asking, asked)) {
            for (const std::string& text : kiosk.texts_of(page)) {
                const auto made_from = std::count_if(
                    study.words.all().begin(), study.words.all().end(), [&](const auto& word) {
                        const bool made = is_made_from(text, word.second) ||
                                          is_made_from(text, word.second + "\u00A0*") ||
                                          is_made_from(text, word.second + "  \u2713");
                        if (made) seen.insert(word.first);
                        return made;
                    });
                const bool is_other = text.size() <= 1 || text == "\u2190" || text == "(reason)" ||
                                      text == "\u25A1" || text == "777" || text == "10" ||
                                      text == "ten" || text == "1\u00A0*";
                EXPECT_TRUE(made_from > 0 || is_other) << language << ": " << text;
            }
        }
        FormDraft letters;
        letters.age.type(U'x');
        for (const std::string& text : kiosk.texts_of(
                 [&](const Fonts& fonts) { (void)form_screen(fonts, study, letters); })) {
            if (text == study.words("only_digits")) seen.insert("only_digits");
        }
        // Each is a key of its own, on a page that a mouse was on.
        seen.insert("keypad_letters");
        // One stands in the foot of the form until its end was seen, then the other.
        seen.insert({"read_on", "continue"});
        for (const auto& [key, text] : study.words.all()) {
            EXPECT_TRUE(seen.contains(key)) << language << ": nothing says " << key;
        }
    }
}

TEST(Languages, ThePagesFitTheSmallestWindowInEveryLanguage) {
    for (const std::string& language : stimuli::word_languages()) {
        EXPECT_THAT(notes_on_pages(study_in(language)), IsEmpty()) << language;
        EXPECT_EQ(note_on_words(study_in(language)), "") << language;
    }
    EXPECT_THAT(note_on_words(study_in("sv")), testing::HasSubstr("yes"));
}

/// Where, from the left, a click gives that answer to the question: the middle of such places.
std::optional<double> place_of(bool first, const stimuli::Study& study) {
    Kiosks kiosk(study);
    double sum = 0.0;
    int count = 0;
    for (const double x : {330.0, 694.0}) {
        for (double y = 300.0; y < 500.0; y += 40.0) {
            const auto answer = kiosk.answer_at({x, y}, study);
            if (!answer || *answer != first) continue;
            sum += x;
            ++count;
        }
    }
    if (count == 0) return std::nullopt;
    return sum / count;
}

class TypesetterTest : public testing::Test {
  protected:
    static constexpr Setting kWide{.text_px = 25.0F, .width_px = 400.0F};
    static Typesetter of(const std::string& language) {
        return {language, stimuli::Words(language).right_to_left(), Typesetter::Draws::kNothing};
    }
};

TEST_F(TypesetterTest, AParagraphBeginsAtTheSideOfItsOwnScript) {
    for (const char* language : {"en", "ar"}) {
        Typesetter typesetter = of(language);
        EXPECT_EQ(typesetter.set("Which image?", kWide).left_px, 0.0F) << language;
        const SetText& arabic =
            typesetter.set("\u0623\u064A \u0635\u0648\u0631\u0629\u061F", kWide);
        EXPECT_GT(arabic.left_px, 200.0F) << language;
        EXPECT_NEAR(arabic.left_px + arabic.width_px, 400.0F, 1.0F) << language;
    }
}

TEST_F(TypesetterTest, ASentenceFromTheRightStaysOneWhereItBeginsWithALatinWord) {
    Typesetter typesetter = of("ar");
    const SetText& mixed =
        typesetter.set("Enter \u0644\u0644\u0645\u062A\u0627\u0628\u0639\u0629", kWide);
    EXPECT_NEAR(mixed.left_px + mixed.width_px, 400.0F, 1.0F);
}

TEST_F(TypesetterTest, LinesBreakWithinTheWidthInScriptsWithoutBlanksToo) {
    Typesetter typesetter = of("ja");
    std::string text;
    for (int i = 0; i < 40; ++i) text += "\u753B\u50CF";
    const SetText& set = typesetter.set(text, kWide);
    EXPECT_LE(set.width_px, 400.0F);
    EXPECT_GT(set.height_px, 3.0F * 25.0F);
    const SetText& word = typesetter.set(std::string(200, 'm'), kWide);
    EXPECT_LE(word.width_px, 400.0F) << "a word longer than a line is broken";
}

TEST_F(TypesetterTest, LettersThatJoinTakeLessRoomThanApart) {
    Typesetter typesetter = of("ar");
    const auto width = [&](const std::string& text) {
        return typesetter.set(text, {.text_px = 25.0F}).width_px;
    };
    EXPECT_LT(width("\u0633\u0633\u0633"), 3.0F * width("\u0633"));
    EXPECT_EQ(width("cafe\u0301"), width("caf\u00E9")) << "a mark stands over its letter";
}

TEST_F(TypesetterTest, TheCaretStandsWhereTheNextLetterWouldCome) {
    Typesetter typesetter = of("en");
    const std::string text = "a\u00E9\U0001F600z";
    EXPECT_EQ(typesetter.caret_px(text, 25.0F, 0), 0.0F);
    float before = 0.0F;
    for (const std::size_t byte : {1U, 3U, 7U, 8U}) {
        const float caret = typesetter.caret_px(text, 25.0F, byte);
        EXPECT_GT(caret, before);
        EXPECT_EQ(typesetter.byte_at(text, 25.0F, caret), byte);
        before = caret;
    }
    const std::string arabic = "\u0633\u0644";
    EXPECT_GT(typesetter.caret_px(arabic, 25.0F, 0),
              typesetter.caret_px(arabic, 25.0F, arabic.size()))
        << "from the right";
}

TEST_F(TypesetterTest, WhatIsNoTextInUtf8IsSetAllTheSame) {
    Typesetter typesetter = of("en");
    EXPECT_GT(typesetter.set("a file \xFF\xFE.sqlite", kWide).width_px, 0.0F);
    EXPECT_THAT(typesetter.characters_without_glyph("\xFF"), IsEmpty());
}

TEST(MirroredPage, TheFirstImageIsAtTheSideWhereReadingBegins) {
    const auto left = place_of(true, study_in("de"));
    const auto right = place_of(false, study_in("de"));
    ASSERT_TRUE(left && right);
    EXPECT_LT(*left, *right);
    const auto first = place_of(true, study_in("ar"));
    const auto second = place_of(false, study_in("ar"));
    ASSERT_TRUE(first && second);
    EXPECT_GT(*first, *second);
}

}  // namespace
}  // namespace obscura::app::kiosk
