// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/mtl_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/import/json_cursor.h"

namespace obscura::renderer::import_detail {
namespace {

using Texel = std::uint8_t;

std::size_t texels(const Texture& texture) { return texture.rgba.size() / 4; }

bool is_grey(const Texture& texture) {
    std::size_t coloured = 0;
    for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
        const auto [low, high] =
            std::minmax({texture.rgba[i], texture.rgba[i + 1], texture.rgba[i + 2]});
        if (high - low > 24) ++coloured;
    }
    return coloured * 50 < texels(texture);
}

Texel value_of(const Texel* rgba, ImageChannel channel) {
    switch (channel) {
        case ImageChannel::kRed:
            return rgba[0];
        case ImageChannel::kGreen:
            return rgba[1];
        case ImageChannel::kBlue:
            return rgba[2];
        case ImageChannel::kMatte:
            return rgba[3];
        case ImageChannel::kLuminance:
            break;
    }
    // Of the stored values, which a grey image has as its only ones; weights of ITU-R BT.709.
    return static_cast<Texel>(std::lround(0.2126 * rgba[0] + 0.7152 * rgba[1] + 0.0722 * rgba[2]));
}

/// Slopes of the heights by central differences over the wrapped image; white is as high as
/// `strength` * 8 texels.
void normals_from_heights(Texture& texture, double strength, ImageChannel channel) {
    constexpr double kTexelsHigh = 8.0;
    const auto at = [&](int x, int y) {
        const int column = (x + texture.width) % texture.width;
        const int row = (y + texture.height) % texture.height;
        const std::size_t texel =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width) +
            static_cast<std::size_t>(column);
        return value_of(texture.rgba.data() + 4 * texel, channel) / 255.0;
    };
    std::vector<Texel> normals;
    normals.reserve(texture.rgba.size());
    const double half = 0.5 * kTexelsHigh * strength;
    for (int y = 0; y < texture.height; ++y) {
        for (int x = 0; x < texture.width; ++x) {
            const glm::dvec3 n = glm::normalize(glm::dvec3(
                half * (at(x - 1, y) - at(x + 1, y)), half * (at(x, y + 1) - at(x, y - 1)), 1.0));
            for (int c = 0; c < 3; ++c) {
                normals.push_back(static_cast<Texel>(std::lround(128.0 + 127.0 * n[c])));
            }
            normals.push_back(255);
        }
    }
    texture.rgba = std::move(normals);
}

/// The image at another size, bilinear between the nearest texels of the wrapped image; the same
/// texels at its own.
std::vector<Texel> resampled(const Texture& texture, int width, int height) {
    if (texture.width == width && texture.height == height) return texture.rgba;
    std::vector<Texel> result;
    result.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    const auto wrapped = [](double texel, int size) {
        const int whole = static_cast<int>(texel);
        return static_cast<std::size_t>((whole % size + size) % size);
    };
    const auto texel_at = [&](double x, double y) {
        return texture.rgba.data() +
               4 * (wrapped(y, texture.height) * static_cast<std::size_t>(texture.width) +
                    wrapped(x, texture.width));
    };
    for (int row = 0; row < height; ++row) {
        const double y = (row + 0.5) * texture.height / height - 0.5;
        const double top = std::floor(y);
        for (int column = 0; column < width; ++column) {
            const double x = (column + 0.5) * texture.width / width - 0.5;
            const double left = std::floor(x);
            for (int c = 0; c < 4; ++c) {
                const double above =
                    std::lerp(static_cast<double>(texel_at(left, top)[c]),
                              static_cast<double>(texel_at(left + 1.0, top)[c]), x - left);
                const double below =
                    std::lerp(static_cast<double>(texel_at(left, top + 1.0)[c]),
                              static_cast<double>(texel_at(left + 1.0, top + 1.0)[c]), x - left);
                result.push_back(static_cast<Texel>(std::lround(std::lerp(above, below, y - top))));
            }
        }
    }
    return result;
}

}  // namespace

std::optional<FoundFile> MtlTextures::find(const MtlMap& map, const std::filesystem::path& folder,
                                           std::string& why) {
    std::string other;
    for (const std::string& name : map.names) {
        // The likeliest name says why, where none is there.
        std::string& reason = &name == &map.names.front() ? why : other;
        const bool absolute = std::filesystem::path(name).is_absolute();
        if (auto found = files_.find(absolute ? name : (folder / name).string(), reason)) {
            return found;
        }
    }
    return std::nullopt;
}

std::optional<DecodedImage> MtlTextures::decode(const FoundFile& file, const MtlMap& map, bool srgb,
                                                std::string& why) {
    const auto bytes = files_.read(file, why);
    if (!bytes) return std::nullopt;
    return decoder_.decode(*bytes, one_line(map.names.front()), srgb, why);
}

TextureIndex MtlTextures::add(const std::string& key, Texture&& texture) {
    const auto index = static_cast<TextureIndex>(scene_.textures.size());
    scene_.textures.push_back(std::move(texture));
    known_.emplace(key, index);
    return index;
}

