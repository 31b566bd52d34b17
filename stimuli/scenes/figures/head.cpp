// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/scenes/figures/figure.h"
#include "stimuli/scenes/support/noise.h"

namespace obscura::stimuli::figures {
namespace {

constexpr std::array kSides{-1.0F, 1.0F};

/// The head's modelling tools: everything is given for a head 0.235 m high and scaled.
class HeadModel {
  public:
    HeadModel(Sculpture& solid, const Placed& at, float scale, const FaceTraits& traits)
        : solid_(solid), at_(at), scale_(scale), traits_(traits) {}

    void skull();
    void brow_and_sockets();
    void lids();
    void nose();
    void mouth();
    void ears();
    void neck();
    void eyebrows();
    [[nodiscard]] glm::vec3 place(float x, float y, float z) const {
        return at_(scale_ * x, scale_ * y, scale_ * z);
    }

  private:
    [[nodiscard]] StrokeStyle flesh(float blend) const {
        return {scale_ * blend, traits_.skin, true};
    }
    [[nodiscard]] Knot knot(float x, float y, float z, float w, float h = 0.0F) const {
        return {place(x, y, z), scale_ * w, scale_ * h};
    }
    [[nodiscard]] ShapePtr blob(float x, float y, float z, const glm::vec3& radii) const {
        return ellipsoid(place(x, y, z), scale_ * radii, at_.axes);
    }
    [[nodiscard]] ShapePtr cone(const glm::vec3& a, float ra, const glm::vec3& b, float rb) const {
        return round_cone(place(a.x, a.y, a.z), scale_ * ra, place(b.x, b.y, b.z), scale_ * rb);
    }
    [[nodiscard]] std::vector<ShapePtr> strip(const std::vector<Knot>& knots, int steps = 5) const {
        return tube(make_curve(knots, steps, at_.axes[1]));
    }

