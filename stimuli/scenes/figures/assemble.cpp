// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/mesh_builder.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli::figures {
namespace {

constexpr float kReach_m = 0.036F;  ///< how far the painted occlusion looks

/// Distance to the nearest of several sculptures, nearly exact within kReach_m of them: a grid
/// whose cells know which parts are near.
class NearField {
  public:
    explicit NearField(const Figure& figure) : figure_(figure) {
        ShapeBounds bounds;
        for (const FigurePart& part : figure.parts) {
            bounds_.push_back(part.solid.bounds());
            bounds.include(bounds_.back());
        }
        low_ = bounds.low - kReach_m;
        size_ = glm::ivec3((bounds.high - bounds.low + 2.0F * kReach_m) / kCell_m) + 1;
        cells_.resize(static_cast<std::size_t>(size_.x * size_.y * size_.z));
        owners_.resize(static_cast<std::size_t>(size_.z));
        for_each_row(size_.z, [this](int z) {
            for (int y = 0; y < size_.y; ++y) {
                for (int x = 0; x < size_.x; ++x) fill({x, y, z});
            }
        });
    }

    [[nodiscard]] float distance(const glm::vec3& p) const {
        const glm::vec3 q = (p - low_) / kCell_m;
        const glm::ivec3 cell = glm::clamp(glm::ivec3(q), glm::ivec3(0), size_ - 1);
        const glm::vec3 centre = low_ + (glm::vec3(cell) + 0.5F) * kCell_m;
        const float away = kSteepest * glm::distance(p, centre);
        float nearest = kReach_m;
        for (const Near& near : cells_[index(cell)]) {
            if (near.at_centre_m - away >= nearest) break;  // so are all after it
            nearest = std::min(nearest, near.sculpture->distance(p, near.parts));
        }
        return nearest;
    }

  private:
    static constexpr float kCell_m = 0.04F;
    static constexpr float kSteepest = 1.25F;  ///< fastest that a sculpture's field grows
    /// What of a sculpture is near a cell.
    struct Near {
        const Sculpture* sculpture = nullptr;
        std::vector<Sculpture::Part> parts;
        float at_centre_m = 0.0F;  ///< distance from the cell's centre, at least
    };

    [[nodiscard]] std::size_t index(const glm::ivec3& cell) const {
        return static_cast<std::size_t>((cell.z * size_.y + cell.y) * size_.x + cell.x);
    }
    void fill(const glm::ivec3& cell) {
        const glm::vec3 centre = low_ + (glm::vec3(cell) + 0.5F) * kCell_m;
        constexpr float kReachOfCell_m = 0.9F * kCell_m + kReach_m;
        for (std::size_t i = 0; i < figure_.parts.size(); ++i) {
            const FigurePart& part = figure_.parts[i];
            const glm::vec3 off = glm::max(bounds_[i].low - centre, centre - bounds_[i].high);
            if (std::max({off.x, off.y, off.z}) > kReachOfCell_m) continue;
            auto near = part.solid.near(centre, kReachOfCell_m, part.solid.parts());
            part.solid.localise(centre, kReachOfCell_m, near,
                                owners_[static_cast<std::size_t>(cell.z)]);
            if (near.empty()) continue;
            const float at_centre_m =
                part.solid.distance(centre, near) - part.solid.relief_high(near);
            cells_[index(cell)].push_back({&part.solid, std::move(near), at_centre_m});
        }
        std::stable_sort(
            cells_[index(cell)].begin(), cells_[index(cell)].end(),
            [](const Near& a, const Near& b) { return a.at_centre_m < b.at_centre_m; });
    }

