// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "app/explorer/colour_scale.h"
#include "app/explorer/layout.h"
#include "app/explorer/shot.h"
#include "app/explorer/truth.h"
#include "stimuli/png.h"

namespace obscura::app::explorer {

/// The colours of a layer, with what they stand for.
struct Scale {
    Rgb (*colour)(float) = nullptr;  ///< nothing: the picture's colours mean themselves
    float low = 0.0F;                ///< the values at the scale's ends
    float high = 1.0F;
    bool diverging = false;  ///< the scale runs over [-1, 1]
    std::string unit;
};

/// A layer as people see it, sRGB; empty (width 0) where there is nothing to show.
struct Picture {
    stimuli::RgbImage image;
    Scale scale;
    std::string why_not;  ///< where there is nothing: what is missing, a sentence
};

/// What a layer of a shot looks like. `truth` may be none, and must be of the shot's size.
[[nodiscard]] Picture picture_of(const Shot& shot, const Truth* truth, const std::string& layer,
                                 const Layout& layout);

/// Whether the layer needs the buffers beside the image, or the truth.
[[nodiscard]] bool needs_buffers(const std::string& layer);
[[nodiscard]] bool needs_truth(const std::string& layer);

/// Smallest and largest depth of surfaces; 0 and 1 where there are none.
struct Range {
    float low = 0.0F;
    float high = 1.0F;
};
[[nodiscard]] Range depth_range(const Shot& shot);

}  // namespace obscura::app::explorer
