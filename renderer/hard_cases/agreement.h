// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/model/model.h"
#include "renderer/model/seen_buffers.h"

namespace obscura::renderer {

/// A pixel that was held against its definition.
struct HeldPixel {
    std::string where;
    double definition = 1.0;
    double measured = 1.0;
    double allowed = 0.0;  ///< how far single precision may lead in that direction

    [[nodiscard]] bool holds() const;
    /// Grows with how far the pixel is beyond, or how near it is to, what is allowed.
    [[nodiscard]] double rank() const;
};

/// How far images are from what the definition gives on the same buffers.
struct Agreement {
    std::size_t images = 0;
    std::size_t pixels = 0;
    std::size_t off = 0;        ///< pixels beyond what single precision allows
    std::size_t uncertain = 0;  ///< pixels that rounding may move by more than kUncertain
    HeldPixel worst;

    void add(const Agreement& other);
};
inline constexpr double kUncertain = 0.01;

/// Holds every admitted pixel against what was measured; `admitted` has no value where the image
/// was only looked at here and there. `what` names the image. Both upper row first.
[[nodiscard]] Agreement agreement_of(std::span<const std::optional<Admitted>> admitted,
                                     std::span<const float> measured, int width,
                                     const std::string& what);

/// The model's value of each pixel, 1 where nothing is seen; of images of more than 65,536 pixels
/// only of every so many, which meet every place of the tile of rotations.
[[nodiscard]] std::vector<std::optional<Admitted>> admitted_by(const PixelModel& model,
                                                               const SeenBuffers& buffers);

}  // namespace obscura::renderer