TextureIndex MtlTextures::colour(const MtlMap& map, const std::filesystem::path& folder,
                                 bool stands_in) {
    const std::string name = one_line(map.names.front());
    std::string why;
    const auto file = find(map, folder, why);
    const std::string key =
        fmt::format("colour {} {}", stands_in,
                    file ? file->key.string() : (folder / map.names.front()).string());
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    auto image = file ? decode(*file, map, true, why) : std::nullopt;
    if (!image) {
        notes_.add(fmt::format("texture {}: {}; {}", name, why,
                               stands_in ? "a checkerboard stands in" : "left out"));
        if (stands_in) return add(key, checkerboard(name));
        known_.emplace(key, kNoTexture);
        return kNoTexture;
    }
    bool alpha = false;
    for (std::size_t i = 3; i < image->texture.rgba.size(); i += 4) {
        alpha = alpha || image->texture.rgba[i] != 255;
        image->texture.rgba[i] = 255;
    }
    const TextureIndex index = add(key, std::move(image->texture));
    if (alpha) had_alpha_.insert(index);
    return index;
}

TextureIndex MtlTextures::normals(const MtlMap& map, const std::filesystem::path& folder,
                                  bool may_be_heights) {
    const std::string name = one_line(map.names.front());
    std::string why;
    const auto file = find(map, folder, why);
    const int channel = map.channel ? static_cast<int>(*map.channel) : -1;
    const std::string key =
        fmt::format("normals {} {} {} {}", may_be_heights, map.strength, channel,
                    file ? file->key.string() : (folder / map.names.front()).string());
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
    auto image = file ? decode(*file, map, false, why) : std::nullopt;
    if (!image) {
        notes_.add(fmt::format("texture {}: {}; left out", name, why));
        known_.emplace(key, kNoTexture);
        return kNoTexture;
    }
    if (may_be_heights && (map.channel || is_grey(image->texture))) {
        normals_from_heights(image->texture, std::clamp(map.strength, -16.0, 16.0),
                             channel_of(map, *image, true));
        notes_.add("height maps are shown as the normals of a relief 8 texels high", name);
    }
    return add(key, std::move(image->texture));
}

/// What the value of an image is: its alpha channel, else its luminance, else what -imfchan says.
/// An alpha that is opaque everywhere is none, but in the image that gives the colours, too.
ImageChannel MtlTextures::channel_of(const MtlMap& map, const DecodedImage& image,
                                     bool is_of_colours) {
    if (map.channel && (*map.channel != ImageChannel::kMatte || image.has_alpha)) {
        return *map.channel;
    }
    if (map.channel) {
        notes_.add("-imfchan m asks for an alpha channel; images without one give luminance",
                   map.place);
        return ImageChannel::kLuminance;
    }
    if (!image.has_alpha) return ImageChannel::kLuminance;
    const std::vector<Texel>& rgba = image.texture.rgba;
    bool opaque = true;
    for (std::size_t i = 3; opaque && i < rgba.size(); i += 4) opaque = rgba[i] == 255;
    if (!opaque || is_of_colours) return ImageChannel::kMatte;
    notes_.add("masks whose alpha channel is opaque everywhere give their luminance", map.place);
    return ImageChannel::kLuminance;
}

std::optional<TextureIndex> MtlTextures::cut_out(TextureIndex colour, const MtlMap& mask,
                                                 const std::optional<MtlMap>& map_kd,
                                                 const std::filesystem::path& folder) {
    std::string why;
    const auto file = find(mask, folder, why);
    std::string ignored;
    const auto colours_file = map_kd ? find(*map_kd, folder, ignored) : std::nullopt;
    const bool is_of_colours = file && colours_file && colours_file->key == file->key;
    const std::string key =
        fmt::format("mask {} {} {} {}", colour, mask.channel ? static_cast<int>(*mask.channel) : -1,
                    is_of_colours, file ? file->key.string() : "");
    if (const auto known = known_.find(key); file && known != known_.end()) return known->second;
    auto image = file ? decode(*file, mask, false, why) : std::nullopt;
    if (!image) {
        notes_.add(fmt::format("texture {}: {}; left out", one_line(mask.names.front()), why));
        return std::nullopt;
    }
    decoder_.give_back(image->texture);
    const ImageChannel channel = channel_of(mask, *image, is_of_colours);
    Texel lowest = 255;
    std::size_t between = 0;
    Texture& alpha = image->texture;
    for (std::size_t i = 0; i < alpha.rgba.size(); i += 4) {
        alpha.rgba[i] = value_of(alpha.rgba.data() + i, channel);
        lowest = std::min(lowest, alpha.rgba[i]);
        between += alpha.rgba[i] > 25 && alpha.rgba[i] < 230 ? 1U : 0U;
    }
    if (lowest == 255) {
        known_.emplace(key, colour);
        return colour;
    }
    if (between * 10 > texels(alpha)) {
        notes_.add("masks that are half transparent are cut out where they are below one half",
                   mask.place);
    }
    Texture made = colour != kNoTexture ? scene_.textures[static_cast<std::size_t>(colour)] : alpha;
    if (colour == kNoTexture) {
        std::fill(made.rgba.begin(), made.rgba.end(), Texel{255});
        made.srgb = true;
    }
    const int width = std::max(made.width, alpha.width);
    const int height = std::max(made.height, alpha.height);
    if (!decoder_.take(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))) {
        notes_.add("masks for which the memory of a scene's textures has no room are left out",
                   mask.place);
        return std::nullopt;
    }
    made.rgba = resampled(made, width, height);
    const std::vector<Texel> values = resampled(alpha, width, height);
    for (std::size_t i = 0; i < values.size(); i += 4) made.rgba[i + 3] = values[i];
    made.width = width;
    made.height = height;
    return add(key, std::move(made));
}

}  // namespace obscura::renderer::import_detail
