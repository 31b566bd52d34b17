// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "renderer/technique/disc.h"
#include "renderer/technique/slices_model.h"

namespace obscura::renderer {

/// The points of a pixel's disc: technique/disc.glsl in double precision.
class DiscModel {
  public:
    DiscModel(const SeenBuffers& buffers, const Variant& variant);

    /// The sum over all points of what `worth` gives the texel that they fall on: at least 0 and,
    /// where a point may be anywhere, at most `most`. Nothing outside the image.
    [[nodiscard]] Rounded sum(int x, int y, double most,
                              const std::function<Rounded(int x, int y)>& worth) const;
    [[nodiscard]] const SeenView& view() const { return view_; }
    [[nodiscard]] int samples() const { return static_cast<int>(kernel_.size()); }

  private:
    const SeenBuffers& buffers_;
    SeenView view_;
    Rounded radius_m_;
    std::vector<DiscPoint> kernel_;
    Tile<Turn> tile_;
};

}  // namespace obscura::renderer
