// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/frame/planner.h"

namespace obscura::renderer {

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
                    {"STEP " + std::to_string(plan_.ao_step), plan_.accessibility_define()},
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
    const bool smaller = (own_buffer != nullptr && own_buffer->scale != 1.0F) || target.columns > 1;
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
        Buffer made = technique ? Target::kAccessibility : Target::kDenoised;
        made.columns = step.columns;
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

}  // namespace obscura::renderer
