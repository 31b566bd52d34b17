// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace obscura::renderer {

/// What a buffer's size follows from.
enum class Extent {
    kPixels,   ///< the image's pixels
    kSamples,  ///< the image's pixels times the supersampling along each side
    kShadow,   ///< the plan says: a shadow map
};

/// An image that steps write and read: one of the house's, or a recipe's own.
struct Buffer {
    std::string name;    ///< `depth`; in shaders a blank is an underscore
    std::string format;  ///< of frame/format.h: r32f
    Extent extent = Extent::kPixels;
    float scale = 1.0F;  ///< of width and height, (0, 1], rounded up
    int levels = 1;      ///< mip levels, each half of the one above; at most what the size has
    int layers = 1;      ///< more than one: an array
    /// Neighbours in a row that share a texel, each with as many of its components; its width is
    /// rounded up. Of one level and layer.
    int columns = 1;

    /// A buffer is known by its name.
    operator std::string_view() const { return name; }  // NOLINT(google-explicit-constructor)
    [[nodiscard]] bool is(std::string_view other) const { return name == other; }
    bool operator==(const Buffer&) const = default;
};

/// The house's own buffers, after Jakobsen 2010, Tables 1 and 2. Depth may be stored in another
/// format, and shadow maps have the plan's size and layers.
struct Target {
    /// Albedo, specular intensity.
    static inline const Buffer kAlbedo{"albedo", "srgb8_alpha8", Extent::kSamples};
    /// View-space normal, specular power / 255.
    static inline const Buffer kNormal{"normal", "rgba8", Extent::kSamples};
    /// Positive view distance in metres; where empty, kBackgroundDepth_m, in 16 bits infinity.
    static inline const Buffer kDepth{"depth", "r32f", Extent::kSamples};
    /// The surface's point in view space, metres, for a technique that does not rebuild it from
    /// depth; in as many bits a component as the depth.
    static inline const Buffer kPosition{"position", "rgba32f", Extent::kSamples};
    /// Which triangle is in front, and which pixels are empty.
    static inline const Buffer kVisibility{"visibility", "depth24", Extent::kSamples};
    /// One layer a directional light.
    static inline const Buffer kShadow{"shadow", "depth32f", Extent::kShadow};
    /// Six layers a point light: +X -X +Y -Y +Z -Z.
    static inline const Buffer kPointShadow{"point shadow", "depth32f", Extent::kShadow};
    /// Light sent out, baked accessibility.
    static inline const Buffer kEmission{"emission", "rgba16f", Extent::kSamples};
    /// As kDepth: what the technique sees, where that is not the image's own G-buffer: once a
    /// pixel, nearly opaque blended surfaces in it on demand.
    static inline const Buffer kOccluderDepth{"occluder depth", "r32f"};
    static inline const Buffer kOccluderNormal{"occluder normal", "rgba8"};
    static inline const Buffer kOccluderPosition{"occluder position", "rgba32f"};
    static inline const Buffer kOccluderVisibility{"occluder visibility", "depth24"};
    /// Of those, what a technique at a lower scale or with formats of its own sees: every so many
    /// columns and rows, from the first.
    static inline const Buffer kSeenDepth{"seen depth", "r32f"};
    static inline const Buffer kSeenNormal{"seen normal", "rgba8"};
    static inline const Buffer kSeenPosition{"seen position", "rgba32f"};
    static inline const Buffer kSeenVisibility{"seen visibility", "depth24"};
    /// The nearest surface that lies a least distance behind the first, in m; kBackgroundDepth_m
    /// where there is none.
    static inline const Buffer kSecondDepth{"second depth", "r32f"};
    static inline const Buffer kSecondVisibility{"second visibility", "depth24"};
    /// What the technique wrote, 1 where empty; a filter may have depth beside it
    /// (recipe/depth_beside.h).
    static inline const Buffer kAccessibility{"accessibility", "r32f"};
    /// The accessibility of the frame before, for a recipe of several frames; 1 before the first.
    static inline const Buffer kHistory{"history", "r32f"};
    /// What the composite reads after a filter.
    static inline const Buffer kDenoised{"denoised", "r32f"};
    /// The same at the image's size, where the technique had a lower one.
    static inline const Buffer kUpsampled{"upsampled", "r32f"};
    /// Irradiance / pi from the environment.
    static inline const Buffer kAmbient{"ambient light", "rgba16f", Extent::kSamples};
    /// Irradiance / pi from the lights, specular light.
    static inline const Buffer kDirect{"direct light", "rgba16f", Extent::kSamples};
    /// The image in linear light, before tone mapping.
    static inline const Buffer kHdr{"hdr", "rgba16f", Extent::kSamples};
    /// The same after a technique that makes colour, which reads and writes it as `colour`.
    static inline const Buffer kColour{"colour", "rgba16f", Extent::kSamples};
    /// The image, sRGB code values.
    static inline const Buffer kDisplay{"display", "rgba8", Extent::kSamples};
    /// The image at its final size, where pixels take several samples.
    static inline const Buffer kResolved{"resolved", "rgba8"};
};

}  // namespace obscura::renderer
