// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <charconv>
#include <cmath>

#include "renderer/base/error.h"
#include "renderer/import/gltf_import.h"
#include "renderer/import/json_cursor.h"
#include "renderer/import/mesh_finish.h"
#include "renderer/import/mtl.h"
#include "renderer/import/obj_check.h"

namespace obscura::renderer::import_detail {
namespace {

constexpr float kCreaseAngle_deg = 60.0F;  // edges sharper than this stay sharp

std::uint8_t code_of(float value) {
    const float limited = value > 0.0F ? std::min(value, 1.0F) : 0.0F;
    return static_cast<std::uint8_t>(limited * 255.0F + 0.5F);
}

/// A mesh of the library as ours; OBJ counts v from the image's lower border.
Mesh converted(const aiMesh& source, double scale) {
    Mesh mesh;
    mesh.name = one_line(source.mName.C_Str());
    mesh.vertices.resize(source.mNumVertices);
    for (unsigned i = 0; i < source.mNumVertices; ++i) {
        Vertex& vertex = mesh.vertices[i];
        const aiVector3D& p = source.mVertices[i];
        vertex.position_m = glm::vec3(glm::dvec3(p.x, p.y, p.z) * scale);
        if (source.HasNormals()) {
            const aiVector3D& n = source.mNormals[i];
            vertex.normal = {n.x, n.y, n.z};
        }
        if (source.HasTextureCoords(0)) {
            const aiVector3D& uv = source.mTextureCoords[0][i];
            const bool usable = std::abs(uv.x) < 1e6F && std::abs(uv.y) < 1e6F;
            vertex.uv = usable ? glm::vec2(uv.x, 1.0F - uv.y) : glm::vec2(0.0F);
        }
        if (source.HasVertexColors(0)) {
            const aiColor4D& c = source.mColors[0][i];
            vertex.color = {code_of(c.r), code_of(c.g), code_of(c.b), 255};
        }
    }
    for (unsigned f = 0; f < source.mNumFaces; ++f) {
        const aiFace& face = source.mFaces[f];
        if (face.mNumIndices != 3) continue;
        mesh.indices.insert(mesh.indices.end(), face.mIndices, face.mIndices + 3);
    }
    return mesh;
}

/// The file's name of a material; empty where a face has none.
std::string name_of_material(std::string_view called, const CheckedObj& checked) {
    std::size_t number = 0;
    if (!called.starts_with('m')) return "";
    const char* end = called.data() + called.size();
    const auto [rest, error] = std::from_chars(called.data() + 1, end, number);
    const bool known = error == std::errc() && rest == end && number < checked.materials.size();
    return known ? checked.materials[number] : "";
}

}  // namespace

ImportedScene import_obj(std::string_view text, const std::string& name,
                         const ImportOptions& options, FilesRead& files, Notes& notes) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
        throw base::bad_input("{}: it is text in UTF-16, wanted is UTF-8 or Latin-1", name);
    }
    const CheckedObj checked = check_obj(text, name, notes);
    ImportedScene imported;
    imported.has_sides = false;
    MtlReader materials(files, notes, imported.scene);
    for (const std::string& library : checked.libraries) materials.read(library);

    Assimp::Importer importer;
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCreaseAngle_deg);
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const unsigned steps = aiProcess_Triangulate | aiProcess_GenSmoothNormals |
                           aiProcess_JoinIdenticalVertices | aiProcess_SortByPType;
    const aiScene* scene =
        importer.ReadFileFromMemory(checked.text.data(), checked.text.size(), steps, "obj");
    if (scene == nullptr) {
        throw base::bad_input("{}: {}", name, one_line(importer.GetErrorString()));
    }
    if (checked.faces_without_normals > 0) {
        notes.add(fmt::format("faces without normals get smooth ones, sharp at edges above {} "
                              "degrees",
                              kCreaseAngle_deg),
                  fmt::format("{} of {}", checked.faces_without_normals, checked.faces));
    }
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        const aiMesh& source = *scene->mMeshes[i];
        Mesh mesh = converted(source, options.scale);
        if (mesh.indices.empty()) continue;
        const std::string called = source.mMaterialIndex < scene->mNumMaterials
                                       ? scene->mMaterials[source.mMaterialIndex]->GetName().C_Str()
                                       : "";
        mesh.material = materials.material(name_of_material(called, checked));
        (void)mend_normals(mesh);  // what the library makes of faces without area
        if (const std::size_t turned = turn_to_normals(mesh); turned > 0) {
            notes.add("triangles whose corners go round against their normals are turned over",
                      fmt::format("{} of {} in {}", turned, mesh.indices.size() / 3, mesh.name));
        }
        if (imported.scene.materials[mesh.material].normal_texture != kNoTexture) {
            make_tangents(mesh);
        }
        imported.scene.meshes.push_back(std::move(mesh));
    }
    return imported;
}

}  // namespace obscura::renderer::import_detail
