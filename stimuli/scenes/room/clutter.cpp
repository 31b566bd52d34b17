// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/room/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::room {
namespace {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

/// A leaf that rises from its stalk and bends over outwards (+z).
Mesh leaf(float length, float width, float bend) {
    PatchOptions options;
    options.columns = 4;
    options.rows = 6;
    return patch(options, [&](float u, float v) {
        const float across = (0.5F - u) * width;
        const float angle = bend * v;
        const float fold = 0.35F * std::abs(across);
        return vec3(across, length * std::sin(angle) / bend + fold * std::cos(angle),
                    length * (1.0F - std::cos(angle)) / bend - fold * std::sin(angle) * 0.2F);
    });
}

/// A rubber tree in a glazed pot: stems with leaves all round.
void put_plant(Assembly& study, const glm::mat4& place) {
    const std::array<vec2, 11> pot{{{0.0F, 0.0F},
                                    {0.11F, 0.0F},
                                    {0.115F, 0.01F},
                                    {0.15F, 0.16F},
                                    {0.165F, 0.26F},
                                    {0.175F, 0.27F},
                                    {0.175F, 0.30F},
                                    {0.165F, 0.305F},
                                    {0.155F, 0.295F},
                                    {0.15F, 0.25F},
                                    {0.0F, 0.245F}}};
    study.put(Surface::kCeramic, revolve(pot, 48), place, 700U, vec3(0.30F, 0.24F, 0.17F));
    const std::array<vec2, 3> earth{{{0.152F, 0.262F}, {0.08F, 0.272F}, {0.0F, 0.275F}}};
    study.put(Surface::kSoil, revolve(earth, 32), place, 701U);
    base::Random random(41);
    for (int s = 0; s < 5; ++s) {
        const float turn = 1.26F * static_cast<float>(s) + draw(random, -0.3F, 0.3F);
        const float high = draw(random, 0.75F, 1.25F);
        const vec3 lean(0.22F * std::sin(turn), 0.0F, 0.22F * std::cos(turn));
        std::vector<vec3> stem;
        for (int i = 0; i <= 10; ++i) {
            const float t = static_cast<float>(i) / 10.0F;
            stem.push_back(0.25F * lean + vec3(0.0F, 0.25F + high * t, 0.0F) + lean * t * t);
        }
        study.put(Surface::kWood, sweep(circle(0.009F, 8), frames_along(stem, {0.0F, 0.0F, 1.0F})),
                  place, 702U, vec3(0.75F, 0.8F, 0.6F));
        const int leaves = 16;
        for (int i = 0; i < leaves; ++i) {
            const float t = 0.22F + 0.80F * static_cast<float>(i) / leaves;
            const vec3 at =
                0.25F * lean + vec3(0.0F, 0.25F + high * std::min(t, 1.0F), 0.0F) + lean * t * t;
            const float size = draw(random, 0.17F, 0.27F) * (1.15F - 0.4F * t);
            study.put_mapped(Surface::kLeaf, leaf(size, 0.48F * size, draw(random, 0.9F, 1.7F)),
                             place * moved(at) * about_y(2.4F * static_cast<float>(i) + turn) *
                                 about_x(draw(random, 0.2F, 0.75F)),
                             shade_of(static_cast<std::uint32_t>(100 * s + i), 0.4F));
        }
    }
}

/// Wire hoops and staves, with balls of crumpled paper inside and beside it.
void put_basket(Assembly& study, const glm::mat4& place) {
    constexpr int kHoops = 15;
    for (int i = 0; i < kHoops; ++i) {
        const float t = static_cast<float>(i) / (kHoops - 1);
        study.put(Surface::kMetal,
                  ring(0.10F + 0.035F * t, i + 1 == kHoops ? 0.004F : 0.0013F, 40, 6),
                  place * moved(0.0F, 0.006F + 0.27F * t, 0.0F), 710U, vec3(0.35F));
    }
    for (const glm::mat4& spot : around(40, 0.0F)) {
        study.put(Surface::kMetal, rod({0.0F, 0.006F, 0.10F}, {0.0F, 0.276F, 0.135F}, 0.0012F, 5),
                  place * spot, 711U, vec3(0.35F));
    }
    const std::array<vec2, 4> base{{{0.0F, 0.0F}, {0.10F, 0.0F}, {0.10F, 0.006F}, {0.0F, 0.006F}}};
    study.put(Surface::kMetal, revolve(base, 32), place, 712U, vec3(0.35F));
    PatchOptions options;
    options.columns = 30;
    options.rows = 22;
    options.closed_u = true;
    std::uint32_t seed = 720;
    for (const vec3& at :
         {vec3(0.02F, 0.055F, 0.03F), vec3(-0.045F, 0.06F, -0.02F), vec3(0.03F, 0.12F, -0.035F),
          vec3(-0.02F, 0.15F, 0.03F), vec3(0.21F, 0.046F, 0.10F)}) {
        ++seed;
        Mesh ball = patch(options, [&](float u, float v) {
            const float a = glm::two_pi<float>() * u;
            const float b = glm::pi<float>() * (v - 0.5F);
            const vec3 way(std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b));
            const float r =
                0.050F * (0.40F + 0.75F * ridged(2.6F * way + static_cast<float>(seed), seed, 2));
            return way * r;
        });
        smooth_normals(ball, 0.35F);
        study.put(Surface::kPaper, ball, place * moved(at), seed, vec3(1.0F));
    }
}

