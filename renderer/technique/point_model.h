// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "renderer/model/seen_buffers.h"
#include "renderer/technique/slices_model.h"

namespace obscura::renderer {

// What the models of techniques that look up a point of the room share.

/// What a sample is worth over all depths that its look-up may give: `worth` gives a Bounded for
/// one depth in metres, between 0 and 1.
template <typename Worth>
[[nodiscard]] Bounded worth_over(const SeenDepths& seen, const Worth& worth) {
    Bounded found = worth(Rounded(seen.nominal_m));
    for (const float depth_m : seen.all_m()) {
        const Bounded other = worth(Rounded(depth_m));
        found.low = std::min(found.low, other.low);
        found.high = std::max(found.high, other.high);
    }
    if (seen.any) found = {found.value, 0.0, 1.0};
    return found;
}

/// 1 where a < b, as rounding may decide it.
[[nodiscard]] inline Bounded if_less(const Rounded& a, const Rounded& b) {
    return {a.value < b.value ? 1.0 : 0.0, may_be_at_least(a, b) ? 0.0 : 1.0,
            may_be_less(a, b) ? 1.0 : 0.0};
}

}  // namespace obscura::renderer
