// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "renderer/base/check.h"
#include "renderer/import/gltf_import.h"
#include "renderer/import/mesh_finish.h"
#include "renderer/light/shadow.h"

namespace obscura::renderer {
namespace {

std::string ending_of(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    std::string ending(dot == std::string_view::npos ? "" : name.substr(dot));
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

void check_coordinates(const Scene& scene, const std::string& name) {
    constexpr float kMost = ImportLimits::kFarthest_m;
    for (const Mesh& mesh : scene.meshes) {
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            const glm::vec3& p = mesh.vertices[v].position_m;
            const glm::vec3 size = glm::abs(p);
            if (!(size.x <= kMost && size.y <= kMost && size.z <= kMost)) {
                throw base::bad_input(
                    "{}: mesh {}: vertex {} lies at ({}, {}, {}) m, allowed is at most {} m from "
                    "the origin along each axis; is the scale right?",
                    name, mesh.name, v, p.x, p.y, p.z, kMost);
            }
        }
    }
}

/// Every camera gets a name of its own, and a far plane behind the scene where it has none.
void finish_cameras(Scene& scene, const std::string& file, import_detail::Notes& notes) {
    std::set<std::string> names;
    const Bounds bounds = bounds_of(scene);
    for (Camera& camera : scene.cameras) {
        const std::string given = camera.name;
        for (int i = 2; !names.insert(camera.name).second; ++i) {
            camera.name = fmt::format("{}-{}", given, i);
        }
        const glm::vec3 size = glm::abs(camera.position_m);
        if (!(std::max({size.x, size.y, size.z}) <= ImportLimits::kFarthest_m)) {
            throw base::bad_input("{}: camera {} is more than {} m away", file, camera.name,
                                  ImportLimits::kFarthest_m);
        }
        if (camera.far_m > 0.0F) continue;
        const glm::vec3 farthest = glm::max(glm::abs(bounds.low_m - camera.position_m),
                                            glm::abs(bounds.high_m - camera.position_m));
        camera.far_m = std::max(1.1F * glm::length(farthest), 10.0F * camera.near_m);
        notes.add("cameras without a far plane get one behind everything", camera.name);
    }
}

}  // namespace

Camera overview_camera(const Scene& scene) {
    const Bounds bounds = bounds_of(scene);
    const float radius_m = std::max(0.5F * glm::length(bounds.high_m - bounds.low_m), 1e-4F);
    Camera camera;
    camera.name = kOverviewCamera;
    camera.vertical_fov_rad = glm::radians(40.0F);
    camera.target_m = 0.5F * (bounds.low_m + bounds.high_m);
    const glm::vec3 backward = glm::normalize(glm::vec3(0.45F, 0.35F, 1.0F));
    const glm::vec3 right = glm::normalize(glm::cross(camera.up, backward));
    const glm::vec3 up = glm::cross(backward, right);
    // As near as every corner of the box allows, in an image as wide as it is high.
    const float most_per_metre = 0.93F * std::tan(0.5F * camera.vertical_fov_rad);
    float distance_m = 0.0F;
    for (int i = 0; i < 8; ++i) {
        const glm::vec3 corner =
            glm::mix(bounds.low_m, bounds.high_m,
                     glm::vec3(static_cast<float>(i & 1), static_cast<float>(i / 2 & 1),
                               static_cast<float>(i / 4))) -
            camera.target_m;
        const float aside_m =
            std::max(std::abs(glm::dot(corner, right)), std::abs(glm::dot(corner, up)));
        distance_m = std::max(distance_m, aside_m / most_per_metre + glm::dot(corner, backward));
    }
    distance_m = std::max(distance_m, 1.1F * radius_m);
    camera.position_m = camera.target_m + distance_m * backward;
    camera.near_m = std::max(0.5F * (distance_m - radius_m), 0.02F * radius_m);
    camera.far_m = 1.05F * (distance_m + radius_m);
    return camera;
}

bool is_scene_file(std::string_view name) {
    const std::string ending = ending_of(name);
    return ending == ".gltf" || ending == ".glb" || ending == ".obj";
}

namespace import_detail {
namespace {

/// The largest alpha that a mesh has anywhere, [0, 1].
float most_alpha(const Scene& scene, const Mesh& mesh) {
    const Material& material = scene.materials[mesh.material];
    std::uint8_t of_vertices = 0;
    for (const Vertex& vertex : mesh.vertices) of_vertices = std::max(of_vertices, vertex.color.a);
    std::uint8_t of_texels = 255;
    if (material.albedo_texture != kNoTexture) {
        const auto& rgba = scene.textures[static_cast<std::size_t>(material.albedo_texture)].rgba;
        of_texels = 0;
        for (std::size_t i = 3; i < rgba.size() && of_texels < 255; i += 4) {
            of_texels = std::max(of_texels, rgba[i]);
        }
    }
    return material.opacity * static_cast<float>(of_vertices) * static_cast<float>(of_texels) /
           (255.0F * 255.0F);
}

/// Notes surfaces that are there and that nobody can see, which can only be a mistake.
void note_invisible(const Scene& scene, Notes& notes) {
    for (const Mesh& mesh : scene.meshes) {
        const Material& material = scene.materials[mesh.material];
        if (material.coverage == Coverage::kOpaque) continue;
        const float alpha = most_alpha(scene, mesh);
        const bool blended = material.coverage == Coverage::kBlended;
        if (blended ? alpha < 0.5F / 255.0F : alpha < material.alpha_cutoff) {
            notes.add(
                "surfaces that cannot be seen, since their opacity is 0 or below the cut-off "
                "everywhere",
                fmt::format("material {}", material.name));
        }
    }
}

}  // namespace

void finish_import(ImportedScene& imported, const std::string& name, Notes& notes) {
    Scene& scene = imported.scene;
    if (scene.triangle_count() == 0) throw base::bad_input("{}: it holds no triangles", name);
    check_coordinates(scene, name);
    std::size_t with_area = 0;
    for (const Mesh& mesh : scene.meshes) {
        const Sides sides = sides_of(mesh);
        with_area += sides.with_area;
        if (sides.with_turned_normal > 0) {
            notes.add(
                "triangles of which a corner's normal points to their back are lit as their "
                "normals say",
                fmt::format("{} of {} in {}", sides.with_turned_normal, sides.with_area,
                            mesh.name));
        }
    }
    if (with_area == 0) throw base::bad_input("{}: no triangle in it has an area", name);
    finish_cameras(scene, name, notes);
    if (scene.cameras.empty()) scene.cameras.push_back(overview_camera(scene));
    if (scene.materials.empty()) scene.materials.push_back({.name = "none"});
    note_invisible(scene, notes);
    imported.notes = notes.lines();
}

}  // namespace import_detail

ImportedScene import_scene(const std::filesystem::path& file, const ImportOptions& options) {
    const std::string name = file.string();
    base::check_range(name, "scale", options.scale, 1e-6, 1e6);
    if (!is_scene_file(name)) {
        throw base::bad_input("{}: allowed are files that end in .gltf, .glb and .obj", name);
    }
    import_detail::Notes notes;
    import_detail::FilesRead files(file.parent_path(), options.allowed_folders, notes);
    std::string why;
    std::optional<std::string> bytes = files.read_scene(file.filename().string(), why);
    if (!bytes) throw base::bad_input("{}: {}", name, why);
    ImportedScene imported =
        ending_of(name) == ".obj"
            ? import_detail::import_obj(*bytes, name, options, files, notes)
            : import_detail::import_gltf(std::move(*bytes), name, options, files, notes);
    imported.scene.name = file.stem().string();
    import_detail::finish_import(imported, name, notes);
    imported.files = files.list();
    return imported;
}

}  // namespace obscura::renderer
