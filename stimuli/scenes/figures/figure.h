// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"
#include "stimuli/scenes/support/implicit_surface.h"

namespace obscura::stimuli::figures {

// People are modelled in a place of their own: origin between the feet on the ground, Y up, the
// face towards +Z, the person's left at +X.

/// What a part is made of; the scene's materials are in this order.
enum class Cloth : std::uint32_t {
    kSkin,
    kHair,
    kEye,
    kJacket,
    kShirt,
    kTrousers,
    kLeather,
    kMetal,
    kGround,
    kWisps,  ///< hairs on cards, cut out
    kBlock,  ///< stone without joints
    kCount,
};

/// One garment or part of a body: a solid of its own with one material.
struct FigurePart {
    std::string name;
    Cloth cloth = Cloth::kSkin;
    float cell_m = 0.006F;       ///< of the grid that it is meshed on
    float texture_m = 0.0F;      ///< what one repeat of the material's texture covers
    float painted_shade = 0.6F;  ///< how dark the occlusion painted into its colours gets, [0, 1]
    Sculpture solid;
};

struct Eye {
    glm::vec3 centre_m{0.0F};
    float radius_m = 0.0125F;
    glm::vec3 gaze{0.0F, 0.0F, 1.0F};  ///< unit length
    glm::vec3 iris{0.2F, 0.12F, 0.06F};
};

/// A card with a lock of hair: from its root to its end.
struct Wisp {
    std::vector<glm::vec3> path_m;
    glm::vec3 inside_m{0.0F};  ///< what it faces away from
    float width_m = 0.01F;
    int strip = 0;  ///< of the material's four; the last one has no gaps
    float root_shade = 1.0F;
    glm::vec3 colour{0.1F};
};

/// A finished mesh of a figure: what is too thin or too crisp for a solid's grid.
struct Overlaid {
    std::string name;
    Cloth cloth = Cloth::kLeather;
    float texture_m = 0.12F;
    renderer::Mesh mesh;
};

struct Figure {
    std::string name;
    std::vector<FigurePart> parts;
    std::vector<Overlaid> overlaid;
    std::vector<Eye> eyes;
    std::vector<Wisp> wisps;

    /// What the skin's colour is multiplied by at a place, for blood, beard and shadows under the
    /// eyes; optional.
    std::function<glm::vec3(const glm::vec3& position_m)> complexion;

