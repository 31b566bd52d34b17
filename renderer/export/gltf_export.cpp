// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/export/gltf_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "renderer/base/error.h"
#include "renderer/export/png.h"
#include "renderer/scene/surface_conversion.h"

namespace obscura::renderer {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kUnsignedByte = 5121;
constexpr int kArrayBuffer = 34962;
constexpr int kElementBuffer = 34963;

Json to_array(const glm::vec3& v) { return {v.x, v.y, v.z}; }

class GltfWriter {
  public:
    GltfWriter(const Scene& scene, const Lighting& lighting) : scene_(scene), lighting_(lighting) {}

    std::string run();

  private:
    int add_view(const void* data, std::size_t bytes, int target);
    template <typename T, typename Get>
    int add_accessor(const Mesh& mesh, const char* type, int component, Get get);
    void add_positions(const Mesh& mesh, Json& attributes);
    void add_mesh(const Mesh& mesh);
    void add_material(const Material& material);
    [[nodiscard]] Json texture_use(TextureIndex index);
    void add_camera(const Camera& camera);
    void add_lights();
    void add_light_node(Json light, const glm::vec3& position_m, const glm::vec3& direction);
    void use_extension(const char* name) { extensions_.insert(name); }
    [[nodiscard]] std::string packed();

    const Scene& scene_;
    const Lighting& lighting_;
    std::string binary_;
    Json json_ = Json::object();
    Json nodes_ = Json::array();
    Json lights_ = Json::array();
    std::set<std::string> extensions_;
    std::map<TextureIndex, int> textures_;
};

int GltfWriter::add_view(const void* data, std::size_t bytes, int target) {
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
    Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes}};
    if (target != 0) view["target"] = target;
    binary_.append(static_cast<const char*>(data), bytes);
    if (binary_.size() > 0xF0000000U) {
        throw base::bad_input("scene {}: it needs more than the 4 GiB that a .glb holds",
                              scene_.name);
    }
    json_["bufferViews"].push_back(std::move(view));
    return static_cast<int>(json_["bufferViews"].size()) - 1;
}

/// One attribute of every vertex.
template <typename T, typename Get>
int GltfWriter::add_accessor(const Mesh& mesh, const char* type, int component, Get get) {
    std::vector<T> values;
    values.reserve(mesh.vertices.size());
    for (const Vertex& vertex : mesh.vertices) values.push_back(get(vertex));
    const int view = add_view(values.data(), values.size() * sizeof(T), kArrayBuffer);
    Json accessor = {{"bufferView", view},
                     {"componentType", component},
                     {"count", values.size()},
                     {"type", type}};
    if (component == kUnsignedByte) accessor["normalized"] = true;
    json_["accessors"].push_back(std::move(accessor));
    return static_cast<int>(json_["accessors"].size()) - 1;
}

/// Positions, whose accessor must state their bounds (glTF 2.0, 3.7.2.1).
void GltfWriter::add_positions(const Mesh& mesh, Json& attributes) {
    glm::vec3 low = mesh.vertices.front().position_m;
    glm::vec3 high = low;
    for (const Vertex& vertex : mesh.vertices) {
        const float sum = vertex.position_m.x + vertex.position_m.y + vertex.position_m.z +
                          glm::length(vertex.normal);
        if (!std::isfinite(sum)) {
            throw base::bad_input("scene {}, mesh {}: a vertex that is not finite", scene_.name,
                                  mesh.name);
        }
        low = glm::min(low, vertex.position_m);
        high = glm::max(high, vertex.position_m);
    }
    attributes["POSITION"] =
        add_accessor<glm::vec3>(mesh, "VEC3", kFloat, [](const Vertex& v) { return v.position_m; });
    Json& accessor = json_["accessors"].back();
    accessor["min"] = to_array(low);
    accessor["max"] = to_array(high);
}

