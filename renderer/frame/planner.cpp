// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>

#include "renderer/base/check.h"
#include "renderer/denoise/denoise.h"
#include "renderer/frame/format.h"
#include "renderer/frame/plan.h"
#include "renderer/recipe/normal_format.h"
#include "renderer/technique/progressive.h"

namespace obscura::renderer {
namespace {

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
    const Recipe recipe_;
    const Recipe& filter_;
    const bool accessibility_;
    std::vector<Buffer> light_;  ///< that the light pass writes
    FramePlan plan_;
};

Buffer Planner::in_its_format(Buffer buffer) const {
    const auto is_one_of = [&buffer](std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), buffer.name) != names.end();
    };
    const Variant& variant = plan_.variant;
    const bool rebuilt = variant.depth_format == "d24";
    if (is_one_of(
            {Target::kDepth, Target::kOccluderDepth, Target::kSeenDepth, Target::kSecondDepth}) &&
        !rebuilt) {
        buffer.format = variant.depth_format;
    }
    if (is_one_of({Target::kPosition, Target::kOccluderPosition, Target::kSeenPosition}) &&
        variant.depth_format == "r16f") {
        buffer.format = "rgba16f";
    }
    if (is_one_of({Target::kSeenNormal}) || (buffer.is(Target::kOccluderNormal) && draws_normals()))
        buffer.format = normal_.buffer;
    if (is_one_of(
            {Target::kAccessibility, Target::kHistory, Target::kDenoised, Target::kUpsampled})) {
        buffer.format = variant.ao_format;
    }
    if (is_one_of({Target::kSeenDepth, Target::kSeenNormal, Target::kSeenPosition,
                   Target::kSeenVisibility, Target::kAccessibility, Target::kHistory,
                   Target::kDenoised})) {
        buffer.scale = 1.0F / static_cast<float>(plan_.ao_step);
    }
    if (is_one_of({Target::kSecondDepth, Target::kSecondVisibility})) {
        buffer.scale = 1.0F / static_cast<float>(plan_.ao_step * plan_.second_step);
    }
    return buffer;
}

const std::string& Planner::add(const Buffer& asked) {
    if (const PlannedTarget* known = plan_.find(asked)) return known->name;
    const Buffer buffer = in_its_format(asked);
    PlannedTarget planned{buffer};
    const bool samples = buffer.extent == Extent::kSamples;
    const auto scaled = [&buffer](int size) {
        return std::max(1, static_cast<int>(std::ceil(static_cast<float>(size) * buffer.scale)));
    };
    planned.width = scaled(samples ? plan_.width : plan_.image_width);
    planned.height = scaled(samples ? plan_.height : plan_.image_height);
    if (buffer.is(Target::kShadow)) {
        planned.width = planned.height = needs().shadow_size;
        planned.layers = needs().lights;
    }
    if (buffer.is(Target::kPointShadow)) {
        planned.width = planned.height = needs().point_shadow_size;
        planned.layers = 6 * needs().point_lights;
    }
    const int longest = std::max(planned.width, planned.height);
    planned.levels =
        std::min(buffer.levels, static_cast<int>(std::bit_width(static_cast<unsigned>(longest))));
    for (int level = 0; level < planned.levels; ++level) {
        planned.bytes += format_of(planned.format).bytes_per_texel *
                         static_cast<std::size_t>(std::max(1, planned.width >> level)) *
                         static_cast<std::size_t>(std::max(1, planned.height >> level)) *
                         static_cast<std::size_t>(planned.layers);
    }
    plan_.targets.push_back(std::move(planned));
    return plan_.targets.back().name;
}

void Planner::plan_geometry() {
    const bool all = plan_.options.all_buffers;
    const bool forward = plan_.lit_forward();
    const bool technique_has_its_own = draws_occluders();
    // Where the technique runs once a pixel, samples find their pixel by depth.
    const bool depth = all || recipe_.reads(Target::kDepth) ||
                       (denoised() && filter_.reads(Target::kDepth)) ||
                       (!forward && (once_a_pixel() || light_reads_depth()));
    const bool read_normal = reads_normal();
    const bool copied =
        read_normal && !technique_has_its_own && plan_.variant.normal_format != "from-depth";
    const bool normal = all || copied || (lit() && !forward);
    const bool position = stores_position() && !technique_has_its_own;
    const bool emission = needs().emission && (!forward || all);
    const bool traced = technique_.is_truth();
    if (forward && !all && (technique_has_its_own || !(depth || traced))) {
        leave_out("geometry", "nothing is read of it before surfaces are drawn and lit");
        return;
    }
    std::vector<Buffer> writes{Target::kVisibility};
    if (!forward || all) writes.push_back(Target::kAlbedo);
    if (normal) writes.push_back(Target::kNormal);
    if (depth) writes.push_back(Target::kDepth);
    if (emission) writes.push_back(Target::kEmission);
    if (position) writes.push_back(Target::kPosition);
    pass(Phase::kGeometry, {}, writes);
    if (!normal) {
        leave_out("normal", read_normal ? "the light reads none, and the technique has its own"
                                        : "neither the technique nor the light reads it");
    }
    if (!depth) leave_out("depth", "neither the technique nor a light reads it");
    if (!needs().emission) {
        leave_out("emission", "no material sends out light or has baked accessibility");
    }
    if (!needs().normal_mapping) leave_out("normal mapping", "the scene asks for none");
    if (!needs().textures) leave_out("albedo texture fetch", "no material has a texture");
    if (!needs().roughness) {
        leave_out("roughness texture fetch", "no material or no light has any use for it");
    }
    if (!needs().cut_out) leave_out("cut-out test", "no material has holes");
}