/// Frames with mounts over the desk.
void put_pictures(Assembly& study) {
    const auto hang = [&](const glm::mat4& at, float width, float high, float subject, float tilt,
                          const vec3& tint) {
        const glm::mat4 place = at * about_z(tilt) * about_x(0.025F);
        const float rim = 0.028F;
        for (const float side : {-1.0F, 1.0F}) {
            study.put(Surface::kWood, bevelled_box({rim, high, 0.026F}, 0.006F),
                      place * moved(side * 0.5F * (width - rim), 0.0F, 0.0F), 730U, tint);
            study.put(Surface::kWood, bevelled_box({rim, width - 2.0F * rim, 0.026F}, 0.006F),
                      place * moved(0.0F, side * 0.5F * (high - rim), 0.0F) *
                          about_z(glm::half_pi<float>()),
                      731U, tint);
        }
        study.put(Surface::kPaper, bevelled_box({width - 0.02F, high - 0.02F, 0.006F}, 0.0F),
                  place * moved(0.0F, 0.0F, -0.006F), 732U, vec3(0.95F));
        Mesh canvas = rectangle({-0.5F * (width - 0.13F), -0.5F * (high - 0.13F), -0.002F},
                                {width - 0.13F, 0.0F, 0.0F}, {0.0F, high - 0.13F, 0.0F}, 1.0F);
        for (renderer::Vertex& vertex : canvas.vertices) {
            vertex.uv = {(subject + vertex.position_m.x / (width - 0.13F) + 0.5F) / 3.0F,
                         0.5F - vertex.position_m.y / (high - 0.13F)};
        }
        make_tangents(canvas);
        study.put_mapped(Surface::kPicture, canvas, place);
    };
    hang(moved(kRight - 0.022F, 1.62F, -0.75F) * about_y(-glm::half_pi<float>()), 0.62F, 0.48F,
         2.0F, 0.006F, vec3(0.7F, 0.6F, 0.4F));
    hang(moved(-1.32F, 1.66F, kBack + 0.022F), 0.52F, 0.42F, 0.0F, 0.008F, vec3(0.45F));
    hang(moved(-0.62F, 1.70F, kBack + 0.022F), 0.38F, 0.46F, 1.0F, -0.012F, vec3(1.0F, 0.8F, 0.5F));
}

