// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace obscura::renderer {

/// The images that a frame may need, after Jakobsen 2010, Tables 1 and 2.
enum class Target {
    kAlbedo,          ///< srgb8_alpha8: albedo, specular intensity
    kNormal,          ///< rgba8: view-space normal, specular power / 255
    kDepth,           ///< r32f or r16f: positive view distance in metres; where empty,
                      ///< kBackgroundDepth_m, in 16 bits infinity
    kVisibility,      ///< depth24: which triangle is in front, and which pixels are empty
    kShadow,          ///< depth32f, one layer a directional light
    kPointShadow,     ///< depth32f, six layers a point light: +X -X +Y -Y +Z -Z
    kEmission,        ///< rgba16f: light sent out, baked accessibility
    kOccluderDepth,   ///< as kDepth: what the technique sees, where that is not the image's own
                      ///< G-buffer: once a pixel, nearly opaque blended surfaces in it on demand
    kOccluderNormal,  ///< rgba8: the same of the normal
    kOccluderVisibility,  ///< depth24: the same of the visibility
    kAccessibility,       ///< r32f: what the technique wrote, once a pixel, 1 where empty
    kDenoiseStep,         ///< r32f: between two passes of a filter, once a pixel
    kDenoised,            ///< r32f: what the composite reads after a filter, once a pixel
    kAmbient,             ///< rgba16f: irradiance / pi from the environment
    kDirect,              ///< rgba16f: irradiance / pi from the lights, specular light
    kHdr,                 ///< rgba16f: the image in linear light, before tone mapping
    kDisplay,             ///< rgba8: the image, sRGB code values
    kResolved,            ///< rgba8: the image at its final size, where pixels take several samples
};

/// What the frame does, in this order.
enum class Pass {
    kGeometry,
    kShadow,
    kOccluders,
    kAccessibility,
    kDenoise,
    kLight,
    kComposite,
    kSky,
    kBlend,
    kToneMap,
    kResolve,
};

[[nodiscard]] std::string to_string(Target target);
[[nodiscard]] std::string to_string(Pass pass);

/// How a target is stored, unless its plan says otherwise.
struct TargetFormat {
    const char* name;
    std::size_t bytes_per_texel;
};
[[nodiscard]] TargetFormat format_of(Target target);

/// Whether a target has the image's size, not that of its samples.
[[nodiscard]] bool is_once_a_pixel(Target target);

}  // namespace obscura::renderer
