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

const vec3 kLampFoot(-1.72F, kDeskTop, -1.72F);
const vec3 kBulb(-1.38F, kDeskTop + 0.40F, -1.56F);
constexpr vec3 kBlack(0.030F, 0.030F, 0.032F);

}  // namespace

vec3 lamp_bulb_m() { return kBulb; }
vec3 lamp_axis() { return glm::normalize(vec3(0.22F, -1.0F, 0.16F)); }

namespace {

/// Foot, two jointed arms with springs, and a shade open below.
void put_lamp(Assembly& study) {
    const vec3 dark_green(0.045F, 0.115F, 0.085F);
    const std::array<vec2, 7> foot{{{0.0F, 0.0F},
                                    {0.085F, 0.0F},
                                    {0.088F, 0.008F},
                                    {0.080F, 0.022F},
                                    {0.03F, 0.030F},
                                    {0.016F, 0.05F},
                                    {0.0F, 0.05F}}};
    study.put(Surface::kPlastic, revolve(foot, 40), moved(kLampFoot), 500U, dark_green);
    const vec3 elbow(-1.86F, kDeskTop + 0.40F, -1.80F);
    const vec3 head = kBulb - lamp_axis() * 0.085F;
    const vec3 base = kLampFoot + vec3(0.0F, 0.05F, 0.0F);
    const vec3 side(0.0F, 0.0F, 0.014F);
    for (const float s : {-1.0F, 1.0F}) {
        study.put(Surface::kMetal, rod(base + s * side, elbow + s * side, 0.005F), glm::mat4(1.0F),
                  501U);
        study.put(Surface::kMetal, rod(elbow + s * side, head + s * side, 0.005F), glm::mat4(1.0F),
                  501U);
    }
    for (const vec3& joint : {base, elbow, head}) {
        study.put(Surface::kMetal, rod(joint - 2.2F * side, joint + 2.2F * side, 0.012F, 16),
                  glm::mat4(1.0F), 502U);
    }
    // The spring.
    std::vector<vec3> coil;
    const vec3 along = elbow - base;
    for (int i = 0; i <= 150; ++i) {
        const float t = static_cast<float>(i) / 150.0F;
        const float a = 0.75F * static_cast<float>(i);
        coil.push_back(base + along * (0.12F + 0.3F * t) + vec3(0.0F, 0.0F, 0.0F) +
                       0.007F * vec3(std::cos(a), 0.0F, std::sin(a)));
    }
    study.put(Surface::kMetal, sweep(circle(0.0011F, 5), frames_along(coil, {0.0F, 1.0F, 0.0F})),
              glm::mat4(1.0F), 503U);
    const vec3 y = -lamp_axis();
    const vec3 x = any_perpendicular(y);
    const glm::mat4 shade(glm::vec4(x, 0.0F), glm::vec4(y, 0.0F), glm::vec4(glm::cross(x, y), 0.0F),
                          glm::vec4(kBulb, 1.0F));
    const std::array<vec2, 10> outer{{{0.092F, -0.06F},
                                      {0.094F, -0.055F},
                                      {0.090F, -0.03F},
                                      {0.072F, 0.02F},
                                      {0.045F, 0.055F},
                                      {0.030F, 0.065F},
                                      {0.028F, 0.11F},
                                      {0.022F, 0.12F},
                                      {0.008F, 0.122F},
                                      {0.0F, 0.122F}}};
    study.put(Surface::kPlastic, revolve(outer, 48), shade, 504U, dark_green);
    const std::array<vec2, 5> inner{
        {{0.0F, 0.052F}, {0.040F, 0.050F}, {0.069F, 0.018F}, {0.087F, -0.03F}, {0.092F, -0.06F}}};
    study.put(Surface::kLacquer, revolve(inner, 48), shade, 505U);
    std::vector<vec2> bulb{{0.0F, -0.032F}};
    for (int i = 1; i <= 8; ++i) {
        const float a = glm::pi<float>() * (static_cast<float>(i) / 10.0F - 0.5F);
        bulb.emplace_back(0.030F * std::cos(a), 0.030F * std::sin(a));
    }
    bulb.emplace_back(0.014F, 0.046F);
    bulb.emplace_back(0.0F, 0.05F);
    study.put(Surface::kBulb, revolve(bulb, 24), shade, 506U);
    const std::array<vec3, 10> lead{{kLampFoot + vec3(-0.07F, 0.006F, 0.0F),
                                     kLampFoot + vec3(-0.14F, 0.004F, -0.05F),
                                     {-1.92F, kDeskTop + 0.004F, -1.90F},
                                     {-1.938F, kDeskTop + 0.004F, -1.955F},
                                     {-1.940F, kDeskTop - 0.05F, -1.978F},
                                     {-1.935F, 0.45F, -1.976F},
                                     {-1.905F, 0.21F, -1.968F},
                                     {-1.850F, 0.165F, -1.958F},
                                     {-1.812F, 0.205F, -1.955F},
                                     {-1.808F, 0.262F, -1.958F}}};
    study.put(Surface::kPlastic, slack_cable(lead, 0.0035F), glm::mat4(1.0F), 507U, kBlack);
    study.put(Surface::kPlastic, bevelled_box({0.036F, 0.046F, 0.042F}, 0.008F),
              moved(-1.808F, 0.281F, -1.968F), 508U, kBlack);
}

void put_monitor(Assembly& study) {
    const glm::mat4 place = moved(-1.02F, kDeskTop, -1.74F) * about_y(0.08F);
    study.put(Surface::kPlastic, bevelled_box({0.24F, 0.012F, 0.18F}, 0.004F),
              place * moved(0.0F, 0.006F, 0.0F), 510U, kBlack);
    study.put(Surface::kPlastic, bevelled_box({0.06F, 0.26F, 0.035F}, 0.01F),
              place * moved(0.0F, 0.14F, -0.03F), 511U, kBlack);
    const glm::mat4 panel = place * moved(0.0F, 0.33F, 0.0F) * about_x(-0.06F);
    study.put(Surface::kPlastic, bevelled_box({0.56F, 0.345F, 0.028F}, 0.008F), panel, 512U,
              kBlack);
    study.put(Surface::kPlastic, bevelled_box({0.536F, 0.306F, 0.003F}, 0.001F),
              panel * moved(0.0F, 0.008F, 0.0138F), 513U, vec3(0.012F, 0.014F, 0.018F));
    study.put(Surface::kPlastic, bevelled_box({0.30F, 0.20F, 0.03F}, 0.012F),
              panel * moved(0.0F, 0.0F, -0.025F), 514U, kBlack);
    const std::array<vec3, 4> lead{{{-1.02F, kDeskTop + 0.2F, -1.80F},
                                    {-1.0F, kDeskTop + 0.05F, -1.86F},
                                    {-0.98F, kDeskTop + 0.004F, -1.955F},
                                    {-0.96F, 0.45F, -1.975F}}};
    study.put(Surface::kPlastic, pipe(lead, 0.08F, 0.004F, 8), glm::mat4(1.0F), 515U, kBlack);
}

/// Caps that taper, in staggered rows, and a mouse on its pad.
void put_keyboard(Assembly& study) {
    const glm::mat4 place = moved(-1.05F, kDeskTop, -1.38F) * about_y(0.05F);
    study.put(Surface::kPlastic, bevelled_box({0.445F, 0.016F, 0.150F}, 0.005F),
              place * moved(0.0F, 0.010F, 0.0F) * about_x(0.045F), 520U, vec3(0.10F));
    constexpr std::array<float, 6> kShift{0.0F, 0.0F, 0.0095F, 0.014F, 0.0F, 0.0F};
    std::uint32_t seed = 521;
    for (std::size_t row = 0; row < 6; ++row) {
        const float z = -0.058F + 0.0215F * static_cast<float>(row);
        float x = -0.212F;
        int column = 0;
        while (x < 0.20F) {
            float width = 0.0175F;
            if (column == 0) width += kShift[row] + (row == 4 ? 0.022F : 0.0F);
            if (row == 5 && column == 3) width = 0.118F;
            width = std::min(width, 0.214F - x);
            Mesh cap = bevelled_box({width, 0.010F, 0.0175F}, 0.0022F);
            for (renderer::Vertex& vertex : cap.vertices) {
                if (vertex.position_m.y > 0.0F) vertex.position_m.z *= 0.86F;
            }
            study.put(Surface::kPlastic, cap,
                      place * moved(x + 0.5F * width, 0.021F - 0.045F * z, z) * about_x(0.045F),
                      seed++, column == 0 ? vec3(0.16F) : vec3(0.24F, 0.24F, 0.23F));
            x += width + 0.0019F;
            ++column;
        }
    }
    const glm::mat4 pad = moved(-0.68F, kDeskTop, -1.36F) * about_y(-0.1F);
    study.put(Surface::kBinding, bevelled_box({0.22F, 0.004F, 0.18F}, 0.001F),
              pad * moved(0.0F, 0.002F, 0.0F), 600U, vec3(0.07F, 0.09F, 0.11F));
    study.put(Surface::kPlastic, cushion({0.058F, 0.032F, 0.100F}, 0.006F),
              pad * moved(0.02F, 0.018F, 0.0F) * about_y(0.15F), 601U, vec3(0.10F));
    study.put(Surface::kPlastic, rod({-0.004F, 0.0F, 0.0F}, {0.004F, 0.0F, 0.0F}, 0.011F, 16),
              pad * moved(0.02F, 0.032F, -0.026F) * about_y(0.15F), 602U, kBlack);
    const std::array<vec3, 5> lead{{{-0.655F, kDeskTop + 0.014F, -1.415F},
                                    {-0.66F, kDeskTop + 0.004F, -1.50F},
                                    {-0.74F, kDeskTop + 0.004F, -1.62F},
                                    {-0.78F, kDeskTop + 0.004F, -1.80F},
                                    {-0.80F, kDeskTop + 0.004F, -1.96F}}};
    study.put(Surface::kPlastic, pipe(lead, 0.06F, 0.002F, 6), glm::mat4(1.0F), 603U, kBlack);
}

void put_mug(Assembly& study, const glm::mat4& place, const vec3& tint) {
    const std::array<vec2, 12> mug{{{0.0F, 0.0F},
                                    {0.034F, 0.0F},
                                    {0.037F, 0.003F},
                                    {0.040F, 0.012F},
                                    {0.041F, 0.088F},
                                    {0.042F, 0.093F},
                                    {0.040F, 0.095F},
                                    {0.038F, 0.092F},
                                    {0.037F, 0.02F},
                                    {0.034F, 0.008F},
                                    {0.02F, 0.006F},
                                    {0.0F, 0.006F}}};
    study.put(Surface::kCeramic, revolve(mug, 40), place, 610U, tint);
    const std::array<vec3, 4> handle{{{0.038F, 0.076F, 0.0F},
                                      {0.078F, 0.078F, 0.0F},
                                      {0.072F, 0.025F, 0.0F},
                                      {0.038F, 0.026F, 0.0F}}};
    study.put(Surface::kCeramic, pipe(handle, 0.025F, 0.006F, 12), place, 611U, tint);
    const std::array<vec2, 2> tea{{{0.0375F, 0.070F}, {0.0F, 0.070F}}};
    study.put(Surface::kPlastic, revolve(tea, 32), place, 612U, vec3(0.10F, 0.045F, 0.02F));
}

/// Loose sheets, some printed, squared up by nobody; the top ones curl.
void put_papers(Assembly& study, const glm::mat4& place, int sheets, std::uint64_t seed) {
    base::Random random(seed);
    const float corner = draw(random, -0.6F, 0.6F);
    for (int i = 0; i < sheets; ++i) {
        const bool top = i + 3 >= sheets;
        // Those below lie flat; each of the top ones curls higher than the one under it.
        const float lift =
            top ? draw(random, 0.002F, 0.005F) + 0.004F * static_cast<float>(i + 3 - sheets) : 0.0F;
        PatchOptions options;
        options.columns = top ? 10 : 2;
        options.rows = top ? 14 : 2;
        Mesh sheet = patch(options, [&](float u, float v) {
            const float out = std::max(0.0F, (u - 0.5F) * corner + (v - 0.5F) * 0.8F);
            return vec3((u - 0.5F) * 0.21F, lift * 4.0F * out * out, (0.5F - v) * 0.297F);
        });
        // v = 0 is the near edge; a page reads from the far one.
        for (renderer::Vertex& vertex : sheet.vertices) {
            vertex.uv.y = 1.0F - vertex.uv.y;
            vertex.tangent.w = -1.0F;
        }
        study.put_mapped(
            Surface::kPrint, sheet,
            place *
                moved(draw(random, -0.010F, 0.010F), 0.0006F + 0.0011F * static_cast<float>(i),
                      draw(random, -0.010F, 0.010F)) *
                about_y(draw(random, -0.12F, 0.12F)),
            vec3(0.93F) * shade_of(static_cast<std::uint32_t>(i) + 7U, 0.08F));
    }
}

void put_pencils(Assembly& study) {
    const glm::mat4 place = moved(-1.46F, kDeskTop, -1.80F);
    const std::array<vec2, 8> cup{{{0.0F, 0.0F},
                                   {0.034F, 0.0F},
                                   {0.036F, 0.003F},
                                   {0.037F, 0.098F},
                                   {0.036F, 0.10F},
                                   {0.034F, 0.098F},
                                   {0.033F, 0.004F},
                                   {0.0F, 0.004F}}};
    study.put(Surface::kMetal, revolve(cup, 32), place, 620U, vec3(0.5F));
    base::Random random(11);
    constexpr std::array<vec3, 5> kColours{{{0.62F, 0.42F, 0.06F},
                                            {0.45F, 0.05F, 0.04F},
                                            {0.05F, 0.15F, 0.32F},
                                            {0.06F, 0.22F, 0.10F},
                                            {0.05F, 0.05F, 0.05F}}};
    for (int i = 0; i < 11; ++i) {
        const float a = 0.57F * static_cast<float>(i);
        const vec3 low(0.012F * std::cos(a + 2.0F), 0.006F, 0.012F * std::sin(a + 2.0F));
        const vec3 high(0.030F * std::cos(a), 0.100F, 0.030F * std::sin(a));
        const vec3 way = glm::normalize(high - low);
        const float length = draw(random, 0.13F, 0.18F);
        study.put(Surface::kPlastic, rod(low, low + length * way, 0.0036F, 6), place, 621U,
                  kColours[random.below(kColours.size())]);
        const std::array<vec2, 3> tip{{{0.0036F, 0.0F}, {0.0012F, 0.014F}, {0.0F, 0.018F}}};
        const vec3 x = any_perpendicular(way);
        const glm::mat4 stand(glm::vec4(x, 0.0F), glm::vec4(way, 0.0F),
                              glm::vec4(glm::cross(x, way), 0.0F),
                              glm::vec4(low + length * way, 1.0F));
        study.put(Surface::kPaper, revolve(tip, 6, 0.2F), place * stand, 622U,
                  vec3(0.75F, 0.52F, 0.30F));
    }
}

}  // namespace