void put_clock(Assembly& study) {
    const glm::mat4 place = moved(-0.02F, 1.86F, kBack) * lie_along_z();
    const std::array<vec2, 7> shell{{{0.0F, 0.0F},
                                     {0.135F, 0.0F},
                                     {0.145F, 0.012F},
                                     {0.145F, 0.04F},
                                     {0.135F, 0.05F},
                                     {0.122F, 0.046F},
                                     {0.120F, 0.03F}}};
    study.put(Surface::kWood, revolve(shell, 48), place, 740U);
    const std::array<vec2, 2> face{{{0.121F, 0.032F}, {0.0F, 0.032F}}};
    study.put(Surface::kLacquer, revolve(face, 48), place, 741U);
    for (const glm::mat4& spot : around(12, 0.104F)) {
        study.put(Surface::kPlastic, bevelled_box({0.006F, 0.002F, 0.018F}, 0.0F),
                  place * spot * moved(0.0F, 0.033F, 0.0F), 742U, vec3(0.03F));
    }
    study.put(Surface::kPlastic, bevelled_box({0.008F, 0.002F, 0.075F}, 0.0F),
              place * about_y(2.3F) * moved(0.0F, 0.036F, 0.03F), 743U, vec3(0.03F));
    study.put(Surface::kPlastic, bevelled_box({0.006F, 0.002F, 0.105F}, 0.0F),
              place * about_y(-0.4F) * moved(0.0F, 0.039F, 0.045F), 744U, vec3(0.03F));
}

/// Sockets and a strip with plugs and leads below the desk.
void put_cables(Assembly& study) {
    const glm::mat4 strip = moved(-1.55F, 0.03F, kBack + 0.10F) * about_y(0.1F);
    study.put(Surface::kPlastic, bevelled_box({0.30F, 0.035F, 0.055F}, 0.008F), strip, 750U,
              vec3(0.75F));
    for (int i = 0; i < 4; ++i) {
        const vec3 plug(-0.105F + 0.07F * static_cast<float>(i), 0.037F, 0.0F);
        study.put(Surface::kPlastic, bevelled_box({0.034F, 0.045F, 0.034F}, 0.008F),
                  strip * moved(plug), 751U, i == 1 ? vec3(0.75F) : vec3(0.04F));
        const vec3 from = vec3(strip * glm::vec4(plug + vec3(0.0F, 0.022F, 0.0F), 1.0F));
        // Out of the plug, slack on the floor, and up behind the desk's back.
        const float n = static_cast<float>(i);
        const vec3 up(-1.06F + 0.055F * n, 0.0F, -1.957F);
        const std::array<vec3, 9> lead{{from,
                                        from + vec3(0.002F, 0.030F, 0.004F),
                                        from + vec3(0.030F, 0.048F, 0.030F),
                                        from + vec3(0.075F, 0.010F, 0.070F + 0.01F * n),
                                        {from.x + 0.13F, 0.0045F, from.z + 0.125F - 0.018F * n},
                                        {-1.28F + 0.06F * n, 0.0045F, -1.74F + 0.055F * n},
                                        {-1.10F + 0.07F * n, 0.0045F, -1.83F + 0.02F * n},
                                        up + vec3(0.0F, 0.07F, 0.0F),
                                        up + vec3(-0.02F + 0.01F * n, 0.52F, 0.0F)}};
        study.put(Surface::kPlastic, slack_cable(lead, 0.0035F), glm::mat4(1.0F), 752U,
                  vec3(0.035F));
    }
    for (const float x : {-1.78F, -0.08F, 0.26F}) {
        study.put(Surface::kPlastic, bevelled_box({0.146F, 0.086F, 0.012F}, 0.005F),
                  moved(x, 0.28F, kBack + 0.005F), 753U, vec3(0.85F));
        for (const float off : {-0.036F, 0.036F}) {
            study.put(Surface::kPlastic, bevelled_box({0.006F, 0.014F, 0.002F}, 0.0F),
                      moved(x + off, 0.29F, kBack + 0.012F), 754U, vec3(0.03F));
        }
    }
}

