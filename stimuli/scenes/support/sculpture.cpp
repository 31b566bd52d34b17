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

class SculptureShape final : public Shape {
  public:
    explicit SculptureShape(Sculpture sculpture)
        : sculpture_(std::move(sculpture)), bounds_(sculpture_.bounds()) {}
    [[nodiscard]] float distance(const glm::vec3& p) const override {
        return sculpture_.distance(p);
    }
    [[nodiscard]] float lower_bound(const glm::vec3& p) const override {
        const glm::vec3 q = glm::max(bounds_.low - p, p - bounds_.high);
        return glm::length(glm::max(q, glm::vec3(0.0F)));
    }
    [[nodiscard]] Bounds bounds() const override { return bounds_; }

  private:
    Sculpture sculpture_;
    Bounds bounds_;
};

}  // namespace

void Sculpture::stroke(Blend blend, const std::vector<ShapePtr>& shapes,
                       const StrokeStyle& style) {
    const auto index = static_cast<std::uint32_t>(strokes_.size());
    strokes_.push_back({blend, style, style.blend_m});
    for (const ShapePtr& shape : shapes) {
        shapes_.push_back(shape);
        parts_.push_back({shape.get(), index});
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

float Sculpture::distance(const glm::vec3& point_m, std::span<const Part> parts) const {
    float result = kFar;
    for (std::size_t i = 0; i < parts.size();) {
        const std::uint32_t index = parts[i].stroke;
        float nearest = kFar;
        for (; i < parts.size() && parts[i].stroke == index; ++i) {
            nearest = std::min(nearest, parts[i].shape->distance(point_m));
        }
        const Stroke& now = strokes_[index];
        result = blended(result, nearest, now.blend, now.style.blend_m);
    }
    if (displacement_.height_m && std::abs(result) < 3.0F * displacement_.high_m + 0.01F) {
        result -= displacement_.height_m(point_m);
    }
    return result;
}

glm::vec3 Sculpture::tint(const glm::vec3& point_m, std::span<const Part> parts) const {
    float result = kFar;
    glm::vec3 colour(1.0F);
    for (std::size_t i = 0; i < parts.size();) {
        const std::uint32_t index = parts[i].stroke;
        float nearest = kFar;
        for (; i < parts.size() && parts[i].stroke == index; ++i) {
            nearest = std::min(nearest, parts[i].shape->distance(point_m));
        }
        const Stroke& now = strokes_[index];
        if (now.style.tints) {
            const float mine = now.blend == Blend::kAdd ? result - nearest
                               : now.blend == Blend::kCarve ? -nearest - result
                                                            : nearest - result;
            const float width = std::max(now.style.blend_m, 1e-4F);
            colour = glm::mix(colour, now.style.tint,
                              std::clamp(0.5F + 0.5F * mine / width, 0.0F, 1.0F));
        }
        result = blended(result, nearest, now.blend, now.style.blend_m);
    }
    return colour;
}

Bounds Sculpture::bounds() const {
    Bounds result;
    for (const Part& part : parts_) {
        if (strokes_[part.stroke].blend == Blend::kAdd) result.include(part.shape->bounds());
    }
    const float room = widest_blend_m_ + displacement_.high_m;
    return {result.low - room, result.high + room};
}

std::vector<Sculpture::Part> Sculpture::near(const glm::vec3& point_m, float radius_m,
                                             std::span<const Part> parts) const {
    std::vector<Part> result;
    const float reach = radius_m + widest_blend_m_ + 2.0F * displacement_.high_m;
    for (const Part& part : parts) {
        const Stroke& now = strokes_[part.stroke];
        if (now.blend == Blend::kKeep ||
            part.shape->lower_bound(point_m) <= reach + now.margin_m) {
            result.push_back(part);
        }
    }
    return result;
}

ShapePtr as_shape(Sculpture sculpture) {
    return std::make_shared<SculptureShape>(std::move(sculpture));
}

}  // namespace obscura::stimuli
