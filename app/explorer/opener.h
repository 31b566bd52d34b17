// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "app/explorer/choices.h"
#include "app/explorer/loaded_scene.h"

namespace obscura::app::explorer {

/// What an opening came to.
struct Opened {
    Choices choices;                     ///< that it was asked for
    std::string camera;                  ///< the same; empty: the scene's first
    bool keeps_camera = false;           ///< the view stays where it is
    std::shared_ptr<LoadedScene> scene;  ///< nothing: it could not be opened
    std::string problem;                 ///< why not, as the importer says it
};

/// Opens scenes on a thread of its own, one at a time: built-in ones are built, files imported.
class Opener {
  public:
    explicit Opener(std::function<void()> wake);
    /// Waits for what is under way.
    ~Opener();
    Opener(const Opener&) = delete;
    Opener& operator=(const Opener&) = delete;

    /// In place of whatever was being opened.
    void open(Choices choices, const std::string& camera, bool keeps_camera);
    /// What is under way comes to nothing: its outcome is thrown away.
    void cancel();
    /// What is being opened, for people; empty: nothing.
    [[nodiscard]] std::string under_way() const;
    /// For so long already.
    [[nodiscard]] double seconds() const;
    [[nodiscard]] std::optional<Opened> take();

  private:
    void work(const std::stop_token& ended);

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable_any asked_;
    std::optional<Opened> waiting_;
    std::optional<Opened> outcome_;
    std::uint64_t number_ = 0;  ///< of what is wanted
    std::string under_way_;
    double began_s_ = 0.0;
    std::jthread thread_;
};

}  // namespace obscura::app::explorer
