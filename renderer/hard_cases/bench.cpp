// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/hard_cases/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/denoise/denoise.h"
#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/recipe/normal_format.h"
#include "renderer/scene/camera.h"
#include "renderer/technique/progressive.h"
#include "renderer/technique/reference.h"

namespace obscura::renderer {
namespace {

constexpr int kRays = 64;
/// Share of pixels that may be uncertain: the others bind the shader to kUncertain or closer.
constexpr double kMostUncertain = 0.05;

/// Nominal values; empty where some pixel was not evaluated.
Values values_of(const std::vector<std::optional<Admitted>>& admitted) {
    Values values;
    values.reserve(admitted.size());
    for (const std::optional<Admitted>& pixel : admitted) {
        if (!pixel) return {};
        values.push_back(static_cast<float>(pixel->value));
    }
    return values;
}

/// What a filter is told: samples that repeat over a tile have no error that it could know.
int samples_of_rays(const Variant& variant) {
    return find_technique(variant.technique)->ray_traced ? variant.samples : 0;
}

}  // namespace

SeenBuffers seen_buffers(const Frame& frame, const Camera& camera) {
    const FramePlan& plan = frame.plan();
    const std::string normal = plan.seen_by_technique(Target::kNormal);
    const PlannedTarget* made = plan.find(Target::kAccessibility);
    SeenBuffers buffers{
        .width = made != nullptr ? made->width : plan.image_width,
        .height = made != nullptr ? made->height : plan.image_height,
        .camera = every_so_many(camera, plan.image_width, plan.image_height, plan.ao_step),
        .depth_m = frame.read_floats(plan.seen_by_technique(Target::kDepth)),
        .empty = frame.read_empty(plan.seen_by_technique(Target::kVisibility)),
        .normal = {},
        .normal_format = plan.variant.normal_format,
        .position = plan.variant.position,
        .position_m = {},
        .second_m = {},
        .second_step = plan.second_step,
        .samples = samples_of_rays(plan.variant)};
    for (float& depth_m : buffers.depth_m) {
        // Half floats may hold infinity there; a shader sees no difference.
        if (depth_m >= kBackgroundLimit_m) depth_m = kBackgroundDepth_m;
    }
    if (plan.variant.position == "stored") {
        buffers.position_m = frame.read_components(plan.seen_by_technique(Target::kPosition), 3);
    }
    if (plan.find(Target::kSecondDepth) != nullptr) {
        buffers.second_m = frame.read_floats(Target::kSecondDepth);
    }
    if (plan.find(normal) == nullptr) return buffers;
    const int most = normal_format_of(buffers.normal_format).most;
    for (const float code : frame.read_components(normal, 3)) {
        buffers.normal.push_back(
            static_cast<std::uint16_t>(std::lround(static_cast<float>(most) * code)));
    }
    return buffers;
}

bool Shot::is_surface(std::size_t pixel) const { return depth_m[pixel] < kBackgroundLimit_m; }

void Bench::run(const HardCase& hard_case, const Technique* technique) {
    name_ = fmt::format("{} {}", hard_case.number, hard_case.title);
    technique_ = technique != nullptr ? technique->name : "all";
    agreements_.clear();
    allow_uncertain_ = false;
    if (technique != nullptr) {
        hard_case.run(*this, *technique);
    } else {
        hard_case.run_once(*this);
    }
    write_agreements();
}

Variant Bench::settings(const Technique& technique, double radius) {
    Variant choice;
    choice.technique = technique.name;
    choice.samples = technique.ray_traced ? kRays : technique.samples.standard;
    const std::pair<const char*, double> lengths[] = {{"radius_m", radius},
                                                      {"full_threshold_m", radius / 25.0},
                                                      {"no_threshold_m", radius},
                                                      {"depth_scale_per_m", 1.0 / radius}};
    for (const auto& [name, value] : lengths) {
        const Parameter* parameter = technique.find_parameter(name);
        if (parameter != nullptr) {
            choice.parameters[name] = std::clamp(value, parameter->low, parameter->high);
        }
    }
    return choice;
}

Frame Bench::render(const Scene& scene, const Camera& camera, const Variant& choice, int width,
                    int height) {
    const Lighting lighting;
    const GpuScene gpu(scene);
    std::optional<ReferenceScene> made;
    const auto rays = [&]() -> const ReferenceScene& {
        if (!made) made.emplace(scene);
        return *made;
    };
    return renderer_.render({gpu, lighting, camera, {}, {}, rays}, choice, width, height);
}

double Bench::time_ms(const Scene& scene, const Camera& camera, const Variant& choice, int width,
                      int height) {
    double spent_ms = 0.0;
    for (const PassTime& time : render(scene, camera, choice, width, height).times) {
        if (time.phase != Phase::kTechnique) continue;
        spent_ms += is_software_renderer() ? time.milliseconds : time.query_milliseconds;
    }
    return spent_ms;
}

Shot Bench::shoot(const std::string& what, const Scene& scene, const Camera& camera,
                  const Variant& choice, int width, int height) {
    if (find_technique(choice.technique)->is_truth()) {
        return trace(scene, camera, choice, width, height);
    }
    const Frame frame = render(scene, camera, choice, width, height);
    const SeenBuffers buffers = seen_buffers(frame, camera);
    const bool filtered = frame.plan().has(Phase::kDenoise);
    Shot shot{.width = buffers.width,
              .height = buffers.height,
              .depth_m = buffers.depth_m,
              .accessibility = frame.read_floats(Target::kAccessibility),
              .denoised = frame.read_floats(filtered ? Target::kDenoised : Target::kAccessibility),
              .shown = frame.read_accessibility()};
    hold_against_definition(what, buffers, choice, shot);
    return shot;
}

Shot Bench::trace(const Scene& scene, const Camera& camera, const Variant& choice, int width,
                  int height) {
    const ReferenceScene rays(scene);
    const ReferenceImage image = rays.trace(camera, width, height, reference_options(choice));
    return {.width = width,
            .height = height,
            .depth_m = image.depth_m,
            .accessibility = image.accessibility,
            .denoised = image.accessibility,
            .shown = image.accessibility};
}

const Bench::AdmittedPixels& Bench::admitted_of(const SeenBuffers& buffers, Variant choice) {
    choice.denoise = "none";  // comes after
    if (last_.choice != choice || !(last_.buffers == buffers)) {
        last_ = {buffers, choice, {}};
        last_.admitted = admitted_by(
            model_of(*find_technique(choice.technique), last_.buffers, choice), last_.buffers);
        for (std::optional<Admitted>& pixel : last_.admitted) {
            if (pixel) *pixel = as_stored(*pixel, choice.ao_format);
        }
    }
    return last_.admitted;
}

void Bench::hold_against_definition(const std::string& what, const SeenBuffers& buffers,
                                    const Variant& choice, Shot& shot) {
    const Technique& technique = *find_technique(choice.technique);
    if (!technique.model) return;
    const auto& admitted = admitted_of(buffers, choice);
    for (const std::optional<Admitted>& pixel : admitted) {
        if (pixel) shot.depth_reads = std::max(shot.depth_reads, pixel->depth_reads);
    }
    Agreement agreement = agreement_of(admitted, shot.accessibility, shot.width, what);
    if (allow_uncertain_) agreement.uncertain = 0;
    agreements_[""].add(agreement);
    shot.as_defined = agreement.off == 0;
    shot.defined_accessibility = values_of(admitted);
    shot.defined_denoised = shot.defined_accessibility;
    const Denoise& denoise = *find_denoise(choice.denoise);
    if (!denoise.model) return;
    // On what the technique's shader wrote, so that each is held against its own definition.
    std::vector<Admitted> filtered = denoise.model(buffers, shot.accessibility);
    for (Admitted& pixel : filtered) pixel = as_stored(pixel, choice.ao_format);
    const std::vector<std::optional<Admitted>> all(filtered.begin(), filtered.end());
    const Agreement of_filter = agreement_of(all, shot.denoised, shot.width, what);
    agreements_[denoise.name].add(of_filter);
    shot.as_defined &= of_filter.off == 0;
    shot.defined_denoised = values_of(all);
}

HardCaseResult Bench::row(const std::string& quantity) const {
    HardCaseResult result;
    result.name = name_;
    result.technique = technique_;
    result.quantity = quantity;
    return result;
}

void Bench::write_agreements() {
    for (const auto& [filter, agreement] : agreements_) {
        const std::string of = filter.empty() ? "A" : filter + ": A";
        HardCaseResult nearest = row(of + " at the pixel farthest from its definition");
        nearest.against = Against::kDefinition;
        nearest.expected = agreement.worst.definition;
        nearest.definition = agreement.worst.definition;
        nearest.measured = agreement.worst.measured;
        nearest.tolerance = agreement.worst.allowed;
        nearest.outcome = agreement.off == 0 ? Outcome::kHolds : Outcome::kFails;
        nearest.note = fmt::format("{} of {} pixels of {} images are off; {}", agreement.off,
                                   agreement.pixels, agreement.images, agreement.worst.where);
        rows_.push_back(nearest);
        HardCaseResult uncertain = row(fmt::format(
            "{}: share of pixels that rounding may move by more than {}", of, kUncertain));
        uncertain.against = Against::kDefinition;
        uncertain.measured =
            static_cast<double>(agreement.uncertain) / static_cast<double>(agreement.pixels);
        uncertain.tolerance = kMostUncertain;
        uncertain.outcome =
            uncertain.measured <= kMostUncertain ? Outcome::kHolds : Outcome::kFails;
        rows_.push_back(uncertain);
    }
}

void Bench::expect(const std::string& quantity, double truth, const Found& found, double tolerance,
                   const std::string& nature, const std::string& note) {
    HardCaseResult result = row(quantity);
    result.expected = truth;
    result.definition = found.definition;
    result.measured = found.measured;
    result.tolerance = tolerance;
    result.outcome = Outcome::kHolds;
    result.note = note;
    if (!(std::abs(found.measured - truth) <= tolerance)) {
        const bool by_nature = !nature.empty() && found.as_defined;
        result.outcome = by_nature ? Outcome::kByNature : Outcome::kFails;
        if (by_nature) result.note += (note.empty() ? "" : "; ") + nature;
    }
    rows_.push_back(result);
}

void Bench::expect_growth(const std::string& quantity, double measured, double most,
                          Outcome outcome, const std::string& note) {
    HardCaseResult result = row(quantity);
    result.expected = 1.0;
    result.measured = measured;
    result.tolerance = most - 1.0;
    result.outcome = outcome;
    result.note = note;
    rows_.push_back(result);
}

void Bench::expect_sound(const std::string& quantity, const Shot& shot, const std::string& note) {
    std::size_t unsound = 0;
    for (const Values* values : {&shot.accessibility, &shot.denoised, &shot.shown}) {
        unsound +=
            static_cast<std::size_t>(std::count_if(values->begin(), values->end(), [](float value) {
                return !(value >= 0.0F && value <= 1.0F);
            }));
    }
    expect(quantity + ": values that are not in [0, 1]", 0.0, static_cast<double>(unsound), 0.0,
           note);
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
