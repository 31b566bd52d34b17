// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "stimuli/scenes/room/parts.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::room {

using glm::vec2;
using glm::vec3;
using renderer::Mesh;

namespace {

/// A strip of the rounded back between two heights (along z), `above_m` over it.
Mesh back_strip(const Book& book, float z0, float z1, float above_m, int rows) {
    PatchOptions options;
    options.columns = 1;
    options.rows = rows;
    options.size_m = {z1 - z0, 1.3F * book.thick_m};
    return patch(options, [&](float u, float v) {
        const float a = glm::pi<float>() * v;
        const float out = 0.22F * book.thick_m * std::sin(a) + above_m;
        return vec3(-0.5F * book.width_m - out, 0.5F * book.thick_m * (1.0F - std::cos(a)),
                    z0 + (z1 - z0) * u);
    });
}

/// A transform that stands a flat book upright with its back towards +z.
glm::mat4 upright() {
    return {glm::vec4(0.0F, 0.0F, -1.0F, 0.0F), glm::vec4(-1.0F, 0.0F, 0.0F, 0.0F),
            glm::vec4(0.0F, 1.0F, 0.0F, 0.0F), glm::vec4(0.0F, 0.0F, 0.0F, 1.0F)};
}

void put_stack(Assembly& study, base::Random& random, int count, float largest_m,
               const glm::mat4& place) {
    float y = 0.0F;
    for (int i = 0; i < count; ++i) {
        Book book = draw_book(random, largest_m);
        book.width_m *= 1.0F - 0.05F * static_cast<float>(i);
        book.height_m *= 1.0F - 0.05F * static_cast<float>(i);
        put_book(study, book,
                 place * moved(draw(random, -0.012F, 0.012F), y, draw(random, -0.012F, 0.012F)) *
                     about_y(draw(random, -0.22F, 0.22F) +
                             (random.below(4) == 0 ? glm::pi<float>() : 0.0F)));
        y += book.thick_m + 0.0006F;
    }
}

/// Something between the books: of each kind the `turn`-th, 0 first.
void put_ornament(Assembly& study, base::Random& random, const glm::mat4& place, int kind,
                  int turn) {
    constexpr std::array<vec3, 3> glaze{
        {{0.16F, 0.28F, 0.34F}, {0.46F, 0.40F, 0.30F}, {0.34F, 0.12F, 0.07F}}};
    if (kind == 0) {
        const std::array<vec2, 13> vase{{{0.0F, 0.0F},
                                         {0.03F, 0.0F},
                                         {0.032F, 0.01F},
                                         {0.05F, 0.05F},
                                         {0.056F, 0.09F},
                                         {0.045F, 0.13F},
                                         {0.022F, 0.16F},
                                         {0.020F, 0.185F},
                                         {0.030F, 0.20F},
                                         {0.024F, 0.20F},
                                         {0.016F, 0.185F},
                                         {0.018F, 0.16F},
                                         {0.0F, 0.14F}}};
        study.put(Surface::kCeramic, revolve(vase, 32),
                  place * glm::scale(glm::mat4(1.0F),
                                     vec3(1.0F, 0.85F + 0.12F * static_cast<float>(turn), 1.0F)),
                  400U, glaze[static_cast<std::size_t>(turn) % glaze.size()]);
    } else if (kind == 1) {
        study.put(Surface::kWood, bevelled_box({0.12F, 0.08F, 0.16F}, 0.006F),
                  place * moved(0.0F, 0.04F, 0.0F), 401U);
        study.put(Surface::kWood, bevelled_box({0.126F, 0.012F, 0.166F}, 0.004F),
                  place * moved(0.0F, 0.088F, 0.0F), 402U);
        study.put(Surface::kMetal, bevelled_box({0.02F, 0.025F, 0.006F}, 0.002F),
                  place * moved(0.0F, 0.078F, 0.084F), 403U);
    } else if (kind == 2) {
        // A globe on a foot.
        std::vector<vec2> ball;
        for (int i = 0; i <= 20; ++i) {
            const float a = glm::pi<float>() * (static_cast<float>(i) / 20.0F - 0.5F);
            ball.emplace_back(i == 0 || i == 20 ? 0.0F : 0.075F * std::cos(a),
                              0.075F * std::sin(a));
        }
        Mesh globe = revolve(ball, 36);
        paint(globe, [](const vec3& p, const vec3&) {
            const float land = glm::smoothstep(0.02F, 0.10F, fbm(p * 22.0F, 81, 3));
            return glm::mix(vec3(0.16F, 0.26F, 0.30F), vec3(0.50F, 0.38F, 0.20F), land);
        });
        study.put(Surface::kBinding, globe, place * moved(0.0F, 0.145F, 0.0F) * about_z(0.4F),
                  404U);
        study.put(Surface::kMetal, ring(0.083F, 0.0025F, 40),
                  place * moved(0.0F, 0.145F, 0.0F) * lie_along_z(), 405U,
                  vec3(0.9F, 0.72F, 0.45F));
        const std::array<vec2, 5> foot{
            {{0.0F, 0.0F}, {0.055F, 0.0F}, {0.05F, 0.012F}, {0.012F, 0.025F}, {0.010F, 0.074F}}};
        study.put(Surface::kWood, revolve(foot, 28), place, 406U);
        study.put(Surface::kMetal, rod({0.0F, -0.084F, 0.0F}, {0.0F, 0.084F, 0.0F}, 0.003F),
                  place * moved(0.0F, 0.145F, 0.0F) * about_z(0.4F), 407U,
                  vec3(0.9F, 0.72F, 0.45F));
    } else {
        put_stack(study, random, 4, 0.22F, place * about_y(glm::half_pi<float>() * 0.1F));
    }
}

/// Books side by side from x0 to x1 with a leaning one here and there and some room for ornaments;
/// `ornaments` counts those that the case has.
void fill_shelf(Assembly& study, base::Random& random, float x0, float x1, float y, float tallest_m,
                int& ornaments) {
    // One globe, and nothing twice in a row.
    constexpr std::array<int, 9> kKinds{0, 3, 1, 2, 3, 0, 1, 3, 0};
    const float front = kBack + kShelfDepth;
    float x = x0 + 0.004F;
    int since = 0;
    Book like = draw_book(random, tallest_m);
    while (true) {
        Book book = draw_book(random, tallest_m);
        // Sets of the same binding stand together.
        if (random.below(3) != 0) {
            const auto seed = book.seed;
            const float thick = book.thick_m;
            book = like;
            book.seed = seed;
            book.thick_m = glm::mix(thick, like.thick_m, 0.7F);
        } else {
            like = book;
        }
        const float in = draw(random, 0.0F, 0.022F);
        const glm::vec3 at(0.0F, 0.5F * book.height_m, front - in - 0.5F * book.width_m);
        ++since;
        if (since > 9 && random.below(7) == 0) {
            const float lean = draw(random, 0.16F, 0.30F);
            const float foot = x + book.height_m * std::sin(lean);
            const float right = foot + book.thick_m + 0.01F;
            if (right + 0.19F > x1) break;
            put_book(
                study, book,
                moved(foot, y, 0.0F) * about_z(lean) * moved(book.thick_m, at.y, at.z) * upright());
            const auto next = static_cast<std::size_t>(ornaments++) % kKinds.size();
            const auto before = std::count(kKinds.data(), kKinds.data() + next, kKinds[next]);
            put_ornament(study, random, moved(right + 0.095F, y, front - 0.14F), kKinds[next],
                         static_cast<int>(before));
            x = right + 0.20F;
            since = 0;
            continue;
        }
        if (x + book.thick_m + 0.003F > x1) break;
        put_book(study, book,
                 moved(x + book.thick_m, y + at.y, at.z) * about_y(draw(random, -0.012F, 0.012F)) *
                     upright());
        x += book.thick_m + draw(random, 0.0012F, 0.0030F);
    }
}

}  // namespace