    FigurePart& part(const std::string& part_name, Cloth cloth, float cell_m, float texture_m);
};

/// The scalp, from the middle of a head 0.235 m high: an ellipsoid that hair is laid over.
inline constexpr glm::vec3 kScalpMiddle{0.0F, 0.034F, -0.012F};
inline constexpr glm::vec3 kScalpRadii{0.0755F, 0.083F, 0.0965F};

/// What makes one face differ from another. Lengths are factors of an average man's.
struct FaceTraits {
    float jaw = 1.0F;      ///< width of the jaw
    float hollow = 1.0F;   ///< of the cheeks
    float brow = 1.0F;     ///< strength of the brow ridge
    float lips = 1.0F;     ///< fullness
    float nose = 1.0F;     ///< size
    float neck = 1.0F;     ///< girth
    float throat = 1.0F;   ///< how far the larynx stands out; 0: not at all
    float eyelids = 1.0F;  ///< opening of the eyes
    float nose_width = 1.0F;
    float nose_length = 1.0F;
    float cheeks = 0.0F;  ///< fullness of the cheeks, [0, 1]
    float age = 0.8F;     ///< depth of the lines from nose to mouth
    float slant = 1.0F;   ///< how far the outer corners of the eyes stand up
    float beard = 0.0F;   ///< shade of a shaven beard, [0, 1]
    glm::vec3 skin{0.55F, 0.36F, 0.27F};
    glm::vec3 lip{0.45F, 0.22F, 0.18F};
    glm::vec3 brows{0.08F, 0.05F, 0.035F};
    float brow_weight = 1.0F;  ///< thickness of the eyebrows
    glm::vec3 hair{0.09F, 0.055F, 0.035F};
    std::function<float(float turn_rad)>
        hairline;  ///< rise by turn, on the scalp: where hair begins
    glm::vec3 iris{0.2F, 0.12F, 0.06F};
};
/// A face without eyes, nose and mouth, and the jaw below it.
[[nodiscard]] ShapePtr face_form(const Placed& at, float scale, const FaceTraits& traits);

/// What the skin's colour is multiplied by at `q`, metres from the middle of a head 0.235 m high:
/// blood, shadows under the eyes, brows, a shaven beard, and hair where it is too short to be seen
/// from the side.
[[nodiscard]] glm::vec3 complexion_at(const glm::vec3& q, const FaceTraits& traits);

/// Face, ears and neck; `at` is the middle of the head at the height of the eyes.
void add_head(Figure& figure, const Placed& at, float scale, const FaceTraits& traits);

/// Where hair begins on the scalp: how far up, by the turn from the forehead, both as angles.
[[nodiscard]] float short_hairline(float turn_rad);
[[nodiscard]] float long_hairline(float turn_rad);
/// The height at `x` of a line through points with rising x.
[[nodiscard]] float along_line(std::span<const glm::vec2> line, float x);

/// A man's short hair, brushed up and aside; a woman's, drawn back into a ponytail.
void add_short_hair(Figure& figure, const Placed& at, float scale, const glm::vec3& colour);
void add_ponytail(Figure& figure, const Placed& at, float scale, const glm::vec3& colour);

/// A hand. `at`: origin at the wrist, forward along the fingers, up out of the back of the hand.
struct HandPose {
    std::array<float, 3> curl_rad{0.35F, 0.45F, 0.3F};  ///< at knuckle, middle and end joint
    float spread_rad = 0.06F;                           ///< between neighbouring fingers
    float thumb_in = 0.3F;  ///< 0 stretched out to the side, 1 across the palm
};
void add_hand(Sculpture& skin, const Placed& at, float scale, float thumb_side,
              const HandPose& pose, const glm::vec3& colour);

/// Folds of a sleeve or trouser leg: they crowd at the joints, on the inner side of the bend.
struct FoldCentre {
    float along_m = 0.0F;      ///< where along the tube
    float reach_m = 0.1F;      ///< how far the folds reach along it
    float angle_rad = 0.0F;    ///< the side on which they crowd
    float height_m = 0.006F;   ///< of the highest fold
    float spacing_m = 0.035F;  ///< between folds
    float evenness = 0.3F;     ///< 0: only on that side; 1: all round
};
[[nodiscard]] TubeStyle folded(std::vector<FoldCentre> centres, std::uint32_t seed);

/// A ray from outside a solid towards it.
struct Beam {
    glm::vec3 from_m{0.0F};
    glm::vec3 way{0.0F, 0.0F, -1.0F};  ///< unit length
};
/// A strap, band, pocket or belt: a sheet that lies on a solid where beams meet it.
struct OverlayStyle {
    int columns = 4;  ///< across, along u
    int rows = 24;    ///< along v
    float thick_m = 0.003F;
    glm::vec3 colour{1.0F};
    int stiff = 1;          ///< over how many rows to each side it bridges hollows
    bool ring = false;      ///< v goes all round
    float sunk_m = 0.006F;  ///< how far its underside lies in the solid
};
[[nodiscard]] renderer::Mesh overlay(const Sculpture& solid, const OverlayStyle& style,
                                     const std::function<Beam(float u, float v)>& beam);
/// Beams for a band of that width along a path near a solid.
[[nodiscard]] std::function<Beam(float u, float v)> along_path(const std::vector<glm::vec3>& path_m,
                                                               const glm::vec3& way, float wide_m);
/// Beams for a belt about the upright axis through `middle`; its left side hangs `slant_m` lower.
[[nodiscard]] std::function<Beam(float u, float v)> around_body(const Placed& at,
                                                                const glm::vec3& middle,
                                                                const glm::vec2& radii_m,
                                                                float high_m, float slant_m);

/// A collar that is turned down on what is worn.
struct CollarCut {
    glm::vec3 neck_m{0.0F};  ///< middle of its fold at the nape's height
    float radius_m = 0.06F;  ///< of the fold
    float open_rad = 0.35F;  ///< how far it stops from the middle in front
    float drop_m = 0.05F;    ///< how much lower it is there
    float wide_m = 0.035F;   ///< at the nape
    float point_m = 0.06F;   ///< at its points
};
void add_collar(Figure& figure, const Placed& at, const Sculpture& clothes, const CollarCut& cut,
                Cloth cloth, float texture_m, const glm::vec3& colour);

/// Of a boot: how high its shaft ends above the ground, and its radius there.
struct Shaft {
    float high_m;
    float radius_m;
};

/// `ankle` is where a boot stands, `toe` which way it points in the ground plane, `knee` what its
/// shaft slants towards. Its upper is added to `leather`; sole and laces to the figure.
void add_boot(Figure& figure, Sculpture& leather, const Placed& person, const glm::vec3& ankle,
              const glm::vec3& knee, const glm::vec2& toe, float scale, const Shaft& shaft,
              const glm::vec3& colour);

[[nodiscard]] Figure make_man(const Placed& place);
[[nodiscard]] Figure make_woman(const Placed& place);

/// Meshes every part, paints the occlusion of the whole figure into the vertex colours, and adds
/// the result to the scene.
void add_to_scene(renderer::Scene& scene, const Figure& figure);

/// Materials in the order of Cloth.
void add_materials(renderer::Scene& scene);

/// Floor and low wall.
void add_surroundings(renderer::Scene& scene);

/// The front of a house across the street behind them.
void add_backdrop(renderer::Scene& scene);

}  // namespace obscura::stimuli::figures
