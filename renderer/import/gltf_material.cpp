// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/gltf_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/scene/surface_conversion.h"

namespace obscura::renderer::import_detail {
namespace {

std::optional<Texture> texels_of(std::optional<DecodedImage> image) {
    if (!image) return std::nullopt;
    return std::move(image->texture);
}

glm::vec3 clamped(const std::vector<double>& rgb) {
    return glm::clamp(glm::vec3(rgb[0], rgb[1], rgb[2]), 0.0F, 1.0F);
}

}  // namespace

glm::vec2 UvMapping::apply(const glm::vec2& uv) const {
    if (*this == UvMapping{.set = set}) return uv;
    const glm::dvec2 scaled = scale * glm::dvec2(uv);
    const double c = std::cos(rotation_rad);
    const double s = std::sin(rotation_rad);
    return {c * scaled.x + s * scaled.y + offset.x, -s * scaled.x + c * scaled.y + offset.y};
}

/// A material on its way from glTF to the G-buffer.
struct GltfMaterials::Surface {
    Material material;
    std::optional<UvMapping> mapping;  ///< of the first texture
    std::optional<Use> base_texture;
    std::optional<Use> metallic_roughness;
    double metallic = 1.0;
    double roughness = 1.0;
    double reflectance = 0.04;  ///< of the part that is no metal
};

GltfMaterials::GltfMaterials(const GltfFile& file, FilesRead& files, Notes& notes, Scene& scene)
    : file_(file), files_(files), notes_(notes), scene_(scene) {}

void GltfMaterials::read() {
    const JsonCursor root = file_.root();
    const std::size_t count = root.count("materials");
    if (count > ImportLimits::kMaterials) {
        root.at("materials")
            .fail(fmt::format("has {} elements, allowed are {}", count, ImportLimits::kMaterials));
    }
    std::vector<Surface> surfaces;
    for (std::size_t i = 0; i < count; ++i) {
        const JsonCursor cursor = root.at("materials").item(i);
        surfaces.push_back(read_surface(cursor, cursor.name(fmt::format("material-{}", i))));
    }
    // Roughness last: where memory for textures ends, it is what is missed least.
    for (Surface& surface : surfaces) add(surface);
}

std::uint32_t GltfMaterials::standard() {
    if (!standard_) {
        static const nlohmann::json kEmpty = nlohmann::json::object();
        standard_ = static_cast<std::uint32_t>(scene_.materials.size());
        Surface surface =
            read_surface(JsonCursor(kEmpty, "the standard material", file_.name()), "standard");
        add(surface);
    }
    return *standard_;
}

std::optional<GltfMaterials::Use> GltfMaterials::find_use(const std::optional<JsonCursor>& owner,
                                                          const char* key) const {
    if (!owner) return std::nullopt;
    const auto info = owner->find(key);
    if (!info) return std::nullopt;
    Use use{*info, 0, {}};
    use.texture = info->at("index").index(file_.root().count("textures"), "textures");
    use.mapping.set = static_cast<int>(info->integer("texCoord", 0, 0, 255));
    const auto extensions = info->find("extensions");
    const auto transform = extensions ? extensions->find("KHR_texture_transform") : std::nullopt;
    if (transform) {
        const auto offset = transform->numbers("offset", {0.0, 0.0});
        const auto scale = transform->numbers("scale", {1.0, 1.0});
        use.mapping.offset = {offset[0], offset[1]};
        use.mapping.scale = {scale[0], scale[1]};
        use.mapping.rotation_rad = transform->number("rotation", 0.0);
        use.mapping.set = static_cast<int>(transform->integer("texCoord", use.mapping.set, 0, 255));
    }
    return use;
}

GltfMaterials::Surface GltfMaterials::read_surface(const JsonCursor& cursor,
                                                   const std::string& name) {
    Surface surface;
    surface.material.name = name;
    surface.material.double_sided = cursor.truth("doubleSided", false);
    read_metallic_roughness(cursor, surface);
    read_extensions(cursor, surface);
    read_coverage(cursor, surface.material);
    read_textures(cursor, surface);
    return surface;
}

void GltfMaterials::add(Surface& surface) {
    read_roughness(surface);
    Material& material = surface.material;
    // With a texture the shader mixes in the metal, texel by texel.
    const bool textured = material.roughness_texture != kNoTexture;
    const float metal = luminance(material.albedo) * static_cast<float>(1.0 - surface.roughness);
    const float metalness = textured ? 0.0F : static_cast<float>(surface.metallic);
    material.specular_intensity =
        std::clamp(glm::mix(static_cast<float>(surface.reflectance), metal, metalness), 0.0F, 1.0F);
    material.specular_power = blinn_phong_power(surface.roughness);
    if (surface.metallic >= 0.25) {
        notes_.add(
            "metals are approximated: their base colour in even light, and highlights, but no "
            "reflections",
            material.name);
    }
    scene_.materials.push_back(material);
    mappings_.push_back(surface.mapping.value_or(UvMapping{}));
}

void GltfMaterials::read_metallic_roughness(const JsonCursor& cursor, Surface& surface) {
    std::vector<double> base{1.0, 1.0, 1.0, 1.0};
    if (const auto pbr = cursor.find("pbrMetallicRoughness")) {
        base = pbr->numbers("baseColorFactor", base);
        surface.metallic = pbr->number("metallicFactor", 1.0, 0.0, 1.0);
        surface.roughness = pbr->number("roughnessFactor", 1.0, 0.0, 1.0);
        surface.base_texture = find_use(pbr, "baseColorTexture");
        surface.metallic_roughness = find_use(pbr, "metallicRoughnessTexture");
    }
    surface.material.albedo = clamped(base);
    surface.material.opacity = static_cast<float>(std::clamp(base[3], 0.0, 1.0));
}

void GltfMaterials::read_specular_glossiness(const JsonCursor& extension, Surface& surface) {
    const auto diffuse = extension.numbers("diffuseFactor", {1.0, 1.0, 1.0, 1.0});
    const auto specular = extension.numbers("specularFactor", {1.0, 1.0, 1.0});
    surface.material.albedo = clamped(diffuse);
    surface.material.opacity = static_cast<float>(std::clamp(diffuse[3], 0.0, 1.0));
    surface.metallic = 0.0;
    surface.reflectance = luminance(clamped(specular));
    surface.roughness = 1.0 - extension.number("glossinessFactor", 1.0, 0.0, 1.0);
    surface.base_texture = find_use(extension, "diffuseTexture");
    surface.metallic_roughness.reset();
    if (extension.find("specularGlossinessTexture")) {
        notes_.add("specular-glossiness textures are left out, their factors used",
                   surface.material.name);
    }
}

void GltfMaterials::read_extensions(const JsonCursor& cursor, Surface& surface) {
    const auto extensions = cursor.find("extensions");
    if (!extensions) return;
    const std::string& name = surface.material.name;
    if (const auto glossy = extensions->find("KHR_materials_pbrSpecularGlossiness")) {
        read_specular_glossiness(*glossy, surface);
    }
    if (const auto ior = extensions->find("KHR_materials_ior")) {
        const double value = ior->number("ior", 1.5, 0.0, 1e6);
        surface.reflectance = value == 0.0 ? 1.0 : reflectance_of_ior(std::max(value, 1.0));
    }
    if (const auto specular = extensions->find("KHR_materials_specular")) {
        const auto colour = specular->numbers("specularColorFactor", {1.0, 1.0, 1.0});
        surface.reflectance =
            std::min(1.0, surface.reflectance * static_cast<double>(luminance(
                                                    glm::vec3(colour[0], colour[1], colour[2])))) *
            specular->number("specularFactor", 1.0, 0.0, 1.0);
        surface.reflectance = std::max(surface.reflectance, 0.0);
        if (colour[0] != colour[1] || colour[1] != colour[2]) {
            notes_.add("coloured highlights are white, of the same luminance", name);
        }
        if (specular->find("specularTexture") || specular->find("specularColorTexture")) {
            notes_.add("specular textures are left out, their factors used", name);
        }
    }
    if (extensions->find("KHR_materials_unlit")) {
        notes_.add("unlit materials are lit like any other, without highlights", name);
        surface.metallic = 0.0;
        surface.reflectance = 0.0;
    }
    for (const char* left_out :
         {"KHR_materials_clearcoat", "KHR_materials_transmission", "KHR_materials_volume",
          "KHR_materials_sheen", "KHR_materials_iridescence", "KHR_materials_anisotropy"}) {
        if (extensions->find(left_out)) notes_.add(fmt::format("{} is left out", left_out), name);
    }
}

void GltfMaterials::read_coverage(const JsonCursor& cursor, Material& material) {
    const std::string mode = cursor.text("alphaMode", "OPAQUE");
    material.alpha_cutoff =
        static_cast<float>(std::clamp(cursor.number("alphaCutoff", 0.5), 0.0, 1.0));
    if (mode == "MASK") {
        material.coverage = Coverage::kCutOut;
    } else if (mode == "BLEND") {
        material.coverage = Coverage::kBlended;
    } else if (mode == "OPAQUE") {
        material.opacity = 1.0F;
    } else {
        cursor.at("alphaMode")
            .fail(fmt::format("is \"{}\", allowed are OPAQUE, MASK and BLEND", one_line(mode)));
    }
}

bool GltfMaterials::lies_alike(const std::optional<Use>& use, Surface& surface, const char* what) {
    if (!use) return false;
    if (!surface.mapping) surface.mapping = use->mapping;
    if (*surface.mapping == use->mapping) return true;
    notes_.add(fmt::format("{} textures with other texture coordinates than the material's first "
                           "texture are left out",
                           what),
               surface.material.name);
    return false;
}

void GltfMaterials::read_textures(const JsonCursor& cursor, Surface& surface) {
    Material& material = surface.material;
    if (lies_alike(surface.base_texture, surface, "base colour")) {
        material.albedo_texture = texture(*surface.base_texture, true, 1.0, "a checkerboard");
    }
    const auto normal = find_use(cursor, "normalTexture");
    if (lies_alike(normal, surface, "normal")) {
        material.normal_texture = texture(*normal, false, normal->info.number("scale", 1.0), "");
    }
    const auto occlusion = find_use(cursor, "occlusionTexture");
    if (lies_alike(occlusion, surface, "occlusion")) {
        material.occlusion_strength =
            static_cast<float>(occlusion->info.number("strength", 1.0, 0.0, 1.0));
        if (material.occlusion_strength > 0.0F) {
            material.occlusion_texture = texture(*occlusion, false, 1.0, "");
        }
    }
    const auto factor = cursor.numbers("emissiveFactor", {0.0, 0.0, 0.0});
    const auto extensions = cursor.find("extensions");
    const auto strength =
        extensions ? extensions->find("KHR_materials_emissive_strength") : std::nullopt;
    material.emissive =
        clamped(factor) *
        static_cast<float>(strength ? strength->number("emissiveStrength", 1.0, 0.0, 1e6) : 1.0);
    const auto emissive = find_use(cursor, "emissiveTexture");
    if (material.emissive != glm::vec3(0.0F) && lies_alike(emissive, surface, "emissive")) {
        material.emissive_texture = texture(*emissive, true, 1.0, "");
        if (material.emissive_texture == kNoTexture) material.emissive = glm::vec3(0.0F);
    }
}

void GltfMaterials::read_roughness(Surface& surface) {
    if (!surface.metallic_roughness) return;
    const Use& use = *surface.metallic_roughness;
    Material& material = surface.material;
    if (!surface.mapping) surface.mapping = use.mapping;
    if (*surface.mapping == use.mapping) {
        material.roughness = static_cast<float>(surface.roughness);
        material.metalness = static_cast<float>(surface.metallic);
        material.roughness_texture = texture(use, false, 1.0, "");
    } else {
        notes_.add(
            "metallic-roughness textures with other texture coordinates than the material's first "
            "texture are replaced by their mean",
            material.name);
    }
    const glm::vec3 mean = mean_of(use);
    surface.roughness *= static_cast<double>(mean.y);
    surface.metallic *= static_cast<double>(mean.z);
}

std::optional<std::size_t> GltfMaterials::image_of(const Use& use) {
    const JsonCursor root = file_.root();
    const JsonCursor texture = root.at("textures").item(use.texture);
    const std::size_t images = root.count("images");
    if (const auto sampler = texture.index("sampler", root.count("samplers"), "samplers")) {
        const JsonCursor cursor = root.at("samplers").item(*sampler);
        constexpr int kRepeat = 10497;
        if (cursor.integer("wrapS", kRepeat, 0, 1 << 20) != kRepeat ||
            cursor.integer("wrapT", kRepeat, 0, 1 << 20) != kRepeat) {
            notes_.add("textures that are to clamp or to mirror at their border are repeated",
                       texture.name(fmt::format("texture {}", use.texture)));
        }
        if (cursor.integer("magFilter", 9729, 0, 1 << 20) == 9728) {
            notes_.add("textures that are to be sampled by the nearest texel are interpolated",
                       texture.name(fmt::format("texture {}", use.texture)));
        }
    }
    if (const auto extensions = texture.find("extensions")) {
        if (const auto webp = extensions->find("EXT_texture_webp")) {
            if (const auto image = webp->index("source", images, "images")) return image;
        }
    }
    return texture.index("source", images, "images");
}

std::string GltfMaterials::name_of_image(std::size_t image) const {
    const JsonCursor cursor = file_.root().at("images").item(image);
    const std::string uri = cursor.text("uri", "");
    if (!uri.empty() && !uri.starts_with("data:")) return one_line(percent_decoded(uri));
    return cursor.name(fmt::format("image {}", image));
}

std::optional<Texture> GltfMaterials::decode(std::size_t image, bool srgb, std::string& why) {
    const JsonCursor cursor = file_.root().at("images").item(image);
    const std::string name = name_of_image(image);
    const std::string uri = cursor.text("uri", "");
    if (uri.empty()) {
        const auto view = cursor.index("bufferView", file_.views().size(), "bufferViews");
        if (!view) cursor.fail("it has neither a uri nor a bufferView");
        return texels_of(decoder_.decode(file_.views()[*view].bytes, name, srgb, why));
    }
    why = "its data URI is not base64";
    const auto bytes = uri.starts_with("data:") ? GltfFile::bytes_of_data_uri(uri)
                                                : files_.read(percent_decoded(uri), why);
    if (!bytes) return std::nullopt;
    return texels_of(decoder_.decode(*bytes, name, srgb, why));
}

TextureIndex GltfMaterials::texture(const Use& use, bool srgb, double normal_scale,
                                    const char* instead) {
    const auto image = image_of(use);
    const std::tuple key(image.value_or(~std::size_t{0}), srgb, normal_scale);
    if (const auto known = textures_.find(key); known != textures_.end()) return known->second;
    std::string why = "it names no image that is known here";
    std::optional<Texture> decoded = image ? decode(*image, srgb, why) : std::nullopt;
    const std::string name = image ? name_of_image(*image) : fmt::format("texture {}", use.texture);
    if (!decoded) {
        const bool stands_in = *instead != '\0';
        notes_.add(fmt::format("texture {}: {}; {}", name, why,
                               stands_in ? fmt::format("{} stands in", instead) : "left out"));
        if (stands_in) decoded = checkerboard(name);
    } else if (normal_scale != 1.0) {
        for (std::size_t i = 0; i < decoded->rgba.size(); ++i) {
            if (i % 4 >= 2) continue;  // x and y only; the shader makes the length one again
            const double bent = 128.0 + normal_scale * (decoded->rgba[i] - 128.0);
            decoded->rgba[i] = static_cast<std::uint8_t>(std::clamp(std::round(bent), 0.0, 255.0));
        }
    }
    TextureIndex index = kNoTexture;
    if (decoded) {
        index = static_cast<TextureIndex>(scene_.textures.size());
        scene_.textures.push_back(std::move(*decoded));
    }
    textures_.emplace(key, index);
    return index;
}

glm::vec3 GltfMaterials::mean_of(const Use& use) {
    const auto image = image_of(use);
    if (!image) return glm::vec3(1.0F);
    const auto [known, fresh] = means_.try_emplace(*image, 1.0F);
    if (!fresh) return known->second;
    const auto kept = textures_.find(std::tuple(*image, false, 1.0));
    const bool in_scene = kept != textures_.end() && kept->second != kNoTexture;
    std::string ignored;  // texture() notes why, where it is asked for
    const auto decoded = in_scene ? std::nullopt : decode(*image, false, ignored);
    if (!in_scene && !decoded) return known->second;
    const Texture& texels =
        in_scene ? scene_.textures[static_cast<std::size_t>(kept->second)] : *decoded;
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < texels.rgba.size(); i += 4) {
        sum += glm::dvec3(texels.rgba[i], texels.rgba[i + 1], texels.rgba[i + 2]);
    }
    known->second = sum / (255.0 * static_cast<double>(texels.rgba.size() / 4));
    if (decoded) decoder_.give_back(*decoded);
    return known->second;
}

}  // namespace obscura::renderer::import_detail
