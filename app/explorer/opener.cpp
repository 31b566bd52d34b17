// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/opener.h"

#include <chrono>
#include <utility>

namespace obscura::app::explorer {
namespace {

[[nodiscard]] double steady_s() {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now().time_since_epoch();
    return since.count();
}

void open_it(Opened& opening) {
    try {
        stimuli::SceneSettings geometry;
        geometry.scale = opening.choices.scene.settings.scale;
        opening.scene = std::make_shared<LoadedScene>(
            stimuli::open_scene(opening.choices.scene.source, geometry, opening.choices.folder));
    } catch (const std::exception& error) {
        opening.problem = error.what();
    }
}

}  // namespace

Opener::Opener(std::function<void()> wake)
    : wake_(std::move(wake)), thread_([this](const std::stop_token& ended) { work(ended); }) {}

Opener::~Opener() {
    thread_.request_stop();
    asked_.notify_all();
}

void Opener::open(Choices choices, const std::string& camera, bool keeps_camera) {
    {
        const std::lock_guard lock(mutex_);
        under_way_ = choices.scene.source;
        began_s_ = steady_s();
        waiting_ = Opened{std::move(choices), camera, keeps_camera, nullptr, ""};
        outcome_.reset();
        ++number_;
    }
    asked_.notify_all();
}

void Opener::cancel() {
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    outcome_.reset();
    under_way_.clear();
    ++number_;
}

std::string Opener::under_way() const {
    const std::lock_guard lock(mutex_);
    return under_way_;
}

double Opener::seconds() const {
    const std::lock_guard lock(mutex_);
    return under_way_.empty() ? 0.0 : steady_s() - began_s_;
}

std::optional<Opened> Opener::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(outcome_, std::nullopt);
}

void Opener::work(const std::stop_token& ended) {
    while (true) {
        Opened opening;
        std::uint64_t number = 0;
        {
            std::unique_lock lock(mutex_);
            asked_.wait(lock, ended, [this] { return waiting_.has_value(); });
            // With work left, too.
            if (ended.stop_requested()) return;
            opening = std::move(*waiting_);
            waiting_.reset();
            number = number_;
        }
        open_it(opening);
        const std::shared_ptr<LoadedScene> scene = opening.scene;
        {
            const std::lock_guard lock(mutex_);
            if (number != number_) continue;
            under_way_.clear();
            outcome_ = std::move(opening);
        }
        wake_();
        if (!scene) continue;
        scene->make_coarse([&] {
            const std::lock_guard lock(mutex_);
            return number == number_ && !ended.stop_requested();
        });
    }
}

}  // namespace obscura::app::explorer
