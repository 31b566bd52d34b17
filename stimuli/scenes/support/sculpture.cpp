// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "stimuli/scenes/support/implicit_surface.h"

namespace obscura::stimuli {
namespace {

constexpr float kFar = 1e6F;

/// Polynomial smooth minimum: exactly min(a, b) where |a - b| >= k.
float smooth_min(float a, float b, float k) {
    const float lower = std::min(a, b);
    const float overlap = k - std::abs(a - b);
    return k > 0.0F && overlap > 0.0F ? lower - overlap * overlap / (4.0F * k) : lower;
}

float blended(float so_far, float stroke, Blend blend, float k) {
    switch (blend) {
        case Blend::kAdd:
            return smooth_min(so_far, stroke, k);
        case Blend::kCarve:
            return -smooth_min(-so_far, stroke, k);
        case Blend::kKeep:
            return -smooth_min(-so_far, -stroke, k);
    }
    return so_far;
}

/// What of a sculpture is near a place.
class NearbyShape final : public Shape {
  public:
    NearbyShape(const Sculpture& sculpture, const ShapeBounds& bounds, const glm::vec3& point_m,
                float radius_m)
        : sculpture_(sculpture),
          bounds_(bounds),
          parts_(sculpture.near(point_m, radius_m, sculpture.parts())) {
        sculpture.localise(point_m, radius_m, parts_, owners_);
    }
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        return sculpture_.distance(p, parts_);
    }
    [[nodiscard]] float distance_below(const glm::vec3& p, float limit) const override {
        return sculpture_.distance_below(p, limit, parts_);
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override {
        const glm::vec3 q = glm::max(bounds_.low - p, p - bounds_.high);
        return glm::length(glm::max(q, glm::vec3(0.0F)));
    }
    [[nodiscard]] ShapeBounds bounds() const override { return bounds_; }

  private:
    const Sculpture& sculpture_;
    ShapeBounds bounds_;
    std::vector<Sculpture::Part> parts_;
    std::vector<ShapePtr> owners_;
};

class SculptureShape final : public Shape {
  public:
    explicit SculptureShape(Sculpture sculpture)
        : sculpture_(std::move(sculpture)), bounds_(sculpture_.bounds()) {}
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        return sculpture_.distance(p);
    }
    [[nodiscard]] float distance_below(const glm::vec3& p, float limit) const override {
        return sculpture_.distance_below(p, limit, sculpture_.parts());
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override {
        const glm::vec3 q = glm::max(bounds_.low - p, p - bounds_.high);
        return glm::length(glm::max(q, glm::vec3(0.0F)));
    }
    [[nodiscard]] ShapeBounds bounds() const override { return bounds_; }
    [[nodiscard]] ShapePtr restricted(const glm::vec3& point_m, float radius_m) const override {
        return std::make_shared<NearbyShape>(sculpture_, bounds_, point_m, radius_m);
    }

  private:
    Sculpture sculpture_;
    ShapeBounds bounds_;
};

}  // namespace

void Sculpture::stroke(Blend blend, const std::vector<ShapePtr>& shapes, const StrokeStyle& style) {
    const auto index = static_cast<std::uint32_t>(strokes_.size());
    strokes_.push_back({blend, style, style.blend_m});
    for (const ShapePtr& shape : shapes) {
        shapes_.push_back(shape);
        const ShapeBounds box = shape->bounds();
        parts_.push_back({shape.get(), index, 0.5F * (box.low + box.high),
                          0.5F * glm::length(box.high - box.low), shape->relief_high()});
    }
    for (Stroke& earlier : strokes_) {
        if (&earlier == &strokes_.back()) break;
        earlier.margin_m = std::max(earlier.margin_m, earlier.style.blend_m + style.blend_m);
    }
    widest_blend_m_ = std::max(widest_blend_m_, style.blend_m);
}

void Sculpture::add(ShapePtr shape, const StrokeStyle& style) {
    stroke(Blend::kAdd, {std::move(shape)}, style);
}
void Sculpture::add(const std::vector<ShapePtr>& shapes, const StrokeStyle& style) {
    stroke(Blend::kAdd, shapes, style);
}
void Sculpture::carve(ShapePtr shape, const StrokeStyle& style) {
    stroke(Blend::kCarve, {std::move(shape)}, style);
}
void Sculpture::carve(const std::vector<ShapePtr>& shapes, const StrokeStyle& style) {
    stroke(Blend::kCarve, shapes, style);
}
void Sculpture::keep(ShapePtr shape, const StrokeStyle& style) {
    stroke(Blend::kKeep, {std::move(shape)}, style);
}
void Sculpture::displace(Displacement displacement) { displacement_ = std::move(displacement); }

float Sculpture::distance(const glm::vec3& point_m) const { return distance(point_m, parts_); }

float Sculpture::stroke_distance(const glm::vec3& point_m, std::span<const Part> parts,
                                 std::size_t& i, float limit_m) {
    const std::uint32_t stroke = parts[i].stroke;
    float nearest = limit_m;
    const Shape* shape = nullptr;
    for (; i < parts.size() && parts[i].stroke == stroke; ++i) {
        const Part& part = parts[i];
        // What is raised may still be nearest, as long as no other shape has been met.
        const float limit = shape == nullptr ? nearest + part.relief_high_m : nearest;
        const glm::vec3 away = point_m - part.centre_m;
        const float reach = limit + part.radius_m;
        if (reach <= 0.0F || glm::dot(away, away) > reach * reach) continue;
        const float d = part.shape->distance_below(point_m, limit);
        if (d < limit) {
            nearest = d;
            shape = part.shape;
        }
    }
    if (shape == nullptr) return limit_m;
    const float high = shape->relief_high();
    if (high > 0.0F && std::abs(nearest) < 2.5F * high) nearest -= shape->relief(point_m);
    return nearest;
}

float Sculpture::limit_of(const Stroke& now, float so_far) const {
    const float k = now.style.blend_m;
    switch (now.blend) {
        case Blend::kAdd:
            return so_far + k;
        case Blend::kCarve:
            return k - so_far;
        case Blend::kKeep:
            return kFar;
    }
    return kFar;
}

float Sculpture::undisplaced(const glm::vec3& point_m, std::span<const Part> parts) const {
    float result = kFar;
    for (std::size_t i = 0; i < parts.size();) {
        const Stroke& now = strokes_[parts[i].stroke];
        const float limit = limit_of(now, result);
        const float nearest = stroke_distance(point_m, parts, i, limit);
        if (nearest >= limit && now.blend != Blend::kKeep) continue;  // too far off to change it
        result = blended(result, nearest, now.blend, now.style.blend_m);
    }
    return result;
}

float Sculpture::distance(const glm::vec3& point_m, std::span<const Part> parts) const {
    const float result = undisplaced(point_m, parts);
    if (!displacement_.height_m || std::abs(result) > 2.0F * displacement_.high_m) return result;
    return result - displacement_.height_m(point_m);
}

float Sculpture::distance_below(const glm::vec3& point_m, float limit_m,
                                std::span<const Part> parts) const {
    const float result = undisplaced(point_m, parts);
    if (!displacement_.height_m || std::abs(result) > 2.0F * displacement_.high_m ||
        result - displacement_.high_m >= limit_m) {
        return result;
    }
    return result - displacement_.height_m(point_m);
}

glm::vec3 Sculpture::tint(const glm::vec3& point_m, std::span<const Part> parts) const {
    // Where all strokes are of one colour nothing needs to be measured: most of a cloth is.
    const StrokeStyle* only = nullptr;
    bool one = true;
    for (const Part& part : parts) {
        const StrokeStyle& style = strokes_[part.stroke].style;
        if (!style.tints) continue;
        one = one && (only == nullptr || only->tint == style.tint);
        only = &style;
    }
    if (one && only != nullptr && strokes_[parts.front().stroke].style.tints) return only->tint;
    float result = kFar;
    glm::vec3 colour(1.0F);
    for (std::size_t i = 0; i < parts.size();) {
        const Stroke& now = strokes_[parts[i].stroke];
        const float width = std::max(now.style.blend_m, 1e-4F);
        const float nearest = stroke_distance(point_m, parts, i, limit_of(now, result) + 1e-4F);
        if (now.style.tints) {
            const float mine = now.blend == Blend::kAdd     ? result - nearest
                               : now.blend == Blend::kCarve ? -nearest - result
                                                            : nearest - result;
            colour = glm::mix(colour, now.style.tint,
                              std::clamp(0.5F + 0.5F * mine / width, 0.0F, 1.0F));
        }
        result = blended(result, nearest, now.blend, now.style.blend_m);
    }
    return colour;
}

ShapeBounds Sculpture::bounds() const {
    ShapeBounds result;
    for (const Part& part : parts_) {
        if (strokes_[part.stroke].blend == Blend::kAdd) result.include(part.shape->bounds());
    }
    const float room = widest_blend_m_ + displacement_.high_m;
    result = {result.low - room, result.high + room};
    for (const Part& part : parts_) {
        if (strokes_[part.stroke].blend != Blend::kKeep) continue;
        const ShapeBounds kept = part.shape->bounds();
        result.low = glm::max(result.low, kept.low - displacement_.high_m);
        result.high = glm::min(result.high, kept.high + displacement_.high_m);
    }
    return result;
}

float Sculpture::relief_high(std::span<const Part> parts) const {
    float high = 0.0F;
    for (const Part& part : parts) high = std::max(high, part.relief_high_m);
    return high + displacement_.high_m;
}

std::vector<Sculpture::Part> Sculpture::near(const glm::vec3& point_m, float radius_m,
                                             std::span<const Part> parts) const {
    std::vector<Part> result;
    const float reach = radius_m + 2.0F * displacement_.high_m;
    bool solid = false;
    // From the last stroke to the first: how far a stroke reaches depends on how widely those that
    // come after it and matter here are blended in.
    float later_m = 0.0F;
    for (std::size_t end = parts.size(); end > 0;) {
        const std::uint32_t stroke = parts[end - 1].stroke;
        const Stroke& now = strokes_[stroke];
        const float limit = reach + now.style.blend_m + later_m;
        const bool keep = now.blend == Blend::kKeep;
        const std::size_t before = result.size();
        for (; end > 0 && parts[end - 1].stroke == stroke; --end) {
            const Part& part = parts[end - 1];
            if (!keep && glm::length(point_m - part.centre_m) > limit + part.radius_m) continue;
            if (!keep && part.shape->lower_bound(point_m) > limit) continue;
            result.push_back(part);
        }
        if (result.size() == before) continue;
        solid = solid || now.blend == Blend::kAdd;
        later_m = std::max(later_m, now.style.blend_m);
    }
    if (!solid) result.clear();  // nothing here that could be carved or kept
    std::reverse(result.begin(), result.end());
    return result;
}

void Sculpture::localise(const glm::vec3& point_m, float radius_m, std::vector<Part>& parts,
                         std::vector<ShapePtr>& owners) const {
    for (Part& part : parts) {
        const float reach = radius_m + 2.0F * displacement_.high_m + strokes_[part.stroke].margin_m;
        if (ShapePtr nearby = part.shape->restricted(point_m, reach)) {
            part.shape = nearby.get();
            owners.push_back(std::move(nearby));
        }
    }
}

ShapePtr as_shape(Sculpture sculpture) {
    return std::make_shared<SculptureShape>(std::move(sculpture));
}

}  // namespace obscura::stimuli
