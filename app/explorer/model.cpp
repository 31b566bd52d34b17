// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/explorer/flight.h"
#include "app/explorer/picture.h"
#include "app/explorer/sane_choices.h"
#include "stimuli/scenes/builtin_scene.h"

namespace obscura::app::explorer {
namespace {

/// An image in motion may take that long: 15 a second, with time for the window itself.
constexpr double kLongest_ms = 55.0;
/// An image that takes longer than this is given up for a newer one.
constexpr double kPatience_s = 0.5;
constexpr std::size_t kMostTimes = 60;

[[nodiscard]] std::size_t index_of(Quality quality) { return static_cast<std::size_t>(quality); }

}  // namespace

bool Visit::operator==(const Visit& other) const {
    return name == other.name && same_view(camera, other.camera);
}

Model::Model(Choices first, bool software)
    : history_(sane(std::move(first), Choices{})),
      pacers_{Pacer(kLongest_ms, !software), Pacer(kLongest_ms, !software)} {}

float Model::aspect() const {
    return static_cast<float>(choices().width) / static_cast<float>(choices().height);
}

void Model::set_software(bool software) {
    pacers_ = {Pacer(kLongest_ms, !software), Pacer(kLongest_ms, !software)};
}

void Model::moved(Motion motion, double now_s) {
    ++look_;
    motion_ = motion;
    changed_s_ = now_s;
    timings_left_ = 0;
}

void Model::change(const std::function<void(Choices&)>& edit, const std::string& name,
                   double now_s) {
    Choices next = choices();
    edit(next);
    next = sane(std::move(next), choices());
    if (scene_) next = with_light_there_is(std::move(next), scene_->opened());
    if (next == choices()) return;
    history_.change(std::move(next), name);
    moved(Motion::kSettings, now_s);
}

void Model::undo(double now_s) {
    if (!can_undo()) return;
    history_.go_back();
    wants_scene_ = !same_source(choices(), loaded_);
    moved(Motion::kSettings, now_s);
}

void Model::redo(double now_s) {
    if (!can_redo()) return;
    history_.go_forward();
    wants_scene_ = !same_source(choices(), loaded_);
    moved(Motion::kSettings, now_s);
}

void Model::look_from(const renderer::Camera& camera, double now_s) {
    if (same_view(camera, view_.camera)) return;
    view_ = {camera, ""};
    moved(Motion::kCamera, now_s);
}

void Model::look_from(const std::string& camera_name, double now_s) {
    for (const NamedCamera& one : cameras()) {
        if (one.name != camera_name) continue;
        view_ = {one.camera, one.of_scene ? one.name : ""};
        moved(Motion::kCamera, now_s);
        visit();
        return;
    }
}

std::vector<Model::NamedCamera> Model::cameras() const {
    std::vector<NamedCamera> all;
    if (!scene_) return all;
    for (const renderer::Camera& camera : scene_->opened().scene->cameras) {
        all.push_back({camera.name, camera, true});
    }
    if (!study_) return all;
    for (const stimuli::StudyScene& scene : study_->study.scenes) {
        Choices there = choices();
        there.scene = scene;
        if (stimuli::find_builtin_scene(scene.source) == nullptr) {
            there.folder = study_->study.folder;
        }
        if (!scene.settings.camera || !same_source(there, choices())) continue;
        all.push_back({"study: " + scene.id, *scene.settings.camera, false});
    }
    return all;
}

void Model::visit() {
    if (scene_) visits_.change(view_, "");
}

void Model::back(double now_s) {
    visit();
    if (!visits_.can_go_back()) return;
    visits_.go_back();
    view_ = visits_.now();
    moved(Motion::kCamera, now_s);
}

void Model::forward(double now_s) {
    if (!visits_.can_go_forward()) return;
    visits_.go_forward();
    view_ = visits_.now();
    moved(Motion::kCamera, now_s);
}

void Model::set_layout(const Layout& layout, double now_s) {
    const std::string sides_before = visible_sides();
    const bool buffers_before = shows_buffers();
    layout_ = layout.sane();
    // What was not drawn while nothing showed it is drawn now.
    if (visible_sides() != sides_before || shows_buffers() != buffers_before) {
        moved(Motion::kSettings, now_s);
    }
}

void Model::set_region(const std::optional<Region>& region) {
    region_ = region ? within(*region, choices().width, choices().height) : std::nullopt;
}

std::optional<Choices> Model::take_wanted_scene() {
    if (!std::exchange(wants_scene_, false)) return std::nullopt;
    return choices();
}

void Model::opened(Opened opening, double now_s) {
    if (!opening.scene) {
        // Back to the scene that there is, where an undo wanted another.
        if (scene_ && !same_source(choices(), loaded_)) history_.change(loaded_, "");
        return;
    }
    const bool first = scene_ == nullptr;
    scene_ = std::move(opening.scene);
    loaded_ = with_light_there_is(sane(opening.choices, choices()), scene_->opened());
    if (first) {
        history_ = History<Choices>(loaded_);
    } else {
        history_.change(loaded_, "");
    }
    image_.clear();
    buffers_.clear();
    truth_.reset();
    region_.reset();
    for (Pacer& one : pacers_) one.forget();
    if (!opening.keeps_camera || first) {
        const renderer::Camera* named = scene_->opened().scene->find_camera(opening.camera);
        const renderer::Camera& camera =
            named != nullptr ? *named : scene_->opened().scene->cameras.front();
        view_ = {camera, camera.name};
    }
    if (first) {
        visits_ = History<Visit>(view_);
    } else {
        visit();
    }
    moved(Motion::kCamera, now_s);
}

std::string Model::visible_sides() const {
    std::string sides;
    for (const char side : {'a', 'b'}) {
        const auto panes = layout_.ever_visible();
        if (std::any_of(panes.begin(), panes.end(),
                        [side](const Pane& pane) { return pane.side == side; })) {
            sides += side;
        }
    }
    return sides;
}

bool Model::shows_buffers() const {
    const auto panes = layout_.ever_visible();
    return std::any_of(panes.begin(), panes.end(), [](const Pane& pane) {
        return needs_buffers(pane.layer) && !needs_truth(pane.layer);
    });
}

Quality Model::finest() const {
    return choices().supersampling > 1 ? Quality::kFine : Quality::kStill;
}

ShotRequest Model::request_of(Quality quality, int divisor) const {
    ShotRequest request;
    request.look = look_;
    request.quality = quality;
    request.scene = scene_;
    request.camera = view_.camera;
    request.choices = choices();
    request.divisor = divisor;
    request.buffers =
        quality == Quality::kStill || (quality == Quality::kMoving && shows_buffers());
    request.sides = quality == Quality::kStill ? "ab" : visible_sides();
    return request;
}

std::optional<Model::Wanted> Model::next_request(double now_s, bool busy) {
    if (!scene_ || !same_source(choices(), loaded_)) return std::nullopt;
    const auto asked = [&](Quality quality) { return asked_[index_of(quality)] == look_; };
    const auto ask = [&](Quality quality, int divisor) {
        asked_[index_of(quality)] = look_;
        asked_last_ = quality;
        asked_s_ = now_s;
        return Wanted{request_of(quality, divisor), busy};
    };
    if (!asked(Quality::kMoving)) {
        const bool patient = asked_last_ == Quality::kMoving && now_s - asked_s_ < kPatience_s;
        if (busy && patient) return std::nullopt;
        Wanted wanted = ask(Quality::kMoving, divisor());
        moving_sides_ = wanted.request.sides;
        moving_ms_ = 0.0;
        return wanted;
    }
    if (busy || moving(now_s)) return std::nullopt;
    if (!asked(Quality::kStill)) return ask(Quality::kStill, 1);
    if (finest() == Quality::kFine && !asked(Quality::kFine)) {
        if (now_s - changed_s_ < kFine_s) return std::nullopt;
        return ask(Quality::kFine, 1);
    }
    if (timings_left_ > 0) {
        --timings_left_;
        Wanted wanted = ask(finest(), 1);
        wanted.request.afresh = true;
        wanted.request.sides = "ab";
        return wanted;
    }
    return std::nullopt;
}

void Model::rendered(Shot shot, double now_s) {
    (void)now_s;
    if (shot.quality == Quality::kMoving) {
        moving_ms_ += shot.milliseconds;
        std::erase(moving_sides_, shot.side);
        if (moving_sides_.empty()) pacer().took(shot.divisor, moving_ms_);
    }
    if (shot.quality == finest() && shot.look == look_) note_cost(shot);
    auto kept = std::make_shared<const Shot>(std::move(shot));
    std::shared_ptr<const Shot>& image = image_[kept->side];
    const bool newer = !image || kept->look > image->look;
    if (newer || (kept->look == image->look && kept->quality >= image->quality)) image = kept;
    std::shared_ptr<const Shot>& buffers = buffers_[kept->side];
    if (!kept->buffers.channels.empty() && (!buffers || kept->look >= buffers->look)) {
        buffers = kept;
    }
}

std::shared_ptr<const Shot> Model::image(char side) const {
    const auto found = image_.find(side);
    return found != image_.end() ? found->second : nullptr;
}

std::shared_ptr<const Shot> Model::buffers(char side) const {
    const auto found = buffers_.find(side);
    const bool fits = found != buffers_.end() && found->second && found->second->look == look_;
    return fits ? found->second : nullptr;
}

void Model::note_cost(const Shot& shot) {
    const std::string of = fmt::format("{} {}x{} {}", shot.variant.in_words(), shot.width,
                                       shot.height, shot.supersampling);
    auto& times = times_[shot.side];
    if (times_of_[shot.side] != of) times.clear();
    times_of_[shot.side] = of;
    times.push_back(shot.times);
    if (times.size() > kMostTimes) times.erase(times.begin());
}

std::vector<Model::PassCost> Model::costs(char side) const {
    std::vector<PassCost> costs;
    const auto found = times_.find(side);
    if (found == times_.end() || found->second.empty()) return costs;
    for (const renderer::PassTime& pass : found->second.back()) {
        PassCost cost;
        cost.name = pass.name;
        for (const auto& one : found->second) {
            for (const renderer::PassTime& time : one) {
                if (time.name != pass.name) continue;
                cost.history_ms.push_back(static_cast<float>(time.milliseconds));
            }
        }
        std::vector<float> sorted = cost.history_ms;
        std::sort(sorted.begin(), sorted.end());
        const std::size_t middle = sorted.size() / 2;
        cost.median_ms =
            sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
        costs.push_back(std::move(cost));
    }
    return costs;
}

std::string Model::truth_key() const {
    const renderer::Camera& c = view_.camera;
    const auto vector = [](const glm::vec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
    return fmt::format("{} {}; {}; {}; {} {} {} {} {}; {}x{} {}", fmt::ptr(scene_.get()),
                       vector(c.position_m), vector(c.target_m), vector(c.up), c.vertical_fov_rad,
                       c.near_m, c.far_m, c.lens_shift.x, c.lens_shift.y, choices().width,
                       choices().height, explorer::truth_radius_m(choices()));
}

std::optional<TruthRequest> Model::next_truth(double now_s) {
    if (!scene_ || moving(now_s) || !same_source(choices(), loaded_)) return std::nullopt;
    if (asked_[index_of(finest())] != look_) return std::nullopt;  // images come first
    std::string key = truth_key();
    if (key == truth_key_) return std::nullopt;
    truth_key_ = std::move(key);
    truth_.reset();
    TruthRequest request;
    request.look = ++truth_look_;
    request.scene = scene_;
    request.camera = view_.camera;
    request.width = choices().width;
    request.height = choices().height;
    request.radius_m = explorer::truth_radius_m(choices());
    return request;
}

bool Model::truth_waits(double now_s, bool rendering) const {
    return rendering || moving(now_s) || timings_left_ > 0;
}

}  // namespace obscura::app::explorer