Book draw_book(base::Random& random, float tallest_m) {
    constexpr std::array<vec3, 12> kCovers{{{0.30F, 0.055F, 0.045F},
                                            {0.055F, 0.12F, 0.20F},
                                            {0.07F, 0.15F, 0.09F},
                                            {0.42F, 0.33F, 0.20F},
                                            {0.10F, 0.08F, 0.075F},
                                            {0.55F, 0.50F, 0.40F},
                                            {0.23F, 0.12F, 0.06F},
                                            {0.16F, 0.22F, 0.26F},
                                            {0.45F, 0.20F, 0.06F},
                                            {0.28F, 0.27F, 0.24F},
                                            {0.20F, 0.07F, 0.14F},
                                            {0.60F, 0.56F, 0.50F}}};
    Book book;
    book.height_m = std::min(tallest_m, draw(random, 0.185F, 0.30F));
    book.width_m = std::min(0.24F, book.height_m * draw(random, 0.62F, 0.76F));
    book.thick_m = draw(random, 0.014F, 0.030F) + (random.below(5) == 0 ? 0.022F : 0.0F);
    book.cover = kCovers[random.below(kCovers.size())];
    book.label = random.below(2) == 0 ? vec3(0.62F, 0.47F, 0.20F) : vec3(0.70F, 0.66F, 0.56F);
    if (book.cover.g > 0.4F) book.label = {0.22F, 0.10F, 0.07F};
    book.seed = static_cast<std::uint32_t>(random.below(1U << 30U));
    return book;
}