void Planner::plan_shadow() {
    std::vector<Buffer> writes;
    if (needs().lights > 0) writes.push_back(Target::kShadow);
    if (needs().point_lights > 0) writes.push_back(Target::kPointShadow);
    if (!writes.empty()) pass(Phase::kShadow, {}, writes);
    if (needs().lights == 0) leave_out("shadow", "the scene has no directional light");
    if (needs().point_lights == 0) leave_out("point shadow", "the scene has no point light");
}

void Planner::plan_occluders() {
    if (!occluders()) {
        leave_out("occluders", !accessibility_    ? "the technique computes no accessibility"
                               : !needs().blended ? "no material is blended"
                               : !plan_.technique_reads_depth
                                   ? "the technique reads no depth"
                                   : "blended surfaces are asked not to occlude");
        return;
    }
    const bool normal = reads_normal() && plan_.variant.normal_format != "from-depth";
    std::vector<Read> reads;
    std::vector<Buffer> writes{Target::kOccluderVisibility, Target::kOccluderDepth};
    if (normal) writes.push_back(Target::kOccluderNormal);
    if (stores_position()) writes.push_back(Target::kOccluderPosition);
    if (!draws_occluders()) {  // copied from the image's own
        reads = {Target::kVisibility, Target::kDepth};
        if (normal) reads.emplace_back(Target::kNormal);
        if (stores_position()) reads.emplace_back(Target::kPosition);
    }
    pass(Phase::kOccluders, reads, writes);
}

void Planner::plan_second_layer() {
    if (!recipe_.reads(Target::kSecondDepth)) return;
    pass(Phase::kSecondLayer, {plan_.seen_by_technique(Target::kDepth)},
         {Target::kSecondVisibility, Target::kSecondDepth});
}

void Planner::plan_seen() {
    const Variant& variant = plan_.variant;
    const bool from_depth = variant.normal_format == "from-depth" && reads_normal();
    if (!accessibility_ || recipe_.steps.empty() ||
        (plan_.ao_step == 1 && variant.depth_format != "d24" && !from_depth)) {
        return;
    }
    const bool normal = reads_normal();
    std::vector<Read> reads{{plan_.of_pixels(Target::kVisibility), Target::kVisibility.name}};
    std::vector<Buffer> writes{Target::kSeenVisibility, Target::kSeenDepth};
    if (variant.depth_format != "d24") {
        reads.emplace_back(plan_.of_pixels(Target::kDepth), Target::kDepth.name);
    }
    if (normal && !from_depth) {
        reads.emplace_back(plan_.of_pixels(Target::kNormal), Target::kNormal.name);
    }
    if (normal) writes.push_back(Target::kSeenNormal);
    if (stores_position()) {
        reads.emplace_back(plan_.of_pixels(Target::kPosition), Target::kPosition.name);
        writes.push_back(Target::kSeenPosition);
    }
    pass(Phase::kSeen, reads, writes);
}

void Planner::plan_upsample() {
    if (plan_.ao_step == 1) return;
    const Step step{"upsample",
                    "passes/upsample.frag.glsl",
                    {},
                    Target::kUpsampled.name,
                    {"STEP " + std::to_string(plan_.ao_step)},
                    13,
                    Cover::kAll};
    PlannedPass planned{Phase::kUpsample, step.name, {}, {}, step};
    planned.reads = {{plan_.final_accessibility(), Target::kAccessibility.name},
                     {Target::kSeenDepth.name, Target::kSeenDepth.name},
                     {plan_.of_pixels(Target::kDepth), Target::kDepth.name}};
    planned.writes.push_back(add(Target::kUpsampled));
    plan_.passes.push_back(std::move(planned));
}

