// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

struct ImportOptions {
    double scale = 1.0;  ///< metres of one unit of the file, [1e-6, 1e6]; glTF's unit is 1 m
    /// Where files that the scene names may lie, beside its own folder.
    std::vector<std::filesystem::path> allowed_folders = {};
};

/// What an import may hold; a file that holds more is refused, a texture that does is replaced.
struct ImportLimits {
    static constexpr std::size_t kFileBytes = std::size_t{512} << 20U;  ///< of all files read
    static constexpr std::size_t kVertices = 8'000'000;                 ///< after instancing
    static constexpr std::size_t kTriangles = 16'000'000;               ///< after instancing
    static constexpr std::size_t kMaterials = 65'536;
    static constexpr std::size_t kTextureBytes = std::size_t{512} << 20U;  ///< 4 a texel
    static constexpr int kTextureSide = 16384;                             ///< texels
    static constexpr float kFarthest_m = 1e6F;  ///< largest coordinate, metres
};

/// A file that was read, as it was then.
struct ImportedFile {
    std::filesystem::path path;
    std::string sha256;  ///< of its bytes
};

/// A scene from a file. Whatever the file holds and the renderer cannot show, or shows otherwise,
/// is in `notes`, a sentence each.
struct ImportedScene {
    Scene scene;  ///< with at least one triangle and one camera
    std::vector<DirectionalLight> lights;
    std::vector<PointLight> point_lights;
    std::vector<std::string> notes;
    bool has_sides = true;  ///< whether the format can say that a surface has one side only
    std::vector<ImportedFile> files;  ///< the file itself, then its buffers, materials and textures
};

/// The name of the camera that is added when a file has none: it frames everything.
inline constexpr std::string_view kOverviewCamera = "overview";

/// Reads a glTF 2.0 (.gltf, .glb) or Wavefront OBJ (.obj) file with the files it names: triangles
/// in the world with their node's transform, skinned meshes in the pose of the file's nodes,
/// missing normals and tangents made. Throws bad input naming the file, the place in it, the value
/// met and what is allowed; a texture that cannot be read becomes a checkerboard with a note.
/// A file outside the scene's folder and the allowed ones counts as one that cannot be read: what
/// somebody else made must not read this user's other files.
[[nodiscard]] ImportedScene import_scene(const std::filesystem::path& file,
                                         const ImportOptions& options = {});

/// Whether the name ends as those of the files that import_scene reads.
[[nodiscard]] bool is_scene_file(std::string_view name);

/// A camera named kOverviewCamera that shows all of the scene, from the front, right and above.
[[nodiscard]] Camera overview_camera(const Scene& scene);

}  // namespace obscura::renderer
