// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "renderer/light/environment.h"

namespace obscura::renderer {

struct IrradianceGrid;

/// Parallel light, as from the sun.
struct DirectionalLight {
    glm::vec3 towards_light{0.0F, 1.0F, 0.0F};  ///< unit length, from the surface to the light
    glm::vec3 irradiance{1.0F};  ///< linear Rec. 709, on a surface that faces the light; pi makes a
                                 ///< white diffuse surface 1
};

/// Light from a point, to all sides or within a cone.
struct PointLight {
    glm::vec3 position_m{0.0F, 1.0F, 0.0F};
    glm::vec3 intensity{1.0F};  ///< linear Rec. 709: the irradiance at 1 m of a surface that faces
                                ///< it; falls with the distance squared
    glm::vec3 direction{0.0F, -1.0F, 0.0F};   ///< unit length, the axis of the cone
    float inner_cone_rad = glm::pi<float>();  ///< half angle within which nothing is lost
    float outer_cone_rad = glm::pi<float>();  ///< half angle beyond which there is no light
    float range_m = std::numeric_limits<float>::infinity();  ///< > 0; no light beyond
};

/// Curves from scene light to display light, all on linear Rec. 709.
enum class ToneCurve {
    kReinhard,  ///< Reinhard et al. 2002, equation 4, on luminance
    kFilmic,    ///< Hable 2010 (Uncharted 2), on each channel
    kAces,      ///< Narkowicz 2016, fit to the ACES reference, on each channel; `white` has no part
    kClip,      ///< none: values above 1 are clipped
};

inline constexpr std::array kToneCurves{ToneCurve::kReinhard, ToneCurve::kFilmic, ToneCurve::kAces,
                                        ToneCurve::kClip};

/// `reinhard`, `filmic`, `aces` or `clip`, as in files.
[[nodiscard]] constexpr std::string_view to_string(ToneCurve curve) {
    switch (curve) {
        case ToneCurve::kReinhard:
            return "reinhard";
        case ToneCurve::kFilmic:
            return "filmic";
        case ToneCurve::kAces:
            return "aces";
        case ToneCurve::kClip:
            return "clip";
    }
    return "";
}

/// Tone mapping of a scene.
struct ToneMapping {
    float exposure = 1.0F;  ///< factor before the curve, > 0
    float white = 4.0F;     ///< value (after exposure) that becomes display white, > 0
    ToneCurve curve = ToneCurve::kReinhard;
};

/// All the light of a scene. What is absent costs nothing: no environment means constant ambient
/// light, no tone mapping means values above 1 are clipped.
struct Lighting {
    glm::vec3 ambient{1.0F};     ///< radiance from everywhere, used where there is no environment
    glm::vec3 background{1.0F};  ///< linear colour of empty pixels, where there is no environment
    std::shared_ptr<const Environment> environment;  ///< irradiance and skybox
    /// Whether the environment's irradiance depends on where one stands; without an environment it
    /// means nothing.
    bool irradiance_probes = false;
    /// Baked for that light and scene (reference/irradiance_baker.h) before anything is drawn.
    std::shared_ptr<const IrradianceGrid> irradiance_grid;
    std::vector<DirectionalLight> lights;  ///< each casts shadows
    std::vector<PointLight> point_lights;  ///< each casts shadows
    bool normal_mapping = false;
    std::optional<ToneMapping> tone_mapping;

    /// Whether a grid is asked for.
    [[nodiscard]] bool wants_probes() const { return environment != nullptr && irradiance_probes; }
};

}  // namespace obscura::renderer
