// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/hard_cases/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/base/check.h"
#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/reference/reference.h"

namespace obscura::renderer {
namespace {

constexpr int kRays = 64;

/// All that compute a buffer.
std::vector<std::string> all_techniques() {
    std::vector<std::string> names;
    for (const Technique& technique : techniques()) {
        if (technique.makes_accessibility()) names.push_back(technique.name);
    }
    return names;
}

std::vector<std::string> chosen_techniques(const HardCaseOptions& options) {
    if (options.techniques.empty()) return all_techniques();
    std::vector<std::string> chosen;
    const std::vector<std::string> known = all_techniques();
    for (const std::string& name : options.techniques) {
        const bool computes = std::find(known.begin(), known.end(), name) != known.end();
        if (!computes && find_technique(name) == nullptr) {
            throw base::bad_input("hard cases: \"{}\" is no technique", name);
        }
        if (computes) chosen.push_back(name);
    }
    return chosen;
}

}  // namespace

const std::vector<HardCase>& hard_cases() {
    static const std::vector<HardCase> list = {
        planes_case(),    separated_cube_case(), thin_occluder_case(), border_case(),
        close_up_case(),  not_a_number_case(),   rotations_case(),     background_case(),
        units_case(),     projections_case(),    denoise_case(),       quantisation_case(),
        odd_sizes_case(), degenerate_case(),
    };
    return list;
}

std::size_t hard_case_steps(const HardCaseOptions& options) {
    const std::size_t techniques = chosen_techniques(options).size();
    std::size_t steps = 0;
    for (const HardCase& hard_case : hard_cases()) steps += hard_case.once ? 1 : techniques;
    return steps;
}

std::vector<HardCaseResult> run_hard_cases(const HardCaseOptions& options) {
    base::check_range("hard cases", "size", options.size_px, 32, 1024);
    base::check_range("hard cases", "vectors", options.vectors, 1, 10'000'000);
    const std::vector<std::string> chosen = chosen_techniques(options);
    std::vector<HardCaseResult> rows;
    Bench bench(options, rows);
    for (const HardCase& hard_case : hard_cases()) {
        bench.begin(hard_case);
        for (const std::string& technique :
             hard_case.once ? std::vector<std::string>{"all"} : chosen) {
            hard_case.run(bench, technique);
            if (options.progress)
                options.progress(fmt::format("{} {}", hard_case.title, technique));
        }
    }
    return rows;
}

bool Shot::is_surface(std::size_t pixel) const { return depth_m[pixel] < kBackgroundLimit_m; }

void Bench::begin(const HardCase& hard_case) {
    name_ = fmt::format("{} {}", hard_case.number, hard_case.title);
}

TechniqueChoice Bench::settings(const std::string& technique, double radius) {
    TechniqueChoice choice;
    choice.technique = technique;
    const Technique* found = find_technique(technique);
    choice.samples = found->samples.standard;
    const std::pair<const char*, double> lengths[] = {{"radius_m", radius},
                                                      {"full_threshold_m", radius / 25.0},
                                                      {"no_threshold_m", radius},
                                                      {"depth_scale_per_m", 1.0 / radius}};
    for (const auto& [name, value] : lengths) {
        const Parameter* parameter = found->find_parameter(name);
        if (parameter != nullptr) {
            choice.parameters[name] = std::clamp(value, parameter->low, parameter->high);
        }
    }
    return choice;
}

Shot Bench::shoot(const Scene& scene, const Camera& camera, const TechniqueChoice& choice,
                  int width, int height) {
    if (choice.technique == kReference) {
        return trace(scene, camera, choice.parameters.at("radius_m"), width, height);
    }
    const Lighting lighting;
    const GpuScene gpu(scene);
    const Frame frame = renderer_.render({gpu, lighting, camera}, choice, width, height);
    Shot shot{width,
              height,
              frame.read_floats(Target::kDepth),
              frame.read_floats(Target::kAccessibility),
              frame.read_floats(frame.plan().final_accessibility()),
              0.0};
    for (const PassTime& time : frame.times) {
        if (time.phase != Phase::kTechnique) continue;
        shot.accessibility_ms +=
            is_software_renderer() ? time.milliseconds : time.query_milliseconds;
    }
    return shot;
}

Shot Bench::trace(const Scene& scene, const Camera& camera, double radius, int width, int height) {
    ReferenceOptions options;
    options.radius_m = radius;
    options.rays = kRays;
    const ReferenceScene rays(scene);
    const ReferenceImage image = rays.trace(camera, width, height, options);
    return {width, height, image.depth_m, image.accessibility, image.accessibility, 0.0};
}

void Bench::expect(const std::string& technique, const std::string& quantity, double expected,
                   double measured, double tolerance, const std::string& nature,
                   const std::string& note) {
    HardCaseResult row{name_,    technique, quantity,        expected,
                       measured, tolerance, Outcome::kHolds, note};
    if (!(std::abs(measured - expected) <= tolerance)) {
        row.outcome = nature.empty() ? Outcome::kFails : Outcome::kByNature;
        if (!nature.empty()) row.note += (note.empty() ? "" : "; ") + nature;
    }
    rows_.push_back(row);
}

void Bench::expect_sound(const std::string& technique, const std::string& quantity,
                         const Shot& shot, const std::string& note) {
    std::size_t unsound = 0;
    for (const std::vector<float>* values : {&shot.accessibility, &shot.denoised}) {
        unsound +=
            static_cast<std::size_t>(std::count_if(values->begin(), values->end(), [](float value) {
                return !(value >= 0.0F && value <= 1.0F);
            }));
    }
    expect(technique, quantity + ": values that are not in [0, 1]", 0.0,
           static_cast<double>(unsound), 0.0, "", note);
}

std::string not_white_by_nature(const std::string& technique) {
    if (technique == "crytek") {
        return "half of the samples around a flat surface lie below it: 0.75 where it faces the "
               "camera, other values where it is tilted or where samples leave the image";
    }
    return "";
}

std::string tilted_by_nature(const std::string& technique) {
    if (technique == "blizzard" || technique == "raymarch") {
        return "the depth at a sample is compared with the depth of P, so the nearer part of a "
               "tilted or round surface counts as an occluder of the rest";
    }
    return not_white_by_nature(technique);
}

std::string border_by_nature(const std::string& technique) {
    if (technique == kReference) return "";
    return "what lies outside the image is not in the buffer and reads as very far";
}

double facing_wall_value(const std::string& technique) {
    return technique == "crytek" ? 0.75 : 1.0;
}

double farthest(const Shot& shot, std::span<const float> values, double expected, double margin) {
    const int x_margin = static_cast<int>(margin * shot.width);
    const int y_margin = static_cast<int>(margin * shot.height);
    double found = expected;
    for (int y = y_margin; y < shot.height - y_margin; ++y) {
        for (int x = x_margin; x < shot.width - x_margin; ++x) {
            const std::size_t pixel = shot.at(x, y);
            if (!shot.is_surface(pixel)) continue;
            const double value = values[pixel];
            if (!std::isfinite(value)) return value;
            if (std::abs(value - expected) > std::abs(found - expected)) found = value;
        }
    }
    return found;
}

}  // namespace obscura::renderer