    Sculpture& solid_;
    Placed at_;
    float scale_;
    FaceTraits traits_;
};

void HeadModel::skull() {
    const float jaw = traits_.jaw;
    solid_.add(blob(0.0F, 0.034F, -0.012F, {0.0735F, 0.081F, 0.094F}), flesh(0.0F));
    solid_.add(blob(0.0F, 0.048F, 0.040F, {0.062F, 0.048F, 0.048F}), flesh(0.03F));
    solid_.add(blob(0.0F, -0.030F, 0.032F, {0.058F * (0.5F + 0.5F * jaw), 0.078F, 0.054F}),
               flesh(0.03F));
    for (const float x : kSides) {
        solid_.add(cone({x * 0.055F * jaw, -0.030F, -0.004F}, 0.018F,
                        {x * 0.0475F * jaw, -0.072F, 0.014F}, 0.017F),
                   flesh(0.02F));
        solid_.add(cone({x * 0.0475F * jaw, -0.072F, 0.014F}, 0.017F,
                        {x * 0.015F * jaw, -0.104F, 0.072F}, 0.015F),
                   flesh(0.02F));
        solid_.add(
            blob(x * 0.046F * (0.5F + 0.5F * jaw), -0.025F, 0.063F, {0.020F, 0.016F, 0.020F}),
            flesh(0.02F));
        solid_.add(blob(x * 0.032F, -0.052F, 0.064F, {0.019F, 0.022F, 0.019F}), flesh(0.025F));
    }
    // A full cheek has none: carved less deep than a cell it would be a scar.
    for (const float x : kSides) {
        if (traits_.hollow < 0.5F) break;
        solid_.carve(blob(x * 0.064F * jaw, -0.058F, 0.068F,
                          glm::vec3(0.0045F, 0.018F, 0.018F) * traits_.hollow),
                     {scale_ * 0.016F, traits_.skin, false});
    }
    solid_.add(blob(0.0F, -0.103F, 0.080F, {0.019F * jaw, 0.014F, 0.014F}), flesh(0.016F));
}

void HeadModel::brow_and_sockets() {
    for (const float x : kSides) {
        solid_.add(strip({knot(x * 0.012F, 0.0145F, 0.0845F, 0.0062F),
                          knot(x * 0.034F, 0.0210F, 0.0815F, 0.0078F),
                          knot(x * 0.057F, 0.011F, 0.062F, 0.0075F)}),
                   flesh(0.010F + 0.006F * traits_.brow));
    }
    for (const float x : kSides) {
        solid_.carve(blob(x * 0.032F, -0.001F, 0.0955F, {0.0195F, 0.0125F, 0.0130F}),
                     {scale_ * 0.012F, traits_.skin * 0.9F, true});
        solid_.carve(blob(x * 0.0165F, 0.000F, 0.096F, {0.007F, 0.010F, 0.008F}),
                     {scale_ * 0.008F, traits_.skin * 0.85F, true});
    }
}

void HeadModel::lids() {
    const float open = traits_.eyelids;
    for (const float x : kSides) {
        const glm::vec3 eye(x * 0.0315F, -0.001F, 0.0725F);
        const auto lid = [&](float edge_y, const glm::vec3& normal) {
            Sculpture shell;
            shell.add(ellipsoid(place(eye.x, eye.y, eye.z),
                                scale_ * glm::vec3(0.0150F, 0.0138F, 0.0141F), at_.axes));
            shell.keep(half_space(place(eye.x, eye.y + edge_y, eye.z + 0.012F),
                                  at_.axes * glm::normalize(normal)),
                       {scale_ * 0.0012F, glm::vec3(1.0F), false});
            return as_shape(std::move(shell));
        };
        solid_.add(lid(0.0040F * open, {x * 0.12F, -1.0F, 0.30F}),
                   {scale_ * 0.0030F, traits_.skin * 0.92F, true});
        solid_.add(lid(-0.0050F * open, {x * -0.05F, 1.0F, 0.10F}),
                   {scale_ * 0.0040F, traits_.skin * 0.95F, true});
        // Lashes: a dark line along the upper lid.
        const float y = eye.y + 0.0040F * open;
        solid_.add(strip({knot(x * 0.0195F, y - 0.0040F, eye.z + 0.0095F, 0.0009F),
                          knot(x * 0.0260F, y + 0.0002F, eye.z + 0.0135F, 0.0012F),
                          knot(x * 0.0330F, y + 0.0008F, eye.z + 0.0140F, 0.0014F),
                          knot(x * 0.0400F, y - 0.0012F, eye.z + 0.0110F, 0.0014F),
                          knot(x * 0.0455F, y - 0.0034F, eye.z + 0.0060F, 0.0009F)}),
                   {scale_ * 0.0008F, traits_.brows * 0.5F, true});
    }
}

void HeadModel::nose() {
    const float n = traits_.nose;
    solid_.add(
        strip({knot(0, 0.014F, 0.0880F, 0.0075F), knot(0, -0.002F, 0.0930F, 0.0078F * n),
               knot(0, -0.020F, 0.1020F, 0.0088F * n), knot(0, -0.037F, 0.1110F, 0.0105F * n)}),
        flesh(0.012F));
    solid_.add(blob(0, -0.0400F, 0.1120F, glm::vec3(0.0125F, 0.0108F, 0.0115F) * n), flesh(0.005F));
    for (const float x : kSides) {
        solid_.add(
            blob(x * 0.0125F * n, -0.0435F, 0.0990F, glm::vec3(0.0090F, 0.0088F, 0.0115F) * n),
            flesh(0.005F));
    }
    for (const float x : kSides) {
        solid_.carve(
            blob(x * 0.0072F * n, -0.0535F, 0.1045F, glm::vec3(0.0040F, 0.0042F, 0.0062F) * n),
            {scale_ * 0.003F, traits_.skin * 0.35F, true});
        // The crease from the wing of the nose towards the mouth's corner.
        solid_.carve(strip({knot(x * 0.0225F, -0.040F, 0.0955F, 0.0016F),
                            knot(x * 0.027F, -0.053F, 0.0935F, 0.0018F),
                            knot(x * 0.0315F, -0.067F, 0.0860F, 0.0012F)}),
                     {scale_ * 0.007F, traits_.skin, false});
    }
}

void HeadModel::mouth() {
    const float full = traits_.lips;
    solid_.add(blob(0, -0.070F, 0.068F, {0.036F, 0.028F, 0.025F}), flesh(0.018F));
    const StrokeStyle lip{scale_ * 0.0045F, traits_.lip, true};
    solid_.add(strip({knot(-0.0250F, -0.0735F, 0.0800F, 0.0022F),
                      knot(-0.0130F, -0.0700F, 0.0905F, 0.0042F * full),
                      knot(-0.0045F, -0.0672F, 0.0950F, 0.0048F * full),
                      knot(0, -0.0684F, 0.0950F, 0.0046F * full),
                      knot(0.0045F, -0.0672F, 0.0950F, 0.0048F * full),
                      knot(0.0130F, -0.0700F, 0.0905F, 0.0042F * full),
                      knot(0.0250F, -0.0735F, 0.0800F, 0.0022F)},
                     4),
               lip);
    solid_.add(strip({knot(-0.0230F, -0.0748F, 0.0810F, 0.0022F),
                      knot(-0.0110F, -0.0795F, 0.0900F, 0.0052F * full),
                      knot(0, -0.0812F, 0.0925F, 0.0060F * full),
                      knot(0.0110F, -0.0795F, 0.0900F, 0.0052F * full),
                      knot(0.0230F, -0.0748F, 0.0810F, 0.0022F)},
                     4),
               lip);
    solid_.carve(
        strip(
            {knot(-0.0265F, -0.0742F, 0.0835F, 0.0010F), knot(-0.0120F, -0.0735F, 0.0960F, 0.0013F),
             knot(0, -0.0745F, 0.0995F, 0.0014F), knot(0.0120F, -0.0735F, 0.0960F, 0.0013F),
             knot(0.0265F, -0.0742F, 0.0835F, 0.0010F)},
            4),
        {scale_ * 0.0030F, traits_.lip * 0.35F, true});
    solid_.carve(strip({knot(0, -0.054F, 0.1000F, 0.0018F), knot(0, -0.064F, 0.1000F, 0.0022F)}, 3),
                 {scale_ * 0.006F, traits_.skin, false});
    solid_.carve(blob(0, -0.0920F, 0.0985F, {0.016F, 0.0045F, 0.0055F}),
                 {scale_ * 0.008F, traits_.skin, false});
}

void HeadModel::ears() {
    for (const float x : kSides) {
        const glm::mat3 lean =
            at_.axes * axes_from(glm::normalize(glm::vec3(x * 0.35F, 0.0F, -1.0F)),
                                 glm::normalize(glm::vec3(0.0F, 1.0F, -0.22F)));
        const StrokeStyle ear{scale_ * 0.004F, traits_.skin * glm::vec3(1.0F, 0.93F, 0.92F), true};
        solid_.add(ellipsoid(place(x * 0.0755F, -0.010F, -0.006F),
                             scale_ * glm::vec3(0.0065F, 0.029F, 0.0165F), lean),
                   ear);
        solid_.carve(ellipsoid(place(x * 0.0835F, -0.008F, -0.004F),
                               scale_ * glm::vec3(0.0062F, 0.020F, 0.0105F), lean),
                     {scale_ * 0.003F, traits_.skin * 0.72F, true});
        solid_.add(strip({knot(x * 0.0745F, -0.004F, 0.012F, 0.0030F),
                          knot(x * 0.0790F, 0.016F, 0.009F, 0.0032F),
                          knot(x * 0.0835F, 0.020F, -0.008F, 0.0034F),
                          knot(x * 0.0855F, 0.006F, -0.021F, 0.0034F),
                          knot(x * 0.0820F, -0.016F, -0.017F, 0.0034F),
                          knot(x * 0.0765F, -0.036F, 0.001F, 0.0050F)}),
                   ear);
        solid_.add(blob(x * 0.0765F, -0.012F, 0.0125F, {0.0045F, 0.0055F, 0.0035F}), ear);
    }
}

void HeadModel::neck() {
    const float girth = traits_.neck;
    solid_.add(cone({0, -0.065F, -0.024F}, 0.052F * girth, {0, -0.170F, -0.034F}, 0.056F * girth),
               flesh(0.022F));
    solid_.add(cone({0, -0.170F, -0.034F}, 0.056F * girth, {0, -0.235F, -0.030F}, 0.080F * girth),
               flesh(0.03F));
    for (const float x : kSides) {
        solid_.add(strip({knot(x * 0.058F, -0.050F, -0.018F, 0.011F),
                          knot(x * 0.045F * girth, -0.110F, 0.004F, 0.012F),
                          knot(x * 0.018F, -0.190F, 0.026F, 0.009F)}),
                   flesh(0.014F));
    }
    solid_.add(blob(0, -0.140F, 0.020F, {0.010F, 0.014F, 0.010F * girth}), flesh(0.014F));
}

void HeadModel::eyebrows() {
    for (const float x : kSides) {
        solid_.add(strip({knot(x * 0.0125F, 0.0135F, 0.0935F, 0.0014F, 0.0044F),
                          knot(x * 0.0250F, 0.0195F, 0.0930F, 0.0018F, 0.0046F),
                          knot(x * 0.0400F, 0.0225F, 0.0865F, 0.0018F, 0.0038F),
                          knot(x * 0.0530F, 0.0160F, 0.0725F, 0.0012F, 0.0018F)}),
                   {scale_ * 0.0016F, traits_.brows, true});
    }
}

}  // namespace

namespace {

/// Blood in cheeks, nose and ears, shadows under the eyes, a shaven beard, and mottling. `q` is for
/// a head 0.235 m high, as in HeadModel.
glm::vec3 complexion_at(const glm::vec3& q, float beard) {
    const auto near = [&](const glm::vec3& centre, float reach) {
        const glm::vec3 mirrored(std::abs(q.x), q.y, q.z);
        const float away = glm::length(mirrored - centre) / reach;
        return std::exp(-away * away);
    };
    const float mottle = fbm(q * 55.0F, 41, 3);
    glm::vec3 colour(1.0F + 0.05F * mottle, 1.0F + 0.09F * mottle, 1.0F + 0.08F * mottle);
    const auto towards = [&](const glm::vec3& other, float share) {
        colour *= glm::mix(glm::vec3(1.0F), other, std::clamp(share, 0.0F, 1.0F));
    };
    const glm::vec3 blood(1.05F, 0.80F, 0.76F);
    towards(blood, (0.8F + 0.4F * mottle) * near({0.040F, -0.030F, 0.072F}, 0.024F));
    towards(blood, 0.7F * near({0.0F, -0.028F, 0.105F}, 0.018F));
    towards(blood, 0.8F * std::clamp((std::abs(q.x) - 0.066F) / 0.012F, 0.0F, 1.0F));
    towards({0.80F, 0.74F, 0.78F}, 0.7F * near({0.030F, -0.013F, 0.080F}, 0.012F));
    towards({0.86F, 0.80F, 0.78F}, 0.6F * near({0.030F, 0.008F, 0.080F}, 0.010F));
    const float lower =
        std::clamp((-0.040F - q.y + 0.35F * std::max(0.0F, q.z - 0.06F)) / 0.02F, 0.0F, 1.0F) *
        std::clamp((q.y + 0.135F) / 0.03F, 0.0F, 1.0F);
    const float hairs = 0.75F + 0.5F * gradient_noise(q * 420.0F, 43);
    towards({0.66F, 0.66F, 0.68F}, beard * lower * hairs);
    return colour;
}

}  // namespace

void add_head(Figure& figure, const Placed& at, float scale, const FaceTraits& traits) {
    figure.complexion = [at, scale, beard = traits.beard](const glm::vec3& p) {
        const glm::vec3 q = (p - at.origin_m) * at.axes / scale;
        return glm::length(q) < 0.25F ? complexion_at(q, beard) : glm::vec3(1.0F);
    };
    FigurePart& skin = figure.part("head", Cloth::kSkin, 0.0028F, 0.06F);
    HeadModel head(skin.solid, at, scale, traits);
    head.skull();
    head.brow_and_sockets();
    head.nose();
    head.mouth();
    head.lids();
    head.eyebrows();
    head.ears();
    head.neck();
    // What the hair covers and what lies inside the collar is not meshed.
    skin.solid.keep(half_space(head.place(0.0F, 0.088F, 0.0F),
                               at.axes * glm::normalize(glm::vec3(0.0F, 0.62F, -0.78F))));
    skin.solid.keep(
        half_space(head.place(0.0F, -0.200F, 0.0F), at.axes * glm::vec3(0.0F, -1.0F, 0.0F)));
    for (const float x : kSides) {
        figure.eyes.push_back({head.place(x * 0.0315F, -0.001F, 0.0725F), scale * 0.0128F,
                               glm::normalize(at.axes[2]), traits.iris});
    }
}

}  // namespace obscura::stimuli::figures
