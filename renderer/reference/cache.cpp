// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/reference/exr.h"
#include "renderer/reference/reference.h"

namespace obscura::renderer {
namespace {

namespace fs = std::filesystem;

/// Changes with every change of what trace() gives for the same inputs.
constexpr int kTraceVersion = 2;
constexpr const char* kPixels = "obscura:pixels_sha256";

/// Everything that trace() depends on, numbers in full precision.
std::string key_of(const ReferenceScene& scene, const Camera& camera, int width, int height,
                   const ReferenceOptions& options) {
    const glm::vec3& p = camera.position_m;
    const glm::vec3& t = camera.target_m;
    const glm::vec3& u = camera.up;
    return base::sha256_hex(fmt::format(
        "{} {} | {} {} {} {} {} {} {} {} {} {} {} {} {} {} | {}x{} | {} {} {} {} {}", kTraceVersion,
        scene.geometry_sha256(), p.x, p.y, p.z, t.x, t.y, t.z, u.x, u.y, u.z,
        camera.vertical_fov_rad, camera.near_m, camera.far_m, camera.lens_shift.x,
        camera.lens_shift.y, width, height, options.radius_m, options.rays, options.seed,
        static_cast<int>(options.falloff), static_cast<int>(options.normal)));
}

/// Of the pixels and what they are of, so that no other image is taken for this one.
std::string hash_of_pixels(const FloatImage& image, const std::string& key) {
    std::string all = fmt::format("{} {}x{}", key, image.width, image.height);
    for (const char* name : {"Z", "ao.Y", "ao.stderr"}) {
        const std::vector<float>* values = image.find(name);
        if (values == nullptr) throw base::bad_input("channel {} is missing", name);
        all += base::sha256_hex(
            {reinterpret_cast<const char*>(values->data()), values->size() * sizeof(float)});
    }
    return base::sha256_hex(all);
}

std::optional<ReferenceImage> read_kept(const fs::path& file, const std::string& key, int width,
                                        int height) {
    if (!fs::exists(file)) return std::nullopt;
    try {
        const FloatImage kept = decode_exr(base::read_file(file), file.string());
        const auto stored = kept.texts.find(kPixels);
        if (kept.width != width || kept.height != height || stored == kept.texts.end() ||
            stored->second != hash_of_pixels(kept, key)) {
            throw base::bad_input("its pixels are not those that were written");
        }
        return ReferenceImage{width, height, *kept.find("ao.Y"), *kept.find("ao.stderr"),
                              *kept.find("Z")};
    } catch (const std::exception& error) {
        base::log::warn("{} is damaged and is made again: {}", file.string(), error.what());
        return std::nullopt;
    }
}

}  // namespace

ReferenceImage cached_reference(const fs::path& folder, const ReferenceScene& scene,
                                const Camera& camera, int width, int height,
                                const ReferenceOptions& options,
                                const ReferenceProgress& progress) {
    check_options(options);
    const std::string key = key_of(scene, camera, width, height, options);
    const fs::path file = folder / (key + ".exr");
    if (std::optional<ReferenceImage> kept = read_kept(file, key, width, height)) return *kept;
    ReferenceImage made = scene.trace(camera, width, height, options, progress);
    FloatImage image;
    image.width = width;
    image.height = height;
    image.channels = {
        {"Z", made.depth_m}, {"ao.Y", made.accessibility}, {"ao.stderr", made.standard_error}};
    image.texts[kPixels] = hash_of_pixels(image, key);
    base::write_file_atomically(file, encode_exr(image));
    return made;
}

}  // namespace obscura::renderer
