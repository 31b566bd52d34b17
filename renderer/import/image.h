// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "renderer/import/import.h"
#include "renderer/scene/scene.h"

namespace obscura::renderer::import_detail {

/// The texels of an image, and whether it has an alpha channel; where not, alpha is 255.
struct DecodedImage {
    Texture texture;
    bool has_alpha = false;
};

/// Decodes textures while the bytes they may take last.
class ImageDecoder {
  public:
    /// The texels of an image file (PNG, JPEG, TGA, BMP, TIFF, WebP) as they are stored: alpha not
    /// multiplied into the colours. `name` says the format where the first bytes do not. Nothing
    /// and why in `why` where the header names more than ImportLimits allow (nothing is decoded
    /// then), or the content is cut off or damaged.
    [[nodiscard]] std::optional<DecodedImage> decode(std::string_view bytes,
                                                     const std::string& name, bool srgb,
                                                     std::string& why);

    /// Whether there is room for a texture of that many bytes which is made of others; takes it.
    [[nodiscard]] bool take(std::size_t bytes);

    /// Says that a decoded texture was thrown away.
    void give_back(const Texture& texture) { left_bytes_ += texture.rgba.size(); }

  private:
    std::size_t left_bytes_ = ImportLimits::kTextureBytes;
    std::size_t left_work_bytes_ = 4 * ImportLimits::kTextureBytes;  ///< given back or not
};

/// Stands in for a texture that could not be read: magenta and dark grey squares.
[[nodiscard]] Texture checkerboard(const std::string& name);

}  // namespace obscura::renderer::import_detail
