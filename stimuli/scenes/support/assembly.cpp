// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/support/assembly.h"

#include <algorithm>

#include "stimuli/scenes/support/noise.h"
#include "stimuli/scenes/support/texture_maker.h"

namespace obscura::stimuli {

glm::vec2 add_finish(renderer::Scene& scene, const Finish& finish) {
    const float ratio = static_cast<float>(finish.height) / static_cast<float>(finish.width);
    const glm::vec2 size_m(finish.repeat_m, finish.repeat_m * ratio);
    const bool baked = finish.specular_power == kBaked;
    renderer::Material material;
    material.name = finish.name;
    material.specular_intensity = finish.specular_intensity;
    if (!baked) material.specular_power = finish.specular_power;
    material.double_sided = finish.double_sided;
    material.emissive = finish.emissive;
    if (finish.cut_out) material.coverage = renderer::Coverage::kCutOut;
    add_material(scene, std::move(material),
                 {finish.name, finish.width, finish.height, size_m, finish.at, baked});
    if (finish.emissive != glm::vec3(0.0F)) {
        renderer::Material& added = scene.materials.back();
        added.emissive_texture = added.albedo_texture;
    }
    return size_m;
}

Assembly::Assembly(std::string name, std::span<const Finish> finishes) {
    scene_.name = std::move(name);
    for (const Finish& finish : finishes) {
        size_m_.push_back(add_finish(scene_, finish));
        renderer::Mesh mesh;
        mesh.name = finish.name;
        mesh.material = static_cast<std::uint32_t>(scene_.materials.size() - 1);
        scene_.meshes.push_back(std::move(mesh));
    }
}

void Assembly::put_at(std::size_t surface, const renderer::Mesh& part, const glm::mat4& transform,
                      std::uint32_t seed, const glm::vec3& tint) {
    Placement placement;
    placement.transform = transform;
    placement.uv_scale = 1.0F / size_m_[surface];
    placement.uv_offset = {hash_unit(static_cast<int>(seed), 1, 0, 5),
                           hash_unit(static_cast<int>(seed), 2, 0, 5)};
    placement.tint = tint;
    append(scene_.meshes[surface], part, placement);
}

renderer::Scene Assembly::take() {
    std::erase_if(scene_.meshes, [](const renderer::Mesh& mesh) { return mesh.indices.empty(); });
    for_each_row(static_cast<int>(scene_.meshes.size()), [this](int i) {
        turn_normals_outwards(scene_.meshes[static_cast<std::size_t>(i)]);
    });
    return std::exchange(scene_, {});
}

renderer::Camera camera_at(std::string name, glm::vec3 position_m, glm::vec3 target_m,
                           float vertical_fov_deg, float far_m) {
    renderer::Camera camera;
    camera.name = std::move(name);
    camera.position_m = position_m;
    camera.target_m = target_m;
    camera.vertical_fov_rad = glm::radians(vertical_fov_deg);
    camera.near_m = 0.05F;
    camera.far_m = far_m;
    return camera;
}

}  // namespace obscura::stimuli
