// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/gltf_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace obscura::renderer::import_detail {
namespace {

/// The attributes of one primitive.
class PrimitiveReader {
  public:
    PrimitiveReader(const GltfFile& file, const JsonCursor& primitive, GltfMaterials& materials,
                    MeshBudget& budget, Notes& notes)
        : file_(file),
          primitive_(primitive),
          attributes_(primitive.at("attributes")),
          materials_(materials),
          budget_(budget),
          notes_(notes) {}

    std::optional<GltfPrimitive> read(const std::vector<double>& morph_weights);

  private:
    [[nodiscard]] const GltfAccessor* accessor(const JsonCursor& owner, const char* key,
                                               std::initializer_list<int> components) const;
    void read_positions();
    void read_indices(int mode);
    void read_normals_and_tangents();
    void read_uv(const UvMapping& mapping);
    void read_colours();
    void read_skin();
    void apply_morph_targets(const std::vector<double>& weights);
    [[nodiscard]] std::vector<std::uint32_t> index_list() const;

    const GltfFile& file_;
    const JsonCursor& primitive_;
    JsonCursor attributes_;
    GltfMaterials& materials_;
    MeshBudget& budget_;
    Notes& notes_;
    GltfPrimitive result_;
};

const GltfAccessor* PrimitiveReader::accessor(const JsonCursor& owner, const char* key,
                                              std::initializer_list<int> components) const {
    const auto index = owner.index(key, file_.accessors().size(), "accessors");
    if (!index) return nullptr;
    const GltfAccessor& found = file_.accessors()[*index];
    if (found.is_matrix ||
        std::find(components.begin(), components.end(), found.components) == components.end()) {
        owner.at(key).fail(fmt::format("its accessor has {} components, allowed are {}",
                                       found.components, fmt::join(components, " and ")));
    }
    const std::size_t vertices = result_.mesh.vertices.size();
    if (vertices != 0 && found.count != vertices) {
        owner.at(key).fail(fmt::format("has {} elements, POSITION has {}", found.count, vertices));
    }
    return &found;
}

void PrimitiveReader::read_positions() {
    const GltfAccessor* positions = accessor(attributes_, "POSITION", {3});
    if (positions == nullptr) attributes_.fail("POSITION is missing");
    if (positions->count > budget_.vertices) {
        primitive_.fail(fmt::format("the scene has more than the {} vertices allowed",
                                    ImportLimits::kVertices));
    }
    budget_.vertices -= positions->count;
    const std::vector<float> values = file_.floats(*positions);
    result_.mesh.vertices.resize(positions->count);
    for (std::size_t i = 0; i < positions->count; ++i) {
        const glm::vec3 p(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
            attributes_.at("POSITION")
                .fail(fmt::format("vertex {} lies at ({}, {}, {}), allowed are finite numbers", i,
                                  p.x, p.y, p.z));
        }
        result_.mesh.vertices[i].position_m = p;
    }
}

std::vector<std::uint32_t> PrimitiveReader::index_list() const {
    const std::size_t vertices = result_.mesh.vertices.size();
    const auto index = primitive_.index("indices", file_.accessors().size(), "accessors");
    std::vector<std::uint32_t> list;
    if (!index) {
        list.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i) list[i] = static_cast<std::uint32_t>(i);
        return list;
    }
    const JsonCursor place = primitive_.at("indices");
    const GltfAccessor& indices = file_.accessors()[*index];
    if (indices.components != 1) place.fail("allowed is an accessor of type SCALAR");
    if (indices.count > 3 * ImportLimits::kTriangles) {
        place.fail(fmt::format("has {} elements, allowed are {} triangles", indices.count,
                               ImportLimits::kTriangles));
    }
    list = file_.integers(indices, place.place());
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] >= vertices) {
            place.fail(fmt::format("index {} is {}, allowed is 0 to {}: there are {} vertices", i,
                                   list[i], vertices - 1, vertices));
        }
    }
    return list;
}

