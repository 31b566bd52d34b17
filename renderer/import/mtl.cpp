// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/mtl.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "renderer/base/error.h"
#include "renderer/import/json_cursor.h"
#include "renderer/import/obj_check.h"
#include "renderer/scene/surface_conversion.h"

namespace obscura::renderer::import_detail {
namespace {

std::string lower(std::string_view word) {
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return result;
}

/// The file a map statement names, after its options, and the bump multiplier.
struct MapStatement {
    std::string file;
    double strength = 1.0;
    bool moved = false;  ///< it scales, offsets or clamps the texture
};

MapStatement parse_map(const std::vector<std::string_view>& words, std::string_view line) {
    MapStatement map;
    std::size_t i = 1;
    while (i < words.size() && words[i].starts_with('-') && words[i].size() > 1) {
        const std::string option = lower(words[i]);
        ++i;
        double value = 0.0;
        const bool vector = option == "-o" || option == "-s" || option == "-t";
        for (int k = 0; vector && k < 3 && i < words.size() && parse_number(words[i], value); ++k) {
            if (value != (option == "-s" ? 1.0 : 0.0)) map.moved = true;
            ++i;
        }
        if (vector || i >= words.size()) continue;
        if (option == "-bm" && parse_number(words[i], value)) map.strength = value;
        if (option == "-clamp" && words[i] == "on") map.moved = true;
        i += option == "-mm" ? 2 : 1;
    }
    if (i < words.size()) {
        const auto from = static_cast<std::size_t>(words[i].data() - line.data());
        const auto to = static_cast<std::size_t>(words.back().data() - line.data());
        map.file = std::string(line.substr(from, to + words.back().size() - from));
        std::replace(map.file.begin(), map.file.end(), '\\', '/');
    }
    return map;
}

bool is_grey(const Texture& texture) {
    std::size_t coloured = 0;
    for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
        const auto [low, high] =
            std::minmax({texture.rgba[i], texture.rgba[i + 1], texture.rgba[i + 2]});
        if (high - low > 24) ++coloured;
    }
    return coloured * 50 < texture.rgba.size() / 4;
}

/// Slopes of the heights by central differences over the wrapped image; white is as high as
/// `strength` * 8 texels.
void normals_from_heights(Texture& texture, double strength) {
    constexpr double kTexelsHigh = 8.0;
    const auto at = [&texture](int x, int y) {
        const int column = (x + texture.width) % texture.width;
        const int row = (y + texture.height) % texture.height;
        return texture.rgba[4 * (static_cast<std::size_t>(row) *
                                     static_cast<std::size_t>(texture.width) +
                                 static_cast<std::size_t>(column))] /
               255.0;
    };
    std::vector<std::uint8_t> normals;
    normals.reserve(texture.rgba.size());
    const double half = 0.5 * kTexelsHigh * strength;
    for (int y = 0; y < texture.height; ++y) {
        for (int x = 0; x < texture.width; ++x) {
            const glm::dvec3 n = glm::normalize(glm::dvec3(
                half * (at(x - 1, y) - at(x + 1, y)), half * (at(x, y + 1) - at(x, y - 1)), 1.0));
            for (int c = 0; c < 3; ++c) {
                normals.push_back(static_cast<std::uint8_t>(std::lround(128.0 + 127.0 * n[c])));
            }
            normals.push_back(255);
        }
    }
    texture.rgba = std::move(normals);
}

std::array<double, 3> three_numbers(const std::vector<std::string_view>& words,
                                    const std::string& file, int line) {
    std::array<double, 3> values{};
    const std::size_t given = words.size() - 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t word =
            1 + std::min(i, given == 0 ? 0 : given - 1);  // one stands for three
        if (given == 0 || !parse_number(words[word], values[i]) || values[i] < 0.0 ||
            values[i] > 1e6) {
            throw base::bad_input("{}:{}: {} wants three numbers from 0 on", file, line, words[0]);
        }
    }
    return values;
}

}  // namespace

void MtlReader::read(const std::string& file) {
    std::string why;
    const auto text = files_.read(file, why);
    if (!text) {
        notes_.add(
            fmt::format("materials {}: {}; what they name is plain grey", one_line(file), why));
        return;
    }
    std::string_view rest = *text;
    int line_number = 0;
    Material* material = nullptr;
    while (!rest.empty()) {
        const std::string line = next_line(rest, line_number);
        const auto words = words_of(line);
        if (words.empty()) continue;
        if (words[0] == "newmtl") {
            const auto from = words.size() > 1
                                  ? static_cast<std::size_t>(words[1].data() - line.data())
                                  : line.size();
            std::string name = line.substr(from);
            name.resize(name.find_last_not_of(" \t\r") + 1);
            materials_[name] = static_cast<std::uint32_t>(scene_.materials.size());
            scene_.materials.push_back({.name = one_line(name)});
            scene_.materials.back().albedo = glm::vec3(0.8F);
            material = &scene_.materials.back();
        } else if (material != nullptr) {
            statement(words, line, {file, line_number}, *material);
        }
    }
}

