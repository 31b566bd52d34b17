// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/reference/analytic_scenes.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "renderer/reference/closed_forms.h"

namespace obscura::renderer {
namespace {

constexpr double kPi = std::numbers::pi;
/// Of surfaces without end where no radius bounds the rays, in units of a scene whose point lies
/// 0.05 from a wall: half of 0.05 / 1e4 is what is missing at most.
constexpr double kEndless = 1e4;
constexpr double kNear = 0.05;
constexpr double kUnlimited = std::numeric_limits<double>::infinity();

glm::dvec3 around(double angle_rad, double radius, double y) {
    return {radius * std::cos(angle_rad), y, radius * std::sin(angle_rad)};
}

/// A grid of (columns + 1) x (rows + 1) points; point(u, v) for u and v in [0, 1].
void add_grid(Scene& scene, int columns, int rows,
              const std::function<glm::dvec3(double, double)>& point) {
    Mesh mesh;
    mesh.name = "grid";
    for (int row = 0; row <= rows; ++row) {
        for (int column = 0; column <= columns; ++column) {
            Vertex vertex;
            vertex.position_m = glm::vec3(
                point(static_cast<double>(column) / columns, static_cast<double>(row) / rows));
            mesh.vertices.push_back(vertex);
        }
    }
    const auto index = [columns](int column, int row) {
        return static_cast<std::uint32_t>(row * (columns + 1) + column);
    };
    const auto same_place = [&mesh](std::uint32_t one, std::uint32_t other) {
        return mesh.vertices[one].position_m == mesh.vertices[other].position_m;
    };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const std::uint32_t a = index(column, row);
            const std::uint32_t b = index(column + 1, row);
            const std::uint32_t c = index(column + 1, row + 1);
            const std::uint32_t d = index(column, row + 1);
            // At a pole or in the middle of a disk a row is one point.
            if (row > 0 || !same_place(a, b)) mesh.indices.insert(mesh.indices.end(), {a, b, c});
            if (row + 1 < rows || !same_place(c, d))
                mesh.indices.insert(mesh.indices.end(), {a, c, d});
        }
    }
    scene.meshes.push_back(std::move(mesh));
}

/// Looks at a point of the floor from `from`, through a field of view of a thousandth of a radian.
Camera looking_at(const glm::dvec3& point, const glm::dvec3& from) {
    Camera camera;
    camera.name = "analytic";
    camera.target_m = glm::vec3(point);
    camera.position_m = glm::vec3(from);
    camera.up = {0.0F, 0.0F, 1.0F};
    camera.vertical_fov_rad = 1.1e-3F;
    camera.near_m = 1e-5F;
    camera.far_m = 1e3F;
    return camera;
}

ClosedForm form_of(std::string name, double analytic, Scene scene, Camera camera, double radius_m,
                   Falloff falloff = Falloff::kNone) {
    ClosedForm form;
    form.name = std::move(name);
    form.analytic = analytic;
    form.scene = std::move(scene);
    form.camera = std::move(camera);
    form.options.radius_m = radius_m;
    form.options.falloff = falloff;
    return form;
}

std::string named(const char* what, double number) {
    std::string text = std::to_string(number);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.ends_with('.')) text.pop_back();
    return what + text;
}

void add_open_surfaces(std::vector<ClosedForm>& forms) {
    Scene plane = analytic_scene();
    add_floor(plane, -20.0, 40.0);
    forms.push_back(
        form_of("infinite plane", 1.0, plane, looking_at({0.3, 0.0, 0.2}, {0.4, 0.1, 0.2}), 1.0));
    Scene ball = analytic_scene();
    add_ball(ball, {0.0, 0.0, 0.0}, 1.0, 64);
    forms.push_back(form_of("convex: on a ball", 1.0, ball,
                            looking_at({0.0, 0.98, 0.17}, {0.0, 2.0, 0.3}), 10.0));
}

void add_corners(std::vector<ClosedForm>& forms) {
    for (const double degrees : {60.0, 90.0, 120.0, 150.0}) {
        Scene scene = analytic_scene();
        add_floor(scene, 0.0, kEndless);
        add_leaning_wall(scene, degrees * kPi / 180.0, kEndless);
        forms.push_back(
            form_of(named("wedge, no radius, degrees ", degrees), wedge(degrees * kPi / 180.0),
                    scene, looking_at({kNear, 0.0, 0.0}, {2.0 * kNear, 0.05, 0.0}), kUnlimited));
    }
    Scene corner = analytic_scene();
    add_floor(corner, 0.0, 20.0);
    add_leaning_wall(corner, 0.5 * kPi, 20.0);
    for (const double c : {0.001, 0.1, 0.25, 0.5, 0.75, 1.0}) {
        const Camera camera = looking_at({c, 0.0, 0.0}, {c + 0.05, 0.05, 0.0});
        forms.push_back(form_of(named("corner within R, c = ", c), corner_within_radius(c), corner,
                                camera, 1.0));
    }
    for (const double c : {0.1, 0.25, 0.5}) {
        const Camera camera = looking_at({c, 0.0, 0.0}, {c + 0.05, 0.05, 0.0});
        forms.push_back(form_of(named("corner, linear falloff, c = ", c),
                                corner_with_linear_falloff(c), corner, camera, 1.0,
                                Falloff::kLinear));
    }
}

