// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "renderer/images/images.h"

namespace obscura::renderer::import_detail {
namespace {

/// The ending by which the image library picks its reader; empty for a format that is not read.
std::string ending_of(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "png";
    if (bytes.starts_with("\xff\xd8\xff")) return "jpg";
    if (bytes.starts_with("RIFF") && bytes.substr(0, 12).ends_with("WEBP")) return "webp";
    if (bytes.starts_with("BM")) return "bmp";
    if (bytes.starts_with(std::string_view("II*\0", 4)) ||
        bytes.starts_with(std::string_view("MM\0*", 4))) {
        return "tif";
    }
    std::string ending = std::filesystem::path(name).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending == ".tga" ? "tga" : "";  // TGA has no mark at its beginning
}

/// Whether every chunk up to the last one is there (ISO 15948, 5.3). The image library leaks when
/// its source ends early.
bool is_whole_png(std::string_view bytes) {
    std::size_t at = 8;  // after the signature
    while (at + 12 <= bytes.size()) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            length = length << 8U | static_cast<unsigned char>(bytes[at + i]);
        }
        if (length > bytes.size() - at - 12) return false;
        if (bytes.substr(at + 4, 4) == "IEND") return true;
        at += 12 + length;
    }
    return false;
}

std::string first_line(const std::string& text) {
    const std::string line = text.substr(0, std::min<std::size_t>(text.find('\n'), 160));
    return line.empty() ? "no reason given" : line;
}

/// One or two channels to four: grey, and alpha where there is any.
void spread_grey(Texture& texture, int channels) {
    for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
        std::uint8_t* texel = texture.rgba.data() + i;
        texel[3] = channels == 2 ? texel[1] : 255;
        texel[1] = texel[2] = texel[0];
    }
}

}  // namespace

bool ImageDecoder::take(std::size_t bytes) {
    if (bytes > left_bytes_) return false;
    left_bytes_ -= bytes;
    return true;
}

std::optional<DecodedImage> ImageDecoder::decode(std::string_view bytes, const std::string& name,
                                                 bool srgb, std::string& why) {
    const std::string ending = ending_of(bytes, name);
    if (ending.empty()) {
        why = "it is no PNG, JPEG, TGA, BMP, TIFF or WebP image";
        return std::nullopt;
    }
    if (ending == "png" && !is_whole_png(bytes)) {
        why = "it is cut off";
        return std::nullopt;
    }
    std::string reason;
    const std::unique_ptr<images::Reader> reader = images::library().open(bytes, ending, reason);
    if (!reader) {
        why = "it cannot be read: " + first_line(reason);
        return std::nullopt;
    }
    constexpr int kMost = ImportLimits::kTextureSide;
    if (reader->width < 1 || reader->height < 1 || reader->width > kMost ||
        reader->height > kMost || reader->channels.empty()) {
        why = fmt::format("its header says {}x{} texels of {} channels, allowed is 1 to {} a side",
                          reader->width, reader->height, reader->channels.size(), kMost);
        return std::nullopt;
    }
    const std::size_t size =
        4 * static_cast<std::size_t>(reader->width) * static_cast<std::size_t>(reader->height);
    if (size > std::min(left_bytes_, left_work_bytes_)) {
        why = fmt::format(
            "its {}x{} texels take {} bytes, of the {} allowed for a scene {} are "
            "left",
            reader->width, reader->height, size, ImportLimits::kTextureBytes,
            std::min(left_bytes_, left_work_bytes_));
        return std::nullopt;
    }
    left_bytes_ -= size;
    left_work_bytes_ -= size;
    Texture texture;
    texture.name = name;
    texture.width = reader->width;
    texture.height = reader->height;
    texture.srgb = srgb;
    texture.rgba.assign(size, 255);
    const int channels = static_cast<int>(std::min<std::size_t>(reader->channels.size(), 4));
    if (!reader->read_bytes(channels, texture.rgba.data(), 4, reason)) {
        why = "its content is damaged or cut off: " + first_line(reason);
        return std::nullopt;
    }
    if (channels < 3) spread_grey(texture, channels);
    return DecodedImage{std::move(texture), channels == 2 || channels == 4};
}

Texture checkerboard(const std::string& name) {
    constexpr int kSide = 16;
    Texture texture{name + " (stand-in)", kSide, kSide, true, {}};
    constexpr std::array<std::array<std::uint8_t, 4>, 2> kColours{
        {{255, 0, 255, 255}, {40, 40, 40, 255}}};
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const auto& colour = kColours[static_cast<std::size_t>((x / 2 + y / 2) % 2)];
            texture.rgba.insert(texture.rgba.end(), colour.begin(), colour.end());
        }
    }
    return texture;
}

}  // namespace obscura::renderer::import_detail
