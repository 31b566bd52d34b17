// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// How fast the reference traces, beside bare loops over the same occlusion rays of the same scene:
//   reference_bench --benchmark_filter=atrium
// All on one thread. items_per_second are rays of surface points; their ratio is what counts.
#include <benchmark/benchmark.h>
#include <xmmintrin.h>

#include <map>
#include <memory>

#include "renderer/passes/shared_constants.h"
#include "renderer/reference/pixel_tracer.h"
#include "renderer/reference/ray_scene.h"
#include "renderer/reference/reference.h"
#include "stimuli/scenes/builtin_scene.h"

namespace {

using namespace obscura;
using namespace obscura::renderer;

constexpr int kWidth = 160;
constexpr int kHeight = 90;
constexpr int kRays = 256;
constexpr float kRadius_m = 0.5F;

ReferenceOptions options() {
    ReferenceOptions wanted;
    wanted.radius_m = kRadius_m;
    wanted.rays = kRays;
    wanted.threads = 1;
    return wanted;
}

/// A built-in scene with the rays that trace() casts in it, already made.
struct Prepared {
    explicit Prepared(const std::string& id)
        : scene(stimuli::find_builtin_scene(id)->build()), reference(scene) {
        const PixelRays pixels(scene.cameras.front(), kWidth, kHeight, reference.rays().origin_m());
        const HemisphereSampler sampler(kRays);
        const ReferenceOptions wanted = options();
        PixelTracer tracer(reference.rays(), pixels, wanted, sampler);
        for (int y = 0; y < kHeight; ++y) {
            for (int x = 0; x < kWidth; ++x) {
                if (tracer.trace(x, y).depth_m >= kBackgroundLimit_m) continue;
                tracer.append_last_rays(rays);
            }
        }
    }

    Scene scene;
    ReferenceScene reference;
    std::vector<RTCRay> rays;
};

const Prepared& prepared(const std::string& id) {
    static std::map<std::string, std::unique_ptr<Prepared>> all;
    std::unique_ptr<Prepared>& one = all[id];
    if (!one) one = std::make_unique<Prepared>(id);
    return *one;
}

/// Denormals flushed, as the reference has it.
class Flushed {
  public:
    Flushed() : saved_(_mm_getcsr()) { _mm_setcsr(saved_ | 0x8040U); }
    ~Flushed() { _mm_setcsr(saved_); }
    Flushed(const Flushed&) = delete;
    Flushed& operator=(const Flushed&) = delete;

  private:
    unsigned saved_;
};

void count_rays(benchmark::State& state, const Prepared& data) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(data.rays.size()));
}

void bare_single(benchmark::State& state, const std::string& id) {
    const Prepared& data = prepared(id);
    const Flushed flushed;
    RayScene::Context context(false);
    for (auto unused : state) {
        for (const RTCRay& ray : data.rays) {
            RTCRay copy = ray;
            rtcOccluded1(data.reference.rays().embree(), &context, &copy);
            benchmark::DoNotOptimize(copy.tfar);
        }
    }
    count_rays(state, data);
}

template <typename Packet, int kSize,
          void (*kOccluded)(const int*, RTCScene, RTCIntersectContext*, Packet*),
          RTCIntersectContextFlags kFlags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT>
void bare_packets(benchmark::State& state, const std::string& id) {
    const Prepared& data = prepared(id);
    const Flushed flushed;
    std::vector<Packet> packets(data.rays.size() / kSize);
    for (std::size_t p = 0; p < packets.size(); ++p) {
        for (std::size_t i = 0; i < kSize; ++i) {
            const RTCRay& ray = data.rays[p * kSize + i];
            packets[p].org_x[i] = ray.org_x;
            packets[p].org_y[i] = ray.org_y;
            packets[p].org_z[i] = ray.org_z;
            packets[p].dir_x[i] = ray.dir_x;
            packets[p].dir_y[i] = ray.dir_y;
            packets[p].dir_z[i] = ray.dir_z;
            packets[p].tnear[i] = 0.0F;
            packets[p].tfar[i] = ray.tfar;
            packets[p].mask[i] = ~0U;
        }
    }
    alignas(64) int valid[kSize];
    std::fill(std::begin(valid), std::end(valid), -1);
    RayScene::Context context(false);
    context.flags = kFlags;
    for (auto unused : state) {
        for (const Packet& packet : packets) {
            Packet copy = packet;
            kOccluded(valid, data.reference.rays().embree(), &context, &copy);
            benchmark::DoNotOptimize(copy.tfar[0]);
        }
    }
    count_rays(state, data);
}

template <RTCIntersectContextFlags kFlags>
void bare_stream(benchmark::State& state, const std::string& id) {
    const Prepared& data = prepared(id);
    const Flushed flushed;
    RayScene::Context context(false);
    context.flags = kFlags;
    std::vector<RTCRay> stream(kRays);
    for (auto unused : state) {
        for (std::size_t first = 0; first < data.rays.size(); first += kRays) {
            std::copy_n(&data.rays[first], kRays, stream.begin());
            rtcOccluded1M(data.reference.rays().embree(), &context, stream.data(), kRays,
                          sizeof(RTCRay));
            benchmark::DoNotOptimize(stream[0].tfar);
        }
    }
    count_rays(state, data);
}

void reference(benchmark::State& state, const std::string& id) {
    const Prepared& data = prepared(id);
    for (auto unused : state) {
        benchmark::DoNotOptimize(
            data.reference.trace(data.scene.cameras.front(), kWidth, kHeight, options()));
    }
    count_rays(state, data);
}

void register_for(const std::string& id) {
    const auto add = [&id](const char* name, void (*run)(benchmark::State&, const std::string&)) {
        benchmark::RegisterBenchmark((id + '/' + name).c_str(), [run, id](benchmark::State& state) {
            run(state, id);
        })->Unit(benchmark::kMillisecond);
    };
    add("bare_1", bare_single);
    add("bare_4", bare_packets<RTCRay4, 4, rtcOccluded4>);
    add("bare_8", bare_packets<RTCRay8, 8, rtcOccluded8>);
    add("bare_16", bare_packets<RTCRay16, 16, rtcOccluded16>);
    add("bare_16_coherent",
        bare_packets<RTCRay16, 16, rtcOccluded16, RTC_INTERSECT_CONTEXT_FLAG_COHERENT>);
    add("bare_stream", bare_stream<RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT>);
    add("bare_stream_coherent", bare_stream<RTC_INTERSECT_CONTEXT_FLAG_COHERENT>);
    add("reference", reference);
}

}  // namespace

int main(int argc, char** argv) {
    for (const stimuli::BuiltinScene& scene : stimuli::builtin_scenes()) register_for(scene.id);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
