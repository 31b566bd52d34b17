// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "renderer/hard_cases/bench.h"
#include "renderer/hard_cases/shapes.h"

namespace obscura::renderer {
namespace {

/// Case 12. A ramp of accessibility through an 8-bit texture, as the driver stores it.
void run_quantisation(Bench& bench) {
    constexpr int kSteps = 4096;
    std::vector<float> ramp(kSteps);
    for (int i = 0; i < kSteps; ++i) {
        ramp[static_cast<std::size_t>(i)] = static_cast<float>(i) / static_cast<float>(kSteps - 1);
    }
    const gl::Texture texture = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
    glTextureStorage2D(texture.name(), 1, GL_R8, kSteps, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, kSteps, 1, GL_RED, GL_FLOAT, ramp.data());
    std::vector<std::uint8_t> stored(ramp.size());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture.name(), 0, GL_RED, GL_UNSIGNED_BYTE,
                      static_cast<GLsizei>(stored.size()), stored.data());
    const std::set<std::uint8_t> levels(stored.begin(), stored.end());
    double sum = 0.0;
    for (std::size_t i = 0; i < ramp.size(); ++i) {
        const double off = stored[i] / 255.0 - static_cast<double>(ramp[i]);
        sum += off * off / static_cast<double>(ramp.size());
    }
    bench.expect("levels of a ramp in 8 bits", 256.0, static_cast<double>(levels.size()), 56.0,
                 "at least 200 are asked for");
    bench.expect("steps down in a rising ramp in 8 bits", 0.0,
                 std::is_sorted(stored.begin(), stored.end()) ? 0.0 : 1.0, 0.0);
    bench.expect("RMSE of 8 bits over a ramp", 1.0 / (255.0 * std::sqrt(12.0)), std::sqrt(sum),
                 1e-4);
}

/// Of the renderer's own formats: what each makes of a technique's values.
void run_formats(Bench& bench, const Technique& technique) {
    constexpr int kSize = 64;
    const auto shot_in = [&](const std::string& format) {
        Variant choice = Bench::settings(technique, 0.4);
        choice.ao_format = format;
        return bench.shoot("clutter in " + format, shapes::clutter(), shapes::camera(5.0F), choice,
                           kSize, kSize);
    };
    Variant eight = Bench::settings(technique, 0.4);
    eight.ao_format = "r8";
    if (!problems_of(eight).empty()) return;
    const Values exact = shot_in("r32f").accessibility;
    for (const auto& [format, most] : {std::pair("r16f", 0x1.0p-11), {"r8", 0.5 / 255.0}}) {
        const Values stored = shot_in(format).accessibility;
        double largest = 0.0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            largest = std::max(largest, std::abs(static_cast<double>(stored[i] - exact[i])));
        }
        bench.expect(std::string("largest difference of A in ") + format + " from A in r32f", 0.0,
                     largest, 1.01 * most);
    }
}

}  // namespace

HardCase quantisation_case() { return {12, "quantisation", run_formats, run_quantisation}; }

}  // namespace obscura::renderer