/// Triangles out of a list (mode 4), strip (5) or fan (6).
void PrimitiveReader::read_indices(int mode) {
    std::vector<std::uint32_t> list = index_list();
    if (mode == 4) {
        if (list.size() % 3 != 0) {
            notes_.add("corners left over after the last whole triangle are left out",
                       result_.mesh.name);
            list.resize(list.size() / 3 * 3);
        }
        result_.mesh.indices = std::move(list);
    } else {
        for (std::size_t i = 2; i < list.size(); ++i) {
            const bool odd = i % 2 == 1;
            const std::uint32_t first = mode == 6 ? list[0] : list[odd ? i - 1 : i - 2];
            const std::uint32_t second = mode == 6 ? list[i - 1] : list[odd ? i - 2 : i - 1];
            result_.mesh.indices.insert(result_.mesh.indices.end(), {first, second, list[i]});
        }
    }
    const std::size_t triangles = result_.mesh.indices.size() / 3;
    if (triangles > budget_.triangles) {
        primitive_.fail(fmt::format("the scene has more than the {} triangles allowed",
                                    ImportLimits::kTriangles));
    }
    budget_.triangles -= triangles;
}

void PrimitiveReader::read_normals_and_tangents() {
    const GltfAccessor* normals = accessor(attributes_, "NORMAL", {3});
    if (normals == nullptr) return;
    result_.has_normals = true;
    const std::vector<float> n = file_.floats(*normals);
    for (std::size_t i = 0; i < normals->count; ++i) {
        result_.mesh.vertices[i].normal = {n[3 * i], n[3 * i + 1], n[3 * i + 2]};
    }
    const GltfAccessor* tangents = accessor(attributes_, "TANGENT", {4});
    if (tangents == nullptr) return;
    result_.has_tangents = true;
    const std::vector<float> t = file_.floats(*tangents);
    for (std::size_t i = 0; i < tangents->count; ++i) {
        const glm::vec4 tangent(t[4 * i], t[4 * i + 1], t[4 * i + 2], t[4 * i + 3]);
        const float length = glm::length(glm::vec3(tangent));
        if (!std::isfinite(length) || !(length > 1e-6F)) {
            result_.has_tangents = false;
            notes_.add("tangents that are no directions are made anew", result_.mesh.name);
            return;
        }
        result_.mesh.vertices[i].tangent = {glm::vec3(tangent), tangent.w < 0.0F ? -1.0F : 1.0F};
    }
}

void PrimitiveReader::read_uv(const UvMapping& mapping) {
    const GltfAccessor* uv =
        accessor(attributes_, fmt::format("TEXCOORD_{}", mapping.set).c_str(), {2});
    const Mesh& mesh = result_.mesh;
    const Material& material = materials_.material(mesh.material);
    if (uv == nullptr) {
        if (material.albedo_texture != kNoTexture || material.normal_texture != kNoTexture ||
            material.roughness_texture != kNoTexture) {
            notes_.add("meshes without the texture coordinates that their material asks for",
                       mesh.name);
        }
        return;
    }
    const std::vector<float> values = file_.floats(*uv);
    for (std::size_t i = 0; i < uv->count; ++i) {
        const glm::vec2 mapped = mapping.apply({values[2 * i], values[2 * i + 1]});
        const bool usable = std::abs(mapped.x) < 1e6F && std::abs(mapped.y) < 1e6F;  // no NaN
        if (!usable) {
            notes_.add("texture coordinates that are not finite or beyond a million are zero",
                       mesh.name);
        }
        result_.mesh.vertices[i].uv = usable ? mapped : glm::vec2(0.0F);
    }
}

void PrimitiveReader::read_colours() {
    const GltfAccessor* colours = accessor(attributes_, "COLOR_0", {3, 4});
    if (colours == nullptr) return;
    const std::vector<float> values = file_.floats(*colours);
    const auto stride = static_cast<std::size_t>(colours->components);
    for (std::size_t i = 0; i < colours->count; ++i) {
        glm::u8vec4& colour = result_.mesh.vertices[i].color;
        for (std::size_t c = 0; c < stride; ++c) {
            const float value = values[stride * i + c];
            const float limited = value > 0.0F ? std::min(value, 1.0F) : 0.0F;  // NaN: 0
            colour[static_cast<int>(c)] = static_cast<std::uint8_t>(limited * 255.0F + 0.5F);
        }
    }
}

