// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/model/stored.h"

#include <algorithm>
#include <cmath>

namespace obscura::renderer {

Admitted as_stored(Admitted pixel, const std::string& format) {
    const auto step_at = [&format](double value) {
        if (format == "r8") return 1.0 / 255.0;
        if (format != "r16f") return 0.0;
        return std::ldexp(1.0, std::max(std::ilogb(std::max(value, 1.0e-9)), -14) - 10);
    };
    pixel.low -= step_at(pixel.low);
    pixel.high += step_at(pixel.high);
    return pixel;
}

}  // namespace obscura::renderer
