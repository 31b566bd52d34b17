// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include "stimuli/scenes/figures/figure.h"

namespace obscura::stimuli::figures {
namespace {

constexpr std::array kSides{-1.0F, 1.0F};
constexpr glm::vec3 kEyeAt{0.0315F, -0.0010F, 0.0690F};  ///< the left one
constexpr float kEyeRadius = 0.0122F;

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
    void lashes(Sculpture& fine) const;
    [[nodiscard]] glm::vec3 place(float x, float y, float z) const {
        return at_(scale_ * x, scale_ * y, scale_ * z);
    }

  private:
    /// How far in front of the ears a solid's skin is.
    [[nodiscard]] float front_of(const Sculpture& solid, float x, float y) const {
        float z = 0.125F;
        for (int i = 0; i < 12; ++i) z -= 0.8F * solid.distance(place(x, y, z)) / scale_;
        return z;
    }
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
    solid_.add(face_form(at_, scale_, traits_), flesh(0.022F));
    for (const float x : kSides) {
        // The temples are a little hollow, the cheekbones stand out.
        solid_.carve(blob(x * 0.0745F, 0.022F, 0.050F, {0.0085F, 0.022F, 0.020F}),
                     {scale_ * 0.020F, traits_.skin, false});
        solid_.add(blob(x * 0.0430F, -0.0235F, 0.0500F, {0.0200F, 0.0140F, 0.0178F}),
                   flesh(0.018F));
        solid_.add(blob(x * 0.0265F, -0.0370F, 0.0655F, {0.0165F, 0.0190F, 0.0140F}),
                   flesh(0.016F));
        // The chewing muscle at the jaw's angle.
        solid_.add(blob(x * 0.0445F * jaw, -0.058F, 0.0110F, {0.0090F, 0.0190F, 0.0170F}),
                   flesh(0.016F));
        solid_.add(blob(x * 0.0385F, -0.0500F, 0.0500F,
                        glm::vec3(0.0150F, 0.0210F, 0.0210F) + 0.0040F * traits_.cheeks),
                   flesh(0.020F));
        if (traits_.hollow < 0.1F) continue;
        solid_.carve(blob(x * 0.0640F * jaw, -0.058F, 0.0520F,
                          glm::vec3(0.0080F, 0.0190F, 0.0190F) * traits_.hollow),
                     {scale_ * 0.020F, traits_.skin, false});
    }
    solid_.add(blob(0.0F, -0.1030F, 0.0780F, {0.0175F * jaw, 0.0120F, 0.0120F}), flesh(0.014F));
}

void HeadModel::brow_and_sockets() {
    const float brow = traits_.brow;
    for (const float x : kSides) {
        solid_.add(strip({knot(x * 0.0100F, 0.0130F, 0.0790F, 0.0070F),
                          knot(x * 0.0310F, 0.0180F, 0.0730F + 0.0016F * brow, 0.0080F),
                          knot(x * 0.0510F, 0.0110F, 0.0590F + 0.0012F * brow, 0.0075F)}),
                   flesh(0.012F));
    }
    for (const float x : kSides) {
        solid_.carve(blob(x * 0.0320F, 0.0010F, 0.0855F, {0.0185F, 0.0115F, 0.0125F}),
                     {scale_ * 0.010F, traits_.skin * 0.93F, true});
        solid_.carve(blob(x * 0.0175F, 0.0005F, 0.0880F, {0.0060F, 0.0100F, 0.0085F}),
                     {scale_ * 0.008F, traits_.skin * 0.90F, true});
    }
}

void HeadModel::lids() {
    const float open = traits_.eyelids;
    for (const float x : kSides) {
        const glm::vec3 eye = kEyeAt * glm::vec3(x, 1.0F, 1.0F);
        // The slit's corners, and how far its edges stand off the line between them.
        const glm::vec3 inner(x * 0.0172F, eye.y - 0.0020F, eye.z + 0.0040F);
        const glm::vec3 outer(x * 0.0452F, eye.y - 0.0005F + 0.001F * traits_.slant,
                              eye.z + 0.0020F);
        const auto lid = [&](const glm::vec3& edge, float thick, bool upper) {
            Sculpture shell;
            shell.add(ellipsoid(place(eye.x, eye.y, eye.z),
                                scale_ * (kEyeRadius + glm::vec3(thick + 0.0006F, thick, thick)),
                                at_.axes));
            glm::vec3 normal = glm::normalize(glm::cross(outer - inner, edge - inner)) * x;
            if ((normal.y > 0.0F) == upper) normal = -normal;
            shell.keep(half_space(place(edge.x, edge.y, edge.z), at_.axes * normal),
                       {scale_ * 0.0006F, glm::vec3(1.0F), false});
            return as_shape(std::move(shell));
        };
        // What hangs over the upper lid from the brow.
        solid_.add(strip({knot(x * 0.0190F, eye.y + 0.0070F, 0.0765F, 0.0030F),
                          knot(x * 0.0310F, eye.y + 0.0112F, 0.0775F, 0.0036F),
                          knot(x * 0.0420F, eye.y + 0.0104F, 0.0720F, 0.0034F),
                          knot(x * 0.0500F, eye.y + 0.0062F, 0.0640F, 0.0028F)}),
                   flesh(0.006F));
        solid_.add(
            lid({eye.x - x * 0.001F, eye.y + 0.0040F * open, eye.z + 0.0120F}, 0.0015F, true),
            {scale_ * 0.0028F, traits_.skin * 0.90F, true});
        solid_.add(
            lid({eye.x + x * 0.001F, eye.y - 0.0055F * open, eye.z + 0.0110F}, 0.0012F, false),
            {scale_ * 0.0040F, traits_.skin * 0.95F, true});
    }
}

void HeadModel::nose() {
    const float n = traits_.nose;
    const float wide = traits_.nose_width;
    const float l = traits_.nose_length;
    solid_.add(strip({knot(0, 0.0130F, 0.0835F, 0.0065F),
                      knot(0, -0.0010F, 0.0855F, 0.0058F + 0.0008F * wide),
                      knot(0, -0.0150F * l, 0.0920F + 0.0030F * n, 0.0060F * wide),
                      knot(0, -0.0290F * l, 0.0975F + 0.0050F * n, 0.0074F * wide)}),
               flesh(0.009F));
    for (const float x : kSides) {
        solid_.add(cone({x * 0.0060F, -0.0040F, 0.0800F}, 0.0060F,
                        {x * 0.0105F * wide, -0.0360F * l, 0.0910F}, 0.0085F),
                   flesh(0.010F));
    }
    solid_.add(
        blob(0, -0.0385F * l, 0.0990F + 0.0065F * n, glm::vec3(0.0100F * wide, 0.0088F, 0.0090F)),
        flesh(0.006F));
    solid_.add(cone({0, -0.0440F * l, 0.0970F + 0.0050F * n}, 0.0045F, {0, -0.0500F * l, 0.0915F},
                    0.0045F),
               flesh(0.005F));
    for (const float x : kSides) {
        solid_.add(blob(x * 0.0122F * wide, -0.0425F * l, 0.0935F,
                        glm::vec3(0.0062F * wide, 0.0072F, 0.0098F)),
                   flesh(0.004F));
        solid_.carve(cone({x * 0.0058F * wide, -0.0495F * l, 0.1010F}, 0.0026F,
                          {x * 0.0082F * wide, -0.0490F * l, 0.0945F}, 0.0030F),
                     {scale_ * 0.0020F, traits_.skin * glm::vec3(0.30F, 0.22F, 0.20F), true});
        // The crease round the wing of the nose, and from it towards the mouth's corner.
        solid_.carve(strip({knot(x * 0.0180F * wide, -0.0350F * l, 0.0905F, 0.0008F),
                            knot(x * 0.0205F * wide, -0.0430F * l, 0.0890F, 0.0010F),
                            knot(x * 0.0175F * wide, -0.0500F * l, 0.0900F, 0.0008F)}),
                     {scale_ * 0.0040F, traits_.skin * 0.88F, true});
        solid_.carve(strip({knot(x * 0.0225F, -0.0440F * l, 0.0880F, 0.0010F),
                            knot(x * 0.0290F, -0.0560F, 0.0850F, 0.0012F),
                            knot(x * 0.0330F, -0.0680F, 0.0790F, 0.0010F)}),
                     {scale_ * 0.0070F * traits_.age, traits_.skin, false});
    }
}

void HeadModel::mouth() {
    const float full = traits_.lips;
    solid_.add(blob(0, -0.0695F, 0.0690F, {0.0330F, 0.0240F, 0.0225F}), flesh(0.016F));
    const StrokeStyle lip{scale_ * 0.0030F, traits_.lip, true};
    const float upper = 0.0040F * full;
    const float lower = 0.0052F * full;
    // All of it lies on the mouth's mound, wherever cheeks and jaw have left that.
    const Sculpture mound = solid_;
    const auto line = [&](const std::vector<glm::vec4>& half) {
        std::vector<Knot> knots;
        for (const float x : kSides) {
            for (std::size_t i = 0; i < half.size(); ++i) {
                const glm::vec4& k = x < 0.0F ? half[i] : half[half.size() - 1 - i];
                if (x > 0.0F && i == 0 && k.x == 0.0F) continue;  // the middle is there already
                knots.push_back(knot(x * k.x, k.y, front_of(mound, x * k.x, k.y) + k.z, k.w));
            }
        }
        return strip(knots, 5);
    };
    solid_.add(line({{0.0245F, -0.0704F, -0.0010F, 0.0019F},
                     {0.0150F, -0.0688F, -0.0006F, 0.80F * upper},
                     {0.0055F, -0.0668F, -0.0002F, upper},
                     {0.0F, -0.0677F, -0.0004F, 0.95F * upper}}),
               lip);
    solid_.add(line({{0.0235F, -0.0714F, -0.0012F, 0.0019F},
                     {0.0130F, -0.0754F, -0.0010F, 0.84F * lower},
                     {0.0F, -0.0768F, -0.0008F, lower}}),
               lip);
    solid_.carve(line({{0.0258F, -0.0708F, 0.0006F, 0.0011F},
                       {0.0145F, -0.0711F, 0.60F * upper, 0.0012F},
                       {0.0050F, -0.0709F, 0.78F * upper, 0.0012F},
                       {0.0F, -0.0717F, 0.80F * upper, 0.0012F}}),
                 {scale_ * 0.0026F, traits_.lip * glm::vec3(0.34F, 0.28F, 0.28F), true});
    solid_.carve(
        strip({knot(0, -0.0530F, 0.0955F, 0.0012F), knot(0, -0.0625F, 0.0960F, 0.0016F)}, 3),
        {scale_ * 0.006F, traits_.skin, false});
    solid_.carve(blob(0, -0.0885F, 0.0945F, {0.0150F, 0.0040F, 0.0050F}),
                 {scale_ * 0.008F, traits_.skin, false});
}

void HeadModel::ears() {
    constexpr float kSize = 0.90F;
    for (const float x : kSides) {
        const glm::mat3 lean =
            at_.axes * axes_from(glm::normalize(glm::vec3(x * 0.30F, 0.0F, -1.0F)),
                                 glm::normalize(glm::vec3(0.0F, 1.0F, -0.24F)));
        // Places and sizes about the ear's middle.
        const auto near = [&](float dx, float dy, float dz) {
            return glm::vec3(x * (0.0715F + kSize * dx), -0.0080F + kSize * dy,
                             -0.0080F + kSize * dz);
        };
        const auto put = [&](float dx, float dy, float dz) {
            const glm::vec3 p = near(dx, dy, dz);
            return place(p.x, p.y, p.z);
        };
        const auto rim = [&](float dx, float dy, float dz, float w) {
            return Knot{put(dx, dy, dz), scale_ * kSize * w, 0.0F};
        };
        const float size = scale_ * kSize;
        const StrokeStyle ear{scale_ * 0.0035F, traits_.skin * glm::vec3(1.0F, 0.95F, 0.94F), true};
        solid_.add(
            ellipsoid(put(0.0F, 0.0F, 0.0F), size * glm::vec3(0.0055F, 0.0290F, 0.0165F), lean),
            ear);
        solid_.carve(ellipsoid(put(0.0070F, -0.0010F, 0.0030F),
                               size * glm::vec3(0.0065F, 0.0160F, 0.0085F), lean),
                     {scale_ * 0.0025F, traits_.skin * glm::vec3(0.62F, 0.50F, 0.47F), true});
        solid_.add(
            strip(
                {rim(-0.0010F, 0.0020F, 0.0140F, 0.0026F), rim(0.0030F, 0.0240F, 0.0110F, 0.0028F),
                 rim(0.0075F, 0.0290F, -0.0060F, 0.0030F), rim(0.0100F, 0.0130F, -0.0185F, 0.0030F),
                 rim(0.0070F, -0.0090F, -0.0150F, 0.0028F),
                 rim(0.0015F, -0.0285F, 0.0010F, 0.0046F)}),
            ear);
        // The fold inside the rim.
        solid_.add(strip({rim(0.0060F, 0.0170F, 0.0030F, 0.0018F),
                          rim(0.0085F, 0.0110F, -0.0090F, 0.0022F),
                          rim(0.0070F, -0.0070F, -0.0085F, 0.0020F),
                          rim(0.0040F, -0.0160F, 0.0020F, 0.0024F)}),
                   ear);
        solid_.add(ellipsoid(put(0.0015F, -0.0030F, 0.0150F),
                             size * glm::vec3(0.0040F, 0.0058F, 0.0034F), at_.axes),
                   ear);
    }
}

void HeadModel::neck() {
    const float girth = traits_.neck;
    solid_.add(cone({0, -0.065F, -0.026F}, 0.049F * girth, {0, -0.170F, -0.034F}, 0.056F * girth),
               flesh(0.022F));
    solid_.add(cone({0, -0.170F, -0.034F}, 0.056F * girth, {0, -0.235F, -0.030F}, 0.080F * girth),
               flesh(0.03F));
    for (const float x : kSides) {
        solid_.add(strip({knot(x * 0.044F, -0.058F, -0.026F, 0.009F),
                          knot(x * 0.038F * girth, -0.115F, -0.001F, 0.010F),
                          knot(x * 0.018F, -0.190F, 0.026F, 0.009F)}),
                   flesh(0.014F));
    }
    if (traits_.throat > 0.0F) {
        solid_.add(blob(0, -0.140F, 0.020F, {0.010F, 0.014F, 0.010F * traits_.throat}),
                   flesh(0.014F));
    }
}

/// Lashes of the upper lid, finer than the head's cells: a mesh of its own.
void HeadModel::lashes(Sculpture& fine) const {
    for (const float x : kSides) {
        const float y = kEyeAt.y + 0.0040F * traits_.eyelids;
        const float z = kEyeAt.z;
        fine.add(strip({knot(x * 0.0185F, y - 0.0045F, z + 0.0068F, 0.0006F),
                        knot(x * 0.0240F, y - 0.0010F, z + 0.0118F, 0.0009F),
                        knot(x * 0.0310F, y + 0.0002F, z + 0.0136F, 0.0011F),
                        knot(x * 0.0380F, y - 0.0010F, z + 0.0118F, 0.0012F),
                        knot(x * 0.0435F, y - 0.0032F, z + 0.0070F, 0.0012F),
                        knot(x * 0.0475F, y - 0.0040F, z + 0.0030F, 0.0007F)}),
                 {0.0F, traits_.brows * 0.4F, true});
    }
}

}  // namespace

