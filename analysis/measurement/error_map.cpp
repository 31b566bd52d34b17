// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "analysis/measurement/plots.h"
#include "analysis/text/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {

Plot error_map(const ErrorMap& map) {
    const std::size_t pixels =
        map.width > 0 && map.height > 0
            ? static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height)
            : 0;
    if (pixels == 0 || map.difference.size() != pixels) {
        throw base::bad_input("error map {}: {} pixels for {}x{}", map.name, map.difference.size(),
                              map.width, map.height);
    }
    std::vector<float> values = map.difference;
    for (float& value : values) {
        if (!std::isfinite(value)) value = std::numeric_limits<float>::quiet_NaN();
    }
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());

    Plot plot;
    plot.name = map.name;
    plot.title = map.title;
    // The image at its own size beside the bar, and room for both texts.
    plot.width_px = std::max(map.width + 180, 560);
    plot.height_px = std::max(map.height + 90, 340);
    const std::string file = map.name + ".f32";
    plot.data.push_back({file, std::move(bytes)});
    plot.script = fmt::format(
        "# {0}: {1}x{2} 32-bit floats, upper row first\n"
        "set palette defined (-1 \"#0072B2\", 0 \"#FFFFFF\", 1 \"#D55E00\")\n"
        "set cbrange [{3}:{4}]\n"
        "set cblabel \"measured - truth, accessibility\"\n"
        "set xrange [-0.5:{5}]\nset yrange [-0.5:{6}]\nset size ratio -1\nunset xtics\nunset "
        "ytics\n"
        "set object 1 rectangle from graph 0,0 to graph 1,1 behind fc rgb \"#000000\"\n"
        "plot \"{0}\" binary array=({1},{2}) flipy format=\"%float32\" with image notitle\n",
        file, map.width, map.height, shortest(-map.limit), shortest(map.limit),
        shortest(map.width - 0.5), shortest(map.height - 0.5));
    return plot;
}

}  // namespace obscura::analysis
