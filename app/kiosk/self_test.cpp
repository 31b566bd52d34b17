// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/self_test.h"

#include <epoxy/gl.h>
// After epoxy, which brings the OpenGL declarations.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "app/kiosk/clock.h"
#include "app/kiosk/pace.h"
#include "app/kiosk/stimulus_view.h"
#include "app/kiosk/window.h"
#include "renderer/base/random.h"

namespace obscura::app::kiosk {
namespace {

constexpr double kMsPerSecond = 1000.0;
/// Of image and interval: long enough to be timed as a session's are, with no flicker of
/// brightness, since noise and grey are about as bright.
constexpr double kInterval_s = 0.1;
constexpr int kAlternationsAKey = 4;

class SelfTester {
  public:
    SelfTester(const stimuli::Study& study, Window& window)
        : study_(study),
          window_(window),
          pace_(measure_pace(window, study.presentation.grey_level)),
          image_(noise_of(study)) {}

    [[nodiscard]] const Pace& pace() const { return pace_; }

    void alternate(SelfTestRun& run) {
        const double image_s = show_at(monotonic_s() + kInterval_s, true, run);
        const double grey_s = show_at(image_s + kInterval_s, false, run);
        const double next_s = show_at(grey_s + kInterval_s, true, run);
        run.error_ms.push_back((next_s - grey_s - kInterval_s) * kMsPerSecond);
    }

    /// From an event posted at any time within a few frames to the screen that answers it.
    void answer_key(SelfTestRun& run, base::Random& random) {
        const double after_s = 0.05 + 0.1 * random.uniform();
        std::atomic<double> posted_s{0.0};
        std::thread key([&] {
            wait_until(monotonic_s() + after_s);
            posted_s = monotonic_s();
            glfwPostEmptyEvent();
        });
        while (posted_s == 0.0) window_.wait_for_events(1.0);
        draw(run.key_to_swap_ms.size() % 2 == 0);
        const double shown_s = window_.present();
        key.join();
        run.key_to_swap_ms.push_back((shown_s - posted_s) * kMsPerSecond);
    }

  private:
    void draw(bool image) const {
        window_.light_patch(image);
        if (image) {
            image_.draw(window_.size(), study_.presentation.grey_level);
        } else {
            draw_grey(window_.size(), study_.presentation.grey_level);
        }
    }

    /// Draws it ahead and hands it over so that it is visible then; gives when it was.
    double show_at(double due_s, bool image, SelfTestRun& run) {
        draw(image);
        glFinish();
        window_.poll_events();
        wait_until(due_s - pace_.lead_s());
        const double shown_s = window_.present();
        run.test.dropped_frames += dropped_frames(pace_, due_s, shown_s);
        return shown_s;
    }

    const stimuli::Study& study_;
    Window& window_;
    Pace pace_;
    StimulusTexture image_;
};

}  // namespace

SelfTestRun run_self_test(const stimuli::Study& study, const KioskOptions& options,
                          int alternations) {
    Window window(window_options(study, options));
    SelfTester tester(study, window);
    SelfTestRun run;
    run.test.time_utc = utc_now();
    for (int i = 0; i < alternations; ++i) tester.alternate(run);
    base::Random random(1);
    for (int i = 0; i < std::max(1, alternations / kAlternationsAKey); ++i) {
        tester.answer_key(run, random);
    }
    run.test.display = window.display();
    run.test.gpu_renderer = window.gpu_renderer();
    run.test.source = window.time_source();
    run.test.told_hz = window.refresh_hz();
    run.test.frame_ms = tester.pace().measured_s * kMsPerSecond;
    run.test.waits = tester.pace().locked;
    run.test.interval_ms = kInterval_s * kMsPerSecond;
    run.test.error_ms = figures_of(run.error_ms);
    run.test.key_to_swap_ms = figures_of(run.key_to_swap_ms);
    return run;
}

}  // namespace obscura::app::kiosk
