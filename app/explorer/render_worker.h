// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/explorer/shot.h"

namespace obscura::app::explorer {

/// What the worker has to say since it was asked last.
struct RenderAnswers {
    std::vector<Shot> shots;
    std::vector<std::string> problems;  ///< of images that could not be made, a sentence each
};

/// Renders shots on a thread of its own, in a context without a window: the very context, driver
/// and code that `obscura render` has. One request at a time; a new one takes the place of what has
/// not begun yet.
class RenderWorker {
  public:
    /// `wake` is called from the worker's thread when there is something to take.
    explicit RenderWorker(std::function<void()> wake);
    ~RenderWorker();
    RenderWorker(const RenderWorker&) = delete;
    RenderWorker& operator=(const RenderWorker&) = delete;

    /// What is under way goes on to the end of its image where `stop` is false; else it ends as
    /// soon as it can.
    void ask(ShotRequest request, bool stop);
    [[nodiscard]] bool busy() const { return busy_; }
    [[nodiscard]] RenderAnswers take();
    /// Whether there is something to take.
    [[nodiscard]] bool has_answers() const;
    /// The driver's name and version; empty before the context is made.
    [[nodiscard]] std::string device() const;
    /// Whether it renders on the CPU; true until known.
    [[nodiscard]] bool software() const { return software_; }

  private:
    void work(const std::stop_token& ended);
    /// One context with what it holds; returns when the thread is to end, throws where it is lost.
    void work_in_context(const std::stop_token& ended);
    void say(std::string problem);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any asked_;
    std::optional<ShotRequest> waiting_;
    RenderAnswers answers_;
    std::string device_;
    std::atomic<bool> busy_ = false;
    std::atomic<bool> stop_ = false;
    std::atomic<bool> software_ = true;
    std::jthread thread_;
};

}  // namespace obscura::app::explorer
