// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/frame/format.h"
#include "renderer/frame/job.h"
#include "renderer/recipe/normal_format.h"

namespace obscura::renderer {
namespace {

constexpr GLfloat kOpen[] = {1.0F, 1.0F, 1.0F, 1.0F};

/// Codes as buffers store them become unit vectors.
void decode_normals(const NormalFormat& format, std::vector<float>& values) {
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) {
        const glm::vec3 n = decoded_normal(format, {values[i], values[i + 1], values[i + 2]});
        std::copy_n(&n.x, 3, &values[i]);
    }
}

std::string sampler_of(const std::string& name) {
    std::string sampler = "t_" + name;
    std::replace(sampler.begin(), sampler.end(), ' ', '_');
    return sampler;
}

/// While it lives, a texture that is drawn into is seen at one level only: the one above.
class LevelAbove {
  public:
    LevelAbove(GLuint texture, int level, int levels) : texture_(texture), levels_(levels) {
        glTextureParameteri(texture_, GL_TEXTURE_BASE_LEVEL, level - 1);
        glTextureParameteri(texture_, GL_TEXTURE_MAX_LEVEL, level - 1);
    }
    ~LevelAbove() {
        glTextureParameteri(texture_, GL_TEXTURE_BASE_LEVEL, 0);
        glTextureParameteri(texture_, GL_TEXTURE_MAX_LEVEL, levels_ - 1);
    }
    LevelAbove(const LevelAbove&) = delete;
    LevelAbove& operator=(const LevelAbove&) = delete;

  private:
    GLuint texture_;
    int levels_;
};

}  // namespace

void Renderer::attach_step(Job& job, const PlannedPass& pass, int level, int layer) {
    const PlannedTarget& target = *job.plan.find(pass.writes.front());
    if (pass.step->cover == Cover::kSurfaces) {
        const std::string visibility = job.plan.seen_by_technique(Target::kVisibility);
        attach(job, {target.name}, visibility);
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kOpen);
        return;
    }
    attach(job, {target.name}, std::nullopt);
    const GLuint texture = job.frame.texture(target.name);
    if (target.layers > 1) {
        glNamedFramebufferTextureLayer(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture, level,
                                       layer);
    } else {
        glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture, level);
    }
    job.size = {std::max(1, target.width >> level), std::max(1, target.height >> level)};
    glViewport(0, 0, job.size.x, job.size.y);
}

void Renderer::set_step(Job& job, gl::Program& program, const PlannedPass& pass, int level,
                        int layer) {
    const bool of_image = pass.phase == Phase::kUpsample || job.plan.makes_colour;
    job.set_view(program, of_image ? job.camera : job.seen);
    program.set("u_far_m", job.camera.far_m);
    program.set("u_level", level);
    program.set("u_layer", layer);
    program.set("u_frame", pass.frame);
    // Where samples repeat over a tile, a pixel's own error is not that of so many.
    const Technique* technique = find_technique(job.plan.variant.technique);
    const bool tiled = technique != nullptr && !technique->ray_traced;
    const bool of_filter = pass.phase == Phase::kDenoise;
    program.set("u_samples", of_filter && tiled ? 0 : job.plan.variant.samples);
    for (const auto& [name, value] : job.plan.parameters) {
        program.set(("p_" + name).c_str(), static_cast<float>(value));
    }
    int unit = 0;
    const auto bind_read = [&](const std::string& name, GLuint texture) {
        const std::string sampler = sampler_of(name);
        if (!program.has(sampler)) {
            mismatches_.insert("step " + pass.name + " names " + sampler + ", which " +
                               program.name() + " does not read");
        }
        bind(program, sampler.c_str(), texture, unit++);
    };
    for (const Read& read : pass.reads) bind_read(read.as, job.frame.texture(read.name));
    for (const NumberTable& table : pass.tables) bind_read(table.name, texture_of(table).name());
    if (pass.step->traces) {
        const RayBuffers& rays = ray_buffers(job);
        rays.bind();
        program.set("u_eye_m", glm::vec3(glm::dvec3(job.seen_source.position_m) - rays.origin_m()));
        program.set("u_world_from_view", glm::transpose(glm::mat3(job.seen.view_from_world)));
    }
}

bool Renderer::is_on_processor(const Step& step) const {
    return step.processor != nullptr && (step.shader.empty() || steps_ == StepsBy::kFragments);
}

bool Renderer::computes(const FramePlan& plan, const PlannedPass& pass) const {
    return steps_ == StepsBy::kCompute &&
           can_be_stored(format_of(plan.find(pass.writes.front())->format));
}

