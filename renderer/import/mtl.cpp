// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/mtl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/import/json_cursor.h"
#include "renderer/import/obj_text.h"
#include "renderer/scene/surface_conversion.h"

namespace obscura::renderer::import_detail {
namespace {

constexpr float kPlainGrey = 0.8F;

/// What two spellings of a name have in common: no quotes, no capitals, one blank for many.
std::string folded(std::string_view name) {
    std::string result;
    for (const char c : lower(trimmed(without_quotes(name)))) {
        const bool blank = c == ' ' || c == '\t';
        if (!blank || !result.ends_with(' ')) result += blank ? ' ' : c;
    }
    return result;
}

/// The names in a mtllib statement that are between blanks.
std::vector<std::string_view> split(std::string_view names) {
    std::vector<std::string_view> words;
    for (names = trimmed(names); !names.empty();) {
        const std::size_t end = std::min(names.find_first_of(" \t"), names.size());
        words.push_back(names.substr(0, end));
        names = trimmed(names.substr(end));
    }
    return words;
}

/// Whether the file's materials have Tr as what d is.
bool tr_is_opacity_in(const std::vector<MtlMaterial>& materials) {
    int for_it = 0;
    bool one_alone = false;
    bool nought_alone = false;
    for (const MtlMaterial& material : materials) {
        if (!material.tr) continue;
        if (!material.d) {
            one_alone = one_alone || *material.tr == 1.0;
            nought_alone = nought_alone || *material.tr == 0.0;
            continue;
        }
        const double as_opacity = std::abs(*material.d - *material.tr);
        const double as_transparency = std::abs(*material.d - (1.0 - *material.tr));
        for_it += as_opacity < as_transparency ? 1 : as_opacity > as_transparency ? -1 : 0;
    }
    return for_it != 0 ? for_it > 0 : one_alone && !nought_alone;
}

}  // namespace

bool MtlReader::read_file(const std::string& name, std::string& why) {
    const auto found = files_.find(name, why);
    if (!found) return false;
    if (!read_.insert(found->key).second) return true;
    const auto text = files_.read(*found, why);
    if (!text) {
        say_unread(name, why);
        return true;
    }
    const std::vector<MtlMaterial> materials = read_mtl(*text, name, notes_);
    const bool tr_is_opacity = tr_is_opacity_in(materials);
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    for (const MtlMaterial& material : materials) {
        add(material, tr_is_opacity, std::filesystem::path(slashes).parent_path());
    }
    return true;
}

void MtlReader::say_unread(const std::string& name, const std::string& why) {
    notes_.add(fmt::format("materials {}: {}; what they name is plain grey", one_line(name), why));
}

void MtlReader::read(const std::string& names) {
    std::string why;
    std::string ignored;
    for (const std::string_view whole : {std::string_view(names), without_comment(names)}) {
        if (read_file(std::string(whole), whole == names ? why : ignored) ||
            read_file(std::string(without_quotes(whole)), ignored)) {
            return;
        }
    }
    // Several files: as many words as make the name of one that is there, or one that is not.
    constexpr std::size_t kMostWords = 16;
    std::vector<std::string_view> words = split(without_comment(names));
    constexpr std::size_t kMostNames = 256;
    if (words.size() > kMostNames) {
        notes_.add(fmt::format("of the words of a mtllib the first {} are read", kMostNames));
        words.resize(kMostNames);
    }
    for (std::size_t first = 0; first < words.size();) {
        const std::size_t most = std::min(words.size(), first + kMostWords);
        const auto name_up_to = [&](std::size_t end) {
            const char* const begin = words[first].data();
            const std::string_view last = words[end - 1];
            return std::string(without_quotes(std::string_view(
                begin, static_cast<std::size_t>(last.data() + last.size() - begin))));
        };
        std::size_t end = most;
        while (end > first && !read_file(name_up_to(end), ignored)) --end;
        if (end == first) {
            while (end + 1 < most && !lower(words[end]).ends_with(".mtl")) ++end;
            ++end;
            if (!read_file(name_up_to(end), why)) say_unread(name_up_to(end), why);
        }
        first = end;
    }
}

void MtlReader::file_under(const std::string& name, std::uint32_t index) {
    materials_[name] = index;
    alike_.try_emplace(folded(name), index);
    commented_.try_emplace(folded(without_comment(name)), index);
}

void MtlReader::add(const MtlMaterial& described, bool tr_is_opacity,
                    const std::filesystem::path& folder) {
    const std::string name = one_line(described.name);
    if (scene_.materials.size() >= ImportLimits::kMaterials) {
        notes_.add(fmt::format("a scene may have {} materials; others are left out",
                               ImportLimits::kMaterials),
                   name);
        return;
    }
    if (materials_.contains(described.name)) {
        notes_.add("of materials that are described more than once the last counts", name);
    }
    Material material;
    material.name = name;
    material.double_sided = true;
    material.albedo = described.kd.value_or(glm::vec3(described.map_kd ? 1.0F : kPlainGrey));
    if (glm::any(glm::greaterThan(material.albedo, glm::vec3(1.0F)))) {
        notes_.add("colours Kd beyond 1 are limited to it", name);
        material.albedo = glm::min(material.albedo, 1.0F);
    }
    if (described.map_kd && material.albedo == glm::vec3(0.0F)) {
        notes_.add("Kd 0 0 0 makes the texture of a material black", name);
    }
    if (!described.map_kd && !described.map_ka.empty()) {
        notes_.add("maps that are left out: map_ka", described.map_ka);
    }
    add_highlight(described, material);
    add_opacity(described, tr_is_opacity, material);
    add_maps(described, folder, material);
    file_under(described.name, static_cast<std::uint32_t>(scene_.materials.size()));
    scene_.materials.push_back(std::move(material));
}

void MtlReader::add_highlight(const MtlMaterial& described, Material& material) {
    constexpr double kMostPower = 255.0;
    const float height = luminance(described.ks.value_or(glm::vec3(0.0F)));
    const double power = described.ns.value_or(static_cast<double>(material.specular_power));
    material.specular_power = static_cast<float>(std::clamp(power, 1.0, kMostPower));
    material.specular_intensity = std::min(height, 1.0F) * 8.0F / (material.specular_power + 8.0F);
    if (height > 0.0F && power > kMostPower) {
        notes_.add("highlights of a power Ns above 255 get that", material.name);
    }
    if (height > 1.0F) notes_.add("highlights Ks beyond 1 are limited to it", material.name);
    if (described.illum && *described.illum < 2 && height > 0.0F) {
        notes_.add("illum 0 and 1 ask for no highlight; Ks gives one", material.name);
    } else if (described.illum && *described.illum > 2) {
        notes_.add("what illum 3 to 10 ask for (mirrors, glass, shadows) is not shown",
                   material.name);
    }
}

void MtlReader::add_opacity(const MtlMaterial& described, bool tr_is_opacity, Material& material) {
    double opacity = described.d.value_or(1.0);
    if (!described.d && described.tr) {
        opacity = tr_is_opacity ? *described.tr : 1.0 - *described.tr;
        if (tr_is_opacity) {
            notes_.add(
                "Tr without d is taken as the opacity that d would be, since with the other "
                "meaning of Tr materials would be invisible",
                material.name);
        } else if (opacity < 1.0) {
            notes_.add("Tr without d is taken as transparency, 1 - d", material.name);
        }
    }
    material.opacity = static_cast<float>(opacity);
    if (opacity < 1.0) material.coverage = Coverage::kBlended;
}

void MtlReader::add_maps(const MtlMaterial& described, const std::filesystem::path& folder,
                         Material& material) {
    if (described.map_kd) {
        material.albedo_texture = textures_.colour(*described.map_kd, folder, true);
    }
    if (described.map_d) {
        const auto cut =
            textures_.cut_out(material.albedo_texture, *described.map_d, described.map_kd, folder);
        const bool holes = cut && *cut != material.albedo_texture;
        if (holes) material.albedo_texture = *cut;
        if (holes && material.coverage == Coverage::kOpaque) material.coverage = Coverage::kCutOut;
    } else if (described.map_kd && textures_.had_alpha(material.albedo_texture)) {
        notes_.add(
            "the alpha of a texture is not used, since its material names no map_d",
            fmt::format("{} of {}", one_line(described.map_kd->names.front()), material.name));
    }
    if (described.norm) {
        material.normal_texture = textures_.normals(*described.norm, folder, false);
    } else if (described.bump) {
        material.normal_texture = textures_.normals(*described.bump, folder, true);
    }
    material.emissive = described.ke.value_or(glm::vec3(0.0F));
    if (!described.map_ke) return;
    material.emissive_texture = textures_.colour(*described.map_ke, folder, false);
    if (material.emissive_texture == kNoTexture) {
        material.emissive = glm::vec3(0.0F);
    } else if (material.emissive == glm::vec3(0.0F)) {
        material.emissive = glm::vec3(1.0F);
        if (described.ke) notes_.add("map_Ke glows as with Ke 1, where Ke is 0", material.name);
    }
}

std::uint32_t MtlReader::material(const std::string& name) {
    if (const auto known = materials_.find(name); known != materials_.end()) return known->second;
    const std::string without(without_comment(name));
    for (const auto& [list, spelt] : {std::pair{&alike_, folded(name)},
                                      {&alike_, folded(without)},
                                      {&commented_, folded(name)}}) {
        const auto alike = list->find(spelt);
        if (name.empty() || alike == list->end()) continue;
        notes_.add(
            "names of materials that differ only in case, quotes, blanks or a comment are "
            "taken for the same",
            fmt::format("{} for {}", scene_.materials[alike->second].name, one_line(name)));
        materials_.emplace(name, alike->second);
        return alike->second;
    }
    if (!name.empty()) {
        notes_.add("materials that no file describes are plain grey", one_line(name));
    }
    const auto index = static_cast<std::uint32_t>(scene_.materials.size());
    Material grey;
    grey.name = one_line(name);
    grey.albedo = glm::vec3(kPlainGrey);
    grey.double_sided = true;
    scene_.materials.push_back(std::move(grey));
    materials_.emplace(name, index);
    return index;
}

}  // namespace obscura::renderer::import_detail
