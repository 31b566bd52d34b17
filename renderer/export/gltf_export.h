// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "renderer/light/lighting.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer {

/// A scene as the bytes of a binary glTF 2.0 file (.glb): meshes with normals, texture coordinates,
/// vertex colours where there are any, tangents where there is a normal map; materials; textures as
/// PNG inside the file; cameras by name; directional and point lights (KHR_lights_punctual, where
/// 1 lux stands for an irradiance of 1). The environment, constant ambient light and tone mapping
/// have no place in glTF and are left out.
///
/// Surfaces become metallic-roughness: with their texture of roughness and its factors, or else
/// with metallic 0 and the roughness of the Blinn-Phong power; the specular intensity as index of
/// refraction (KHR_materials_ior; renderer/scene/surface_conversion.h). Cameras keep their aim in
/// `extras`, so that import_scene gives the same views to the bit. The same scene gives the same
/// bytes. Throws bad input for an index out of range, a coordinate or normal that is not finite,
/// more than 4 GiB.
[[nodiscard]] std::string to_glb(const Scene& scene, const Lighting& lighting);

}  // namespace obscura::renderer
