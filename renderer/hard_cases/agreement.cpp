// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/hard_cases/agreement.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include "renderer/passes/shared_constants.h"

namespace obscura::renderer {
namespace {

constexpr double kMostPixels = 65536.0;

/// Every which column and row: 1, or odd, so that it meets each place of a 4x4 tile.
int stride_of(const SeenBuffers& buffers) {
    const double pixels = static_cast<double>(buffers.width) * buffers.height;
    const int stride = static_cast<int>(std::ceil(std::sqrt(pixels / kMostPixels)));
    return std::max(1, stride % 2 == 0 ? stride + 1 : stride);
}

}  // namespace

bool HeldPixel::holds() const { return std::abs(measured - definition) <= allowed; }

double HeldPixel::rank() const {
    const double off = std::abs(measured - definition);
    if (std::isnan(off)) return std::numeric_limits<double>::infinity();
    if (off <= allowed) return allowed > 0.0 ? off / allowed : 0.0;  // at most 1
    return 1.0 + (off - allowed);
}

void Agreement::add(const Agreement& other) {
    images += other.images;
    pixels += other.pixels;
    off += other.off;
    uncertain += other.uncertain;
    if (worst.where.empty() || other.worst.rank() > worst.rank()) worst = other.worst;
}

Agreement agreement_of(std::span<const std::optional<Admitted>> admitted,
                       std::span<const float> measured, int width, const std::string& what) {
    Agreement found;
    found.images = 1;
    found.worst.where = what;
    std::size_t at = 0;
    for (std::size_t i = 0; i < admitted.size(); ++i) {
        if (!admitted[i]) continue;
        ++found.pixels;
        HeldPixel pixel{"", admitted[i]->value, static_cast<double>(measured[i]), 0.0};
        pixel.allowed = pixel.measured > pixel.definition ? admitted[i]->high - pixel.definition
                                                          : pixel.definition - admitted[i]->low;
        if (!pixel.holds()) ++found.off;
        if (admitted[i]->high - admitted[i]->low > kUncertain) ++found.uncertain;
        if (pixel.rank() <= found.worst.rank()) continue;
        found.worst = pixel;
        at = i;
    }
    const auto row = static_cast<std::size_t>(width);
    found.worst.where = fmt::format("{}, pixel {}, {}", what, at % row, at / row);
    return found;
}

std::vector<std::optional<Admitted>> admitted_by(const PixelModel& model,
                                                 const SeenBuffers& buffers) {
    std::vector<std::optional<Admitted>> admitted(buffers.depth_m.size());
    const int stride = stride_of(buffers);
    std::atomic<int> next{0};
    const auto work = [&] {
        for (int y = stride * next++; y < buffers.height; y = stride * next++) {
            for (int x = 0; x < buffers.width; x += stride) {
                admitted[buffers.index(x, y)] = buffers.is_empty(x, y) ? Admitted{} : model(x, y);
            }
        }
    };
    {
        const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
        std::vector<std::jthread> others;
        for (unsigned i = 1; i < cores; ++i) others.emplace_back(work);
        work();
    }
    return admitted;
}

}  // namespace obscura::renderer
