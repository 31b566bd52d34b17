// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/gltf_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>

#include "renderer/base/error.h"
#include "renderer/import/gltf_check.h"
#include "renderer/import/gltf_material.h"
#include "renderer/import/gltf_mesh.h"
#include "renderer/import/gltf_nodes.h"
#include "renderer/import/mesh_finish.h"

namespace obscura::renderer::import_detail {
namespace {

/// Normals go with the cofactors, which exist where a placement flattens a mesh, too.
glm::dmat3 normal_matrix(const glm::dmat4& placement) {
    const glm::dmat3 m(placement);
    const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]),
                               glm::cross(m[0], m[1]));
    return glm::determinant(m) < 0.0 ? -cofactors : cofactors;
}

/// Unit length; what has it within a float's precision stays as it is, to the bit.
glm::vec3 directed(const glm::dvec3& v) {
    const double length = glm::length(v);
    if (std::abs(length - 1.0) < 2e-7) return glm::vec3(v);
    return length > 0.0 ? glm::vec3(v / length) : glm::vec3(0.0F);
}

/// Moves a vertex; directions stay to the bit where the placement changes none.
void place(Vertex& vertex, const glm::dmat4& placement, const glm::dmat3& normals, bool plain) {
    vertex.position_m =
        glm::vec3(glm::dvec3(placement * glm::dvec4(glm::dvec3(vertex.position_m), 1.0)));
    if (plain) return;
    vertex.normal = directed(normals * glm::dvec3(vertex.normal));
    const double side = glm::determinant(glm::dmat3(placement)) < 0.0 ? -1.0 : 1.0;
    vertex.tangent = {directed(glm::dmat3(placement) * glm::dvec3(glm::vec3(vertex.tangent))),
                      vertex.tangent.w * static_cast<float>(side)};
}

void turn_windings(Mesh& mesh) {
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
}

class GltfImport {
  public:
    GltfImport(const GltfFile& file, const ImportOptions& options, FilesRead& files, Notes& notes)
        : file_(file),
          options_(options),
          notes_(notes),
          nodes_(read_nodes(file, options.scale, notes)),
          materials_(file, files, notes, imported_.scene) {}

    ImportedScene run() {
        materials_.read();
        for (const std::size_t node : nodes_.shown) {
            const JsonCursor cursor = file_.root().at("nodes").item(node);
            read_mesh(cursor, node);
            read_camera(cursor, node);
            read_light(cursor, node);
        }
        if (file_.root().count("animations") > 0) {
            notes_.add("animations are not played: the pose of the file's nodes is shown");
        }
        return std::move(imported_);
    }

  private:
    void read_mesh(const JsonCursor& node, std::size_t index);
    void add_primitive(GltfPrimitive&& primitive, std::size_t node,
                       const std::vector<glm::dmat4>& joints);
    void finish_mesh(GltfPrimitive& primitive);
    [[nodiscard]] const std::vector<glm::dmat4>& joints_of(std::size_t skin);
    void read_camera(const JsonCursor& node, std::size_t index);
    void read_light(const JsonCursor& node, std::size_t index);

    const GltfFile& file_;
    const ImportOptions& options_;
    Notes& notes_;
    GltfNodes nodes_;
    ImportedScene imported_;
    GltfMaterials materials_;
    MeshBudget budget_;
    std::map<std::size_t, std::vector<glm::dmat4>> skins_;
};

void GltfImport::read_mesh(const JsonCursor& node, std::size_t index) {
    const JsonCursor root = file_.root();
    const auto mesh_index = node.index("mesh", root.count("meshes"), "meshes");
    if (!mesh_index) return;
    const JsonCursor mesh = root.at("meshes").item(*mesh_index);
    const std::size_t count = mesh.at("primitives").count();
    const JsonCursor weighted = node.find("weights") ? node : mesh;
    std::vector<double> weights(weighted.count("weights"), 0.0);
    weights = weighted.numbers("weights", weights);
    static const std::vector<glm::dmat4> kNoJoints;
    const auto skin = node.index("skin", root.count("skins"), "skins");
    const std::vector<glm::dmat4>& joints = skin ? joints_of(*skin) : kNoJoints;
    const std::string name = node.name(mesh.name(fmt::format("mesh-{}", *mesh_index)));
    for (std::size_t i = 0; i < count; ++i) {
        auto primitive = read_primitive(file_, mesh.at("primitives").item(i), weights, materials_,
                                        budget_, notes_);
        if (!primitive) continue;
        primitive->mesh.name = name;
        add_primitive(std::move(*primitive), index, joints);
    }
}

