// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/page.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

// Only for the names of the keys.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/kiosk/widgets.h"
#include "app/window/letters.h"

namespace obscura::app::kiosk {
namespace {

/// Free space between a card and the window's edge, in pixels.
constexpr float kMargin_px = 24.0F;
/// Times the text's height: between body and foot, one step of an arrow or of the wheel, and what
/// of a page stays in view when it is turned.
constexpr float kFootGap = 0.9F;
constexpr float kScrollStep = 3.0F;
constexpr float kKeptInView = 2.5F;
/// What comes into view with a stop: its question above, what is said of it below.
constexpr float kShownAround = 2.5F;
constexpr float kBesideScrollBar = 0.6F;
constexpr float kFarthest_px = 1e9F;
constexpr float kBelowAnyBody_px = 1e6F;
/// Frames after which the heights of the frame before are those of this one.
constexpr int kSettling = 2;

[[nodiscard]] const FocusStop* find_stop(const std::vector<FocusStop>& stops, unsigned id) {
    const auto found = std::find_if(stops.begin(), stops.end(),
                                    [id](const FocusStop& stop) { return stop.id == id; });
    return found != stops.end() ? &*found : nullptr;
}

/// Where the keyboard begins: as eyes read in the body, else at the page's way on.
[[nodiscard]] unsigned first_focus(const std::vector<FocusStop>& stops) {
    if (stops.empty()) return 0;
    if (stops.front().in_body) return stops.front().id;
    const auto primary =
        std::find_if(stops.begin(), stops.end(), [](const auto& stop) { return stop.primary; });
    return primary != stops.end() ? primary->id : stops.front().id;
}

void focus_on(PageState& page, const FocusStop& stop) {
    page.focus = stop.id;
    page.reveal = true;
    // What stands above the first stop and below the last is read as well.
    if (!stop.in_body) return;
    const auto in_body = [](const FocusStop& other) { return other.in_body; };
    const auto first = std::find_if(page.stops.begin(), page.stops.end(), in_body);
    const auto last = std::find_if(page.stops.rbegin(), page.stops.rend(), in_body);
    if (first->id == stop.id) page.scroll_px = -kFarthest_px;
    if (last->id == stop.id) page.scroll_px = kFarthest_px;
}

/// To the next stop or the one before, round and round.
void move_by_one(PageState& page, int by) {
    const auto count = static_cast<int>(page.stops.size());
    if (count == 0) return;
    int at = 0;
    while (at < count && page.stops[static_cast<std::size_t>(at)].id != page.focus) ++at;
    focus_on(page, page.stops[static_cast<std::size_t>((at + by + count) % count)]);
}

/// To the first stop of the line above or below.
void move_by_line(PageState& page, int by) {
    const FocusStop* here = find_stop(page.stops, page.focus);
    if (here == nullptr) return;
    const auto middle = [](const FocusStop& stop) { return stop.top_px + 0.5F * stop.height_px; };
    const auto is_beyond = [&](const FocusStop& stop, const FocusStop& from) {
        const float apart = (middle(stop) - middle(from)) * static_cast<float>(by);
        return apart > 0.5F * std::min(stop.height_px, from.height_px);
    };
    const FocusStop* best = nullptr;
    for (const FocusStop& stop : page.stops) {
        if (is_beyond(stop, *here) && (best == nullptr || is_beyond(*best, stop))) best = &stop;
    }
    if (best != nullptr) focus_on(page, *best);
}

[[nodiscard]] bool has_lines_to_move_over(const PageState& page) {
    return std::count_if(page.stops.begin(), page.stops.end(),
                         [](const FocusStop& stop) { return stop.in_body; }) > 1;
}

/// What a key does on every page; `visible_px` of the body are in view.
void obey(PageState& page, const Stroke& stroke, float visible_px) {
    const float text_px = ImGui::GetFontSize();
    const bool moves = page.keyboard == Keyboard::kMovesAndPresses;
    const FocusStop* here = find_stop(page.stops, page.focus);
    const bool typing = here != nullptr && here->text;
    const auto up_or_down = [&](int by) {
        if (moves && has_lines_to_move_over(page)) {
            move_by_line(page, by);
        } else {
            page.scroll_px += static_cast<float>(by) * kScrollStep * text_px;
        }
    };
    const float turn_px = std::max(text_px, visible_px - kKeptInView * text_px);
    switch (stroke.key) {
        case GLFW_KEY_TAB:
            if (moves) move_by_one(page, (stroke.modifiers & GLFW_MOD_SHIFT) != 0 ? -1 : 1);
            break;
        case GLFW_KEY_DOWN:
            up_or_down(1);
            break;
        case GLFW_KEY_UP:
            up_or_down(-1);
            break;
        case GLFW_KEY_RIGHT:
            if (moves && !typing) move_by_one(page, is_mirrored() ? -1 : 1);
            break;
        case GLFW_KEY_LEFT:
            if (moves && !typing) move_by_one(page, is_mirrored() ? 1 : -1);
            break;
        case GLFW_KEY_PAGE_DOWN:
            page.scroll_px += turn_px;
            break;
        case GLFW_KEY_PAGE_UP:
            page.scroll_px -= turn_px;
            break;
        case GLFW_KEY_HOME:
            if (!typing) page.scroll_px = -kFarthest_px;
            break;
        case GLFW_KEY_END:
            if (!typing) page.scroll_px = kFarthest_px;
            break;
        default:
            break;
    }
}

void begin_frame(PageState& page, Keyboard keyboard, float visible_px) {
    page.keyboard = keyboard;
    page.scroll_px = -ImGui::GetIO().MouseWheel * kScrollStep * ImGui::GetFontSize();
    page.reveal = false;
    if (find_stop(page.stops, page.focus) == nullptr) page.focus = first_focus(page.stops);
    for (const Stroke& stroke : page.input.strokes) {
        obey(page, stroke, visible_px);
        page.keypad = {};
        if (stroke.character != 0) page.keyboard_types = true;
    }
    page.stops_now.clear();
}

void draw_body(PageState& page, const std::function<void()>& body, float visible_px,
               bool overflows) {
    const ImGuiWindowFlags bar =
        overflows ? ImGuiWindowFlags_AlwaysVerticalScrollbar : ImGuiWindowFlags_NoScrollbar;
    page.in_body = true;
    if (overflows) {
        const float bar_px = ImGui::GetStyle().ScrollbarSize + times_text(kBesideScrollBar);
        ImGui::SetNextWindowContentSize({ImGui::GetContentRegionAvail().x - bar_px, 0.0F});
    }
    ImGui::BeginChild("##body", {0.0F, std::max(1.0F, visible_px)}, false,
                      bar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNav);
    if (page.frames < kSettling) {
        ImGui::SetScrollY(0.0F);
    } else if (page.scroll_px != 0.0F) {
        const float to = ImGui::GetScrollY() + page.scroll_px;
        ImGui::SetScrollY(std::clamp(to, 0.0F, ImGui::GetScrollMaxY()));
    }
    body();
    page.body_px = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
    page.scrolled_px = ImGui::GetScrollY();
    page.at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 1.0F;
    ImGui::EndChild();
    page.in_body = false;
}

/// Stands in place of the foot until the end was seen.
void draw_way_to_the_end(PageState& page, float visible_px) {
    if (primary_button(words()("read_on"))) {
        page.scroll_px = std::max(1.0F, visible_px - kKeptInView * ImGui::GetFontSize());
    }
}

}  // namespace

float times_text(float times) { return std::round(times * ImGui::GetFontSize()); }

PageState& page_state() { return *static_cast<PageState*>(ImGui::GetIO().UserData); }

const stimuli::Words& words() { return *page_state().tools.words; }

bool is_mirrored() { return words().right_to_left(); }

void card(const char* name, float columns, const std::function<void()>& body,
          const std::function<void()>& foot, Keyboard keyboard) {
    PageState& page = page_state();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float text_px = ImGui::GetFontSize();
    const float width = std::round(std::min(screen.x - 2.0F * kMargin_px, columns * text_px));
    const float around_px = 2.0F * ImGui::GetStyle().WindowPadding.y + page.foot_px +
                            (page.foot_px > 0.0F ? times_text(kFootGap) : 0.0F);
    const float room_px = screen.y - 2.0F * kMargin_px - around_px;
    // Rounding alone must not bring a scroll bar.
    const bool overflows = page.body_px > room_px + 0.5F;
    const float visible_px = overflows || page.frames == 0 ? room_px : page.body_px;
    const bool in_view =
        overflows ? page.at_end && page.frames > kSettling : page.frames >= kSettling;
    if (in_view) page.end_seen = true;
    const float asked_px = page.scroll_px;
    begin_frame(page, keyboard, visible_px);
    if (asked_px > 0.0F) page.scroll_px += asked_px;

    ImGui::SetNextWindowPos({screen.x * 0.5F, screen.y * 0.5F}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({width, std::ceil(around_px + visible_px)});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse |
                     ImGuiWindowFlags_NoNav);
    draw_body(page, body, visible_px, overflows);
    page.scroll_px = 0.0F;
    if (foot) {
        const float top = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
        ImGui::SetCursorPosY(top + times_text(kFootGap));
        if (page.end_seen || page.frames < kSettling) {
            foot();
        } else {
            draw_way_to_the_end(page, visible_px);
        }
        const float bottom = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
        const float foot_px = bottom - top - times_text(kFootGap);
        // A foot that is taller than what stood in its place would move the text being read.
        page.foot_px = overflows ? std::max(page.foot_px, foot_px) : foot_px;
    }
    ImGui::End();
    page.stops = std::exchange(page.stops_now, {});
    ++page.frames;
}

bool key_pressed(int key) {
    const auto& strokes = page_state().input.strokes;
    return std::any_of(strokes.begin(), strokes.end(), [key](const Stroke& stroke) {
        return stroke.key == key && !stroke.repeats;
    });
}

bool enter_pressed() { return key_pressed(GLFW_KEY_ENTER) || key_pressed(GLFW_KEY_KP_ENTER); }

bool letter_pressed(char letter) { return key_pressed(window::key_of_letter(letter)); }

void focus_next() { page_state().focus_next = true; }

bool is_disabled() { return (GImGui->CurrentItemFlags & ImGuiItemFlags_Disabled) != 0; }

bool begin_stop(unsigned id, StopKind kind) {
    PageState& page = page_state();
    if (is_disabled() || page.keyboard == Keyboard::kIsLeftToTheCaller) return false;
    const float top_px = ImGui::GetCursorPosY() + (page.in_body ? 0.0F : kBelowAnyBody_px);
    page.stops_now.push_back({id, top_px, ImGui::GetFrameHeight(), page.in_body,
                              kind == StopKind::kPrimary, kind == StopKind::kText});
    if (std::exchange(page.focus_next, false)) {
        page.focus = id;
        page.reveal = true;
    }
    return page.focus == id;
}

bool end_stop(unsigned id, bool here) {
    PageState& page = page_state();
    if (ImGui::IsItemActivated() && page.keyboard == Keyboard::kMovesAndPresses) page.focus = id;
    if (!here) return false;
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    if (page.reveal && page.in_body) {
        const float around_px = times_text(kShownAround);
        ImGui::ScrollToRect(ImGui::GetCurrentWindow(),
                            {from.x, from.y - around_px, to.x, to.y + around_px},
                            ImGuiScrollFlags_KeepVisibleEdgeY);
    }
    const float text_px = ImGui::GetFontSize();
    const float off = std::round(0.15F * text_px);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // The ring may reach a little out of the body's frame.
    list.PushClipRect({ImGui::GetWindowPos().x - 2.0F * off, ImGui::GetWindowPos().y - 2.0F * off},
                      {ImGui::GetWindowPos().x + ImGui::GetWindowWidth() + 2.0F * off,
                       ImGui::GetWindowPos().y + ImGui::GetWindowHeight() + 2.0F * off});
    list.AddRect({from.x - off, from.y - off}, {to.x + off, to.y + off},
                 ImGui::GetColorU32(ImGuiCol_NavHighlight), 0.3F * text_px, 0,
                 std::max(2.0F, 0.1F * text_px));
    list.PopClipRect();
    const bool pressed = key_pressed(GLFW_KEY_SPACE);
    // It shall not type a blank where the press moves the keyboard to.
    if (pressed) page.input.strokes.clear();
    return pressed;
}

}  // namespace obscura::app::kiosk
