// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
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

/// A context with all that it holds; made, used and ended on one thread.
class Studio {
  public:
    virtual ~Studio() = default;
    /// The driver's name and version.
    [[nodiscard]] virtual std::string device() const = 0;
    [[nodiscard]] virtual bool software() const = 0;
    /// As Photographer::take. Throws failure where the driver was reset or refuses.
    [[nodiscard]] virtual Shot take(const ShotRequest& request, char side,
                                    const std::function<bool()>& wanted) = 0;
    /// As Photographer::get_ready_to_move.
    virtual void get_ready_to_move(const ShotRequest& request,
                                   const std::function<bool()>& wanted) = 0;
};
/// In a context without a window: the very context, driver and code that `obscura render` has.
/// Throws failure where there is no driver.
[[nodiscard]] std::unique_ptr<Studio> headless_studio();

/// Renders shots on a thread of its own. One request at a time; a new one takes the place of what
/// has not begun yet. A studio that is lost is built anew, and the request that it was lost at is
/// tried once more.
class RenderWorker {
  public:
    /// `wake` is called from the worker's thread when there is something to take.
    explicit RenderWorker(std::function<void()> wake,
                          std::function<std::unique_ptr<Studio>()> open = &headless_studio);
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
    /// Returns when the thread is to end, throws where the studio is lost; `taken` counts requests.
    void work_in(Studio& studio, int& taken, const std::stop_token& ended);
    /// Until there is another request.
    void give_up(std::string problem, bool opened);
    /// All sides of a request.
    void take_all(Studio& studio, const ShotRequest& request, const std::stop_token& ended);
    void say(std::string problem);
    /// Gives them to who takes next; empty: nothing.
    void answer(std::vector<Shot>& made);

    std::function<void()> wake_;
    std::function<std::unique_ptr<Studio>()> open_;
    std::optional<ShotRequest> lost_;  ///< that the last studio was lost at
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
