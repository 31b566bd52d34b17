// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "stimuli/scenes/support/implicit_surface.h"

namespace obscura::stimuli::relic {

// The parts of the relic, each adding strokes to a sculpture. World space, metres; the piece
// stands on y = 0 and its front faces +Z.

/// Linear colours of the stone.
inline constexpr glm::vec3 kJade{0.43F, 0.555F, 0.455F};
inline constexpr glm::vec3 kPale{0.69F, 0.67F, 0.585F};
inline constexpr glm::vec3 kDeep{0.375F, 0.485F, 0.400F};
inline constexpr glm::vec3 kSandstone{0.56F, 0.51F, 0.435F};

/// The spine from the tip of the tail to the skull; normals point to the back.
[[nodiscard]] Curve spine();
/// Where the head sits on the spine.
[[nodiscard]] Placed head_place();

/// Overlapping scales, `around` of them to a turn and up to `high_m` high where the tube is
/// thickest; with `plates`, broad plates on the side that faces away from the normal.
[[nodiscard]] TubeStyle scales(const Curve& curve, int around, float high_m, bool plates);

void add_body(Sculpture& sculpture, const Curve& spine);
void add_crest(Sculpture& sculpture, const Curve& spine);
void add_limbs(Sculpture& sculpture);
void add_head(Sculpture& sculpture);
void add_mane(Sculpture& sculpture);
void add_base(Sculpture& sculpture);

}  // namespace obscura::stimuli::relic
