// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/explorer.h"

#include <fmt/format.h>
#include <imgui.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/explorer/controls.h"
#include "app/explorer/flight.h"
#include "app/explorer/remembered.h"
#include "app/explorer/starting_point.h"
#include "renderer/base/error.h"
#include "renderer/base/log.h"

namespace obscura::app::explorer {
namespace {

constexpr double kLivelyWait_s = 1.0 / 60.0;
constexpr double kIdleWait_s = 0.25;
constexpr double kSoonWait_s = 0.04;
/// While an image is rendered on the processor, drawing the window takes the time from it: it waits
/// for the image, but not longer than this.
constexpr double kWindowEvery_s = 0.1;
constexpr int kOutsideTheHeap_bytes = 16 << 20;
constexpr const char* kSidePanel = "##side";

[[nodiscard]] Remembered remembered_for(const ExploreOptions& options) {
    if (options.reset) return {};
    return load_remembered(options.data).value_or(Remembered{});
}

[[nodiscard]] std::optional<WindowSize> window_for(const ExploreOptions& options) {
    if (options.window) return options.window;
    const Remembered remembered = remembered_for(options);
    if (remembered.window_width < 1 || remembered.window_height < 1) return std::nullopt;
    return WindowSize{remembered.window_width, remembered.window_height};
}

}  // namespace

Explorer::Explorer(ExploreOptions options)
    : options_(std::move(options)),
      window_(window_for(options_)),
      model_(Choices{}),
      renderer_(&ExplorerWindow::wake),
      tracer_(&ExplorerWindow::wake),
      opener_(&ExplorerWindow::wake) {
    // Scenes and images come and go: in a heap they would leave gaps between what stays, and the
    // program would grow with every scene.
    (void)::mallopt(M_MMAP_THRESHOLD, kOutsideTheHeap_bytes);
    const Remembered remembered = remembered_for(options_);
    state_.panels = remembered.panels;
    state_.text_scale = remembered.text_scale;
    model_.set_layout(remembered.layout, window_.now_s());
    frame_s_ = window_.now_s();
    if (!options_.what.empty()) {
        open(options_.what);
        return;
    }
    try {
        open(remembered.what.empty() ? "atrium" : remembered.what);
    } catch (const base::Error& error) {
        say(error.what(), true);
        open("atrium");
    }
}

Explorer::~Explorer() {
    try {
        const WindowSize size = window_.size();
        std::string what = model_.choices().scene.source;
        if (model_.study()) what = model_.study()->name;
        // The next start may be from another folder.
        if (model_.study() && !model_.study()->file.empty()) {
            what = std::filesystem::absolute(model_.study()->file).string();
        }
        save_remembered(options_.data, {size.width, size.height, what, state_.text_scale,
                                        state_.panels, model_.layout()});
    } catch (const std::exception& error) {
        base::log::warn("what is remembered could not be saved: {}", error.what());
    }
}

void Explorer::say(std::string text, bool problem) {
    if (problem) base::log::warn("{}", text);
    state_.messages.push_back({std::move(text), problem, window_.now_s()});
}

bool Explorer::at_rest() const {
    return opener_.under_way().empty() && !renderer_.busy() && !waiting_image_ && !waiting_buffers_;
}

void Explorer::open(const std::string& what) {
    StartingPoint start = starting_point(what, model_.choices());
    if (options_.image) {
        start.choices.width = options_.image->width;
        start.choices.height = options_.image->height;
    }
    model_.set_study(std::move(start.study));
    own_camera_ = start.own_camera;
    opener_.open(std::move(start.choices), start.camera, false);
}

void Explorer::show_condition(const std::string& id) {
    if (!model_.study() || model_.study()->study.find_condition(id) == nullptr) return;
    const StartingPoint start = starting_point(*model_.study(), id, model_.choices());
    own_camera_ = start.own_camera;
    opener_.open(start.choices, start.camera, false);
}

void Explorer::take_results() {
    const double now_s = window_.now_s();
    if (auto opened = opener_.take()) {
        if (!opened->scene) {
            say(fmt::format("{}; allowed are .gltf, .glb and .obj files and studies (.toml)",
                            opened->problem),
                true);
        }
        const bool there = opened->scene != nullptr;
        scene_is_new_ |= there;
        model_.opened(std::move(*opened), now_s);
        if (there) {
            if (own_camera_) model_.look_from(*own_camera_, now_s);
            own_camera_.reset();
            read_fitted();
            state_.speed_m_s = usual_speed_m_s(model_.scene()->bounds());
            window_.set_title("Obscura: " + model_.choices().scene.source);
        }
    }
    RenderAnswers answers = renderer_.take();
    for (Shot& shot : answers.shots) model_.rendered(std::move(shot), now_s);
    for (std::string& problem : answers.problems) say(std::move(problem), true);
    if (std::string problem = tracer_.take_problem(); !problem.empty()) say(problem, true);
    // A copy of all pixels is not made for every frame.
    constexpr double kTruthEvery_s = 0.4;
    if (now_s - truth_s_ > kTruthEvery_s) {
        truth_s_ = now_s;
        model_.set_truth(tracer_.snapshot(model_.truth_look()));
    }
    if (!renderer_.device().empty() && software_ != renderer_.software()) {
        software_ = renderer_.software();
        model_.set_software(software_);
    }
}

void Explorer::give_back_memory() {
    scene_is_new_ = false;
    // What the scene before had lies in pieces between what is still used, in a heap of each
    // thread: without this the program would grow by hundreds of megabytes with every scene.
    (void)::malloc_trim(0);
}

void Explorer::read_fitted() {
    try {
        state_.fitted = read_fitted_values(options_.data / "reports" / "measure" / "fitted.csv");
    } catch (const std::exception& error) {
        state_.fitted.clear();
        say(fmt::format("No fitted values are offered: {}", error.what()), true);
    }
}

void Explorer::ask_for_work() {
    const double now_s = window_.now_s();
    if (auto wanted = model_.take_wanted_scene()) opener_.open(*wanted, "", true);
    if (auto wanted = model_.next_request(now_s, renderer_.busy())) {
        renderer_.ask(std::move(wanted->request), wanted->stop);
    }
    tracer_.pause(model_.truth_waits(now_s, renderer_.busy()));
    if (auto wanted = model_.next_truth(now_s)) tracer_.start(std::move(*wanted));
    if (state_.pointer_px) tracer_.focus(state_.pointer_px->x, state_.pointer_px->y);
    if (!model_.moving(now_s)) model_.visit();
}

void Explorer::draw_side_panel(Desk& desk, const Box& box) {
    ImGui::SetNextWindowPos({box.low.x, box.low.y});
    ImGui::SetNextWindowSize({box.size().x, box.size().y});
    side_panel_ = PanelPlace{kSidePanel, box.low, box.high};
    ImGui::Begin(kSidePanel, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing);
    const auto section = [](const char* name, bool open) {
        return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    };
    if (section("Scene", true)) scene_panel(desk);
    if (section("View", true)) view_panel(desk);
    if (section("A", true)) technique_panel(desk, 'a');
    if (section("B", true)) technique_panel(desk, 'b');
    if (section("Error", true)) error_panel(desk);
    if (section("Cost", false)) cost_panel(desk);
    ImGui::End();
}

void Explorer::draw(Desk& desk) {
    menu_bar(desk);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float text = ImGui::GetFontSize();
    const float menu = ImGui::GetFrameHeight();
    const float status = std::min(5.2F * text, 0.5F * screen.y);
    const bool roomy = screen.x > 40.0F * text && screen.y > 12.0F * text;
    // Whole pixels, so that a picture of the panel is the panel.
    const float side =
        state_.panels && roomy ? std::floor(std::min(25.0F * text, 0.45F * screen.x)) : 0.0F;
    const float bottom = std::max(menu + 1.0F, screen.y - status);
    const float right = std::max(1.0F, screen.x - side);
    view_.draw(desk, {{0.0F, menu}, {right, bottom}});
    side_panel_.reset();
    if (side > 0.0F) draw_side_panel(desk, {{right, menu}, {screen.x, bottom}});
    status_bar(desk, status);
    open_window(desk);
    study_window(desk);
    help_window(desk);
}

double Explorer::longest_wait_s() const {
    const bool lively =
        keys_held_ || view_.dragging() || model_.layout().arrangement == Arrangement::kFlicker;
    if (lively || frames_due_ > 0) return kLivelyWait_s;
    // The image at rest is asked for soon after the last change.
    if (has_gamepad() || model_.moving(window_.now_s())) return kSoonWait_s;
    return kIdleWait_s;
}

bool Explorer::step() {
    window_.set_text_scale(state_.text_scale);
    const bool shares = software_ && renderer_.busy() && !renderer_.has_answers();
    window_.begin_frame(longest_wait_s(), shares ? frame_s_ + kWindowEvery_s : 0.0,
                        [this] { return renderer_.has_answers(); });
    // A window that is asked for is there in the second frame, and has the keys in the third.
    frames_due_ = window_.pressed() ? 3 : std::max(0, frames_due_ - 1);
    const std::optional<double> first_input_s = window_.first_input_s();
    const double now_s = window_.now_s();
    take_results();
    Orders orders;
    Desk desk{model_, now_s, window_.fonts(), orders, state_};
    desk.device = renderer_.device();
    desk.opening = opener_.under_way();
    desk.opening_s = opener_.seconds();
    desk.rendering = renderer_.busy();
    desk.tracing = tracer_.running();
    const std::uint64_t look_before = model_.look();
    draw(desk);
    keys_held_ = keyboard_and_gamepad(desk, now_s - frame_s_);
    frame_s_ = now_s;
    if (model_.look() != look_before && first_input_s) {
        unanswered_.push_back({*first_input_s, 0.0, model_.look()});
    }
    ask_for_work();
    // Flying, nobody uses the panel, and its letters take the time of the images.
    const bool flies = software_ && model_.moving(now_s) && (keys_held_ || view_.dragging());
    window_.end_frame(flies ? side_panel_ : std::nullopt);
    if (window_.is_lost()) end_without_driver();
    note_answered();
    for (const std::string& file : window_.take_dropped()) orders.open = file;
    carry_out(orders);
    save_when_ready();
    if (scene_is_new_ && at_rest() && !model_.moving(window_.now_s())) give_back_memory();
    return !window_.wants_to_close();
}

void Explorer::note_answered() {
    // What nobody takes is not kept for ever.
    constexpr std::size_t kMostAnswered = 100'000;
    const auto panes = model_.layout().visible(window_.now_s());
    const auto shown = model_.image(panes.front().side);
    if (!shown) return;
    const auto rest = std::find_if(unanswered_.begin(), unanswered_.end(),
                                   [&](const Answered& one) { return one.look > shown->look; });
    if (answered_.size() > kMostAnswered) answered_.clear();
    for (auto one = unanswered_.begin(); one != rest; ++one) {
        answered_.push_back({one->input_s, window_.now_s(), shown->look});
    }
    unanswered_.erase(unanswered_.begin(), rest);
}

void Explorer::carry_out(Orders& orders) {
    try {
        if (orders.cancel_opening && !opener_.under_way().empty()) {
            say("Not opened: " + opener_.under_way());
            opener_.cancel();
        }
        if (orders.open) open(*orders.open);
        if (orders.condition) show_condition(*orders.condition);
    } catch (const std::exception& error) {
        say(error.what(), true);
    }
    waiting_image_ |= orders.save_image;
    waiting_buffers_ |= orders.save_buffers;
    if (orders.save_to_study) save_to_study();
    if (orders.copy) {
        ImGui::SetClipboardText(orders.copy->c_str());
        say("Copied.");
    }
    if (orders.close) window_.close();
}

void run_explorer(ExploreOptions options) {
    Explorer explorer(std::move(options));
    while (explorer.step()) {
    }
}

}  // namespace obscura::app::explorer