void GltfWriter::add_mesh(const Mesh& mesh) {
    if (mesh.indices.empty() || mesh.vertices.empty()) return;
    if (mesh.material >= scene_.materials.size()) {
        throw base::bad_input("scene {}, mesh {}: material {} of {}", scene_.name, mesh.name,
                              mesh.material, scene_.materials.size());
    }
    for (const std::uint32_t index : mesh.indices) {
        if (index >= mesh.vertices.size()) {
            throw base::bad_input("scene {}, mesh {}: index {} of {} vertices", scene_.name,
                                  mesh.name, index, mesh.vertices.size());
        }
    }
    const Material& material = scene_.materials[mesh.material];
    Json attributes = Json::object();
    add_positions(mesh, attributes);
    attributes["NORMAL"] = add_accessor<glm::vec3>(mesh, "VEC3", kFloat, [](const Vertex& v) {
        const float length = glm::length(v.normal);
        if (!(length > 0.0F)) return glm::vec3(0.0F, 1.0F, 0.0F);
        return std::abs(length - 1.0F) > 1e-3F ? v.normal / length : v.normal;
    });
    if (material.normal_texture != kNoTexture) {
        attributes["TANGENT"] = add_accessor<glm::vec4>(mesh, "VEC4", kFloat,
                                                        [](const Vertex& v) { return v.tangent; });
    }
    attributes["TEXCOORD_0"] =
        add_accessor<glm::vec2>(mesh, "VEC2", kFloat, [](const Vertex& v) { return v.uv; });
    const bool coloured = std::any_of(mesh.vertices.begin(), mesh.vertices.end(),
                                      [](const Vertex& v) { return v.color != glm::u8vec4(255); });
    if (coloured) {
        attributes["COLOR_0"] = add_accessor<glm::u8vec4>(mesh, "VEC4", kUnsignedByte,
                                                          [](const Vertex& v) { return v.color; });
    }
    const int view =
        add_view(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t), kElementBuffer);
    json_["accessors"].push_back({{"bufferView", view},
                                  {"componentType", kUnsignedInt},
                                  {"count", mesh.indices.size()},
                                  {"type", "SCALAR"}});
    const auto indices = static_cast<int>(json_["accessors"].size()) - 1;
    const Json primitive = {
        {"attributes", attributes}, {"indices", indices}, {"material", mesh.material}};
    json_["meshes"].push_back({{"name", mesh.name}, {"primitives", Json::array({primitive})}});
    nodes_.push_back({{"name", mesh.name}, {"mesh", json_["meshes"].size() - 1}});
}

Json GltfWriter::texture_use(TextureIndex index) {
    if (index < 0 || static_cast<std::size_t>(index) >= scene_.textures.size()) {
        throw base::bad_input("scene {}: texture {} of {}", scene_.name, index,
                              scene_.textures.size());
    }
    const auto known = textures_.find(index);
    if (known != textures_.end()) return {{"index", known->second}};
    const Texture& texture = scene_.textures[static_cast<std::size_t>(index)];
    const std::string png = encode_rgba_png(texture);
    const int view = add_view(png.data(), png.size(), 0);
    json_["images"].push_back(
        {{"name", texture.name}, {"mimeType", "image/png"}, {"bufferView", view}});
    if (!json_.contains("samplers")) {
        json_["samplers"].push_back(
            {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}});
    }
    json_["textures"].push_back({{"sampler", 0}, {"source", json_["images"].size() - 1}});
    const auto made = static_cast<int>(json_["textures"].size()) - 1;
    textures_.emplace(index, made);
    return {{"index", made}};
}

