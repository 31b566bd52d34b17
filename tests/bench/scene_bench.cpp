// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// How long a built-in scene takes until it can be drawn, on all cores: its generation, and with its
// upload until OpenGL is finished.
//   scene_bench --benchmark_filter=figures
// items_per_second are triangles.
#include <benchmark/benchmark.h>

#include "renderer/frame/gpu_scene.h"
#include "renderer/gl/context.h"
#include "stimuli/scenes/builtin_scene.h"

namespace {

using namespace obscura;

void count_triangles(benchmark::State& state, std::size_t triangles) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) *
                            static_cast<std::int64_t>(triangles));
}

void generate(benchmark::State& state, const stimuli::BuiltinScene& scene) {
    std::size_t triangles = 0;
    for (auto unused : state) triangles = scene.build().triangle_count();
    count_triangles(state, triangles);
}

void generate_and_upload(benchmark::State& state, const stimuli::BuiltinScene& scene) {
    const renderer::HeadlessContext context;
    std::size_t triangles = 0;
    for (auto unused : state) {
        const renderer::Scene built = scene.build();
        const renderer::GpuScene gpu(built);
        glFinish();
        triangles = built.triangle_count();
    }
    count_triangles(state, triangles);
}

}  // namespace

int main(int argc, char** argv) {
    for (const stimuli::BuiltinScene& scene : stimuli::builtin_scenes()) {
        for (const auto& [name, run] :
             {std::pair<const char*, decltype(&generate)>("generate", &generate),
              {"generate_and_upload", &generate_and_upload}}) {
            benchmark::RegisterBenchmark(
                (scene.id + '/' + name).c_str(),
                [run, scene](benchmark::State& state) { run(state, scene); })
                ->Unit(benchmark::kMillisecond)
                ->UseRealTime();
        }
    }
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
