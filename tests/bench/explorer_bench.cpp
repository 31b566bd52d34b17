// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT

// How late the explorer's images show what is put in, how many there are a second, how long a scene
// takes to its first image, and the memory after each: on the display that DISPLAY names.
//   explorer_bench [SECONDS] [SCENE...]
#include <epoxy/gl.h>
#include <fmt/format.h>
// After epoxy, which brings the OpenGL declarations.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/explorer/explorer.h"
#include "renderer/base/log.h"
#include "stimuli/scenes/builtin_scene.h"

namespace {

using obscura::app::explorer::Explorer;
using obscura::app::explorer::ExplorerWindow;

[[nodiscard]] double resident_MB() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1000.0;
    }
    return 0.0;
}

[[nodiscard]] double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

void steps_until_rest(Explorer& explorer) {
    while (!explorer.at_rest() || !explorer.model().buffers('b') ||
           explorer.model().moving(ExplorerWindow::now_s())) {
        explorer.step();
    }
}

/// The left button held on the image, so that the pointer turns the camera.
class Hand {
  public:
    explicit Hand(Explorer& explorer) : explorer_(explorer) {
        GLFWwindow* const window = explorer.window().handle();
        pressed_ = glfwSetMouseButtonCallback(window, nullptr);
        glfwSetMouseButtonCallback(window, pressed_);
        move(0);
        explorer.step();
        pressed_(window, GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS, 0);
        explorer.step();
    }
    ~Hand() {
        pressed_(explorer_.window().handle(), GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE, 0);
        explorer_.step();
    }
    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;
    /// To and fro.
    void move(int moment) {
        glfwSetCursorPos(explorer_.window().handle(), 400.0 + 100.0 * std::sin(0.05 * moment),
                         300.0);
    }

  private:
    Explorer& explorer_;
    GLFWmousebuttonfun pressed_ = nullptr;
};

void print_pace(Explorer& explorer, const char* how, std::size_t before, double seconds) {
    const auto& all = explorer.pace().input_ms;
    const std::vector<double> late(all.begin() + static_cast<std::ptrdiff_t>(before), all.end());
    const auto shown = explorer.model().image('b');
    fmt::print(
        "{:10} {:9} {:9} {:6.1f} images/s at 1/{}{}   input to image p50 {:6.1f} ms, p95 {:6.1f} "
        "ms\n",
        explorer.model().choices().scene.source,
        to_string(explorer.model().choices().scene.validity), how,
        static_cast<double>(late.size()) / seconds, explorer.model().divisor(),
        shown && shown->coarse ? " coarse" : "", quantile(late, 0.5), quantile(late, 0.95));
    std::fflush(stdout);
}

/// Turns for so long, as a hand with a mouse would.
void fly(Explorer& explorer, double seconds) {
    Hand hand(explorer);
    const std::size_t before = explorer.pace().input_ms.size();
    const double began_s = ExplorerWindow::now_s();
    for (int i = 1; ExplorerWindow::now_s() - began_s < seconds; ++i) {
        hand.move(i);
        explorer.step();
    }
    print_pace(explorer, "moving", before, ExplorerWindow::now_s() - began_s);
}

/// Turns a little each time that everything has come to rest.
void nudge(Explorer& explorer, int times) {
    const std::size_t before = explorer.pace().input_ms.size();
    const double began_s = ExplorerWindow::now_s();
    for (int i = 0; i < times; ++i) {
        steps_until_rest(explorer);
        Hand hand(explorer);
        const std::size_t shown = explorer.pace().input_ms.size();
        hand.move(i % 2 == 0 ? 10 : 0);
        while (explorer.pace().input_ms.size() == shown) explorer.step();
    }
    print_pace(explorer, "standing", before, ExplorerWindow::now_s() - began_s);
}

/// Once at each level that the scene has light for.
void at_each_level(Explorer& explorer, double seconds) {
    const auto levels = explorer.model().scene()->opened().levels;
    for (const auto level : levels) {
        explorer.model().change([level](auto& to) { to.scene.validity = level; }, "",
                                ExplorerWindow::now_s());
        steps_until_rest(explorer);
        fly(explorer, seconds);
        nudge(explorer, 5);
    }
}

}  // namespace

int main(int argc, char** argv) {
    obscura::base::log::set_up(true);
    const double seconds = argc > 1 ? std::atof(argv[1]) : 5.0;
    std::vector<std::string> scenes(argv + std::min(argc, 2), argv + argc);
    if (scenes.empty()) {
        for (const auto& scene : obscura::stimuli::builtin_scenes()) scenes.push_back(scene.id);
    }
    obscura::app::explorer::ExploreOptions options;
    options.what = scenes.front();
    options.data = std::filesystem::temp_directory_path() / "obscura-explorer-bench";
    options.reset = true;
    Explorer explorer(options);
    for (int round = 1; round <= 2; ++round) {
        for (const std::string& scene : scenes) {
            const double began_s = ExplorerWindow::now_s();
            explorer.open(scene);
            while (!explorer.model().scene() || explorer.model().scene()->opened().id != scene ||
                   !explorer.model().image('a')) {
                explorer.step();
            }
            const double first_s = ExplorerWindow::now_s() - began_s;
            if (round == 1) at_each_level(explorer, seconds);
            steps_until_rest(explorer);
            fmt::print("{:10} round {}: first image after {:.2f} s, {:.0f} MB resident\n", scene,
                       round, first_s, resident_MB());
            std::fflush(stdout);
        }
    }
    return 0;
}
