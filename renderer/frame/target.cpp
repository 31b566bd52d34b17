// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/target.h"

namespace obscura::renderer {
namespace {

struct Facts {
    const char* name;
    TargetFormat format;
};

Facts facts_of(Target target) {
    switch (target) {
        case Target::kAlbedo:
            return {"albedo", {"srgb8_alpha8", 4}};
        case Target::kNormal:
            return {"normal", {"rgba8", 4}};
        case Target::kDepth:
            return {"depth", {"r32f", 4}};
        case Target::kVisibility:
            return {"visibility", {"depth24", 4}};
        case Target::kShadow:
            return {"shadow", {"depth32f", 4}};
        case Target::kPointShadow:
            return {"point shadow", {"depth32f", 4}};
        case Target::kEmission:
            return {"emission", {"rgba16f", 8}};
        case Target::kOccluderDepth:
            return {"occluder depth", {"r32f", 4}};
        case Target::kOccluderNormal:
            return {"occluder normal", {"rgba8", 4}};
        case Target::kOccluderVisibility:
            return {"occluder visibility", {"depth24", 4}};
        case Target::kAccessibility:
            return {"accessibility", {"r32f", 4}};
        case Target::kDenoiseStep:
            return {"denoise step", {"r32f", 4}};
        case Target::kDenoised:
            return {"denoised", {"r32f", 4}};
        case Target::kAmbient:
            return {"ambient light", {"rgba16f", 8}};
        case Target::kDirect:
            return {"direct light", {"rgba16f", 8}};
        case Target::kHdr:
            return {"hdr", {"rgba16f", 8}};
        case Target::kDisplay:
            return {"display", {"rgba8", 4}};
        case Target::kResolved:
            return {"resolved", {"rgba8", 4}};
    }
    return {"", {"", 0}};
}

}  // namespace

bool is_once_a_pixel(Target target) {
    switch (target) {
        case Target::kOccluderDepth:
        case Target::kOccluderNormal:
        case Target::kOccluderVisibility:
        case Target::kAccessibility:
        case Target::kDenoiseStep:
        case Target::kDenoised:
        case Target::kResolved:
            return true;
        default:
            return false;
    }
}

TargetFormat format_of(Target target) { return facts_of(target).format; }

std::string to_string(Target target) { return facts_of(target).name; }

std::string to_string(Pass pass) {
    switch (pass) {
        case Pass::kGeometry:
            return "geometry";
        case Pass::kShadow:
            return "shadow";
        case Pass::kOccluders:
            return "occluders";
        case Pass::kAccessibility:
            return "accessibility";
        case Pass::kDenoise:
            return "denoise";
        case Pass::kLight:
            return "light";
        case Pass::kComposite:
            return "composite";
        case Pass::kSky:
            return "sky";
        case Pass::kBlend:
            return "blend";
        case Pass::kToneMap:
            return "tone map";
        case Pass::kResolve:
            return "resolve";
    }
    return "";
}

}  // namespace obscura::renderer