void add_head(Figure& figure, const Placed& at, float scale, const FaceTraits& traits) {
    figure.complexion = [at, scale, traits](const glm::vec3& p) {
        const glm::vec3 q = (p - at.origin_m) * at.axes / scale;
        return glm::length(q) < 0.25F ? complexion_at(q, traits) : glm::vec3(1.0F);
    };
    FigurePart& skin = figure.part("head", Cloth::kSkin, 0.0021F, 0.06F);
    HeadModel head(skin.solid, at, scale, traits);
    head.skull();
    head.brow_and_sockets();
    head.nose();
    head.mouth();
    head.lids();
    head.ears();
    head.neck();
    // What the hair covers and what lies inside the collar is not meshed.
    skin.solid.keep(half_space(head.place(0.0F, 0.088F, 0.0F),
                               at.axes * glm::normalize(glm::vec3(0.0F, 0.62F, -0.78F))));
    skin.solid.keep(
        half_space(head.place(0.0F, -0.200F, 0.0F), at.axes * glm::vec3(0.0F, -1.0F, 0.0F)));
    head.lashes(figure.part("lashes", Cloth::kHair, 0.0008F, 0.05F).solid);
    for (const float x : kSides) {
        figure.eyes.push_back({head.place(x * kEyeAt.x, kEyeAt.y, kEyeAt.z), scale * kEyeRadius,
                               glm::normalize(at.axes[2]), traits.iris});
    }
}

}  // namespace obscura::stimuli::figures
