// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/frame/frame.h"
#include "renderer/frame/ray_buffers.h"
#include "renderer/frame/steps_by.h"
#include "renderer/frame/view.h"
#include "renderer/gl/program.h"
#include "renderer/scene/camera.h"

namespace obscura::renderer {

/// Renders the images of views. Needs a current OpenGL 4.5 context for as long as it lives;
/// shaders are compiled once, when a plan first needs them.
class Renderer {
  public:
    explicit Renderer(StepsBy steps = steps_by_device());
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Plans an image of the view and draws it. Passes that `known`, of the same scene, lighting
    /// and camera, holds the results of are not run again. Throws as plan_frame does, and failure
    /// where the technique is ray traced and the view cannot trace.
    [[nodiscard]] Frame render(const View& view, const Variant& variant, int width, int height,
                               const ViewBuffers& known = {});

    /// Runs the plan's passes in order; each is timed by glFinish and a monotonic clock, which is
    /// right on every driver. The plan must be one of the view: plan_of.
    [[nodiscard]] Frame draw(const View& view, const FramePlan& plan,
                             const ViewBuffers& known = {});

    /// Runs the steps of technique and filter once more on the buffers of a frame that was rendered
    /// of the same view, and gives their times. Throws failure for a variant whose plan has other
    /// buffers.
    std::vector<PassTime> render_accessibility_again(Frame& frame, const View& view,
                                                     const Variant& variant);

    /// What steps name and their shaders do not use, parameters that no step of a technique reads,
    /// and what shaders of full-screen passes read and nobody sets, of all that was drawn so far; a
    /// driver may have removed what has no effect.
    [[nodiscard]] const std::set<std::string>& mismatches() const { return mismatches_; }
    [[nodiscard]] StepsBy steps_by() const { return steps_; }

  private:
    struct Job;
    static Job job_of(const View& view, const FramePlan& plan, Frame& frame);
    /// Runs and times each of the plan's passes that `wanted` holds.
    std::vector<PassTime> run(Job& job, const std::function<bool(Phase)>& wanted);
    void run_pass(Job& job, const PlannedPass& pass);
    using Defines = std::vector<std::string>;

    gl::Program& program(const std::string& vertex, const std::string& fragment,
                         const Defines& defines);
    /// An environment as the passes use it.
    struct EnvironmentData {
        gl::Texture texture;
        IrradianceSh irradiance{};
    };
    const EnvironmentData& environment(const std::shared_ptr<const Environment>& source);
    /// The probes as passes/lighting.glsl reads them.
    const gl::Texture& texture_of(const std::shared_ptr<const IrradianceGrid>& source);
    const gl::Texture& texture_of(const NumberTable& table);

    void run_geometry(Job& job);
    void run_shadow(Job& job);
    void run_occluders(Job& job);
    void run_second_layer(Job& job);
    void run_seen(Job& job);
    void run_traced(Job& job);
    /// Whether that step of the plan is run as a compute shader: its buffer must be of a format
    /// that images of shaders can have.
    [[nodiscard]] bool computes(const FramePlan& plan, const PlannedPass& pass) const;
    [[nodiscard]] bool is_on_processor(const Step& step) const;
    gl::Program& step_program(const FramePlan& plan, const PlannedPass& pass);
    void run_step(Job& job, const PlannedPass& pass);
    void draw_step(Job& job, gl::Program& program, const PlannedPass& pass, int level, int layer);
    void compute_step(Job& job, gl::Program& program, const PlannedPass& pass, int level,
                      int layer);
    /// The scene's triangles for shaders that trace; kept for one scene at a time.
    const RayBuffers& ray_buffers(Job& job);
    void run_on_processor(Job& job, const PlannedPass& pass);
    void note_unread_parameters(const FramePlan& plan);
    /// Attaches one level and layer of what the step writes.
    void attach_step(Job& job, const PlannedPass& pass, int level, int layer);
    /// Everything that a step's shader may use.
    void set_step(Job& job, gl::Program& program, const PlannedPass& pass, int level, int layer);
    void run_light(Job& job);
    void run_sky(Job& job);
    void run_composite(Job& job);
    void run_forward(Job& job);
    void run_blend(Job& job);
    void run_tone_map(Job& job);
    void run_resolve(Job& job);

    /// What the shaders of surfaces read, as defines.
    static Defines surface_defines(const SceneNeeds& needs, bool normal);
    /// What passes/lighting.glsl reads.
    static Defines lighting_defines(const SceneNeeds& needs);
    /// What passes/lit_surface.glsl reads, with accessibility or without.
    static Defines lit_surface_defines(const Job& job, bool occluded);
    /// The uniforms of passes/surface.glsl and the side that is drawn.
    void set_surface(Job& job, gl::Program& program, const Material& material);
    /// The uniforms of passes/lighting.glsl; shadow maps and probes are bound to units
    /// 6 to 8.
    void set_lighting(Job& job, gl::Program& program);
    /// What is behind all surfaces, in the image that they are drawn into.
    void clear_to_background(Job& job);
    /// The layers of a shadow map, one a view.
    void draw_shadows(Job& job, const Buffer& map, const std::vector<ShadowView>& views);
    /// Blended triangles of materials at least that opaque, the furthest first.
    void draw_blended(Job& job, gl::Program& program, float least_opacity);

    /// Makes `targets` the colour outputs 0, 1, ... (those that the plan has not are skipped), and
    /// `visibility` the depth that is tested; all have one size.
    void attach(Job& job, const std::vector<std::string_view>& targets,
                std::optional<std::string_view> visibility = Target::kVisibility);
    /// Draws all that is not blended, nearest in front, with passes/geometry.vert.glsl and a
    /// camera; `set` sets what else the fragment shader reads.
    void draw_opaque(Job& job, const CameraMatrices& camera, const std::string& fragment,
                     Defines defines, const std::function<void(gl::Program&)>& set = {});
    /// The shader's accessibility_of_sample().
    void bind_accessibility(Job& job, gl::Program& program);
    /// Draws over the whole image, at the far plane, where the visibility buffer passes the test:
    /// GL_GREATER where there is geometry, GL_EQUAL where there is none.
    /// `writes`: the shader writes that depth.
    void full_screen(const Job& job, gl::Program& program, GLenum test,
                     GLboolean writes = GL_FALSE);
    /// Throws Stopped where the view is wanted no more; a view that nobody asks costs nothing.
    static void ask_whether_to_go_on(const Job& job);
    /// Makes it current, and notes what it reads and nobody set.
    void use(gl::Program& program);
    void bind(gl::Program& program, const char* sampler, GLuint texture, int unit);

    StepsBy steps_;
    std::optional<RayBuffers> ray_buffers_;
    TexturePool textures_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray empty_;
    std::map<std::string, std::unique_ptr<gl::Program>> programs_;
    std::map<std::string, gl::Texture> tables_;  ///< by their size and bytes
    std::map<std::shared_ptr<const Environment>, EnvironmentData> environments_;
    std::map<std::shared_ptr<const IrradianceGrid>, gl::Texture> grids_;
    std::set<std::string> mismatches_;
};

}  // namespace obscura::renderer
