// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/frame/renderer.h"

#include <algorithm>
#include <chrono>

#include "renderer/base/error.h"
#include "renderer/frame/job.h"
#include "renderer/gl/timestamps.h"
#include "renderer/light/irradiance_grid.h"

namespace obscura::renderer {
namespace {

/// Lets go of what belongs to sources that nobody but the map has any more.
template <typename Map, typename Source>
void keep_used(Map& map, const Source& wanted) {
    std::erase_if(map, [&wanted](const auto& one) {
        return one.first != wanted && one.first.use_count() == 1;
    });
}

/// Rows of a buffer that are drawn before it is asked whether they are still wanted: whole tiles
/// of a software renderer.
constexpr int kRowsAtATime = 64;

/// A width x height texture of unfiltered float vectors.
gl::Texture vector_texture(const std::vector<glm::vec3>& values, int width, int height) {
    gl::Texture texture = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
    glTextureStorage2D(texture.name(), 1, GL_RGB32F, width, height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RGB, GL_FLOAT, values.data());
    glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

/// Whatever shares the context (the kiosk's window) may have left other settings.
void set_known_state() {
    for (const GLenum capability : {GL_BLEND, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_DITHER,
                                    GL_CULL_FACE, GL_FRAMEBUFFER_SRGB, GL_POLYGON_OFFSET_FILL}) {
        glDisable(capability);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glCullFace(GL_BACK);
    glFrontFace(GL_CCW);
    glDepthRange(0.0, 1.0);
}

}  // namespace

Renderer::Renderer(StepsBy steps)
    : steps_(steps), framebuffer_(gl::Framebuffer::make()), empty_(gl::VertexArray::make()) {}

Renderer::~Renderer() = default;

Renderer::Job Renderer::job_of(const View& view, const FramePlan& plan, Frame& frame) {
    const Camera seen =
        every_so_many(view.camera, plan.image_width, plan.image_height, plan.ao_step);
    const auto fewer = [&plan](int size) { return (size + plan.ao_step - 1) / plan.ao_step; };
    return {view.scene,
            view.lighting,
            plan,
            matrices_of(view.camera, plan.width, plan.height),
            matrices_of(seen, fewer(plan.image_width), fewer(plan.image_height)),
            frame,
            view.camera,
            seen,
            view.traced,
            view.rays,
            view.timed,
            view.go_on};
}

gl::Program& Renderer::program(const std::string& vertex, const std::string& fragment,
                               const Defines& defines) {
    std::string key = vertex + '|' + fragment;
    for (const std::string& define : defines) key += '|' + define;
    auto& entry = programs_[key];
    if (!entry) entry = std::make_unique<gl::Program>(vertex, fragment, defines);
    return *entry;
}

const gl::Texture& Renderer::texture_of(const NumberTable& table) {
    std::string key(reinterpret_cast<const char*>(table.texels.data()),
                    table.texels.size() * sizeof(glm::vec3));
    key += std::to_string(table.width);
    gl::Texture& texture = tables_[key];
    if (!texture) texture = vector_texture(table.texels, table.width, table.height);
    return texture;
}

const Renderer::EnvironmentData& Renderer::environment(
    const std::shared_ptr<const Environment>& source) {
    keep_used(environments_, source);
    EnvironmentData& data = environments_[source];
    if (!data.texture) {
        data.irradiance = project_irradiance(*source);
        data.texture = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_2D));
        const GLuint name = data.texture.name();
        glTextureStorage2D(name, 1, GL_RGB16F, source->width, source->height);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        // What is seen of a sun is limited to what half floats hold; its irradiance is not.
        std::vector<glm::vec3> seen = source->radiance;
        for (glm::vec3& value : seen) value = glm::min(value, glm::vec3(6e4F));
        glTextureSubImage2D(name, 0, 0, 0, source->width, source->height, GL_RGB, GL_FLOAT,
                            seen.data());
        glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_REPEAT);
        glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    return data;
}

const gl::Texture& Renderer::texture_of(const std::shared_ptr<const IrradianceGrid>& source) {
    keep_used(grids_, source);
    gl::Texture& texture = grids_[source];
    if (texture) return texture;
    const glm::ivec3 count = source->lattice.count;
    texture = gl::Texture::make(static_cast<GLenum>(GL_TEXTURE_3D));
    const GLuint name = texture.name();
    const GLsizei layers = kTexelsOfProbe * count.z;
    glTextureStorage3D(name, 1, GL_RGBA16F, count.x, count.y, layers);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage3D(name, 0, 0, 0, 0, count.x, count.y, layers, GL_RGBA, GL_HALF_FLOAT,
                        texels_of(*source).data());
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
        glTextureParameteri(name, axis, GL_CLAMP_TO_EDGE);
    }
    return texture;
}