void GltfWriter::add_material(const Material& material) {
    Json pbr = {
        {"baseColorFactor",
         {material.albedo.r, material.albedo.g, material.albedo.b, material.opacity}},
        {"metallicFactor", 0.0},
        {"roughnessFactor", roughness_of_power(static_cast<double>(material.specular_power))}};
    if (material.roughness_texture != kNoTexture) {
        pbr["metallicFactor"] = material.metalness;
        pbr["roughnessFactor"] = material.roughness;
        pbr["metallicRoughnessTexture"] = texture_use(material.roughness_texture);
    }
    if (material.albedo_texture != kNoTexture) {
        pbr["baseColorTexture"] = texture_use(material.albedo_texture);
    }
    Json json = {{"name", material.name}, {"pbrMetallicRoughness", pbr}};
    if (material.normal_texture != kNoTexture) {
        json["normalTexture"] = texture_use(material.normal_texture);
    }
    if (material.occlusion_texture != kNoTexture) {
        json["occlusionTexture"] = texture_use(material.occlusion_texture);
        json["occlusionTexture"]["strength"] = material.occlusion_strength;
    }
    const float brightest =
        std::max({material.emissive.r, material.emissive.g, material.emissive.b});
    if (brightest > 0.0F) {
        const float strength = std::max(brightest, 1.0F);
        json["emissiveFactor"] = to_array(material.emissive / strength);
        if (material.emissive_texture != kNoTexture) {
            json["emissiveTexture"] = texture_use(material.emissive_texture);
        }
        if (strength > 1.0F) {
            json["extensions"]["KHR_materials_emissive_strength"] = {
                {"emissiveStrength", strength}};
            use_extension("KHR_materials_emissive_strength");
        }
    }
    if (material.double_sided) json["doubleSided"] = true;
    if (material.coverage == Coverage::kCutOut) {
        json["alphaMode"] = "MASK";
        json["alphaCutoff"] = material.alpha_cutoff;
    } else if (material.coverage == Coverage::kBlended) {
        json["alphaMode"] = "BLEND";
    }
    const auto reflectance = static_cast<double>(material.specular_intensity);
    if (std::abs(reflectance - 0.04) > 1e-6) {
        if (reflectance > 0.0) {
            json["extensions"]["KHR_materials_ior"] = {{"ior", ior_of_reflectance(reflectance)}};
            use_extension("KHR_materials_ior");
        } else {
            json["extensions"]["KHR_materials_specular"] = {{"specularFactor", 0.0}};
            use_extension("KHR_materials_specular");
        }
    }
    json_["materials"].push_back(std::move(json));
}

/// The sixteen numbers of a placement whose -Z axis looks along `direction`.
Json placement(const glm::vec3& position_m, const glm::vec3& direction, const glm::vec3& up) {
    // A direction that is one already stays as it is, to the bit.
    const double length = glm::length(glm::dvec3(direction));
    const glm::dvec3 z = glm::dvec3(direction) / (std::abs(length - 1.0) < 1e-6 ? -1.0 : -length);
    glm::dvec3 across = glm::cross(glm::dvec3(up), z);
    if (!(glm::length(across) > 1e-6)) across = glm::cross(glm::dvec3(0.0, 0.0, 1.0), z);
    if (!(glm::length(across) > 1e-6)) across = glm::cross(glm::dvec3(1.0, 0.0, 0.0), z);
    const glm::dvec3 x = glm::normalize(across);
    const glm::dvec3 y = glm::cross(z, x);
    Json matrix = Json::array();
    for (const glm::dvec3& column : {x, y, z}) {
        for (int i = 0; i < 3; ++i) matrix.push_back(column[i]);
        matrix.push_back(0.0);
    }
    for (int i = 0; i < 3; ++i) matrix.push_back(position_m[i]);
    matrix.push_back(1.0);
    return matrix;
}

void GltfWriter::add_camera(const Camera& camera) {
    json_["cameras"].push_back(
        {{"name", camera.name},
         {"type", "perspective"},
         {"perspective",
          {{"yfov", camera.vertical_fov_rad}, {"znear", camera.near_m}, {"zfar", camera.far_m}}}});
    nodes_.push_back(
        {{"name", camera.name},
         {"camera", json_["cameras"].size() - 1},
         {"matrix", placement(camera.position_m, camera.target_m - camera.position_m, camera.up)},
         {"extras",
          {{"obscura_target", to_array(camera.target_m)}, {"obscura_up", to_array(camera.up)}}}});
}