void Planner::plan_accessibility() {
    plan_occluders();
    plan_seen();
    plan_second_layer();
    if (!accessibility_) {
        leave_out("accessibility", "the technique computes none");
        leave_out("denoise", "there is no accessibility to denoise");
        return;
    }
    if (technique_.is_truth()) {
        pass(Phase::kTechnique, {plan_.seen_by_technique(Target::kVisibility)},
             {Target::kAccessibility});
    } else {
        plan_steps(recipe_, Phase::kTechnique);
    }
    if (denoised()) {
        plan_steps(filter_, Phase::kDenoise);
    } else {
        leave_out("denoise", "the variant asks for none");
    }
    plan_upsample();
}

void Planner::plan_steps(const Recipe& recipe, Phase phase) {
    // The house's own step: what the frame before made, or 1.
    Step history{"history", "passes/history.frag.glsl", {}, Target::kHistory.name, {"FIRST"}};
    history.cover = Cover::kAll;
    for (int frame = 0; frame < recipe.frames; ++frame) {
        const bool read =
            std::any_of(recipe.steps.begin(), recipe.steps.end(), [frame](const Step& step) {
                return step.is_in(frame) && step.reads_buffer(Target::kHistory);
            });
        if (read) {
            if (frame > 0) {
                history.reads = {Target::kAccessibility};
                history.defines.clear();
            }
            plan_step(recipe, history, phase, frame);
        }
        for (const Step& step : recipe.steps) {
            if (step.is_in(frame)) plan_step(recipe, step, phase, frame);
        }
    }
}

void Planner::plan_step(const Recipe& recipe, const Step& step, Phase phase, int frame) {
    const Buffer target = written_by(recipe, step);
    const Buffer* own_buffer = recipe.find_buffer(step.writes);
    const bool smaller = own_buffer != nullptr && own_buffer->scale != 1.0F;
    if (step.cover == Cover::kSurfaces &&
        (smaller || target.levels > 1 || target.layers > 1 || plan_.makes_colour)) {
        throw base::failure("step \"{}\" covers surfaces only, which \"{}\" does not allow",
                            step.name, target.name);
    }
    PlannedPass planned{phase, step.name, {}, {}, step, {}, frame};
    if (reads_normal() && normal_.define[0] != '\0' && step.reads_buffer(Target::kNormal)) {
        planned.step->defines.emplace_back(normal_.define);
    }
    for (const Read& read : step.reads) {
        if (read.name == Target::kPosition.name && !stores_position()) continue;
        if (const NumberTable* table = recipe.find_table(read.name)) {
            planned.tables.push_back(*table);
            planned.tables.back().name = read.as;
        } else {
            planned.reads.push_back({read_by(recipe, read.name), read.as});
        }
    }
    planned.writes.push_back(add(target));
    if (step.first_level == 0 &&
        std::any_of(step.reads.begin(), step.reads.end(),
                    [&](const Read& read) { return read.name == step.writes; }) &&
        recipe.find_buffer(step.writes) != nullptr) {
        throw base::failure("step \"{}\" reads the level above of \"{}\" and begins with the first",
                            step.name, step.writes);
    }
    for (const Read& read : planned.reads) {
        if (plan_.find(read.name) != nullptr) continue;
        throw base::failure("step \"{}\" reads \"{}\", which nothing has written before", step.name,
                            read.name);
    }
    plan_.passes.push_back(std::move(planned));
}

Buffer Planner::written_by(const Recipe& recipe, const Step& step) const {
    if (const Buffer* own = recipe.find_buffer(step.writes)) {
        Buffer buffer = *own;
        buffer.extent = plan_.makes_colour ? Extent::kSamples : Extent::kPixels;
        buffer.scale /= static_cast<float>(plan_.ao_step);
        return buffer;
    }
    const bool technique = &recipe == &recipe_;
    if (step.writes == Target::kHistory.name) return Target::kHistory;
    if (plan_.makes_colour) {
        if (step.writes == Target::kColour.name) return Target::kColour;
    } else {
        const Buffer& made = technique ? Target::kAccessibility : Target::kDenoised;
        if (step.writes == made.name) return made;
    }
    throw base::failure(
        "step \"{}\" writes \"{}\", which is neither a buffer of its recipe nor "
        "what the recipe makes",
        step.name, step.writes);
}

std::string Planner::read_by(const Recipe& recipe, const std::string& name) const {
    if (recipe.find_buffer(name) != nullptr) return name;
    // What the technique makes colour of is the image before.
    if (plan_.makes_colour && name == Target::kColour.name) return Target::kHdr.name;
    return plan_.seen_by_technique(name);
}

