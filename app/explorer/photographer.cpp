// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/photographer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/explorer/flight.h"
#include "app/explorer/pacer.h"
#include "renderer/base/error.h"
#include "renderer/denoise/denoise.h"
#include "renderer/frame/format.h"
#include "renderer/frame/kept_shadows.h"
#include "renderer/technique/reference.h"
#include "stimuli/buffers.h"

namespace obscura::app::explorer {
namespace {

void add_own(const renderer::Frame& frame, const renderer::Recipe& recipe, Shot& shot) {
    for (const renderer::Buffer& buffer : recipe.buffers) {
        const renderer::PlannedTarget* planned = frame.plan().find(buffer.name);
        if (planned == nullptr || buffer.format.starts_with("depth")) continue;
        OwnBuffer own{buffer.name,
                      buffer.format,
                      planned->row,
                      planned->height,
                      std::max(1, planned->layers),
                      components_of(renderer::format_of(buffer.format)) / buffer.columns,
                      {}};
        own.values = frame.read_components(buffer.name, own.channels);
        shot.own.push_back(std::move(own));
    }
}

}  // namespace

void Photographer::load(const ShotRequest& request) {
    if (scene_ != request.scene) {
        whole_ = {};
        coarse_ = {};
        scene_ = request.scene;
        whole_.gpu = std::make_unique<renderer::GpuScene>(*scene_->opened().scene);
        light_key_.clear();
        ready_key_.clear();
    }
    const stimuli::StudyScene& wanted = request.choices.scene;
    const std::string key =
        fmt::format("{} {}", to_string(wanted.validity), stimuli::to_json(wanted.settings));
    if (key == light_key_) return;
    whole_.known = {};
    coarse_.known = {};
    light_key_.clear();
    const stimuli::OpenedScene& opened = scene_->opened();
    lighting_ =
        opened.with_probes(stimuli::with_settings(opened.lighting(wanted.validity), wanted.validity,
                                                  wanted.settings, request.choices.folder));
    light_key_ = key;
}

Photographer::Stage& Photographer::stage_for(const ShotRequest& request) {
    const CoarseScene* coarse =
        software_ && request.quality == Quality::kMoving ? scene_->coarse() : nullptr;
    if (coarse == nullptr) return whole_;
    if (!coarse_.gpu) {
        coarse_.gpu = std::make_unique<renderer::GpuScene>(coarse->scene, *whole_.gpu);
    }
    return coarse_;
}

void Photographer::forget_other_views(Stage& stage, const ShotRequest& request,
                                      const renderer::FrameOptions& options, int width,
                                      int height) const {
    const std::string key = fmt::format("{}x{} {} {} {}", width, height, options.supersampling,
                                        options.all_buffers, options.occluding_opacity.value_or(0));
    if (request.afresh) {
        stage.known = {};
    } else if (key != stage.known_key || !same_view(request.camera, stage.known_camera)) {
        stage.known = renderer::shadows_of(stage.known);
    }
    stage.known_key = key;
    stage.known_camera = request.camera;
}

Shot Photographer::take(const ShotRequest& request, char side,
                        const std::function<bool()>& wanted) {
    const auto began = std::chrono::steady_clock::now();
    load(request);
    const Choices& choices = request.choices;
    const bool fine = request.quality == Quality::kFine;
    renderer::FrameOptions options;
    options.supersampling = fine ? choices.supersampling : 1;
    options.occluding_opacity = choices.occluding_opacity;
    // With the same buffers for every technique, what one image computed serves the next.
    options.all_buffers = !fine;
    const int width = std::max(1, choices.width / request.divisor);
    const int height = std::max(1, choices.height / request.divisor);
    Stage& stage = stage_for(request);
    forget_other_views(stage, request, options, width, height);
    const auto trace = [&](const renderer::Camera& camera, int image_width, int image_height,
                           const renderer::Variant& choice) {
        const auto go_on = [&](double /*share*/) { return wanted(); };
        try {
            return scene_->rays()
                .trace(camera, image_width, image_height, renderer::reference_options(choice),
                       go_on)
                .accessibility;
        } catch (const base::Error&) {
            if (!wanted()) throw renderer::Stopped();
            throw;
        }
    };
    const renderer::Variant& variant = choices.side(side);
    const auto rays = [this]() -> const renderer::ReferenceScene& { return scene_->rays(); };
    renderer::View view{*stage.gpu, lighting_, request.camera, options, trace, rays};
    // Of an image that no better one takes passes over from, nobody is told what they took.
    view.timed = !(software_ && request.quality == Quality::kMoving &&
                   (&stage == &coarse_ || request.divisor > 1));
    if (software_ && request.quality != Quality::kMoving) view.go_on = wanted;
    const renderer::Frame frame = renderer_.render(view, variant, width, height, stage.known);
    renderer::ViewBuffers buffers = frame.view_buffers();
    // What took over everything may hold less than what it took it from.
    if (frame.taken_over().size() < buffers.times.size()) stage.known = std::move(buffers);
    Shot shot;
    shot.look = request.look;
    shot.quality = request.quality;
    shot.side = side;
    shot.variant = variant;
    shot.width = width;
    shot.height = height;
    shot.divisor = request.divisor;
    shot.coarse = &stage == &coarse_;
    shot.supersampling = options.supersampling;
    shot.rgb = frame.read_display();
    if (view.go_on && !wanted()) throw renderer::Stopped();
    if (request.buffers) {
        shot.buffers = stimuli::buffers_of(frame, lighting_);
        if (frame.plan().find(renderer::Target::kEmission) != nullptr) {
            shot.emission = frame.read_components(renderer::Target::kEmission, 3);
        }
        if (const renderer::Technique* technique = renderer::find_technique(variant.technique);
            technique != nullptr && technique->recipe != nullptr) {
            add_own(frame, technique->recipe(variant), shot);
        }
        if (const renderer::Denoise* denoise = renderer::find_denoise(variant.denoise)) {
            add_own(frame, denoise->recipe, shot);
        }
    }
    shot.times = renderer::by_name(frame.times);
    shot.buffers_planned = frame.plan().targets;
    shot.bytes = frame.plan().bytes();
    shot.left_out = frame.plan().left_out;
    shot.fetches = renderer::fetches_per_pixel(variant);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - began;
    shot.milliseconds = spent.count();
    return shot;
}

void Photographer::get_ready_to_move(const ShotRequest& request,
                                     const std::function<bool()>& wanted) {
    if (!software_ || scene_ != request.scene || scene_->coarse() == nullptr) return;
    const Choices& choices = request.choices;
    const std::string key = fmt::format("{} {} {}", light_key_, choices.side('a').in_words(),
                                        choices.side('b').in_words());
    if (key == ready_key_) return;
    ShotRequest moving = request;
    moving.quality = Quality::kMoving;
    moving.divisor = Pacer::kDivisors.back();
    moving.buffers = false;
    moving.afresh = false;
    for (const char side : {'a', 'b'}) {
        if (!wanted()) return;
        const renderer::Technique* technique =
            renderer::find_technique(choices.side(side).technique);
        if (technique != nullptr && !technique->ray_traced) (void)take(moving, side, wanted);
    }
    ready_key_ = key;
}

}  // namespace obscura::app::explorer
