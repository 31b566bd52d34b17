// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/sweep.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "renderer/gl/context.h"
#include "renderer/passes/shared_constants.h"

namespace obscura::app {
namespace {

using renderer::Frame;
using renderer::Target;
using renderer::Variant;

constexpr float kSameSurface = 0.98F;  // of the depth of what the rays see

analysis::MeasurementRow describe(const MeasuredView& view, const Setting& setting, int width,
                                  int height) {
    const Variant& choice = setting.choice;
    analysis::MeasurementRow row;
    row.scene_id = view.scene_id;
    row.scene = view.scene->id;
    row.camera = view.camera;
    row.validity = stimuli::to_string(view.validity);
    row.technique = choice.technique;
    row.variant = choice.variant_name();
    row.samples = choice.samples;
    row.denoise = choice.denoise;
    row.depth_format = choice.depth_format;
    row.ao_scale = 1.0 / renderer::ao_step(choice);
    row.noise = choice.samples > 0 ? choice.noise : "none";
    row.options = renderer::options_in_words(choice);
    row.width = width;
    row.height = height;
    row.device = renderer::gpu_renderer();
    row.fitted = setting.values == Values::kFitted;
    row.values = to_string(setting.values);
    row.published = setting.shown;
    row.parameters = choice.all_parameters();
    row.reference_radius_m = setting.truth_radius_m;
    row.fetches_per_px = renderer::fetches_per_pixel(choice);
    return row;
}

std::size_t nonfinite_of(const std::vector<float>& values) {
    std::size_t count = 0;
    for (const float value : values) count += std::isfinite(value) ? 0 : 1;
    return count;
}

double rms(const std::vector<float>& values, const std::vector<std::uint8_t>& counted) {
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (counted[i] == 0) continue;
        sum += static_cast<double>(values[i]) * static_cast<double>(values[i]);
        count += 1.0;
    }
    return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

/// Fills the errors of a row from its first image, and draws where they are.
analysis::ErrorMap compare(analysis::MeasurementRow& row, const Frame& frame,
                           const renderer::ReferenceImage& truth,
                           const std::vector<std::uint8_t>& true_image) {
    const std::vector<float> measured = frame.read_accessibility();
    const std::vector<std::uint8_t> surfaces = surface_mask(frame, truth);
    row.error = analysis::accessibility_error(measured, truth.accessibility, surfaces);
    std::vector<std::uint8_t> interior =
        analysis::interior_mask(truth.width, truth.height, kInteriorMargin);
    for (std::size_t i = 0; i < interior.size(); ++i) interior[i] &= surfaces[i];
    row.interior = analysis::accessibility_error(measured, truth.accessibility, interior);
    const renderer::Technique& technique = *renderer::find_technique(row.technique);
    if (technique.output == renderer::Output::kColour) {
        row.error = row.interior =
            analysis::Possible<analysis::AccessibilityError>::none(why_unmeasured(technique));
    }
    row.nonfinite = nonfinite_of(measured);
    if (frame.plan().has(renderer::Phase::kDenoise)) {
        row.nonfinite += nonfinite_of(frame.read_floats(Target::kAccessibility));
    }
    row.truth_stderr = rms(truth.standard_error, surfaces);
    row.image =
        analysis::final_image_error(frame.read_display(), true_image, truth.width, truth.height);
    analysis::ErrorMap map;
    map.width = truth.width;
    map.height = truth.height;
    for (std::size_t i = 0; i < measured.size(); ++i) {
        map.difference.push_back(surfaces[i] != 0 ? measured[i] - truth.accessibility[i] : 0.0F);
    }
    return map;
}

/// The buffers of a plan, which any setting with that plan can be run on.
using PlanFrames = std::map<std::string, Frame>;

/// The passes beside accessibility and filter of plans that have the same ones, run by run.
struct OtherPasses {
    Variant choice;  ///< the first one with them
    std::vector<double> ms;
    std::vector<double> layer_ms;  ///< of them, a second layer's
    std::map<std::string, std::vector<double>> by_pass_ms = {};
};

std::string key_of(const renderer::PlannedTarget& target) {
    return fmt::format("{} {} {}x{} ", target.name, target.format, target.width, target.height);
}

/// Equal for plans with the same passes and buffers.
std::string key_of(const renderer::FramePlan& plan) {
    std::string key;
    for (const renderer::PlannedPass& pass : plan.passes) key += pass.name + ' ';
    for (const renderer::PlannedTarget& target : plan.targets) key += key_of(target);
    return key;
}

/// Equal for plans whose passes beside accessibility and filter are the same.
std::string key_of_others(const renderer::FramePlan& plan) {
    std::string key;
    for (const renderer::PlannedPass& pass : plan.passes) {
        if (renderer::is_of_the_variant(pass.phase)) continue;
        key += pass.name + ' ';
        for (const std::string& buffer : pass.writes) key += key_of(*plan.find(buffer));
    }
    return key;
}

/// Of the buffers that a setting has for itself.
std::size_t bytes_of_the_variant(const renderer::FramePlan& plan) {
    std::map<std::string, std::size_t> bytes;
    for (const renderer::PlannedPass& pass : plan.passes) {
        if (!renderer::is_of_the_variant(pass.phase) &&
            pass.phase != renderer::Phase::kSecondLayer) {
            continue;
        }
        for (const std::string& buffer : pass.writes) bytes[buffer] = plan.find(buffer)->bytes;
    }
    std::size_t sum = 0;
    for (const auto& [buffer, of_buffer] : bytes) sum += of_buffer;
    return sum;
}

/// Of accessibility and filter.
double own_ms(const Frame& frame, bool use_queries) {
    double sum_ms = 0.0;
    for (const renderer::PassTime& time : frame.times) {
        if (!renderer::is_of_the_variant(time.phase)) continue;
        sum_ms += use_queries ? time.query_milliseconds : time.milliseconds;
    }
    return sum_ms;
}

double second_layer_ms(const Frame& frame, bool use_queries) {
    double sum_ms = 0.0;
    for (const renderer::PassTime& time : frame.times) {
        if (time.phase != renderer::Phase::kSecondLayer) continue;
        sum_ms += use_queries ? time.query_milliseconds : time.milliseconds;
    }
    return sum_ms;
}

}  // namespace

std::string shown_where(const MeasuredView& view, const Variant& choice) {
    std::string where;
    for (const ShownSetting& shown : view.shown) {
        if (shown.choice != choice) continue;
        where += (where.empty() ? "" : ", ") + shown.where;
    }
    return where;
}

std::vector<std::uint8_t> surface_mask(const Frame& frame, const renderer::ReferenceImage& truth) {
    std::vector<std::uint8_t> mask;
    mask.reserve(truth.depth_m.size());
    for (const float depth_m : truth.depth_m) mask.push_back(depth_m < kBackgroundLimit_m);
    const renderer::FramePlan& plan = frame.plan();
    const std::string seen = plan.of_pixels(Target::kDepth);
    const renderer::PlannedTarget* planned = plan.find(seen);
    if (planned == nullptr || planned->width != plan.image_width) return mask;
    const std::vector<float> depth_m = frame.read_floats(seen);
    for (std::size_t i = 0; i < mask.size(); ++i) {
        mask[i] &= depth_m[i] < kBackgroundLimit_m;
        // Rays pass through a blended surface that the technique takes for an occluder: the two
        // values are of different surfaces.
        if (plan.blended_occlude()) mask[i] &= depth_m[i] > kSameSurface * truth.depth_m[i];
    }
    return mask;
}

SweptView sweep(MeasuredScene& stage, const MeasureRequest& request, const MeasuredView& view,
                const std::vector<Setting>& settings, const TimerCheck& timers,
                const SweepWatcher& watcher) {
    SweptView swept;
    std::map<double, std::vector<std::uint8_t>> true_images;
    for (const Setting& setting : settings) {
        const double radius_m = setting.truth_radius_m;
        const renderer::ReferenceImage& truth =
            stage.truth(view, radius_m, *request.width, *request.height, *request.rays);
        if (!true_images.contains(radius_m)) {
            true_images.emplace(radius_m, stage.true_image(view, truth, radius_m));
        }
        swept.rows.push_back(describe(view, setting, *request.width, *request.height));
        swept.rows.back().timer = timers.timer();
    }
    PlanFrames frames;
    std::map<std::string, OtherPasses> others;
    std::vector<std::string> plans;
    std::vector<std::string> plans_of_others;
    renderer::ViewBuffers known;  // what no setting changes is drawn once
    const auto name_of = [&](const Setting& setting) {
        return fmt::format("{} {} {}", view.scene->id, view.camera, setting.choice.variant_name());
    };
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const double radius_m = settings[i].truth_radius_m;
        Frame frame =
            stage.render(view, settings[i].choice, *request.width, *request.height, known);
        renderer::ViewBuffers buffers = frame.view_buffers();
        if (frame.taken_over().size() < buffers.times.size()) known = std::move(buffers);
        analysis::ErrorMap map =
            compare(swept.rows[i], frame,
                    stage.truth(view, radius_m, *request.width, *request.height, *request.rays),
                    true_images.at(radius_m));
        if (!swept.rows[i].published.empty()) swept.maps.emplace_back(i, std::move(map));
        swept.rows[i].bytes = bytes_of_the_variant(frame.plan());
        plans.push_back(key_of(frame.plan()));
        plans_of_others.push_back(key_of_others(frame.plan()));
        others.try_emplace(plans_of_others.back(), OtherPasses{settings[i].choice, {}, {}});
        const double again_ms = own_ms(frame, timers.use_queries);
        frames.try_emplace(plans.back(), std::move(frame));
        watcher.image(name_of(settings[i]), again_ms);
    }
    for (int run = 0; run < *request.runs; ++run) {
        for (auto& [key, passes] : others) {
            const Frame frame = stage.render(view, passes.choice, *request.width, *request.height);
            passes.ms.push_back(others_ms(frame, timers.use_queries));
            passes.layer_ms.push_back(second_layer_ms(frame, timers.use_queries));
            for (const renderer::PassTime& time : frame.times) {
                if (renderer::is_of_the_variant(time.phase)) continue;
                passes.by_pass_ms[time.name].push_back(timers.use_queries ? time.query_milliseconds
                                                                          : time.milliseconds);
            }
        }
    }
    std::vector<RunTimes> times(settings.size());
    for (int run = 1; run < kDiscardedRuns + *request.runs; ++run) {
        for (std::size_t i = 0; i < settings.size(); ++i) {
            const auto passes = stage.render_again(view, frames.at(plans[i]), settings[i].choice);
            if (run >= kDiscardedRuns) times[i].add(passes, timers.use_queries);
            watcher.run(name_of(settings[i]));
        }
    }
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const OtherPasses& passes = others.at(plans_of_others[i]);
        times[i].put(swept.rows[i], passes.ms);
        swept.rows[i].layer_ms = analysis::summary_of(passes.layer_ms).median_ms;
        auto& house_ms = swept.house_ms.emplace_back();
        for (const auto& [name, ms] : passes.by_pass_ms) {
            house_ms[name] = analysis::summary_of(ms).median_ms;
        }
    }
    return swept;
}

}  // namespace obscura::app
