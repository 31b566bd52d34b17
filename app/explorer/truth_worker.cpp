// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/truth_worker.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "renderer/reference/pixel_tracer.h"
#include "renderer/reference/ray_scene.h"
#include "renderer/reference/sampler.h"

namespace obscura::app::explorer {
namespace {

/// Linux counts the priority of each thread by itself.
void lower_priority() {
    constexpr int kNice = 10;
    (void)::setpriority(PRIO_PROCESS, static_cast<id_t>(::syscall(SYS_gettid)), kNice);
}

struct TracedTile {
    std::vector<float> accessibility;
    std::vector<float> standard_error;
};

[[nodiscard]] TracedTile trace(const renderer::ReferenceScene& scene, const TruthRequest& request,
                               const Truth::Tile& tile) {
    renderer::ReferenceOptions options;
    options.radius_m = request.radius_m;
    options.rays = Truth::kRaysOfRound;
    // A seed of its own makes a round independent of the others.
    options.seed = static_cast<std::uint64_t>(tile.round) + 1;
    renderer::check_options(options);
    static const renderer::HemisphereSampler sampler(Truth::kRaysOfRound);
    const renderer::PixelRays pixels(request.camera, request.width, request.height,
                                     scene.rays().origin_m());
    renderer::PixelTracer tracer(scene.rays(), pixels, options, sampler);
    TracedTile traced;
    for (int y = tile.top; y < tile.top + tile.height; ++y) {
        for (int x = tile.left; x < tile.left + tile.width; ++x) {
            const renderer::TracedPixel pixel = tracer.trace(x, y);
            traced.accessibility.push_back(pixel.accessibility);
            traced.standard_error.push_back(pixel.standard_error);
        }
    }
    return traced;
}

}  // namespace

TruthWorker::TruthWorker(std::function<void()> wake, int threads) : wake_(std::move(wake)) {
    const int count =
        threads > 0 ? threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    for (int i = 0; i < count; ++i) {
        threads_.emplace_back([this](const std::stop_token& ended) { work(ended); });
    }
}

TruthWorker::~TruthWorker() {
    for (std::jthread& thread : threads_) thread.request_stop();
    asked_.notify_all();
    threads_.clear();
}

void TruthWorker::start(TruthRequest request) {
    {
        const std::lock_guard lock(mutex_);
        look_ = request.look;
        truth_ = std::make_shared<Truth>(request.width, request.height);
        copy_.reset();
        request_ = std::make_shared<const TruthRequest>(std::move(request));
    }
    asked_.notify_all();
}

void TruthWorker::pause(bool pauses) {
    {
        const std::lock_guard lock(mutex_);
        if (pauses == paused_) return;
        paused_ = pauses;
    }
    asked_.notify_all();
}

void TruthWorker::focus(double x, double y) {
    const std::lock_guard lock(mutex_);
    focus_x_ = x;
    focus_y_ = y;
}

bool TruthWorker::running() const {
    const std::lock_guard lock(mutex_);
    return request_ != nullptr && !paused_;
}

std::shared_ptr<const Truth> TruthWorker::snapshot(std::uint64_t look) {
    const std::lock_guard lock(mutex_);
    if (truth_ == nullptr || look != look_ || truth_->version() == 0) return nullptr;
    if (copy_ == nullptr || copy_->version() != truth_->version()) {
        copy_ = std::make_shared<const Truth>(*truth_);
    }
    return copy_;
}

std::string TruthWorker::take_problem() {
    const std::lock_guard lock(mutex_);
    return std::exchange(problem_, {});
}

void TruthWorker::work(const std::stop_token& ended) {
    lower_priority();
    while (true) {
        std::shared_ptr<const TruthRequest> request;
        std::shared_ptr<Truth> truth;
        std::optional<Truth::Tile> tile;
        {
            std::unique_lock lock(mutex_);
            const auto wanted = [this] { return request_ != nullptr && !paused_; };
            asked_.wait(lock, ended, wanted);
            // With work left, too.
            if (ended.stop_requested()) return;
            request = request_;
            truth = truth_;
            tile = truth->take_tile(focus_x_, focus_y_);
            if (!tile) request_.reset();
        }
        if (!tile) {
            wake_();
            continue;
        }
        try {
            const TracedTile traced = trace(request->scene->rays(), *request, *tile);
            const std::lock_guard lock(mutex_);
            if (truth == truth_) truth->add(*tile, traced.accessibility, traced.standard_error);
        } catch (const std::exception& error) {
            const std::lock_guard lock(mutex_);
            problem_ = fmt::format("The truth cannot be traced: {}", error.what());
            if (request == request_) request_.reset();
        }
    }
}

}  // namespace obscura::app::explorer
