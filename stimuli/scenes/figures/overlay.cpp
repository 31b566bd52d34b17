// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/mesh_builder.h"

namespace obscura::stimuli::figures {
namespace {

/// A grid of values over an overlay, u across and v along; v may be a ring.
template <typename T>
class Grid {
  public:
    Grid(int columns, int rows, bool ring)
        : columns_(columns),
          rows_(rows),
          ring_(ring),
          values_(static_cast<std::size_t>(columns * rows)) {}

    [[nodiscard]] T& at(int u, int v) {
        v = ring_ ? (v + rows_) % rows_ : std::clamp(v, 0, rows_ - 1);
        u = std::clamp(u, 0, columns_ - 1);
        return values_[static_cast<std::size_t>(v * columns_ + u)];
    }

  private:
    int columns_, rows_;
    bool ring_;
    std::vector<T> values_;
};

constexpr float kFurthest_m = 0.20F;

/// What of a solid a row of beams may meet.
struct Nearby {
    const Sculpture& solid;
    std::vector<Sculpture::Part> parts;
    std::vector<ShapePtr> owners;

    Nearby(const Sculpture& whole, const Beam& first, const Beam& last) : solid(whole) {
        const glm::vec3 middle =
            0.5F * (first.from_m + last.from_m) + 0.25F * kFurthest_m * (first.way + last.way);
        const float radius_m = 0.5F * kFurthest_m + 0.5F * glm::distance(first.from_m, last.from_m);
        parts = solid.near(middle, radius_m, solid.parts());
        solid.localise(middle, radius_m, parts, owners);
    }
    [[nodiscard]] float distance(const glm::vec3& p) const {
        return parts.empty() ? kFurthest_m : solid.distance(p, parts);
    }
};

/// How far it is from `start` along `way` to the solid.
float travel_to(const Nearby& solid, const glm::vec3& start, const glm::vec3& way) {
    constexpr int kSteps = 16;
    float travel = 0.0F;
    for (int i = 0; i < kSteps; ++i) {
        const float free_m = solid.distance(start + way * travel);
        travel = std::clamp(travel + 0.85F * free_m, -0.05F, kFurthest_m);
        if (std::abs(free_m) < 0.0004F) break;
    }
    return travel;
}

}  // namespace

renderer::Mesh overlay(const Sculpture& solid, const OverlayStyle& style,
                       const std::function<Beam(float u, float v)>& beam) {
    const int columns = style.columns + 1;
    const int rows = style.ring ? style.rows : style.rows + 1;
    Grid<Beam> beams(columns, rows, style.ring);
    Grid<float> travel(columns, rows, style.ring);
    for (int v = 0; v < rows; ++v) {
        for (int u = 0; u < columns; ++u) {
            beams.at(u, v) = beam(static_cast<float>(u) / static_cast<float>(style.columns),
                                  static_cast<float>(v) / static_cast<float>(style.rows));
        }
        const Nearby nearby(solid, beams.at(0, v), beams.at(columns - 1, v));
        for (int u = 0; u < columns; ++u) {
            travel.at(u, v) = travel_to(nearby, beams.at(u, v).from_m, beams.at(u, v).way);
        }
    }
    // It bridges what is narrower than it can bend: the outermost of the neighbours, then a mean.
    for (int pass = 0; pass < 2; ++pass) {
        Grid<float> before = travel;
        for (int v = 0; v < rows; ++v) {
            for (int u = 0; u < columns; ++u) {
                float nearest = before.at(u, v);
                float sum = 0.0F;
                for (int k = -style.stiff; k <= style.stiff; ++k) {
                    nearest = std::min(nearest, before.at(u, v + k));
                    sum += before.at(u, v + k);
                }
                travel.at(u, v) =
                    pass == 0 ? nearest : sum / static_cast<float>(2 * style.stiff + 1);
            }
        }
    }
    Grid<glm::vec3> places(columns, rows, style.ring);
    for (int v = 0; v < rows; ++v) {
        for (int u = 0; u < columns; ++u) {
            places.at(u, v) = beams.at(u, v).from_m + beams.at(u, v).way * travel.at(u, v);
        }
    }
    renderer::Mesh mesh;
    const auto index = [&](int u, int v, bool top) {
        const int row = style.ring ? v % rows : v;
        return static_cast<std::uint32_t>(2 * (row * columns + u) + (top ? 0 : 1));
    };
    for (int v = 0; v < rows; ++v) {
        for (int u = 0; u < columns; ++u) {
            const glm::vec3 across = places.at(u + 1, v) - places.at(u - 1, v);
            const glm::vec3 along = places.at(u, v + 1) - places.at(u, v - 1);
            glm::vec3 out = glm::normalize(glm::cross(across, along));
            if (glm::dot(out, beams.at(u, v).way) > 0.0F) out = -out;
            const bool edge =
                u == 0 || u == columns - 1 || (!style.ring && (v == 0 || v == rows - 1));
            renderer::Vertex vertex;
            vertex.normal = out;
            vertex.color = glm::u8vec4(
                glm::clamp(style.colour * (edge ? 0.72F : 1.0F), 0.0F, 1.0F) * 255.0F + 0.5F, 255);
            vertex.position_m = places.at(u, v) + out * (style.thick_m * (edge ? 0.55F : 1.0F));
            mesh.vertices.push_back(vertex);
            vertex.position_m = places.at(u, v) - out * style.sunk_m;
            mesh.vertices.push_back(vertex);
        }
    }
    // Outside is on the side that the beams come from.
    const glm::vec3 turn =
        glm::cross(places.at(1, 0) - places.at(0, 0), places.at(0, 1) - places.at(0, 0));
    const bool flip = glm::dot(turn, beams.at(0, 0).way) > 0.0F;
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        if (flip) std::swap(b, d);
        for (const std::uint32_t i : {a, b, c, a, c, d}) mesh.indices.push_back(i);
    };
    for (int v = 0; v < style.rows; ++v) {
        for (int u = 0; u < style.columns; ++u) {
            quad(index(u, v, true), index(u + 1, v, true), index(u + 1, v + 1, true),
                 index(u, v + 1, true));
            quad(index(u, v + 1, false), index(u + 1, v + 1, false), index(u + 1, v, false),
                 index(u, v, false));
        }
        quad(index(0, v, false), index(0, v, true), index(0, v + 1, true), index(0, v + 1, false));
        quad(index(style.columns, v, true), index(style.columns, v, false),
             index(style.columns, v + 1, false), index(style.columns, v + 1, true));
    }
    for (int u = 0; u < style.columns && !style.ring; ++u) {
        quad(index(u, 0, false), index(u + 1, 0, false), index(u + 1, 0, true), index(u, 0, true));
        quad(index(u, style.rows, true), index(u + 1, style.rows, true),
             index(u + 1, style.rows, false), index(u, style.rows, false));
    }
    smooth_normals(mesh, 0.9F);
    return mesh;
}