void Planner::plan_light() {
    if (needs().environment) light_.push_back(Target::kAmbient);
    if (needs().direct_light()) light_.push_back(Target::kDirect);
    if (!lit()) {
        leave_out("light", "constant ambient light needs no buffer");
        return;
    }
    if (plan_.lit_forward() && !plan_.options.all_buffers) {
        leave_out("light", "surfaces are lit while they are drawn");
        return;
    }
    std::vector<Read> reads{Target::kNormal};
    if (light_reads_depth()) reads.emplace_back(Target::kDepth);
    if (needs().lights > 0) reads.emplace_back(Target::kShadow);
    if (needs().point_lights > 0) reads.emplace_back(Target::kPointShadow);
    pass(Phase::kLight, reads, light_);
    if (needs().environment && !needs().irradiance_grid) {
        leave_out("irradiance probes", "the light asks for none");
    }
    if (!needs().specular) leave_out("specular", "no material or no light has any");
}

void Planner::plan_composite() {
    std::vector<Read> reads{Target::kAlbedo};
    if (accessibility_) reads.emplace_back(plan_.final_accessibility());
    if (once_a_pixel()) {
        reads.emplace_back(Target::kDepth);
        reads.emplace_back(Target::kOccluderDepth);
    }
    reads.insert(reads.end(), light_.begin(), light_.end());
    if (needs().emission) reads.emplace_back(Target::kEmission);
    pass(Phase::kComposite, reads, {plan_.hdr() ? Target::kHdr : Target::kDisplay});
}

void Planner::plan_forward() {
    std::vector<Read> reads;
    if (accessibility_) reads.emplace_back(plan_.final_accessibility());
    if (once_a_pixel()) reads.emplace_back(Target::kOccluderDepth);
    if (needs().lights > 0) reads.emplace_back(Target::kShadow);
    if (needs().point_lights > 0) reads.emplace_back(Target::kPointShadow);
    pass(Phase::kForward, reads,
         {Target::kVisibility, plan_.hdr() ? Target::kHdr : Target::kDisplay});
    leave_out("composite", "surfaces are drawn and lit in one");
}

void Planner::plan_image() {
    const Buffer& image = plan_.hdr() ? Target::kHdr : Target::kDisplay;
    if (plan_.lit_forward()) {
        plan_forward();
    } else {
        plan_composite();
    }
    if (needs().environment) {
        pass(Phase::kSky, {Target::kVisibility}, {image});
    } else {
        leave_out("sky", "the scene has no environment");
    }
    if (plan_.makes_colour) plan_steps(recipe_, Phase::kTechnique);
    const Buffer& linear = plan_.makes_colour ? Target::kColour : Target::kHdr;
    if (needs().blended) {
        std::vector<Read> seen{Target::kVisibility};
        if (needs().lights > 0) seen.emplace_back(Target::kShadow);
        if (needs().point_lights > 0) seen.emplace_back(Target::kPointShadow);
        if (plan_.blended_occlude()) {
            seen.emplace_back(plan_.final_accessibility());
            if (once_a_pixel()) seen.emplace_back(Target::kOccluderDepth);
        }
        pass(Phase::kBlend, seen, {linear});
    } else {
        leave_out("blend", "no material is blended");
    }
    if (plan_.hdr()) {
        pass(Phase::kToneMap, {linear}, {Target::kDisplay});
    } else {
        leave_out("tone map", "the scene is not HDR");
    }
    if (plan_.options.supersampling > 1) {
        pass(Phase::kResolve, {Target::kDisplay}, {Target::kResolved});
    } else {
        leave_out("resolve", "each pixel takes one sample");
    }
}

}  // namespace

FramePlan plan_frame(const SceneNeeds& needs, const Variant& variant, int width, int height,
                     const FrameOptions& options) {
    base::check_range("resolution", "supersampling", options.supersampling, 1, kMostSupersampling);
    const int most = 16384 / options.supersampling;
    base::check_range("resolution", "width", width, 1, most);
    base::check_range("resolution", "height", height, 1, most);
    if (options.occluding_opacity) {
        base::check_above("blended surfaces", "occluding opacity", *options.occluding_opacity, 0.0F,
                          1.0F);
    }
    for (const VariantProblem& problem : problems_of(variant)) {
        throw base::bad_input("{}: {}", problem.key, problem.message);
    }
    return plan_frame(needs, *find_technique(variant.technique), variant, width, height, options);
}

FramePlan plan_frame(const SceneNeeds& needs, const Technique& technique, const Variant& variant,
                     int width, int height, const FrameOptions& options) {
    Planner planner(needs, technique, variant, options, width, height);
    planner.plan_geometry();
    planner.plan_shadow();
    planner.plan_accessibility();
    planner.plan_light();
    planner.plan_image();
    return planner.take();
}

}  // namespace obscura::renderer
