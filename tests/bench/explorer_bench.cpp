// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT

// How late the explorer's images show what is put in, how many there are a second, how long a scene
// takes to its first image, and the memory after each. A pointer that moves sixty times a second
// and keys that are held come in by the X server, as from a hand: the display that DISPLAY names,
// where it is set, else one of its own (Xvfb with openbox).
//   explorer_bench [SECONDS] [SCENE...]     SECONDS 0: only opening and memory
#include <epoxy/gl.h>
#include <fmt/format.h>
// After epoxy, which brings the OpenGL declarations.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "app/explorer/explorer.h"
#include "renderer/base/log.h"
#include "stimuli/scenes/builtin_scene.h"
#include "tests/app/kiosk/virtual_display.h"

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

/// Processor time in seconds.
struct Worked {
    double window_s = 0.0;  ///< main thread, and those that draw for it
    double images_s = 0.0;  ///< all others: images, truth, opening
};

/// Of this process since its start. A software renderer's threads have its name, those of the
/// window's context the lower numbers: it is made first.
[[nodiscard]] Worked worked() {
    std::map<long, double> drawing;
    Worked sum;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream file(task.path() / "stat");
        std::string line;
        std::getline(file, line);
        const std::size_t end = line.rfind(')');
        if (end == std::string::npos) continue;
        std::istringstream rest(line.substr(end + 1));
        std::string skipped;
        for (int i = 0; i < 11; ++i) rest >> skipped;
        double user = 0.0;
        double system = 0.0;
        rest >> user >> system;
        const double seconds = (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
        const long id = std::stol(task.path().filename().string());
        if (line.find("(llvmpipe") != std::string::npos) {
            drawing[id] = seconds;
        } else {
            (id == getpid() ? sum.window_s : sum.images_s) += seconds;
        }
    }
    std::size_t number = 0;
    for (const auto& [id, seconds] : drawing) {
        (number++ < drawing.size() / 2 ? sum.window_s : sum.images_s) += seconds;
    }
    return sum;
}

