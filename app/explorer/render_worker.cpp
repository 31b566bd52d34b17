// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/render_worker.h"

#include <fmt/format.h>

#include <utility>

#include "app/explorer/photographer.h"
#include "renderer/base/error.h"
#include "renderer/gl/context.h"

namespace obscura::app::explorer {

namespace {

class HeadlessStudio : public Studio {
  public:
    [[nodiscard]] std::string device() const override { return renderer::gpu_description(); }
    [[nodiscard]] bool software() const override { return renderer::is_software_renderer(); }
    [[nodiscard]] Shot take(const ShotRequest& request, char side,
                            const std::function<bool()>& wanted) override {
        return photographer_.take(request, side, wanted);
    }
    void get_ready_to_move(const ShotRequest& request,
                           const std::function<bool()>& wanted) override {
        photographer_.get_ready_to_move(request, wanted);
    }

  private:
    renderer::HeadlessContext context_;
    Photographer photographer_;
};

}  // namespace

std::unique_ptr<Studio> headless_studio() { return std::make_unique<HeadlessStudio>(); }

RenderWorker::RenderWorker(std::function<void()> wake,
                           std::function<std::unique_ptr<Studio>()> open)
    : wake_(std::move(wake)),
      open_(std::move(open)),
      thread_([this](const std::stop_token& ended) { work(ended); }) {}

RenderWorker::~RenderWorker() {
    stop_ = true;
    thread_.request_stop();
    asked_.notify_all();
}

void RenderWorker::ask(ShotRequest request, bool stop) {
    {
        const std::lock_guard lock(mutex_);
        waiting_ = std::move(request);
        busy_ = true;
        if (stop) stop_ = true;
    }
    asked_.notify_all();
}

RenderAnswers RenderWorker::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(answers_, {});
}

bool RenderWorker::has_answers() const {
    const std::lock_guard lock(mutex_);
    return !answers_.shots.empty() || !answers_.problems.empty();
}

std::string RenderWorker::device() const {
    const std::lock_guard lock(mutex_);
    return device_;
}

void RenderWorker::say(std::string problem) {
    {
        const std::lock_guard lock(mutex_);
        answers_.problems.push_back(std::move(problem));
    }
    wake_();
}

void RenderWorker::answer(std::vector<Shot>& made) {
    if (made.empty()) return;
    {
        const std::lock_guard lock(mutex_);
        for (Shot& shot : made) answers_.shots.push_back(std::move(shot));
    }
    made.clear();
    wake_();
}

void RenderWorker::work(const std::stop_token& ended) {
    while (!ended.stop_requested()) {
        const bool is_second_try = lost_.has_value();
        bool opened = false;
        int taken = 0;
        try {
            const std::unique_ptr<Studio> studio = open_();
            opened = true;
            software_ = studio->software();
            {
                const std::lock_guard lock(mutex_);
                device_ = studio->device();
                // What is newer is wanted instead.
                if (lost_ && !waiting_) waiting_ = std::move(lost_);
                lost_.reset();
            }
            wake_();
            work_in(*studio, taken, ended);
        } catch (const std::exception& error) {
            if (opened && (!is_second_try || taken > 0)) {
                say(fmt::format("The driver failed ({}); it is started anew.", error.what()));
                continue;
            }
            give_up(fmt::format("The image cannot be rendered: {}", error.what()), opened);
            std::unique_lock lock(mutex_);
            asked_.wait(lock, ended, [this] { return waiting_.has_value(); });
        }
    }
}

void RenderWorker::give_up(std::string problem, bool opened) {
    lost_.reset();
    {
        const std::lock_guard lock(mutex_);
        // What came meanwhile has its own try, unless there is no driver at all.
        if (!opened) waiting_.reset();
        busy_ = waiting_.has_value();
    }
    say(std::move(problem));
}

void RenderWorker::work_in(Studio& studio, int& taken, const std::stop_token& ended) {
    while (true) {
        ShotRequest request;
        {
            std::unique_lock lock(mutex_);
            if (!waiting_) busy_ = false;
            asked_.wait(lock, ended, [this] { return waiting_.has_value(); });
            // With work left, too.
            if (ended.stop_requested()) return;
            request = std::move(*waiting_);
            waiting_.reset();
            busy_ = true;
            stop_ = false;
        }
        try {
            take_all(studio, request, ended);
            ++taken;
        } catch (...) {
            lost_ = std::move(request);
            throw;
        }
    }
}

void RenderWorker::take_all(Studio& studio, const ShotRequest& request,
                            const std::stop_token& ended) {
    const auto wanted = [&] { return !stop_ && !ended.stop_requested(); };
    // Images in motion are shown together: a frame of the window for each would take the time of
    // another image.
    const bool together = request.quality == Quality::kMoving;
    std::vector<Shot> made;
    for (const char side : request.sides) {
        if (!wanted()) break;
        try {
            made.push_back(studio.take(request, side, wanted));
        } catch (const renderer::Stopped&) {
            break;
        } catch (const base::Error& error) {
            // A variant or scene that cannot be rendered leaves the context as it was, but a driver
            // that failed may not.
            if (error.code() != base::ExitCode::kBadInput) throw;
            say(fmt::format("{}: {}", side == 'a' ? "A" : "B", error.what()));
            break;
        }
        if (!together) answer(made);
    }
    answer(made);
    if (together || !wanted()) return;
    try {
        studio.get_ready_to_move(request, wanted);
    } catch (const renderer::Stopped&) {
        // It is wanted now.
    } catch (const base::Error& error) {
        if (error.code() != base::ExitCode::kBadInput) throw;  // the images themselves say why
    }
}

}  // namespace obscura::app::explorer
