// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/render_worker.h"

#include <fmt/format.h>

#include <utility>

#include "app/explorer/photographer.h"
#include "renderer/base/error.h"
#include "renderer/gl/context.h"

namespace obscura::app::explorer {

RenderWorker::RenderWorker(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this](const std::stop_token& ended) { work(ended); }) {}

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

void RenderWorker::work(const std::stop_token& ended) {
    // A context that is lost takes all that it held with it; another is tried at the next request.
    while (!ended.stop_requested()) {
        try {
            work_in_context(ended);
        } catch (const std::exception& error) {
            busy_ = false;
            say(fmt::format("The image cannot be rendered: {}", error.what()));
            std::unique_lock lock(mutex_);
            asked_.wait(lock, ended, [this] { return waiting_.has_value(); });
        }
    }
}

void RenderWorker::work_in_context(const std::stop_token& ended) {
    const renderer::HeadlessContext context;
    Photographer photographer;
    software_ = renderer::is_software_renderer();
    {
        const std::lock_guard lock(mutex_);
        device_ = renderer::gpu_description();
    }
    wake_();
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
        const auto wanted = [&] { return !stop_ && !ended.stop_requested(); };
        for (const char side : request.sides) {
            if (!wanted()) break;
            try {
                Shot shot = photographer.take(request, side, wanted);
                const std::lock_guard lock(mutex_);
                answers_.shots.push_back(std::move(shot));
            } catch (const Stopped&) {
                break;
            } catch (const base::Error& error) {
                // A variant or scene that cannot be rendered leaves the context as it was, but a
                // driver that failed may not.
                if (error.code() != base::ExitCode::kBadInput) throw;
                say(fmt::format("{}: {}", side == 'a' ? "A" : "B", error.what()));
                break;
            }
            wake_();
        }
    }
}

}  // namespace obscura::app::explorer