void MtlReader::statement(const std::vector<std::string_view>& words, std::string_view line,
                          const Place& place, Material& material) {
    const std::string key = lower(words[0]);
    const auto numbers = [&] { return three_numbers(words, place.file, place.line); };
    if (key == "kd") {
        const auto c = numbers();
        material.albedo = glm::clamp(glm::vec3(c[0], c[1], c[2]), 0.0F, 1.0F);
    } else if (key == "ks") {
        const auto c = numbers();
        material.specular_intensity = std::min(luminance(glm::vec3(c[0], c[1], c[2])), 1.0F);
    } else if (key == "ke") {
        const auto c = numbers();
        material.emissive = glm::vec3(c[0], c[1], c[2]);
    } else if (key == "ns") {
        material.specular_power = std::clamp(static_cast<float>(numbers()[0]), 1.0F, 255.0F);
    } else if (key == "d" || key == "tr") {
        const double value = std::min(numbers()[0], 1.0);
        material.opacity = static_cast<float>(key == "d" ? value : 1.0 - value);
        const bool seen_through = material.opacity < 1.0F;
        if (seen_through && material.coverage == Coverage::kOpaque) {
            material.coverage = Coverage::kBlended;
        }
    } else if (key.starts_with("map_") || key == "bump" || key == "norm" || key == "disp" ||
               key == "refl") {
        map(words, line, place, material);
    } else if (key != "ka" && key != "illum" && key != "ni" && key != "tf" && key != "sharpness") {
        notes_.add("statements of materials that are not known are left out", one_line(words[0]));
    }
}

void MtlReader::map(const std::vector<std::string_view>& words, std::string_view line,
                    const Place& place, Material& material) {
    const std::string key = lower(words[0]);
    const MapStatement statement = parse_map(words, line);
    if (statement.file.empty()) {
        notes_.add("maps without a file are left out",
                   fmt::format("{}:{}", one_line(place.file), place.line));
        return;
    }
    if (statement.moved) {
        notes_.add("moved, scaled or clamped maps are shown as they are", statement.file);
    }
    const std::string file =
        (std::filesystem::path(place.file).parent_path() / statement.file).string();
    if (key == "map_kd") {
        material.albedo_texture = texture(file, true, true);
    } else if (key == "map_ke") {
        material.emissive_texture = texture(file, true, false);
        if (material.emissive == glm::vec3(0.0F)) material.emissive = glm::vec3(1.0F);
        if (material.emissive_texture == kNoTexture) material.emissive = glm::vec3(0.0F);
    } else if (key == "map_d") {
        cut_out(file, material);
    } else if (key == "bump" || key == "map_bump" || key == "norm") {
        material.normal_texture = bump(file, statement.strength);
    } else if (key != "map_ka") {
        notes_.add("maps that are left out", one_line(words[0]));
    }
}

TextureIndex MtlReader::texture(const std::string& file, bool srgb, bool stands_in) {
    const std::string key = (srgb ? "srgb " : "linear ") + file;
    if (const auto known = textures_.find(key); known != textures_.end()) return known->second;
    std::string why;
    const auto bytes = files_.read(file, why);
    auto decoded = bytes ? decoder_.decode(*bytes, one_line(file), srgb, why) : std::nullopt;
    if (!decoded) {
        notes_.add(fmt::format("texture {}: {}; {}", one_line(file), why,
                               stands_in ? "a checkerboard stands in" : "left out"));
        if (stands_in) decoded = checkerboard(one_line(file));
    }
    TextureIndex index = kNoTexture;
    if (decoded) {
        index = static_cast<TextureIndex>(scene_.textures.size());
        scene_.textures.push_back(std::move(*decoded));
    }
    textures_.emplace(key, index);
    return index;
}

TextureIndex MtlReader::bump(const std::string& file, double strength) {
    const bool fresh = !textures_.contains("linear " + file);
    const TextureIndex index = texture(file, false, false);
    if (fresh && index != kNoTexture) {
        Texture& made = scene_.textures[static_cast<std::size_t>(index)];
        if (is_grey(made)) {
            normals_from_heights(made, std::clamp(strength, -16.0, 16.0));
            notes_.add("height maps are shown as the normals of a relief 8 texels high",
                       one_line(file));
        }
    }
    return index;
}

/// Makes the map's first channel the alpha of the albedo texture.
void MtlReader::cut_out(const std::string& file, Material& material) {
    std::string why;
    const auto bytes = files_.read(file, why);
    const auto mask = bytes ? decoder_.decode(*bytes, one_line(file), false, why) : std::nullopt;
    if (!mask) {
        notes_.add(fmt::format("texture {}: {}; left out", one_line(file), why));
        return;
    }
    decoder_.give_back(*mask);
    Texture cut = *mask;
    if (material.albedo_texture != kNoTexture) {
        cut = scene_.textures[static_cast<std::size_t>(material.albedo_texture)];
    } else {
        std::fill(cut.rgba.begin(), cut.rgba.end(), std::uint8_t{255});
        cut.srgb = true;
    }
    for (int y = 0; y < cut.height; ++y) {
        for (int x = 0; x < cut.width; ++x) {
            const std::size_t from =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(mask->height) /
                    static_cast<std::size_t>(cut.height) * static_cast<std::size_t>(mask->width) +
                static_cast<std::size_t>(x) * static_cast<std::size_t>(mask->width) /
                    static_cast<std::size_t>(cut.width);
            const std::size_t to =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(cut.width) +
                static_cast<std::size_t>(x);
            cut.rgba[4 * to + 3] = mask->rgba[4 * from];
        }
    }
    material.coverage = Coverage::kCutOut;
    material.opacity = 1.0F;
    material.albedo_texture = static_cast<TextureIndex>(scene_.textures.size());
    scene_.textures.push_back(std::move(cut));
}

std::uint32_t MtlReader::material(const std::string& name) {
    const auto known = materials_.find(name);
    if (known != materials_.end()) return known->second;
    if (!name.empty())
        notes_.add("materials that no file describes are plain grey", one_line(name));
    const auto index = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.push_back({.name = one_line(name), .albedo = glm::vec3(0.8F)});
    materials_.emplace(name, index);
    return index;
}

}  // namespace obscura::renderer::import_detail