const std::vector<glm::dmat4>& GltfImport::joints_of(std::size_t skin) {
    const auto known = skins_.find(skin);
    if (known != skins_.end()) return known->second;
    const JsonCursor cursor = file_.root().at("skins").item(skin);
    const JsonCursor list = cursor.at("joints");
    const std::size_t count = list.count();
    std::vector<float> inverse;
    if (const auto index =
            cursor.index("inverseBindMatrices", file_.accessors().size(), "accessors")) {
        const GltfAccessor& accessor = file_.accessors()[*index];
        constexpr std::size_t kMostJoints = 65536;  // what the indices of joints reach
        if (accessor.components != 16 || accessor.count < count || accessor.count > kMostJoints) {
            cursor.at("inverseBindMatrices")
                .fail(fmt::format("is of {} elements, allowed are {} to {} of type MAT4",
                                  accessor.count, count, kMostJoints));
        }
        inverse = file_.floats(accessor);
    }
    std::vector<glm::dmat4> joints;
    for (std::size_t j = 0; j < count; ++j) {
        glm::dmat4 bind(1.0);
        for (std::size_t i = 0; !inverse.empty() && i < 16; ++i) {
            bind[static_cast<int>(i / 4)][static_cast<int>(i % 4)] =
                static_cast<double>(inverse[16 * j + i]);
        }
        const std::size_t node = list.item(j).index(nodes_.world_from_node.size(), "nodes");
        joints.push_back(nodes_.world_from_node[node] * bind);
    }
    return skins_.emplace(skin, std::move(joints)).first->second;
}

void GltfImport::add_primitive(GltfPrimitive&& primitive, std::size_t node,
                               const std::vector<glm::dmat4>& joints) {
    Mesh& mesh = primitive.mesh;
    const glm::dmat4& world = nodes_.world_from_node[node];
    if (primitive.skin && !joints.empty()) {
        // glTF 2.0, 3.7.3: the mesh's own node does not count, its joints place it.
        double side = 0.0;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            glm::dmat4 placement(0.0);
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t joint = primitive.skin->joints[v][k];
                const auto weight =
                    static_cast<double>(primitive.skin->weights[v][static_cast<int>(k)]);
                if (weight == 0.0) continue;
                if (joint >= joints.size()) {
                    throw base::bad_input("{}: mesh {}: joint {} of vertex {}, allowed is 0 to {}",
                                          file_.name(), mesh.name, joint, v, joints.size() - 1);
                }
                placement += weight * joints[joint];
            }
            if (placement == glm::dmat4(0.0)) placement = world;
            place(mesh.vertices[v], placement, normal_matrix(placement), false);
            side += glm::determinant(glm::dmat3(placement));
        }
        if (side < 0.0) turn_windings(mesh);
    } else {
        const bool plain = glm::dmat3(world) == glm::dmat3(1.0);
        const glm::dmat3 normals = normal_matrix(world);
        for (Vertex& vertex : mesh.vertices) place(vertex, world, normals, plain);
        if (glm::determinant(glm::dmat3(world)) < 0.0) turn_windings(mesh);
    }
    finish_mesh(primitive);
}

void GltfImport::finish_mesh(GltfPrimitive& primitive) {
    Mesh& mesh = primitive.mesh;
    const std::size_t before = mesh.vertices.size();
    if (!primitive.has_normals) {
        if (mesh.indices.size() > budget_.vertices) {
            throw base::bad_input("{}: mesh {}: the scene has more than the {} vertices allowed",
                                  file_.name(), mesh.name, ImportLimits::kVertices);
        }
        make_flat_normals(mesh);
        notes_.add("meshes without normals get those of their triangles", mesh.name);
    } else if (mend_normals(mesh) > 0) {
        notes_.add("normals that are no directions are replaced by the triangles'", mesh.name);
    }
    if (materials_.material(mesh.material).normal_texture != kNoTexture &&
        !(primitive.has_normals && primitive.has_tangents)) {
        make_tangents(mesh);
    }
    const std::size_t more = mesh.vertices.size() > before ? mesh.vertices.size() - before : 0;
    budget_.vertices -= std::min(more, budget_.vertices);
    imported_.scene.meshes.push_back(std::move(mesh));
}

