// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/hard_cases/agreement.h"
#include "renderer/hard_cases/hard_case.h"
#include "renderer/model/stored.h"

namespace obscura::renderer {

/// What the technique of that frame read.
[[nodiscard]] SeenBuffers seen_buffers(const Frame& frame, const Camera& camera);

/// One value a pixel, upper row first.
using Values = std::vector<float>;

/// The buffers of one image that a hard case looks at.
struct Shot {
    int width = 0;
    int height = 0;
    Values depth_m;
    Values accessibility;  ///< as the technique wrote it
    Values denoised;       ///< after the filter; the same where there is none
    Values shown = {};     ///< what the image uses, at its size
    /// What the definitions give on the same buffers: the technique's of accessibility, the
    /// filter's of denoised. Empty where there is no model, or the image is too large for it.
    Values defined_accessibility = {};
    Values defined_denoised = {};
    bool as_defined = false;  ///< every pixel is, but for what single precision allows
    int depth_reads = 0;      ///< the most look-ups that the definition makes for a pixel

    [[nodiscard]] bool is_surface(std::size_t pixel) const;
    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// A quantity of one or more images: of the shader's buffers, and of the definition's.
struct Found {
    double measured = 0.0;
    std::optional<double> definition;
    bool as_defined = false;
};

/// What `quantity` gives of a shot's accessibility.
template <std::invocable<const Values&> Quantity>
[[nodiscard]] Found of_accessibility(const Shot& shot, const Quantity& quantity) {
    Found found{quantity(shot.accessibility), {}, shot.as_defined};
    if (!shot.defined_accessibility.empty())
        found.definition = quantity(shot.defined_accessibility);
    return found;
}
/// The same of what the filter made of it.
template <std::invocable<const Values&> Quantity>
[[nodiscard]] Found of_denoised(const Shot& shot, const Quantity& quantity) {
    Found found{quantity(shot.denoised), {}, shot.as_defined};
    if (!shot.defined_denoised.empty()) found.definition = quantity(shot.defined_denoised);
    return found;
}
/// The same of the accessibilities of two.
template <std::invocable<const Values&, const Values&> Quantity>
[[nodiscard]] Found of_both(const Shot& a, const Shot& b, const Quantity& quantity) {
    Found found{quantity(a.accessibility, b.accessibility), {}, a.as_defined && b.as_defined};
    if (!a.defined_accessibility.empty() && !b.defined_accessibility.empty()) {
        found.definition = quantity(a.defined_accessibility, b.defined_accessibility);
    }
    return found;
}

/// What the cases share: rendering with any technique, and writing rows.
class Bench {
  public:
    Bench(const HardCaseOptions& options, std::vector<HardCaseResult>& rows)
        : options_(options), rows_(rows) {}

    [[nodiscard]] const HardCaseOptions& options() const { return options_; }

    /// Runs a case on a technique, or once for `all` where there is none; then writes the rows that
    /// hold every image of the case against its definition.
    void run(const HardCase& hard_case, const Technique* technique);

    /// `technique` with lengths that fit R: radius R, a full threshold of R/25, no occluders beyond
    /// R, and a curve that knows no other unit of length.
    [[nodiscard]] static Variant settings(const Technique& technique, double radius);

    /// From here to the end of the case, images may be uncertain: single precision cannot tell
    /// offsets from none, so all that is asked of a pixel is one of the values that it admits.
    void allow_uncertain(bool allowed) { allow_uncertain_ = allowed; }

    /// One image, which `what` names, also evaluated by the models of technique and filter. Ray
    /// traced ones take 64 rays within the choice's radius.
    [[nodiscard]] Shot shoot(const std::string& what, const Scene& scene, const Camera& camera,
                             const Variant& choice, int width, int height);

    /// What the technique's pass takes for that image.
    [[nodiscard]] double time_ms(const Scene& scene, const Camera& camera, const Variant& choice,
                                 int width, int height);

    /// A row that holds where |measured - truth| <= tolerance; NaN never does. Where it does not,
    /// the images are as defined and `nature` gives a reason, the row fails by nature.
    void expect(const std::string& quantity, double truth, const Found& found, double tolerance,
                const std::string& nature = "", const std::string& note = "");

    /// A row that holds where |measured - expected| <= tolerance, without an excuse.
    void expect(const std::string& quantity, double expected, double measured, double tolerance,
                const std::string& note = "") {
        expect(quantity, expected, Found{measured, {}, false}, tolerance, "", note);
    }

    /// A row that holds where it was found so, and may be undecided.
    void expect_growth(const std::string& quantity, double measured, double most, Outcome outcome,
                       const std::string& note);

    /// A row that counts values that are NaN, infinite or outside [0, 1]: none is expected.
    void expect_sound(const std::string& quantity, const Shot& shot, const std::string& note = "");

  private:
    [[nodiscard]] Frame render(const Scene& scene, const Camera& camera, const Variant& choice,
                               int width, int height);
    [[nodiscard]] Shot trace(const Scene& scene, const Camera& camera, const Variant& choice,
                             int width, int height);
    /// Evaluates the models on the shot's buffers.
    void hold_against_definition(const std::string& what, const SeenBuffers& buffers,
                                 const Variant& choice, Shot& shot);
    using AdmittedPixels = std::vector<std::optional<Admitted>>;
    /// What the technique's definition gives; kept until other buffers or settings come.
    const AdmittedPixels& admitted_of(const SeenBuffers& buffers, Variant choice);
    void write_agreements();
    [[nodiscard]] HardCaseResult row(const std::string& quantity) const;

    const HardCaseOptions& options_;
    std::vector<HardCaseResult>& rows_;
    std::string name_;
    std::string technique_;
    bool allow_uncertain_ = false;
    std::map<std::string, Agreement> agreements_;  ///< of the case's images; "" or the filter's
    struct Evaluated {
        SeenBuffers buffers;
        Variant choice;
        AdmittedPixels admitted;
    };
    Evaluated last_;
    Renderer renderer_;
};

/// The value farthest from `expected` among the surfaces at least `margin` (fraction of the size)
/// from the border; `expected` where there are none.
[[nodiscard]] double farthest(const Shot& shot, std::span<const float> values, double expected,
                              double margin);

}  // namespace obscura::renderer