void Renderer::bind(gl::Program& program, const char* sampler, GLuint texture, int unit) {
    glBindTextureUnit(static_cast<GLuint>(unit), texture);
    program.set(sampler, unit);
}

void Renderer::attach(Job& job, const std::vector<std::string_view>& targets,
                      std::optional<std::string_view> visibility) {
    constexpr int kSlots = 5;
    const GLuint name = framebuffer_.name();
    std::vector<GLenum> buffers;
    for (int i = 0; i < kSlots; ++i) {
        glNamedFramebufferTexture(name, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i), 0, 0);
    }
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const GLenum slot = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i);
        const bool present = job.has(targets[i]);
        if (present) {
            glNamedFramebufferTexture(name, slot, job.frame.texture(targets[i]), 0);
            const PlannedTarget& planned = *job.plan.find(targets[i]);
            job.size = {planned.width, planned.height};
        }
        buffers.push_back(present ? slot : GL_NONE);
    }
    glNamedFramebufferTexture(name, GL_DEPTH_ATTACHMENT,
                              visibility ? job.frame.texture(*visibility) : 0, 0);
    glNamedFramebufferDrawBuffers(name, static_cast<GLsizei>(buffers.size()), buffers.data());
    if (glCheckNamedFramebufferStatus(name, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw base::failure("the driver cannot render to the buffers that a frame of {}x{} needs",
                            job.plan.width, job.plan.height);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    glViewport(0, 0, job.size.x, job.size.y);
}

void Renderer::use(gl::Program& program) {
    for (const std::string& uniform : program.newly_unset()) {
        mismatches_.insert(program.name() + " reads " + uniform + ", which nobody sets");
    }
    program.use();
}

void Renderer::ask_whether_to_go_on(const Job& job) {
    if (!job.go_on) return;
    glFinish();
    if (!job.go_on()) throw Stopped();
}

void Renderer::full_screen(const Job& job, gl::Program& program, GLenum test, GLboolean writes) {
    glEnable(GL_DEPTH_TEST);
    glDepthMask(writes);
    glDepthFunc(test);
    use(program);
    glBindVertexArray(empty_.name());
    if (!job.go_on) {
        glDrawArrays(GL_TRIANGLES, 0, 3);
        return;
    }
    glEnable(GL_SCISSOR_TEST);
    for (int row = 0; row < job.size.y; row += kRowsAtATime) {
        glScissor(0, row, job.size.x, kRowsAtATime);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        ask_whether_to_go_on(job);
    }
    glDisable(GL_SCISSOR_TEST);
}

void Renderer::run_pass(Job& job, const PlannedPass& pass) {
    using Run = void (Renderer::*)(Job&);
    static const std::map<Phase, Run> kRuns = {
        {Phase::kGeometry, &Renderer::run_geometry},
        {Phase::kShadow, &Renderer::run_shadow},
        {Phase::kSecondLayer, &Renderer::run_second_layer},
        {Phase::kSeen, &Renderer::run_seen},
        {Phase::kOccluders, &Renderer::run_occluders},
        {Phase::kTechnique, &Renderer::run_traced},
        {Phase::kLight, &Renderer::run_light},
        {Phase::kSky, &Renderer::run_sky},
        {Phase::kComposite, &Renderer::run_composite},
        {Phase::kForward, &Renderer::run_forward},
        {Phase::kBlend, &Renderer::run_blend},
        {Phase::kToneMap, &Renderer::run_tone_map},
        {Phase::kResolve, &Renderer::run_resolve},
    };
    if (pass.step) {
        run_step(job, pass);
    } else {
        (this->*kRuns.at(pass.phase))(job);
    }
}

std::vector<PassTime> Renderer::run(Job& job, const std::function<bool(Phase)>& wanted) {
    std::vector<PassTime> times;
    // What is made once for a scene is no part of a frame's time.
    for (const PlannedPass& pass : job.plan.passes) {
        if (!pass.step || (pass.step->processor == nullptr && !pass.step->traces)) continue;
        if (!job.rays) {
            throw base::failure("technique {} needs the scene's rays, and this frame has none",
                                job.plan.variant.technique);
        }
        if (is_on_processor(*pass.step)) {
            (void)job.rays();
        } else {
            (void)ray_buffers(job);
        }
    }
    set_known_state();
    glFinish();
    gl::TimestampQueries timestamps(2 * job.plan.passes.size());
    for (const PlannedPass& planned : job.plan.passes) {
        if (!wanted(planned.phase)) continue;
        ask_whether_to_go_on(job);
        if (!job.timed) {
            run_pass(job, planned);
            times.push_back({planned.phase, planned.name});
            continue;
        }
        timestamps.mark();
        const auto start = std::chrono::steady_clock::now();
        run_pass(job, planned);
        timestamps.mark();
        glFinish();
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        times.push_back({planned.phase, planned.name, spent.count(), 0.0});
    }
    for (std::size_t i = 0; job.timed && i < times.size(); ++i) {
        times[i].query_milliseconds = timestamps.milliseconds(2 * i, 2 * i + 1);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glUseProgram(0);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
        throw base::failure("rendering failed: OpenGL error 0x{:x}", error);
    }
    return times;
}

Frame Renderer::render(const View& view, const Variant& variant, int width, int height,
                       const ViewBuffers& known) {
    return draw(view, plan_of(view, variant, width, height), known);
}

Frame Renderer::draw(const View& view, const FramePlan& plan, const ViewBuffers& known) {
    Frame frame(plan, known, textures_);
    Job job = job_of(view, plan, frame);
    const auto taken = [&frame](Phase phase) {
        const auto& all = frame.taken_over();
        return std::find_if(all.begin(), all.end(),
                            [phase](const PassTime& time) { return time.phase == phase; });
    };
    const auto is_taken = [&](Phase phase) { return taken(phase) != frame.taken_over().end(); };
    const std::vector<PassTime> spent = run(job, [&](Phase phase) { return !is_taken(phase); });
    note_unread_parameters(plan);
    auto next = spent.begin();
    for (const PlannedPass& planned : plan.passes) {
        frame.times.push_back(is_taken(planned.phase) ? *taken(planned.phase) : *next++);
    }
    return frame;
}

void Renderer::note_unread_parameters(const FramePlan& plan) {
    std::set<std::string> unread;
    bool has_steps = false;
    for (const auto& [name, value] : plan.parameters) unread.insert("p_" + name);
    for (const PlannedPass& pass : plan.passes) {
        if (pass.phase != Phase::kTechnique || !pass.step) continue;
        if (is_on_processor(*pass.step)) return;  // it is given all of them
        has_steps = true;
        const gl::Program& shader = step_program(plan, pass);
        // A step may also make a parameter's value a constant of its program.
        const auto& defines = pass.step->defines;
        std::erase_if(unread, [&](const std::string& name) {
            return shader.has(name) ||
                   std::any_of(defines.begin(), defines.end(), [&name](const std::string& define) {
                       return define.starts_with(name + ' ');
                   });
        });
    }
    if (!has_steps) return;
    for (const std::string& name : unread) {
        mismatches_.insert("no step of " + plan.variant.technique + " reads " + name);
    }
}

std::vector<PassTime> Renderer::render_accessibility_again(Frame& frame, const View& view,
                                                           const Variant& variant) {
    const FramePlan plan =
        plan_of(view, variant, frame.plan().image_width, frame.plan().image_height);
    if (plan.targets != frame.plan().targets) {
        throw base::failure("{} needs other buffers than the frame has", variant.in_words());
    }
    Job job = job_of(view, plan, frame);
    return run(job, is_of_the_variant);
}

}  // namespace obscura::renderer