void add_round_shapes(std::vector<ClosedForm>& forms) {
    for (const double x : {0.5, 1.0, 2.0}) {
        Scene scene = analytic_scene();
        add_floor(scene, -20.0, 40.0);
        add_ball(scene, {0.0, 1.0, 0.0}, 1.0, 160);
        forms.push_back(form_of(named("ball on a plane, x/r = ", x), beside_sphere(1.0, x), scene,
                                looking_at({x, 0.0, 0.0}, {x + 0.1, 0.02, 0.0}), kUnlimited));
    }
    for (const double h : {0.5, 1.0, 2.0}) {
        Scene scene = analytic_scene();
        add_floor(scene, -20.0, 40.0);
        add_disk(scene, {0.0, h, 0.0}, 1.0, 1024);
        forms.push_back(form_of(named("under a disk, h/r = ", h), under_disk(1.0, h), scene,
                                looking_at({0.0, 0.0, 0.0}, {0.1, 0.1, 0.0}), kUnlimited));
    }
    for (const double h : {0.5, 1.0, 3.0}) {
        Scene scene = analytic_scene();
        add_disk(scene, {0.0, 0.0, 0.0}, 1.0, 1024);
        add_tube(scene, 1.0, h, 1024);
        forms.push_back(form_of(named("round pit, depth/radius = ", h), in_pit(1.0, h), scene,
                                looking_at({0.0, 0.0, 0.0}, {0.1, 0.1, 0.0}), kUnlimited));
    }
}

void add_enclosures(std::vector<ClosedForm>& forms) {
    for (const double c : {0.25, 0.5, 0.75}) {
        Scene scene = analytic_scene();
        add_floor(scene, -20.0, 40.0);
        add_parallelogram(scene, {-20.0, c, -20.0}, {40.0, 0.0, 0.0}, {0.0, 0.0, 40.0});
        forms.push_back(form_of(named("parallel plates, gap/R = ", c), between_plates(c), scene,
                                looking_at({0.0, 0.0, 0.0}, {0.1, 0.1, 0.0}), 1.0));
    }
    Scene box = analytic_scene();
    for (const double y : {0.0, 1.0}) {
        add_parallelogram(box, {-0.5, y, -0.5}, {1.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    }
    for (const double x : {-0.5, 0.5}) {
        add_parallelogram(box, {x, 0.0, -0.5}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
        add_parallelogram(box, {-0.5, 0.0, x}, {0.0, 1.0, 0.0}, {1.0, 0.0, 0.0});
    }
    forms.push_back(form_of("closed box smaller than R", 0.0, box,
                            looking_at({0.1, 0.0, 0.2}, {0.2, 0.3, 0.2}), 10.0));
}

}  // namespace

Scene analytic_scene() {
    Scene scene;
    scene.name = "analytic";
    Material white;
    white.name = "white";
    white.double_sided = true;
    scene.materials.push_back(white);
    return scene;
}

void add_parallelogram(Scene& scene, const glm::dvec3& origin, const glm::dvec3& u,
                       const glm::dvec3& v) {
    add_grid(scene, 1, 1, [&](double a, double b) { return origin + a * u + b * v; });
    for (Vertex& vertex : scene.meshes.back().vertices) {
        vertex.normal = glm::vec3(glm::normalize(glm::cross(u, v)));
    }
}

void add_floor(Scene& scene, double left, double reach) {
    add_parallelogram(scene, {left, 0.0, -reach}, {0.0, 0.0, 2.0 * reach}, {reach, 0.0, 0.0});
}

void add_leaning_wall(Scene& scene, double opening_rad, double reach) {
    add_parallelogram(scene, {0.0, 0.0, -reach},
                      {reach * std::cos(opening_rad), reach * std::sin(opening_rad), 0.0},
                      {0.0, 0.0, 2.0 * reach});
}

void add_ball(Scene& scene, const glm::dvec3& middle, double radius, int rings) {
    add_grid(scene, 2 * rings, rings, [&](double u, double v) {
        return middle +
               around(2.0 * kPi * u, radius * std::sin(kPi * v), radius * std::cos(kPi * v));
    });
    for (Vertex& vertex : scene.meshes.back().vertices) {
        vertex.normal = glm::vec3(glm::normalize(glm::dvec3(vertex.position_m) - middle));
    }
}

void add_disk(Scene& scene, const glm::dvec3& middle, double radius, int segments) {
    add_grid(scene, segments, 1,
             [&](double u, double v) { return middle + around(2.0 * kPi * u, radius * v, 0.0); });
}

void add_tube(Scene& scene, double radius, double height, int segments) {
    add_grid(scene, segments, 1,
             [&](double u, double v) { return around(2.0 * kPi * u, radius, height * v); });
    for (Vertex& vertex : scene.meshes.back().vertices) {
        vertex.normal =
            glm::vec3(-glm::normalize(glm::dvec3(vertex.position_m.x, 0.0, vertex.position_m.z)));
    }
}

std::vector<ClosedForm> closed_forms() {
    std::vector<ClosedForm> forms;
    add_open_surfaces(forms);
    add_corners(forms);
    add_round_shapes(forms);
    add_enclosures(forms);
    return forms;
}

}  // namespace obscura::renderer