void PrimitiveReader::read_skin() {
    const GltfAccessor* joints = accessor(attributes_, "JOINTS_0", {4});
    const GltfAccessor* weights = accessor(attributes_, "WEIGHTS_0", {4});
    if (joints == nullptr || weights == nullptr) return;
    if (attributes_.find("JOINTS_1")) {
        notes_.add("more than four joints at a vertex: the first four are used", result_.mesh.name);
    }
    const std::vector<std::uint32_t> j =
        file_.integers(*joints, attributes_.at("JOINTS_0").place());
    const std::vector<float> w = file_.floats(*weights);
    SkinWeights& skin = result_.skin.emplace();
    for (std::size_t i = 0; i < joints->count; ++i) {
        skin.joints.push_back({j[4 * i], j[4 * i + 1], j[4 * i + 2], j[4 * i + 3]});
        glm::vec4 weight(w[4 * i], w[4 * i + 1], w[4 * i + 2], w[4 * i + 3]);
        const float sum = weight.x + weight.y + weight.z + weight.w;
        if (!std::isfinite(sum) || !(sum > 1e-6F)) {
            notes_.add("vertices whose joint weights are no shares stay where they are",
                       result_.mesh.name);
            weight = glm::vec4(0.0F);
        } else if (std::abs(sum - 1.0F) > 1e-5F) {
            weight /= sum;
        }
        skin.weights.push_back(weight);
    }
}

void PrimitiveReader::apply_morph_targets(const std::vector<double>& weights) {
    const std::size_t targets = primitive_.count("targets");
    for (std::size_t t = 0; t < std::min(targets, weights.size()); ++t) {
        if (weights[t] == 0.0) continue;
        const std::size_t vertices = result_.mesh.vertices.size();
        if (vertices > budget_.morph_work) primitive_.fail("too many morph targets in use");
        budget_.morph_work -= vertices;
        const JsonCursor target = primitive_.at("targets").item(t);
        const auto weight = static_cast<float>(weights[t]);
        const auto add = [&](const char* key, glm::vec3 Vertex::*member) {
            const GltfAccessor* moved = accessor(target, key, {3});
            if (moved == nullptr) return;
            const std::vector<float> d = file_.floats(*moved);
            for (std::size_t i = 0; i < vertices; ++i) {
                result_.mesh.vertices[i].*member +=
                    weight * glm::vec3(d[3 * i], d[3 * i + 1], d[3 * i + 2]);
            }
        };
        add("POSITION", &Vertex::position_m);
        add("NORMAL", &Vertex::normal);
    }
}

std::optional<GltfPrimitive> PrimitiveReader::read(const std::vector<double>& morph_weights) {
    const auto mode = static_cast<int>(primitive_.integer("mode", 4, 0, 6));
    if (mode < 4) {
        notes_.add("points and lines are left out", primitive_.place());
        return std::nullopt;
    }
    const GltfAccessor* positions = accessor(attributes_, "POSITION", {3});
    if (positions != nullptr && !positions->view && !positions->sparse) {
        notes_.add("geometry is left out: the file has no positions of it, or only compressed ones",
                   primitive_.place());
        return std::nullopt;
    }
    const std::size_t materials = file_.root().count("materials");
    const auto material = primitive_.index("material", materials, "materials");
    result_.mesh.material =
        material ? static_cast<std::uint32_t>(*material) : materials_.standard();
    result_.mesh.name = primitive_.place();
    read_positions();
    read_indices(mode);
    read_normals_and_tangents();
    read_uv(materials_.mapping(result_.mesh.material));
    read_colours();
    read_skin();
    apply_morph_targets(morph_weights);
    if (result_.mesh.indices.empty()) return std::nullopt;
    return std::move(result_);
}

}  // namespace

std::optional<GltfPrimitive> read_primitive(const GltfFile& file, const JsonCursor& primitive,
                                            const std::vector<double>& morph_weights,
                                            GltfMaterials& materials, MeshBudget& budget,
                                            Notes& notes) {
    return PrimitiveReader(file, primitive, materials, budget, notes).read(morph_weights);
}

}  // namespace obscura::renderer::import_detail
