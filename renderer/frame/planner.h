// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/denoise/denoise.h"
#include "renderer/frame/plan.h"
#include "renderer/recipe/depth_beside.h"
#include "renderer/recipe/normal_format.h"
#include "renderer/technique/progressive.h"

namespace obscura::renderer {

/// Adds passes and, with them, the buffers that they write.
class Planner {
  public:
    Planner(const SceneNeeds& needs, const Technique& technique, const Variant& variant,
            const FrameOptions& options, int width, int height)
        : normal_(normal_format_of(variant.normal_format)),
          technique_(technique),
          recipe_(recipe_of(technique, variant)),
          filter_(find_denoise(variant.denoise)->recipe),
          accessibility_(technique.makes_accessibility()) {
        depth_beside_ = lay_depth_beside(variant.ao_format, recipe_, filter_);
        plan_.width = width * options.supersampling;
        plan_.height = height * options.supersampling;
        plan_.image_width = width;
        plan_.image_height = height;
        plan_.options = options;
        plan_.needs = needs;
        plan_.variant = variant;
        for (const Parameter& parameter : technique.parameters) {
            plan_.parameters[parameter.name] = variant.value_of(parameter);
        }
        plan_.technique_reads_depth = accessibility_ && recipe_.reads(Target::kDepth);
        plan_.makes_colour = technique.output == Output::kColour;
        plan_.ao_step = ao_step(variant);
        if (recipe_.reads(Target::kSecondDepth)) {
            plan_.separation_m = recipe_.separation_m;
            plan_.second_step = 1 << recipe_.second_halvings;
        }
    }

    void plan_geometry();
    void plan_shadow();
    void plan_accessibility();
    void plan_light();
    void plan_image();

    FramePlan take() { return std::move(plan_); }

  private:
    void pass(Phase phase, std::vector<Read> reads, const std::vector<Buffer>& writes) {
        PlannedPass planned{phase, to_string(phase), std::move(reads), {}};
        for (const Buffer& buffer : writes) planned.writes.push_back(add(buffer));
        plan_.passes.push_back(std::move(planned));
    }

    void leave_out(std::string what, std::string why) {
        plan_.left_out.push_back({std::move(what), std::move(why)});
    }

    /// Plans a buffer once and gives its name.
    const std::string& add(const Buffer& buffer);
    /// The house's buffers in the formats and sizes that the variant gives them.
    [[nodiscard]] Buffer in_its_format(Buffer buffer) const;
    void plan_occluders();
    void plan_second_layer();
    void plan_seen();
    void plan_upsample();
    void plan_composite();
    void plan_forward();
    /// The steps of a recipe, as often as it has frames.
    void plan_steps(const Recipe& recipe, Phase phase);
    void plan_step(const Recipe& recipe, const Step& step, Phase phase, int frame);
    /// What a recipe's words mean in this plan. Throw failure for what there is not.
    [[nodiscard]] Buffer written_by(const Recipe& recipe, const Step& step) const;
    [[nodiscard]] std::string read_by(const Recipe& recipe, const std::string& name) const;

    const SceneNeeds& needs() const { return plan_.needs; }
    [[nodiscard]] bool lit() const { return needs().environment || needs().direct_light(); }
    [[nodiscard]] bool light_reads_depth() const {
        return needs().direct_light() || needs().irradiance_grid;
    }
    /// Whether the technique runs on fewer pixels than the other passes.
    [[nodiscard]] bool once_a_pixel() const {
        return accessibility_ && plan_.options.supersampling > 1;
    }
    [[nodiscard]] bool occluders() const { return draws_occluders() || plan_.blended_occlude(); }
    /// Whether what the technique sees is drawn apart from what the image shows.
    [[nodiscard]] bool draws_occluders() const { return once_a_pixel() || draws_normals(); }
    [[nodiscard]] bool stores_position() const {
        return plan_.variant.position == "stored" && recipe_.reads(Target::kPosition);
    }
    [[nodiscard]] bool draws_normals() const { return reads_normal() && plan_.own_normals(); }
    [[nodiscard]] bool reads_normal() const {
        return recipe_.reads(Target::kNormal) || (denoised() && filter_.reads(Target::kNormal));
    }
    [[nodiscard]] bool denoised() const { return accessibility_ && !filter_.steps.empty(); }

    const NormalFormat& normal_;
    const Technique& technique_;
    Recipe recipe_;
    Recipe filter_;
    const bool accessibility_;
    bool depth_beside_ = false;  ///< the accessibility
    std::vector<Buffer> light_;  ///< that the light pass writes
    FramePlan plan_;
};

}  // namespace obscura::renderer
