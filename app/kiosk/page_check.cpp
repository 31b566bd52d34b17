// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/page_check.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <functional>

#include "app/kiosk/page.h"
#include "app/kiosk/screens.h"
#include "app/kiosk/widgets.h"
#include "app/kiosk/window.h"

namespace obscura::app::kiosk {
namespace {

/// Dear ImGui without a window: pages are laid out and never drawn.
class Layout {
  public:
    Layout(const stimuli::Words& words, Extent window)
        : before_(ImGui::GetCurrentContext()),
          context_(ImGui::CreateContext()),
          typesetter_(words.language(), words.right_to_left(), Typesetter::Draws::kNothing) {
        page_.tools = {&typesetter_, &words};
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.UserData = &page_;
        io.DisplaySize = {static_cast<float>(window.width), static_cast<float>(window.height)};
        try {
            fonts_ = window::load_fonts({}, window::sizes_of_pages(window.height));
        } catch (...) {
            end();
            throw;
        }
        set_style(fonts_.text->FontSize);
    }
    ~Layout() { end(); }
    Layout(const Layout&) = delete;
    Layout& operator=(const Layout&) = delete;

    [[nodiscard]] bool holds(const std::function<void(const Fonts&)>& page) {
        page_.begin_anew();
        for (int frame = 0; frame < kFirstFrames; ++frame) {
            ImGui::NewFrame();
            typesetter_.note_uses();
            page(fonts_);
            ImGui::EndFrame();
        }
        return page_.end_seen;
    }

  private:
    void end() {
        ImGui::DestroyContext(context_);
        ImGui::SetCurrentContext(before_);
    }

    ImGuiContext* before_;
    ImGuiContext* context_;
    Typesetter typesetter_;
    PageState page_;
    Fonts fonts_;
};

}  // namespace

std::vector<std::string> notes_on_pages(const stimuli::Study& study,
                                        const stimuli::Questions& questions) {
    const Extent window{std::max(kSmallestWindow.width, study.width),
                        std::max(kSmallestWindow.height, study.height)};
    Layout layout(study.words, window);
    const Progress at{0, study.pair_count()};
    std::vector<std::string> notes;
    const auto note = [&](const char* what, const std::function<void(const Fonts&)>& page) {
        if (layout.holds(page)) return;
        notes.push_back(
            fmt::format("{} longer than a page at {}x{}: that scrolls, and can be left only after "
                        "its end was seen",
                        what, window.width, window.height));
    };
    note("the instructions are",
         [&](const Fonts& fonts) { (void)instructions_screen(fonts, study); });
    if (!study.information.empty()) {
        note("the information is",
             [&](const Fonts& fonts) { (void)information_screen(fonts, study); });
    }
    FormDraft draft;
    if (study.consent) {
        note("the consent is",
             [&](const Fonts& fonts) { (void)consent_screen(fonts, *study.consent, draft); });
    }
    note("the form is", [&](const Fonts& fonts) { (void)form_screen(fonts, study, draft); });
    if (questions.list.empty()) {
        note("the question is",
             [&](const Fonts& fonts) { (void)question_screen(fonts, study, at); });
    }
    for (const stimuli::Question& question : questions.list) {
        const AskedPage page{&question, question.each_image ? 1 : 0};
        note(fmt::format("the question {} is", question.id).c_str(),
             [&](const Fonts& fonts) { (void)question_screen(fonts, study, at, page); });
    }
    note("the thanks are",
         [&](const Fonts& fonts) { thanks_screen(fonts, study, study.words("all_saved")); });
    note("the list of pairs is",
         [&](const Fonts& fonts) { (void)pairs_screen(fonts, at, study.has_next_button()); });
    return notes;
}

}  // namespace obscura::app::kiosk