void build_desk_things(Assembly& study) {
    put_lamp(study);
    put_monitor(study);
    put_keyboard(study);
    put_pencils(study);
    put_mug(study, moved(-0.74F, kDeskTop, -1.60F) * about_y(-0.6F), vec3(0.62F, 0.66F, 0.62F));
    put_mug(study, moved(-0.90F, 0.50F, 1.38F), vec3(0.50F, 0.16F, 0.10F));
    put_papers(study, moved(-1.55F, kDeskTop, -1.40F) * about_y(0.35F), 16, 31);
    put_papers(study, moved(-0.36F, kDeskTop, -1.38F) * about_y(-0.20F), 30, 32);
    put_papers(study, moved(0.62F, 0.0F, -1.02F) * about_y(0.8F), 3, 33);
    Book notes;
    notes.width_m = 0.15F;
    notes.height_m = 0.21F;
    notes.thick_m = 0.014F;
    notes.cover = {0.05F, 0.06F, 0.10F};
    notes.seed = 9;
    put_book(study, notes, moved(-1.54F, kDeskTop + 0.021F, -1.39F) * about_y(-0.15F));
    study.put(Surface::kPlastic, rod({-0.075F, 0.0F, 0.0F}, {0.075F, 0.0F, 0.0F}, 0.004F, 6),
              moved(-1.53F, kDeskTop + 0.0395F, -1.37F) * about_y(0.9F), 640U,
              vec3(0.62F, 0.42F, 0.06F));
}

}  // namespace obscura::stimuli::room