void GltfImport::read_camera(const JsonCursor& node, std::size_t index) {
    const JsonCursor root = file_.root();
    const auto number = node.index("camera", root.count("cameras"), "cameras");
    if (!number) return;
    const JsonCursor cursor = root.at("cameras").item(*number);
    Camera camera;
    camera.name = node.name(cursor.name(fmt::format("camera-{}", *number)));
    const auto perspective = cursor.find("perspective");
    if (cursor.text("type", "") != "perspective" || !perspective) {
        notes_.add("cameras without perspective are left out", camera.name);
        return;
    }
    camera.vertical_fov_rad = static_cast<float>(perspective->at("yfov").number(0.001, 3.14));
    camera.near_m = static_cast<float>(perspective->at("znear").number(1e-6, 1e6) * options_.scale);
    if (perspective->find("zfar")) {
        camera.far_m =
            static_cast<float>(perspective->number("zfar", 0.0, 1e-6, 1e12) * options_.scale);
        if (!(camera.far_m > camera.near_m)) perspective->at("zfar").fail("is not above znear");
    } else {
        camera.far_m = 0.0F;
    }
    const glm::dmat4& world = nodes_.world_from_node[index];
    const glm::vec3 forward = directed(-glm::dvec3(world[2]));
    camera.position_m = glm::vec3(glm::dvec3(world[3]));
    camera.target_m = camera.position_m + forward;
    camera.up = directed(glm::dvec3(world[1]));
    if (!(glm::length(glm::cross(forward, camera.up)) > 1e-4F)) {
        notes_.add("cameras whose node flattens them are left out", camera.name);
        return;
    }
    // A camera that this program exported: the point it looks at, so that nothing is rounded.
    if (const auto extras = node.find("extras"); extras && extras->json().is_object()) {
        const auto target = extras->find("obscura_target");
        if (target && options_.scale == 1.0) {
            const auto t = extras->numbers("obscura_target", {0.0, 0.0, 0.0});
            const auto u = extras->numbers("obscura_up", {0.0, 1.0, 0.0});
            const glm::vec3 at(t[0], t[1], t[2]);
            if (glm::dot(directed(glm::dvec3(at) - glm::dvec3(camera.position_m)), forward) >
                0.99999F) {
                camera.target_m = at;
                camera.up = glm::vec3(u[0], u[1], u[2]);
            }
        }
    }
    imported_.scene.cameras.push_back(camera);
}

void GltfImport::read_light(const JsonCursor& node, std::size_t index) {
    const auto extensions = node.find("extensions");
    const auto use = extensions ? extensions->find("KHR_lights_punctual") : std::nullopt;
    if (!use) return;
    const JsonCursor lights = file_.root().at("extensions").at("KHR_lights_punctual").at("lights");
    const JsonCursor cursor = lights.item(use->at("light").index(lights.count(), "lights"));
    const auto c = cursor.numbers("color", {1.0, 1.0, 1.0});
    const double intensity = cursor.number("intensity", 1.0, 0.0, 1e9);
    const glm::vec3 colour(glm::max(glm::dvec3(c[0], c[1], c[2]), 0.0) * intensity);
    const glm::dmat4& world = nodes_.world_from_node[index];
    const glm::vec3 backward = directed(glm::dvec3(world[2]));
    const std::string type = cursor.text("type", "");
    const std::string name = node.name(cursor.name(type));
    if (type != "point" && backward == glm::vec3(0.0F)) {
        notes_.add("lights whose node flattens them are left out", name);
        return;
    }
    if (type == "directional") {
        imported_.lights.push_back({backward, colour});
        return;
    }
    if (type != "point" && type != "spot") {
        cursor.fail(
            fmt::format("type is \"{}\", allowed are directional, point and spot", one_line(type)));
    }
    PointLight light;
    light.position_m = glm::vec3(glm::dvec3(world[3]));
    // Distances grow with the scale: with its square, surfaces stay as bright as they were.
    light.intensity = colour * static_cast<float>(options_.scale * options_.scale);
    if (cursor.find("range")) {
        light.range_m = static_cast<float>(cursor.number("range", 1.0, 1e-6, 1e9) * options_.scale);
    }
    if (type == "spot") {
        light.direction = -backward;
        const auto spot = cursor.find("spot");
        constexpr double kRight = glm::half_pi<double>();
        light.outer_cone_rad = static_cast<float>(
            spot ? spot->number("outerConeAngle", kRight / 2.0, 0.0, kRight + 1e-6) : kRight / 2.0);
        light.inner_cone_rad = static_cast<float>(
            spot ? spot->number("innerConeAngle", 0.0, 0.0, kRight + 1e-6) : 0.0);
        light.inner_cone_rad = std::min(light.inner_cone_rad, light.outer_cone_rad);
    }
    imported_.point_lights.push_back(light);
}

}  // namespace

ImportedScene import_gltf(std::string bytes, const std::string& name, const ImportOptions& options,
                          FilesRead& files, Notes& notes) {
    const GltfFile file(
        std::move(bytes), name,
        [&files](const std::string& wanted, std::string& why) { return files.read(wanted, why); },
        notes);
    return GltfImport(file, options, files, notes).run();
}

}  // namespace obscura::renderer::import_detail