gl::Program& Renderer::step_program(const FramePlan& plan, const PlannedPass& pass) {
    const Step& step = *pass.step;
    if (!computes(plan, pass)) {
        return program("passes/full_screen.vert.glsl", step.shader, step.defines);
    }
    Defines defines = step.defines;
    if (step.cover == Cover::kSurfaces) defines.emplace_back("SURFACES");
    std::string key = "compute|" + step.shader;
    for (const std::string& define : defines) key += '|' + define;
    auto& entry = programs_[key];
    if (!entry) {
        entry = std::make_unique<gl::Program>(gl::Program::computing(step.shader, defines));
    }
    return *entry;
}

const RayBuffers& Renderer::ray_buffers(Job& job) {
    const ReferenceScene& scene = job.rays();
    if (!ray_buffers_ || !ray_buffers_->is_of(scene)) {
        ray_buffers_.reset();  // before the next takes memory
        ray_buffers_.emplace(scene);
    }
    return *ray_buffers_;
}

void Renderer::run_on_processor(Job& job, const PlannedPass& pass) {
    const PlannedTarget& target = *job.plan.find(pass.writes.front());
    ProcessorWork work{
        target.width,        target.height,           {}, job.seen_source, job.rays(),
        job.plan.parameters, job.plan.variant.samples};
    const auto texels =
        static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (const Read& read : pass.reads) {
        const bool normal = format_of(job.plan.find(read.name)->format).format != GL_RED;
        std::vector<float>& values = work.reads.emplace_back(normal ? 3 * texels : texels);
        glGetTextureImage(job.frame.texture(read.name), 0, normal ? GL_RGB : GL_RED, GL_FLOAT,
                          static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
        if (normal) decode_normals(normal_format_of(job.plan.variant.normal_format), values);
    }
    const std::vector<float> values = pass.step->processor(work);
    glTextureSubImage2D(job.frame.texture(target.name), 0, 0, 0, target.width, target.height,
                        GL_RED, GL_FLOAT, values.data());
}

void Renderer::draw_step(Job& job, gl::Program& program, const PlannedPass& pass, int level,
                         int layer) {
    attach_step(job, pass, level, layer);
    set_step(job, program, pass, level, layer);
    full_screen(job, program, pass.step->cover == Cover::kSurfaces ? GL_GREATER : GL_ALWAYS);
}

void Renderer::compute_step(Job& job, gl::Program& program, const PlannedPass& pass, int level,
                            int layer) {
    const PlannedTarget& target = *job.plan.find(pass.writes.front());
    job.size = {std::max(1, target.width >> level), std::max(1, target.height >> level)};
    set_step(job, program, pass, level, layer);
    if (pass.step->cover == Cover::kSurfaces) {
        const auto unit = static_cast<int>(pass.reads.size() + pass.tables.size());
        const std::string visibility = job.plan.seen_by_technique(Target::kVisibility);
        bind(program, "t_covered", job.frame.texture(visibility), unit);
    }
    program.set("o_image", 0);
    glBindImageTexture(0, job.frame.texture(target.name), level, GL_FALSE, layer, GL_WRITE_ONLY,
                       format_of(target.format).internal);
    use(program);
    const glm::ivec2 groups = (job.size + gl::kWorkGroup - 1) / gl::kWorkGroup;
    glDispatchCompute(static_cast<GLuint>(groups.x), static_cast<GLuint>(groups.y), 1);
    glMemoryBarrier(GL_ALL_BARRIER_BITS);
}

void Renderer::run_step(Job& job, const PlannedPass& pass) {
    const Step& step = *pass.step;
    if (is_on_processor(step)) {
        run_on_processor(job, pass);
        return;
    }
    const PlannedTarget& target = *job.plan.find(pass.writes.front());
    const bool computed = computes(job.plan, pass);
    gl::Program& shader = step_program(job.plan, pass);
    const bool reads_itself =
        std::any_of(pass.reads.begin(), pass.reads.end(),
                    [&target](const Read& read) { return read.name == target.name; });
    for (int level = step.first_level; level < step.end_level(target.levels); ++level) {
        std::optional<LevelAbove> above;
        if (reads_itself) above.emplace(job.frame.texture(target.name), level, target.levels);
        for (int layer = 0; layer < target.layers; ++layer) {
            if (computed) {
                compute_step(job, shader, pass, level, layer);
            } else {
                draw_step(job, shader, pass, level, layer);
            }
        }
    }
}

}  // namespace obscura::renderer
