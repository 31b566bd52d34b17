// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The pages of further questions, in a window: each answer by its key and by the mouse.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <set>

#include "app/kiosk/key_names.h"
#include "app/kiosk/screens.h"
#include "app/kiosk/stage.h"
#include "tests/app/kiosk/asking_study.h"
#include "tests/app/kiosk/virtual_display.h"

namespace obscura::app::kiosk {
namespace {

using stimuli::Question;
using stimuli::QuestionKind;
using testing::SizeIs;

/// Every kind of page.
std::vector<Question> every_page() {
    std::vector<Question> questions = asking_questions().list;
    questions.push_back({"none", QuestionKind::kChoiceOrNone, "Is there a difference?"});
    questions.push_back({"own",
                         QuestionKind::kChoiceOrNone,
                         "And here?",
                         {"This one", "That one", "Neither of them"},
                         {{"f"}, {"j"}, {"space"}}});
    questions.push_back(
        {"ten", QuestionKind::kRating, "From one to ten?", {"low", "high"}, {}, 1, 10});
    questions.push_back({"steps",
                         QuestionKind::kRating,
                         "In words?",
                         {"bad", "poor", "fair", "good", "excellent"},
                         {},
                         1,
                         5});
    return questions;
}

std::optional<int> answer_in(const std::optional<Event>& event) {
    if (!event) return std::nullopt;
    const auto* pressed = std::get_if<AnswerPressed>(&*event);
    return pressed == nullptr ? std::nullopt : std::optional<int>(pressed->answer);
}

class QuestionPages : public testing::TestWithParam<const char*> {
  protected:
    QuestionPages()
        : study_(small_study(3)), display_(1024, 720), window_({0, false, {64, 64}}), ui_([this] {
              study_.words = stimuli::Words(GetParam());
              return Ui(window_, study_.words, 128);
          }()) {}

    stimuli::Study study_;
    VirtualDisplay display_;
    Window window_;
    Ui ui_;
};

TEST_P(QuestionPages, EveryAnswerCanBeGivenByTheMouseAndNoButtonIsAnothers) {
    // One of each way to lay out a page.
    const std::set<std::string> laid_out{"none", "ten", "steps"};
    for (const Question& question : every_page()) {
        if (!laid_out.contains(question.id)) continue;
        const AskedPage page{&question, question.each_image ? 1 : 0};
        std::optional<Event> event;
        const auto draw = [&] {
            const auto pressed = question_screen(ui_.fonts(), study_, {0, 3}, page);
            if (pressed) event = pressed;
        };
        draw_first_frame(ui_, draw);
        window_.present();
        EXPECT_TRUE(ui_.end_seen()) << question.id << " is no page that scrolls";
        Input& input = window_.input();
        input.forget();
        input.open_at(0.0);
        double time_s = 0.0;
        std::set<int> answered;
        for (double y = 240; y < 720 && static_cast<int>(answered.size()) < page.answer_count();
             y += 30) {
            for (double x = 20; x < 1024; x += 40) {
                event.reset();
                input.pointer_moves({x, y});
                input.button_down(GLFW_MOUSE_BUTTON_LEFT, ++time_s);
                input.button_up(GLFW_MOUSE_BUTTON_LEFT, ++time_s);
                do {
                    ui_.draw(draw);
                } while (input.more());
                if (const auto answer = answer_in(event)) answered.insert(*answer);
            }
        }
        EXPECT_THAT(answered, SizeIs(page.answer_count())) << question.id;
    }
}

TEST_P(QuestionPages, EveryAnswerHasAKeyOfItsOwn) {
    std::set<int> keys;
    for (int key = GLFW_KEY_SPACE; key <= GLFW_KEY_KP_ENTER; ++key) keys.insert(key);
    for (const Question& question : every_page()) {
        const AskedPage page{&question, 0};
        std::set<int> answered;
        for (const int key : keys) {
            if (const auto answer = answer_of({key, 0, 1.0}, study_, page))
                answered.insert(*answer);
        }
        EXPECT_THAT(answered, SizeIs(page.answer_count())) << question.id;
    }
    const AskedPage plain;
    const bool mirrored = study_.words.right_to_left();
    EXPECT_EQ(answer_of({GLFW_KEY_LEFT, 0, 1.0}, study_, plain), mirrored ? 1 : 0);
    EXPECT_EQ(answer_of({GLFW_KEY_1, 0, 1.0}, study_, plain), 0);
    EXPECT_EQ(answer_of({GLFW_KEY_3, 0, 1.0}, study_, plain), std::nullopt);
}

INSTANTIATE_TEST_SUITE_P(LeftAndRight, QuestionPages, testing::Values("en", "ar"));

}  // namespace
}  // namespace obscura::app::kiosk
