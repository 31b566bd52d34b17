// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/scenes/inspect.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "renderer/frame/plan.h"
#include "renderer/light/shadow.h"
#include "renderer/scene/surface_conversion.h"
#include "stimuli/scenes/backs.h"

namespace obscura::stimuli {
namespace {

using renderer::Coverage;
using renderer::kNoTexture;
using renderer::Material;
using renderer::Scene;

std::string vector_text(const glm::vec3& v) { return fmt::format("{:g} {:g} {:g}", v.x, v.y, v.z); }

/// Bytes as people say them.
std::string bytes_text(std::size_t bytes) {
    if (bytes < 10000) return fmt::format("{} bytes", bytes);
    const double kibibytes = static_cast<double>(bytes) / 1024.0;
    if (kibibytes < 10000.0) return fmt::format("{:.0f} KiB", kibibytes);
    return fmt::format("{:.1f} MiB", kibibytes / 1024.0);
}

std::size_t vertex_count(const Scene& scene) {
    std::size_t count = 0;
    for (const renderer::Mesh& mesh : scene.meshes) count += mesh.vertices.size();
    return count;
}

/// What the surfaces of a scene ask for, in words.
std::vector<std::string> asked_of_renderer(const Scene& scene) {
    const auto any = [&scene](auto holds) {
        return std::any_of(scene.materials.begin(), scene.materials.end(), holds);
    };
    std::vector<std::string> asked;
    const auto add = [&asked](bool there, const char* what) {
        if (there) asked.emplace_back(what);
    };
    add(any([](const Material& m) { return m.albedo_texture != kNoTexture; }), "albedo textures");
    add(any([](const Material& m) { return m.normal_texture != kNoTexture; }), "normal maps");
    add(any([](const Material& m) { return m.specular_intensity > 0.0F; }), "highlights");
    add(any([](const Material& m) { return m.roughness_texture != kNoTexture; }),
        "roughness textures");
    add(any([](const Material& m) { return m.coverage == Coverage::kCutOut; }), "cut-outs");
    add(any([](const Material& m) { return m.coverage == Coverage::kBlended; }),
        "blended surfaces");
    add(any([](const Material& m) { return m.emissive != glm::vec3(0.0F); }), "emission");
    add(any([](const Material& m) { return m.occlusion_texture != kNoTexture; }),
        "baked occlusion");
    add(any([](const Material& m) { return m.double_sided; }), "double-sided surfaces");
    if (asked.empty()) asked.emplace_back("plain surfaces");
    return asked;
}

std::vector<std::string> names_of_cameras(const Scene& scene) {
    std::vector<std::string> names;
    for (const renderer::Camera& camera : scene.cameras) names.push_back(camera.name);
    return names;
}

std::vector<std::string> names_of_levels(const OpenedScene& scene) {
    std::vector<std::string> names;
    for (const Validity level : scene.levels) names.emplace_back(to_string(level));
    return names;
}

std::string material_line(const Scene& scene, const Material& material) {
    std::string line = fmt::format("  {}: albedo {}", material.name, vector_text(material.albedo));
    const auto texture = [&](const char* what, renderer::TextureIndex index) {
        if (index == kNoTexture) return;
        line += fmt::format(", {} {}", what, scene.textures[static_cast<std::size_t>(index)].name);
    };
    texture("albedo texture", material.albedo_texture);
    texture("normal map", material.normal_texture);
    texture("roughness texture", material.roughness_texture);
    if (material.specular_intensity > 0.0F) {
        line += fmt::format(", highlight {:.3g}", material.specular_intensity);
        if (material.roughness_texture == kNoTexture) {
            line += fmt::format(" of power {:.3g}", material.specular_power);
        }
    }
    if (material.coverage == Coverage::kCutOut) {
        line += fmt::format(", cut out below alpha {:g}", material.alpha_cutoff);
    }
    if (material.coverage == Coverage::kBlended) {
        line += fmt::format(", blended, opacity {:g}", material.opacity);
    }
    if (material.emissive != glm::vec3(0.0F)) {
        line += fmt::format(", emits {}", vector_text(material.emissive));
        texture("times", material.emissive_texture);
    }
    texture("baked occlusion", material.occlusion_texture);
    if (material.double_sided) line += ", double-sided";
    return line + '\n';
}

std::string surfaces_text(const Scene& scene) {
    std::string text = fmt::format("materials: {}\n", scene.materials.size());
    for (const Material& material : scene.materials) text += material_line(scene, material);
    std::size_t sum = 0;
    for (const renderer::Texture& texture : scene.textures) sum += texture.rgba.size();
    text += fmt::format("textures: {}, {}, a third more with smaller levels on the GPU\n",
                        scene.textures.size(), bytes_text(sum));
    for (const renderer::Texture& texture : scene.textures) {
        text += fmt::format("  {}: {}x{}, {}\n", texture.name, texture.width, texture.height,
                            texture.srgb ? "colour (sRGB)" : "data (linear)");
    }
    return text;
}

std::string cameras_text(const Scene& scene) {
    std::string text = fmt::format("cameras: {}\n", scene.cameras.size());
    for (const renderer::Camera& camera : scene.cameras) {
        text +=
            fmt::format("  {}: at {} m, to {} m, {:.3g} degrees high, {:.3g} to {:.4g} m\n",
                        camera.name, vector_text(camera.position_m), vector_text(camera.target_m),
                        glm::degrees(camera.vertical_fov_rad), camera.near_m, camera.far_m);
    }
    return text;
}

std::string light_text(const renderer::Lighting& light) {
    std::vector<std::string> parts;
    if (light.environment) {
        parts.push_back(fmt::format("environment {} {}x{}", light.environment->name,
                                    light.environment->width, light.environment->height));
    } else {
        parts.push_back(fmt::format("ambient {}", vector_text(light.ambient)));
    }
    for (const renderer::DirectionalLight& sun : light.lights) {
        parts.push_back(fmt::format("directional light of irradiance {} from {}",
                                    vector_text(sun.irradiance), vector_text(sun.towards_light)));
    }
    for (const renderer::PointLight& point : light.point_lights) {
        parts.push_back(fmt::format("{} light of {} at {} m",
                                    point.outer_cone_rad < glm::pi<float>() ? "spot" : "point",
                                    vector_text(point.intensity), vector_text(point.position_m)));
    }
    if (light.tone_mapping) {
        parts.push_back(fmt::format("{} curve, exposure {:g}, white {:g}",
                                    to_string(light.tone_mapping->curve),
                                    light.tone_mapping->exposure, light.tone_mapping->white));
    }
    return fmt::format("{}", fmt::join(parts, "; "));
}

std::string level_text(const OpenedScene& scene, Validity level, const renderer::Variant& choice,
                       int width, int height) {
    const renderer::Lighting light = scene.lighting(level);
    const renderer::FramePlan plan =
        renderer::plan_frame(renderer::needs_of(*scene.scene, light), choice, width, height);
    std::string text = fmt::format("level {}: {}\n", to_string(level), light_text(light));
    std::vector<std::string> passes;
    for (const renderer::PlannedPass& pass : plan.passes) {
        if (passes.empty() || passes.back() != pass.name) passes.push_back(pass.name);
    }
    text +=
        fmt::format("  passes: {}\n  buffers of a {}x{} image with {}: {} bytes\n",
                    fmt::join(passes, ", "), width, height, choice.variant_name(), plan.bytes());
    for (const renderer::PlannedTarget& target : plan.targets) {
        text += fmt::format("    {:16} {:10} bytes  {} {}x{}{}\n", target.name, target.bytes,
                            target.format, target.width, target.height,
                            target.layers > 1 ? fmt::format("x{}", target.layers) : "");
    }
    for (const renderer::LeftOut& left_out : plan.left_out) {
        text += fmt::format("    without {}: {}\n", left_out.what, left_out.why);
    }
    return text;
}

}  // namespace

std::string summary_of(const OpenedScene& scene) {
    return fmt::format(
        "{}: {}\n  {} triangles; cameras {}; levels {}; needs {}\n", scene.id, scene.title,
        scene.scene->triangle_count(), fmt::join(names_of_cameras(*scene.scene), ", "),
        fmt::join(names_of_levels(scene), ", "), fmt::join(asked_of_renderer(*scene.scene), ", "));
}

std::vector<std::string> notes_on(const OpenedScene& scene) {
    std::vector<std::string> notes = scene.notes;
    if (const std::string backs = note_on_backs(scene, scene.scene->cameras); !backs.empty()) {
        notes.push_back(backs);
    }
    return notes;
}

std::string overview_of(const OpenedScene& scene) {
    const Scene& content = *scene.scene;
    const renderer::Bounds bounds = renderer::bounds_of(content);
    const glm::vec3 size = bounds.high_m - bounds.low_m;
    std::string text = fmt::format(
        "{}: {}\nsize: {:.3g} x {:.3g} x {:.3g} m, from {} to {} m\ncameras:\n", scene.id,
        scene.title, size.x, size.y, size.z, vector_text(bounds.low_m), vector_text(bounds.high_m));
    for (const renderer::Camera& camera : content.cameras) {
        const std::string line = fmt::format("camera = \"{}\"", camera.name);
        text += fmt::format("  {:24} # {}at {} m, to {} m\n", line,
                            scene.has_own_camera() ? "" : "the file has none; frames everything, ",
                            vector_text(camera.position_m), vector_text(camera.target_m));
    }
    text += fmt::format("levels: {}\ntriangles: {}\n", fmt::join(names_of_levels(scene), ", "),
                        content.triangle_count());
    const std::vector<std::string> notes = notes_on(scene);
    text += fmt::format("notes: {}\n", notes.empty() ? "none" : "");
    for (const std::string& note : notes) text += fmt::format("  {}\n", note);
    return text;
}

std::string inspection_of(const OpenedScene& scene, const renderer::Variant& choice, int width,
                          int height) {
    const Scene& content = *scene.scene;
    const renderer::Bounds bounds = renderer::bounds_of(content);
    std::string text = fmt::format("{}: {}\n", scene.id, scene.title);
    text += fmt::format("triangles: {} in {} meshes; {} vertices, {} on the GPU\n",
                        content.triangle_count(), content.meshes.size(), vertex_count(content),
                        bytes_text(vertex_count(content) * sizeof(renderer::Vertex) +
                                   content.triangle_count() * 3 * sizeof(std::uint32_t)));
    text += fmt::format("bounds: {} to {} m, which is {} m\n", vector_text(bounds.low_m),
                        vector_text(bounds.high_m), vector_text(bounds.high_m - bounds.low_m));
    text += surfaces_text(content) + cameras_text(content);
    const std::vector<std::string> notes = notes_on(scene);
    text += fmt::format("notes: {}\n", notes.empty() ? "none" : "");
    for (const std::string& note : notes) text += fmt::format("  {}\n", note);
    if (!scene.files.empty()) text += fmt::format("files: {}\n", scene.files.size());
    for (const renderer::ImportedFile& file : scene.files) {
        text += fmt::format("  {} (SHA-256 {})\n", file.path.string(), file.sha256);
    }
    for (const Validity level : scene.levels) {
        text += level_text(scene, level, choice, width, height);
    }
    return text;
}

}  // namespace obscura::stimuli