    const Figure& figure_;
    std::vector<ShapeBounds> bounds_;  ///< of its parts
    glm::vec3 low_{0.0F};
    glm::ivec3 size_{0};
    std::vector<std::vector<Near>> cells_;
    std::vector<std::vector<ShapePtr>> owners_;  ///< by z
};

/// How much of the space just above the surface is taken, [0, 1]: where the field grows slower
/// than the height above the surface, something else is near.
float occlusion_at(const NearField& field, const glm::vec3& p, const glm::vec3& normal) {
    constexpr std::array kHeights_m{0.035F, 0.009F};
    constexpr std::array kWeights{0.42F, 0.58F};
    float sum = 0.0F;
    for (std::size_t i = 0; i < kHeights_m.size(); ++i) {
        const float free_m = field.distance(p + normal * kHeights_m[i]);
        // A free ball that touches the surface holds the smaller ones, which are free too.
        if (i == 0 && free_m >= 0.999F * kHeights_m[0]) return 0.0F;
        sum += kWeights[i] * std::clamp(1.0F - free_m / kHeights_m[i], 0.0F, 1.0F);
    }
    return sum;
}

/// An eyeball with a cornea's bulge left out: white, iris and pupil are painted on its rings.
renderer::Mesh eyeball(const Eye& eye) {
    constexpr int kRings = 18;
    std::vector<glm::vec2> profile;
    for (int i = 0; i <= kRings; ++i) {
        // Rings crowd at the front pole, where the iris is.
        const float t = static_cast<float>(i) / kRings;
        const float angle = 3.1415926F * (1.0F - t * (1.5F - 0.5F * t));
        profile.emplace_back(i == 0 || i == kRings ? 0.0F : eye.radius_m * std::sin(angle),
                             -eye.radius_m * std::cos(3.1415926F - angle));
    }
    renderer::Mesh whole;
    Placement placement;
    const glm::mat3 axes = axes_from(eye.gaze, glm::vec3(0.0F, 1.0F, 0.0F));
    // The ball's pole (+Y) becomes the gaze.
    placement.transform = glm::mat4(glm::vec4(axes[0], 0.0F), glm::vec4(axes[2], 0.0F),
                                    glm::vec4(-axes[1], 0.0F), glm::vec4(eye.centre_m, 1.0F));
    append(whole, revolve(profile, 22), placement);
    paint(whole, [&](const glm::vec3& p, const glm::vec3&) {
        const glm::vec3 way = glm::normalize(p - eye.centre_m);
        const float off = std::acos(std::clamp(glm::dot(way, eye.gaze), -1.0F, 1.0F));
        const float iris = std::clamp((0.50F - off) / 0.05F, 0.0F, 1.0F);
        const float pupil = std::clamp((0.20F - off) / 0.04F, 0.0F, 1.0F);
        const float rim = std::clamp((off - 0.36F) / 0.12F, 0.0F, 1.0F);
        const float lid_shade = std::clamp(0.68F - 1.1F * way.y, 0.30F, 1.0F);
        glm::vec3 colour =
            glm::mix(glm::vec3(0.50F, 0.46F, 0.43F), eye.iris * (1.0F - 0.6F * rim), iris);
        return glm::mix(colour, glm::vec3(0.01F), pupil) * lid_shade;
    });
    return whole;
}

renderer::Mesh card_of(const Wisp& wisp) {
    PatchOptions options;
    options.columns = 2;
    options.rows = static_cast<int>(wisp.path_m.size()) - 1;
    const auto row_of = [&](float v) {
        return std::min(static_cast<std::size_t>(v * static_cast<float>(options.rows)),
                        wisp.path_m.size() - 2);
    };
    renderer::Mesh card = patch(options, [&](float u, float v) {
        const auto i = row_of(v);
        const float t = v * static_cast<float>(options.rows) - static_cast<float>(i);
        const glm::vec3 at = glm::mix(wisp.path_m[i], wisp.path_m[i + 1], t);
        const glm::vec3 way =
            wisp.path_m[std::min(i + 2, wisp.path_m.size() - 1)] - wisp.path_m[i == 0 ? 0 : i - 1];
        const glm::vec3 out = glm::normalize(at - wisp.inside_m);
        const glm::vec3 across = glm::normalize(glm::cross(way, out));
        // Bent a little over what it lies on.
        const float off = 2.0F * std::abs(u - 0.5F);
        return at + across * (wisp.width_m * (u - 0.5F)) - out * (0.10F * wisp.width_m * off * off);
    });
    for (renderer::Vertex& vertex : card.vertices) {
        // As smooth as what it is part of, a little rounder.
        const glm::vec3 out = glm::normalize(vertex.position_m - wisp.inside_m);
        vertex.normal = glm::normalize(glm::mix(vertex.normal, out, 0.6F));
        const float shade = glm::mix(wisp.root_shade, 1.0F, std::min(1.0F, 1.6F * vertex.uv.y));
        vertex.color =
            glm::u8vec4(glm::clamp(wisp.colour * shade, 0.0F, 1.0F) * 255.0F + 0.5F, 255);
        vertex.uv.x = (static_cast<float>(wisp.strip) + 0.02F + 0.96F * vertex.uv.x) / 4.0F;
        vertex.uv.y = 0.004F + 0.992F * vertex.uv.y;
    }
    turn_normals_outwards(card);
    make_tangents(card);
    return card;
}

renderer::Mesh mesh_of(const Figure& figure, const FigurePart& part, const NearField& field) {
    renderer::Mesh mesh =
        polygonise(part.solid, part.cell_m,
                   [&](const glm::vec3& p, const glm::vec3& normal, const glm::vec3& tint) {
                       const bool skin = part.cloth == Cloth::kSkin && figure.complexion != nullptr;
                       const glm::vec3 colour = skin ? tint * figure.complexion(p) : tint;
                       return colour * (1.0F - part.painted_shade * occlusion_at(field, p, normal));
                   });
    mesh.name = figure.name + " " + part.name;
    mesh.material = static_cast<std::uint32_t>(part.cloth);
    project_box_uv(mesh);
    for (renderer::Vertex& vertex : mesh.vertices) vertex.uv /= part.texture_m;
    return mesh;
}

void add_overlaid(renderer::Scene& scene, const Figure& figure, const NearField& field) {
    for (const Overlaid& piece : figure.overlaid) {
        renderer::Mesh mesh = piece.mesh;
        paint(mesh, [&](const glm::vec3& p, const glm::vec3& normal) {
            return glm::vec3(1.0F - 0.5F * occlusion_at(field, p + 0.004F * normal, normal));
        });
        mesh.name = figure.name + " " + piece.name;
        mesh.material = static_cast<std::uint32_t>(piece.cloth);
        project_box_uv(mesh);
        for (renderer::Vertex& vertex : mesh.vertices) vertex.uv /= piece.texture_m;
        scene.meshes.push_back(std::move(mesh));
    }
}

void add_small_parts(renderer::Scene& scene, const Figure& figure) {
    renderer::Mesh wisps;
    for (const Wisp& wisp : figure.wisps) append(wisps, card_of(wisp));
    wisps.name = figure.name + " wisps";
    wisps.material = static_cast<std::uint32_t>(Cloth::kWisps);
    if (!figure.wisps.empty()) scene.meshes.push_back(std::move(wisps));
    renderer::Mesh eyes;
    for (const Eye& eye : figure.eyes) append(eyes, eyeball(eye));
    eyes.name = figure.name + " eyes";
    eyes.material = static_cast<std::uint32_t>(Cloth::kEye);
    scene.meshes.push_back(std::move(eyes));
}

}  // namespace

FigurePart& Figure::part(const std::string& part_name, Cloth cloth, float cell_m, float texture_m) {
    FigurePart& added = parts.emplace_back();
    added.name = part_name;
    added.cloth = cloth;
    added.cell_m = cell_m;
    added.texture_m = texture_m;
    return added;
}

void add_to_scene(renderer::Scene& scene, const Figure& figure) {
    const NearField field(figure);
    // Parts at once, so that no core waits while a part is begun or put together.
    std::vector<renderer::Mesh> meshes(figure.parts.size());
    for_each_row(static_cast<int>(meshes.size()), [&](int row) {
        const auto i = static_cast<std::size_t>(row);
        meshes[i] = mesh_of(figure, figure.parts[i], field);
    });
    std::move(meshes.begin(), meshes.end(), std::back_inserter(scene.meshes));
    add_overlaid(scene, figure, field);
    add_small_parts(scene, figure);
}

}  // namespace obscura::stimuli::figures
