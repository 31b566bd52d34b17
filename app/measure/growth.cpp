// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/growth.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "renderer/gl/context.h"

namespace obscura::app {
namespace {

using renderer::Variant;

/// One point: a setting at a size.
struct Point {
    double x = 0.0;
    Variant choice;
    int width = 0;
    int height = 0;
};

std::vector<std::pair<int, int>> sizes_of(const MeasureRequest& request) {
    if (request.quick) return {{160, 90}, {226, 127}, {320, 180}, {452, 254}};
    return {{160, 90}, {320, 180}, {452, 254}, {640, 360}, {905, 509}, {1280, 720}};
}

/// The range's own samples, doubled from 8.
std::vector<int> samples_of(const renderer::Technique& technique) {
    std::vector<int> list;
    const renderer::SampleRange& range = technique.samples;
    for (int samples = 8; samples <= std::min(128, range.high); samples *= 2) {
        renderer::Variant variant = renderer::standard_variant(technique);
        variant.samples = samples;
        if (renderer::problems_of(variant).empty()) list.push_back(samples);
    }
    return list;
}

std::vector<Point> points_of(const MeasureRequest& request, const renderer::Technique& technique,
                             const std::string& quantity) {
    Variant choice;
    choice.technique = technique.name;
    choice.samples = technique.samples.standard;
    std::vector<Point> points;
    if (quantity == "pixels") {
        for (const auto& [width, height] : sizes_of(request)) {
            points.push_back({static_cast<double>(width) * height, choice, width, height});
        }
        return points;
    }
    for (const int samples : samples_of(technique)) {
        choice.samples = samples;
        points.push_back({static_cast<double>(samples), choice, 320, 180});
    }
    return points;
}

/// The techniques whose cost can grow: those with a shader.
std::vector<const renderer::Technique*> growing(const MeasureRequest& request) {
    std::vector<const renderer::Technique*> list;
    for (const std::string& name : measured_techniques(request)) {
        const renderer::Technique* technique = renderer::find_technique(name);
        if (technique->recipe != nullptr) list.push_back(technique);
    }
    return list;
}

constexpr const char* kQuantities[] = {"pixels", "samples"};

}  // namespace

std::size_t growth_steps(const MeasureRequest& request) {
    std::size_t steps = 0;
    for (const renderer::Technique* technique : growing(request)) {
        for (const char* quantity : kQuantities) {
            steps += points_of(request, *technique, quantity).size();
        }
    }
    return steps * static_cast<std::size_t>(kDiscardedRuns + *request.runs);
}

std::vector<analysis::Growth> measure_growth(MeasuredScene& stage, const MeasureRequest& request,
                                             const MeasuredView& view, const TimerCheck& timers,
                                             const std::function<void(const std::string&)>& step) {
    std::vector<analysis::Growth> growths;
    std::vector<std::vector<Point>> points;
    for (const char* quantity : kQuantities) {
        for (const renderer::Technique* technique : growing(request)) {
            analysis::Growth growth;
            growth.technique = technique->name;
            growth.quantity = quantity;
            growth.device = renderer::gpu_renderer();
            growths.push_back(growth);
            points.push_back(points_of(request, *technique, quantity));
        }
    }
    std::vector<std::vector<RunTimes>> times;
    for (const auto& list : points) times.emplace_back(list.size());
    for (int run = 0; run < kDiscardedRuns + *request.runs; ++run) {
        for (std::size_t i = 0; i < points.size(); ++i) {
            for (std::size_t k = 0; k < points[i].size(); ++k) {
                const Point& point = points[i][k];
                const renderer::Frame frame =
                    stage.render_plainly(view, point.choice, point.width, point.height);
                if (run >= kDiscardedRuns) times[i][k].add(frame.times, timers.use_queries);
                step(fmt::format("{} {}", growths[i].technique, growths[i].quantity));
            }
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t k = 0; k < points[i].size(); ++k) {
            analysis::MeasurementRow row;
            times[i][k].put(row, {});
            growths[i].x.push_back(points[i][k].x);
            growths[i].ms.push_back(row.accessibility.median_ms);
        }
        growths[i].law = analysis::power_law(growths[i].x, growths[i].ms);
    }
    return growths;
}

}  // namespace obscura::app