/// A pair of slippers on the rug.
void put_slippers(Assembly& study) {
    for (const float side : {-1.0F, 1.0F}) {
        const glm::mat4 place = moved(-1.02F + 0.07F * side, 0.012F, 0.62F + 0.03F * side) *
                                about_y(1.9F + 0.12F * side);
        study.put(Surface::kBinding, cushion({0.098F, 0.026F, 0.27F}, 0.004F),
                  place * moved(0.0F, 0.014F, 0.0F), 760U, vec3(0.12F, 0.08F, 0.06F));
        PatchOptions options;
        options.columns = 20;
        options.rows = 14;
        options.size_m = {0.2F, 0.14F};
        Mesh upper = patch(options, [](float u, float v) {
            const float a = glm::pi<float>() * u;
            const float t = v;
            const float width = 0.050F * std::sqrt(std::max(0.02F, 1.0F - 0.9F * t * t));
            return vec3(width * std::cos(a), 0.018F + (0.055F - 0.035F * t * t) * std::sin(a),
                        0.135F * t - 0.005F);
        });
        study.put(Surface::kBinding, upper, place, 761U, vec3(0.30F, 0.11F, 0.08F));
    }
}

/// Cartons against the right wall, the upper one open.
void put_cartons(Assembly& study) {
    const vec3 brown(0.52F, 0.36F, 0.22F);
    study.put(Surface::kPaper, bevelled_box({0.46F, 0.34F, 0.56F}, 0.006F),
              moved(2.18F, 0.17F, -1.05F) * about_y(0.05F), 770U, brown);
    study.put(Surface::kPaper, bevelled_box({0.463F, 0.003F, 0.06F}, 0.0F),
              moved(2.18F, 0.3405F, -1.05F) * about_y(0.05F), 771U, vec3(0.75F, 0.68F, 0.55F));
    const glm::mat4 open = moved(2.16F, 0.342F, -1.02F) * about_y(-0.22F);
    const float high = 0.26F;
    for (int i = 0; i < 4; ++i) {
        const glm::mat4 side = open * about_y(glm::half_pi<float>() * static_cast<float>(i));
        const float half = i % 2 == 0 ? 0.22F : 0.18F;
        const float width = i % 2 == 0 ? 0.36F : 0.444F;
        study.put(Surface::kPaper, bevelled_box({width, high, 0.005F}, 0.001F),
                  side * moved(0.0F, 0.5F * high, half), 772U, brown);
        study.put(Surface::kPaper, bevelled_box({width - 0.01F, 0.15F, 0.004F}, 0.001F),
                  side * moved(0.0F, high, half) * about_x(1.9F + 0.2F * static_cast<float>(i)) *
                      moved(0.0F, 0.075F, 0.0F),
                  773U, brown * 1.05F);
    }
    study.put(Surface::kPaper, bevelled_box({0.35F, 0.004F, 0.43F}, 0.0F),
              open * moved(0.0F, 0.004F, 0.0F), 774U, brown);
    Book book;
    base::Random random(775);
    for (int i = 0; i < 7; ++i) {
        book = draw_book(random, 0.25F);
        put_book(study, book,
                 open *
                     moved(-0.145F + 0.048F * static_cast<float>(i), 0.006F + 0.5F * book.height_m,
                           0.0F) *
                     glm::mat4(0.0F, 0.0F, -1.0F, 0.0F, -1.0F, 0.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.0F,
                               0.0F, 0.0F, 0.0F, 0.0F, 1.0F));
    }
}

}  // namespace

void build_clutter(Assembly& study) {
    put_plant(study, moved(-1.98F, 0.0F, 0.02F));
    put_basket(study, moved(0.02F, 0.0F, -0.95F));
    put_pictures(study);
    put_clock(study);
    put_cables(study);
    put_slippers(study);
    put_cartons(study);
}

}  // namespace obscura::stimuli::room
