// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <thread>

#include "renderer/base/check.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/pixel_tracer.h"
#include "renderer/reference/ray_scene.h"
#include "renderer/reference/reference.h"

namespace obscura::renderer {
namespace {

constexpr int kTile_px = 16;

/// Hands out tiles to threads and gathers what happened.
class Work {
  public:
    Work(int width, int height, const ReferenceProgress& progress)
        : columns_((width + kTile_px - 1) / kTile_px),
          tiles_(columns_ * ((height + kTile_px - 1) / kTile_px)),
          progress_(progress) {}

    [[nodiscard]] int columns() const { return columns_; }
    [[nodiscard]] int tiles() const { return tiles_; }

    /// The next tile, or -1 when there is none or the work was stopped.
    int next() {
        if (stop_.load(std::memory_order_relaxed)) return -1;
        const int tile = next_.fetch_add(1);
        return tile < tiles_ ? tile : -1;
    }

    void finished_one() {
        const std::scoped_lock lock(mutex_);
        ++done_;
        const auto now = std::chrono::steady_clock::now();
        if (!progress_ || (done_ < tiles_ && now - told_ < std::chrono::milliseconds(50))) return;
        told_ = now;
        if (!progress_(static_cast<double>(done_) / tiles_)) stop_ = stopped_ = true;
    }

    void failed(std::exception_ptr error) {
        const std::scoped_lock lock(mutex_);
        if (!error_) error_ = std::move(error);
        stop_ = true;
    }

    void throw_what_happened() const {
        if (error_) std::rethrow_exception(error_);
        if (stopped_) {
            throw base::failure("ray tracing was stopped at {} of {} tiles", done_, tiles_);
        }
    }

  private:
    int columns_;
    int tiles_;
    const ReferenceProgress& progress_;
    std::atomic<int> next_ = 0;
    std::atomic<bool> stop_ = false;
    std::mutex mutex_;
    int done_ = 0;
    bool stopped_ = false;
    std::exception_ptr error_;
    std::chrono::steady_clock::time_point told_;
};

void trace_tiles(const RayScene& scene, const PixelRays& pixels, const ReferenceOptions& options,
                 const HemisphereSampler& sampler, Work& work, ReferenceImage& image) {
    try {
        PixelTracer tracer(scene, pixels, options, sampler);
        for (int tile = work.next(); tile >= 0; tile = work.next()) {
            const int left = tile % work.columns() * kTile_px;
            const int top = tile / work.columns() * kTile_px;
            for (int y = top; y < std::min(top + kTile_px, image.height); ++y) {
                for (int x = left; x < std::min(left + kTile_px, image.width); ++x) {
                    const TracedPixel pixel = tracer.trace(x, y);
                    const std::size_t i =
                        static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(x);
                    image.accessibility[i] = pixel.accessibility;
                    image.standard_error[i] = pixel.standard_error;
                    image.depth_m[i] = pixel.depth_m;
                }
            }
            work.finished_one();
        }
    } catch (...) {
        work.failed(std::current_exception());
    }
}

}  // namespace

void check_options(const ReferenceOptions& options) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    base::check_above("reference", "radius_m", options.radius_m, 0.0, kInfinity);
    base::check_range("reference", "rays", options.rays, 1, kMostReferenceRays);
    base::check_range("reference", "threads", options.threads, 0, 4096);
    if (options.falloff != Falloff::kNone && std::isinf(options.radius_m)) {
        throw base::bad_input("reference: radius_m is infinite; a falloff needs a finite one");
    }
}

ReferenceScene::ReferenceScene(const Scene& scene) : rays_(std::make_unique<RayScene>(scene)) {}
ReferenceScene::~ReferenceScene() = default;
ReferenceScene::ReferenceScene(ReferenceScene&&) noexcept = default;
ReferenceScene& ReferenceScene::operator=(ReferenceScene&&) noexcept = default;

const std::string& ReferenceScene::geometry_sha256() const { return rays_->sha256(); }

std::size_t ReferenceScene::skipped_triangles() const { return rays_->skipped(); }

ReferenceImage ReferenceScene::trace(const Camera& camera, int width, int height,
                                     const ReferenceOptions& options,
                                     const ReferenceProgress& progress) const {
    base::check_range("reference", "width", width, 1, 16384);
    base::check_range("reference", "height", height, 1, 16384);
    check_options(options);
    const PixelRays pixels(camera, width, height, rays_->origin_m());
    const HemisphereSampler sampler(options.rays);
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    ReferenceImage image{width, height, std::vector<float>(count, 1.0F),
                         std::vector<float>(count, 0.0F),
                         std::vector<float>(count, kBackgroundDepth_m)};
    Work work(width, height, progress);
    const auto run = [&] { trace_tiles(*rays_, pixels, options, sampler, work, image); };
    const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    const int threads = std::min(options.threads > 0 ? options.threads : cores, work.tiles());
    {
        std::vector<std::jthread> others;
        for (int i = 1; i < threads; ++i) others.emplace_back(run);
        run();
    }
    work.throw_what_happened();
    return image;
}

}  // namespace obscura::renderer