void put_book(Assembly& study, const Book& book, const glm::mat4& place) {
    constexpr float kBoard = 0.0026F;
    const vec3 cover = book.cover * shade_of(book.seed, 0.35F);
    const Mesh board = bevelled_box({book.width_m, kBoard, book.height_m}, 0.0006F);
    for (const float y : {0.5F * kBoard, book.thick_m - 0.5F * kBoard}) {
        study.put(Surface::kBinding, board, place * moved(0.0F, y, 0.0F), book.seed, cover);
    }
    study.put(Surface::kBinding,
              back_strip(book, -0.5F * book.height_m, 0.5F * book.height_m, 0.0F, 8), place,
              book.seed, cover);
    study.put(
        Surface::kPaper,
        bevelled_box({book.width_m - 0.006F, book.thick_m - 2.0F * kBoard, book.height_m - 0.007F},
                     0.0F),
        place * moved(-0.002F, 0.5F * book.thick_m, 0.0F), book.seed,
        shade_of(book.seed + 1U, 0.25F));
    // Title and bands.
    const float top = 0.5F * book.height_m;
    const auto strip = [&](float from, float to, const vec3& tint) {
        study.put(
            Surface::kBinding,
            back_strip(book, top - to * book.height_m, top - from * book.height_m, 0.0004F, 6),
            place, book.seed + 2U, tint);
    };
    const auto style = book.seed % 4U;
    if (style != 3U)
        strip(0.14F, style == 0U ? 0.30F : 0.40F, style == 1U ? book.label : 0.5F * book.cover);
    if (style != 2U) strip(0.80F, 0.87F, book.label);
    if (style == 0U || style == 3U) {
        for (const float at : {0.10F, 0.33F, 0.56F, 0.76F}) strip(at, at + 0.008F, book.label);
    }
}

void build_books(Assembly& study) {
    base::Random random(20100501);
    int ornaments = 0;
    for (std::size_t i = 0; i < kShelf_m.size(); ++i) {
        const float above = i + 1 < kShelf_m.size() ? kShelf_m[i + 1] : 2.15F;
        const float tallest = above - kShelf_m[i] - 0.045F;
        fill_shelf(study, random, kShelfLeft, kShelfMiddle - 0.0125F, kShelf_m[i], tallest,
                   ornaments);
        fill_shelf(study, random, kShelfMiddle + 0.0125F, kShelfRight, kShelf_m[i], tallest,
                   ornaments);
    }
    put_stack(study, random, 6, 0.28F, moved(-0.42F, kDeskTop, -1.74F) * about_y(0.3F));
    put_stack(study, random, 9, 0.30F, moved(0.22F, 0.0F, -1.62F) * about_y(-0.4F));
    put_stack(study, random, 5, 0.27F, moved(0.12F, 0.0F, -1.28F) * about_y(0.9F));
    put_stack(study, random, 3, 0.22F, moved(-1.02F, 0.50F, 1.24F) * about_y(1.4F));
}

}  // namespace obscura::stimuli::room
