// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::images {

/// What a file says of itself beside its size.
struct Attributes {
    std::map<std::string, std::string> texts;
    std::map<std::string, std::array<float, 16>> matrices;
};

/// An image file whose header was read, its content not yet.
class Reader {
  public:
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;  ///< their names
    std::string value_type;             ///< of a channel as it is stored: `uint8`, `half`
    virtual ~Reader() = default;

    /// The first `count` channels as code values 0 to 255, a pixel every `step` bytes, upper row
    /// first. False with the reason.
    virtual bool read_bytes(int count, std::uint8_t* values, int step, std::string& why) = 0;

    /// The first `count` channels as floats, interleaved, upper row first. False with the reason.
    virtual bool read_floats(int count, float* values, std::string& why) = 0;

    [[nodiscard]] virtual Attributes attributes() const = 0;
};

/// 8-bit code values, a pixel every `step` bytes, upper row first.
struct Bytes {
    int width = 0;
    int height = 0;
    int channels = 3;
    int step = 3;
    const std::uint8_t* values = nullptr;
    bool is_srgb = false;  ///< says so in the file
    int compression = -1;  ///< 0 to 9; less than 0: as the library does it
};

/// Floats, interleaved, upper row first.
struct Floats {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels;
    const float* values = nullptr;
    Attributes attributes;
};

/// Between two images, over all channels.
struct Difference {
    double rms = 0.0;
    double max = 0.0;
};

/// What OpenImageIO does for the program: image files, and what is computed of whole images. Where
/// a function gives nothing or an empty string, `why` has the reason.
class Library {
  public:
    virtual ~Library() = default;

    /// `ending` tells the format: `png`. The bytes must live as long as the reader.
    [[nodiscard]] virtual std::unique_ptr<Reader> open(std::string_view bytes,
                                                       const std::string& ending,
                                                       std::string& why) const = 0;
    [[nodiscard]] virtual std::unique_ptr<Reader> open(const std::filesystem::path& file,
                                                       std::string& why) const = 0;

    [[nodiscard]] virtual std::string png(const Bytes& image, std::string& why) const = 0;
    /// Losslessly compressed.
    [[nodiscard]] virtual std::string exr(const Floats& image, std::string& why) const = 0;
    /// Into a file of the format that its ending names.
    [[nodiscard]] virtual bool write(const std::filesystem::path& file, const Floats& image,
                                     std::string& why) const = 0;

    /// A JPEG file at most width_px wide of a PNG file's sRGB colours, averaged as light.
    [[nodiscard]] virtual std::string thumbnail(std::string_view png, int width_px,
                                                std::string& why) const = 0;

    /// Of three channels each, width * height * 3 values.
    [[nodiscard]] virtual Difference difference(const float* a, const float* b, int width,
                                                int height) const = 0;
    /// Pixels of linear light that a viewer would tell apart (Yee's metric), on a display of that
    /// luminance that fills so many degrees of the view.
    [[nodiscard]] virtual int yee_failed(const float* a, const float* b, int width, int height,
                                         float luminance_cd_m2, float field_deg) const = 0;
};

/// The library, which lies in a file of its own beside the program and is loaded when it is first
/// asked for: with all that it draws in, it takes twenty times as long as the rest of the program
/// takes to start. Throws failure naming the file that is missing or cannot be loaded.
[[nodiscard]] const Library& library();

}  // namespace obscura::images
