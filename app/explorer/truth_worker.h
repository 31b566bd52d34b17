// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "app/explorer/loaded_scene.h"
#include "app/explorer/truth.h"
#include "renderer/scene/scene.h"

namespace obscura::app::explorer {

/// What truth is wanted.
struct TruthRequest {
    std::uint64_t look = 0;
    std::shared_ptr<LoadedScene> scene;
    renderer::Camera camera;
    int width = 0;
    int height = 0;
    double radius_m = 0.5;
};

/// Traces the truth of the visible view on threads of their own, of low priority, a tile at a time.
class TruthWorker {
  public:
    /// `threads` 0: one a core. `wake` is called from a worker's thread now and then.
    explicit TruthWorker(std::function<void()> wake, int threads = 0);
    ~TruthWorker();
    TruthWorker(const TruthWorker&) = delete;
    TruthWorker& operator=(const TruthWorker&) = delete;

    /// Another view, from its beginning.
    void start(TruthRequest request);
    /// While it pauses it goes on only with the tiles that are under way.
    void pause(bool pauses);
    /// Tiles near there come first, in pixels of the image.
    void focus(double x, double y);
    [[nodiscard]] bool running() const;
    /// What there is so far, of that look; nothing where it is of another.
    [[nodiscard]] std::shared_ptr<const Truth> snapshot(std::uint64_t look);
    /// Why there is none, a sentence; asked once.
    [[nodiscard]] std::string take_problem();

  private:
    void work(const std::stop_token& ended);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any asked_;
    std::shared_ptr<const TruthRequest> request_;  ///< nothing: none is wanted
    std::uint64_t look_ = 0;                       ///< that truth_ is of
    std::shared_ptr<Truth> truth_;
    std::shared_ptr<const Truth> copy_;
    bool paused_ = false;
    double focus_x_ = 0.0;
    double focus_y_ = 0.0;
    std::string problem_;
    std::vector<std::jthread> threads_;
};

}  // namespace obscura::app::explorer