[[nodiscard]] double quantile(std::vector<double> values, double share) {
    if (values.empty()) return std::nan("");
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

/// An xdotool that does what it is told as it is told: one for each word would take its time from
/// what is measured, and a process as large as this one takes long to fork.
class Tool {
  public:
    Tool() : tool_(::popen("xdotool -", "w")) {
        if (tool_ == nullptr) std::exit(1);
    }
    ~Tool() { ::pclose(tool_); }
    Tool(const Tool&) = delete;
    Tool& operator=(const Tool&) = delete;
    void operator()(const char* words) {
        fmt::print(tool_, "{}\n", words);
        std::fflush(tool_);
    }

  private:
    std::FILE* tool_;
};

/// A hand on mouse and keyboard, in a thread and a connection to the X server of its own.
class Hand {
  public:
    explicit Hand(Explorer& explorer) : window_(explorer.window().handle()) {
        glfwGetWindowPos(window_, &left_, &top_);
        connection_ = XOpenDisplay(nullptr);
        root_ = DefaultRootWindow(connection_);
        heard_ = glfwSetCursorPosCallback(window_, nullptr);
        glfwSetCursorPosCallback(window_, &Hand::hear);
        self = this;
        move(0);
    }
    ~Hand() {
        still();
        XCloseDisplay(connection_);
        glfwSetCursorPosCallback(window_, heard_);
        self = nullptr;
    }
    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;

    /// Turns with the left button held, and flies there and back.
    void fly() {
        tool_("mousedown 1 keydown w");
        thread_ = std::jthread([this](const std::stop_token& ended) {
            constexpr int kMovesAWay = 45;
            for (int i = 1; !ended.stop_requested(); ++i) {
                move(i);
                if (i % kMovesAWay == 0) {
                    const bool back = i / kMovesAWay % 2 == 1;
                    tool_(back ? "keyup w keydown s" : "keyup s keydown w");
                }
                std::this_thread::sleep_for(std::chrono::microseconds(16'667));
            }
        });
    }
    void still() {
        if (!thread_.joinable()) return;
        thread_.request_stop();
        thread_.join();
        tool_("mouseup 1 keyup w keyup s");
    }
    /// Turns once.
    void nudge(int moment) {
        // Pressed where the pointer is, so that only the way from there counts.
        tool_("mousedown 1");
        std::this_thread::sleep_for(std::chrono::milliseconds(150));
        move(moment);
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        tool_("mouseup 1");
    }
    /// How long the X server and the window let an input wait that the window heard of then; from
    /// the moment the hand moved.
    [[nodiscard]] double waited_s(double heard_s) const {
        auto after = waits_.upper_bound(heard_s);
        return after == waits_.begin() ? 0.0 : std::prev(after)->second;
    }

  private:
    /// To and fro in the left image, off the line that splits the view; no place twice in a row.
    void move(int moment) {
        const int x = left_ + 220 + static_cast<int>(std::lround(150.0 * std::sin(0.05 * moment)));
        const int y = top_ + 350 + moment % 2;
        {
            const std::lock_guard lock(mutex_);
            moved_s_[{x - left_, y - top_}] = ExplorerWindow::now_s();
        }
        XWarpPointer(connection_, None, root_, 0, 0, 0, 0, x, y);
        XFlush(connection_);
    }
    static void hear(GLFWwindow* window, double x, double y) {
        const double now_s = ExplorerWindow::now_s();
        {
            const std::lock_guard lock(self->mutex_);
            const auto moved = self->moved_s_.find({std::lround(x), std::lround(y)});
            if (moved != self->moved_s_.end()) self->waits_[now_s] = now_s - moved->second;
        }
        self->heard_(window, x, y);
    }

    inline static Hand* self = nullptr;
    Tool tool_;
    GLFWwindow* window_;
    int left_ = 0;
    int top_ = 0;
    Display* connection_ = nullptr;
    Window root_ = 0;
    GLFWcursorposfun heard_ = nullptr;
    std::mutex mutex_;
    std::map<std::pair<long, long>, double> moved_s_;  ///< the pointer to that place, when
    std::map<double, double> waits_;                   ///< by when the window heard
    std::jthread thread_;
};

/// The image is as good as it gets, and nothing more is computed but rays.
void steps_until_rest(Explorer& explorer) {
    const auto& model = explorer.model();
    const auto best = [&] {
        const auto shown = model.image('b');
        return shown && shown->look == model.look() && shown->quality == model.finest();
    };
    while (!explorer.at_rest() || !model.buffers('b') || !best() ||
           model.moving(ExplorerWindow::now_s())) {
        explorer.step();
    }
}

/// What came of some time before the window.
class Watch {
  public:
    explicit Watch(Explorer& explorer) : explorer_(explorer) { (void)explorer.take_answered(); }
    /// A frame of the window is done.
    void note(const Hand& hand) {
        ++frames_;
        for (const Explorer::Answered& one : explorer_.take_answered()) {
            late_ms_.push_back(1000.0 *
                               (one.shown_s - one.input_s + hand.waited_s(one.input_s + 1e-4)));
            if (one.look != look_) ++images_;
            look_ = one.look;
        }
    }
    [[nodiscard]] std::size_t answers() const { return late_ms_.size(); }
    void print(const char* how) const {
        const double seconds = ExplorerWindow::now_s() - began_s_;
        const auto shown = explorer_.model().image('b');
        const Worked now = worked();
        const double window_s = now.window_s - began_.window_s;
        const double images_s = now.images_s - began_.images_s;
        fmt::print(
            "{:10} {:9} {:9} {:5.1f} images/s at 1/{}{}   input to image p50 {:6.1f} ms, p95 "
            "{:6.1f} ms   processor {:5.1f} ms an image, {:4.1f} ms a frame of the window ({} "
            "frames, {:.2f} cores in all)\n",
            explorer_.model().choices().scene.source,
            to_string(explorer_.model().choices().scene.validity), how, images_ / seconds,
            explorer_.model().divisor(), shown && shown->coarse ? " coarse" : "",
            quantile(late_ms_, 0.5), quantile(late_ms_, 0.95), 1000.0 * images_s / images_,
            1000.0 * window_s / frames_, frames_, (window_s + images_s) / seconds);
        std::fflush(stdout);
    }

  private:
    Explorer& explorer_;
    double began_s_ = ExplorerWindow::now_s();
    Worked began_ = worked();
    int frames_ = 0;
    std::vector<double> late_ms_;
    int images_ = 0;
    std::uint64_t look_ = 0;
};

void moving(Explorer& explorer, double seconds) {
    Hand hand(explorer);
    explorer.step();
    hand.fly();
    Watch watch(explorer);
    const double began_s = ExplorerWindow::now_s();
    while (ExplorerWindow::now_s() - began_s < seconds) {
        explorer.step();
        watch.note(hand);
    }
    watch.print("moving");
    hand.still();
}

/// Turns a little each time that everything has come to rest.
void standing(Explorer& explorer, int times) {
    Hand hand(explorer);
    Watch watch(explorer);
    for (int i = 1; i <= times; ++i) {
        steps_until_rest(explorer);
        // What is left of the time before is no answer to this one, and the window goes on until
        // the hand is off.
        (void)explorer.take_answered();
        std::atomic<bool> off = false;
        const std::jthread nudge([&] {
            hand.nudge(7 * i);
            off = true;
        });
        const std::size_t answers = watch.answers();
        // A move that the X server lost turns nothing.
        constexpr double kLongest_s = 5.0;
        const double end_s = ExplorerWindow::now_s() + kLongest_s;
        while (!off || (watch.answers() == answers && ExplorerWindow::now_s() < end_s)) {
            explorer.step();
            watch.note(hand);
        }
    }
    watch.print("standing");
}

/// Turns a little at moments when images at rest are being made, which have to make room.
void resuming(Explorer& explorer, int times) {
    Hand hand(explorer);
    Watch watch(explorer);
    for (int i = 1; i <= times; ++i) {
        std::atomic<bool> off = false;
        const std::jthread nudge([&] {
            hand.nudge(7 * i);
            off = true;
        });
        const double rest_s = 0.1 + 0.37 * (i % 7);
        std::optional<double> off_s;
        while (!off_s || ExplorerWindow::now_s() - *off_s < rest_s) {
            explorer.step();
            watch.note(hand);
            if (off && !off_s) off_s = ExplorerWindow::now_s();
        }
    }
    watch.print("resuming");
}

/// Once at each level that the scene has light for.
void at_each_level(Explorer& explorer, double seconds) {
    const auto levels = explorer.model().scene()->opened().levels;
    for (const auto level : levels) {
        explorer.model().change([level](auto& to) { to.scene.validity = level; }, "",
                                ExplorerWindow::now_s());
        steps_until_rest(explorer);
        moving(explorer, seconds);
        standing(explorer, 5);
        resuming(explorer, 21);
    }
}

}  // namespace

int main(int argc, char** argv) {
    XInitThreads();
    obscura::base::log::set_up(true);
    const double seconds = argc > 1 ? std::atof(argv[1]) : 5.0;
    std::vector<std::string> scenes(argv + std::min(argc, 2), argv + argc);
    if (scenes.empty()) {
        for (const auto& scene : obscura::stimuli::builtin_scenes()) scenes.push_back(scene.id);
    }
    std::optional<obscura::app::kiosk::VirtualDisplay> display;
    if (std::getenv("DISPLAY") == nullptr) {
        display.emplace(1600, 1000);
        display->start_window_manager();
    }
    obscura::app::explorer::ExploreOptions options;
    options.what = scenes.front();
    options.data = std::filesystem::temp_directory_path() / "obscura-explorer-bench";
    options.reset = true;
    const double start_s = 0.0;  // GLFW's clock begins with the window
    Explorer explorer(options);
    bool first = true;
    for (int round = 1; round <= 3; ++round) {
        for (const std::string& scene : scenes) {
            const double began_s = first ? start_s : ExplorerWindow::now_s();
            const auto before = explorer.model().scene();
            if (!first) explorer.open(scene);
            first = false;
            while (explorer.model().scene() == before || !explorer.model().image('a')) {
                explorer.step();
            }
            const double first_s = ExplorerWindow::now_s() - began_s;
            if (round == 1 && seconds > 0.0) at_each_level(explorer, seconds);
            steps_until_rest(explorer);
            fmt::print("{:10} round {}: first image after {:.2f} s, {:.0f} MB resident\n", scene,
                       round, first_s, resident_MB());
            std::fflush(stdout);
        }
    }
    return 0;
}