void GltfWriter::add_light_node(Json light, const glm::vec3& position_m,
                                const glm::vec3& direction) {
    const std::string name = fmt::format("light-{}", lights_.size() + 1);
    light["name"] = name;
    nodes_.push_back({{"name", name},
                      {"matrix", placement(position_m, direction, glm::vec3(0.0F, 1.0F, 0.0F))},
                      {"extensions", {{"KHR_lights_punctual", {{"light", lights_.size()}}}}}});
    lights_.push_back(std::move(light));
}

void GltfWriter::add_lights() {
    const auto colour_and_intensity = [](const glm::vec3& value) {
        const glm::dvec3 exact(value);  // so that the product is the value again
        const double brightest = std::max({exact.r, exact.g, exact.b, 1e-9});
        return Json{{"color", {exact.r / brightest, exact.g / brightest, exact.b / brightest}},
                    {"intensity", brightest}};
    };
    for (const DirectionalLight& sun : lighting_.lights) {
        Json light = colour_and_intensity(sun.irradiance);
        light["type"] = "directional";
        add_light_node(std::move(light), glm::vec3(0.0F), -sun.towards_light);
    }
    for (const PointLight& point : lighting_.point_lights) {
        Json light = colour_and_intensity(point.intensity);
        const bool spot = point.outer_cone_rad <= glm::half_pi<float>();
        light["type"] = spot ? "spot" : "point";
        if (std::isfinite(point.range_m)) light["range"] = point.range_m;
        if (spot) {
            light["spot"] = {
                {"innerConeAngle", std::min(point.inner_cone_rad, point.outer_cone_rad * 0.999F)},
                {"outerConeAngle", point.outer_cone_rad}};
        }
        add_light_node(std::move(light), point.position_m, point.direction);
    }
}

std::string GltfWriter::packed() {
    const auto append_word = [](std::string& bytes, std::size_t value) {
        const auto word = static_cast<std::uint32_t>(value);
        bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
    };
    std::string text = json_.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
    std::string glb = "glTF";
    glb.reserve(28 + text.size() + binary_.size());
    append_word(glb, 2);
    append_word(glb, 12 + 8 + text.size() + 8 + binary_.size());
    append_word(glb, text.size());
    glb += "JSON";
    glb += text;
    append_word(glb, binary_.size());
    glb.append("BIN\0", 4);
    glb += binary_;
    return glb;
}

std::string GltfWriter::run() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "Obscura " OBSCURA_VERSION}};
    json_["scene"] = 0;
    for (const Material& material : scene_.materials) add_material(material);
    for (const Mesh& mesh : scene_.meshes) add_mesh(mesh);
    if (!json_.contains("meshes")) {
        throw base::bad_input("scene {}: it holds no triangles", scene_.name);
    }
    for (const Camera& camera : scene_.cameras) add_camera(camera);
    add_lights();
    Json all = Json::array();
    for (std::size_t i = 0; i < nodes_.size(); ++i) all.push_back(i);
    json_["nodes"] = nodes_;
    json_["scenes"] = Json::array({{{"name", scene_.name}, {"nodes", all}}});
    if (!lights_.empty()) {
        json_["extensions"]["KHR_lights_punctual"] = {{"lights", lights_}};
        use_extension("KHR_lights_punctual");
    }
    if (!extensions_.empty()) json_["extensionsUsed"] = extensions_;
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
    json_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    return packed();
}

}  // namespace

std::string to_glb(const Scene& scene, const Lighting& lighting) {
    return GltfWriter(scene, lighting).run();
}

}  // namespace obscura::renderer