std::function<Beam(float u, float v)> along_path(const std::vector<glm::vec3>& path_m,
                                                 const glm::vec3& way, float wide_m) {
    std::vector<Knot> knots;
    for (const glm::vec3& p : path_m) knots.push_back({p, 0.01F, 0.0F});
    const Curve curve = make_curve(knots, 12, -way);
    return [curve, way, wide_m](float u, float v) {
        const float step = v * static_cast<float>(curve.size() - 1);
        const auto i = std::min(static_cast<std::size_t>(step), curve.size() - 2);
        const glm::vec3 at =
            glm::mix(curve[i].position_m, curve[i + 1].position_m, step - static_cast<float>(i));
        const glm::vec3 across =
            glm::normalize(glm::cross(curve[i + 1].position_m - curve[i].position_m, way));
        return Beam{at + across * (wide_m * (u - 0.5F)), way};
    };
}

std::function<Beam(float u, float v)> around_body(const Placed& at, const glm::vec3& middle,
                                                  const glm::vec2& radii_m, float high_m,
                                                  float slant_m) {
    return [=](float u, float v) {
        const float angle = 2.0F * 3.14159265F * v;
        const glm::vec3 out(std::sin(angle), 0.0F, std::cos(angle));
        const glm::vec3 off(radii_m.x * out.x, high_m * (u - 0.5F) - slant_m * out.x,
                            radii_m.y * out.z);
        const glm::vec3 from = middle + off;
        return Beam{at(from.x, from.y, from.z),
                    at.axes * -glm::normalize(glm::vec3(off.x, 0.0F, off.z))};
    };
}

void add_collar(Figure& figure, const Placed& at, const Sculpture& clothes, const CollarCut& cut,
                Cloth cloth, float texture_m, const glm::vec3& colour) {
    // The neck is in the way of what falls into the opening.
    Sculpture solid = clothes;
    solid.add(round_cone(at(0.0F, cut.neck_m.y - 0.10F, cut.neck_m.z), cut.radius_m,
                         at(0.0F, cut.neck_m.y + 0.03F, cut.neck_m.z), cut.radius_m));
    const auto beam = [&](float u, float v) {
        // From one front edge round the neck to the other.
        const float t = 2.0F * v - 1.0F;
        const float angle = 3.14159265F + t * (3.14159265F - cut.open_rad);
        const glm::vec3 out(-std::sin(angle), 0.0F, std::cos(angle));
        const float front = std::pow(std::abs(t), 2.2F);
        const float wide = glm::mix(cut.wide_m, cut.point_m, front);
        // Points hang outwards and down.
        const glm::vec3 down =
            glm::normalize(glm::vec3(0.8F * out.x, -0.2F - 0.9F * front, 0.8F * out.z));
        glm::vec3 p =
            cut.neck_m + (cut.radius_m + 0.003F) * out - glm::vec3(0.0F, front * cut.drop_m, 0.0F);
        p += down * (wide * u);
        const glm::vec3 in = -glm::normalize(
            glm::vec3(0.55F * out.x, 0.8F - 0.55F * front, (0.55F + 0.6F * front) * out.z));
        const glm::vec3 from = p - in * 0.05F;
        return Beam{at(from.x, from.y, from.z), at.axes * in};
    };
    figure.overlaid.push_back(
        {"collar", cloth, texture_m,
         overlay(solid,
                 {.columns = 8, .rows = 44, .thick_m = 0.0048F, .colour = colour, .stiff = 2},
                 beam)});
}

}  // namespace obscura::stimuli::figures
