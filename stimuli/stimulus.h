// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/frame/renderer.h"
#include "renderer/reference/exr.h"
#include "renderer/reference/reference.h"
#include "stimuli/accuracy.h"
#include "stimuli/manifest.h"
#include "stimuli/png.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// One image of a study: a condition's side.
struct Stimulus {
    const Condition* condition = nullptr;
    char side = 'a';  ///< a or b

    [[nodiscard]] const renderer::Variant& choice() const {
        return side == 'a' ? condition->a : condition->b;
    }
    [[nodiscard]] std::string file() const;  ///< CONDITION-a.png
};

/// Every image of a study, in the order of its conditions, a before b.
[[nodiscard]] std::vector<Stimulus> stimuli_of(const Study& study);

/// Renders a study's images, one after the other. Needs a current OpenGL context; keeps the scene
/// of the last image, so ask for images of one scene together.
class StimulusRenderer {
  public:
    explicit StimulusRenderer(const Study& study,
                              const std::vector<BuiltinScene>& catalogue = builtin_scenes());

    /// All buffers of the image. What `known`, of the same scene id, holds is taken over.
    [[nodiscard]] renderer::Frame render(const Stimulus& stimulus,
                                         const renderer::ViewBuffers& known = {});

    /// The same to the bit, of which surfaces, shadow maps and light are taken over from the image
    /// before where that was of the same view: ask for images of one scene id together.
    [[nodiscard]] renderer::Frame render_next(const Stimulus& stimulus);

    /// The same surfaces from a frame that leaves nothing out (renderer/frame/everything.h).
    [[nodiscard]] renderer::Frame render_everything(const Stimulus& stimulus,
                                                    const renderer::ViewBuffers& known = {});

    /// Renders both small, so that neither has shaders left to compile.
    void compile(const Stimulus& stimulus);

    /// Its buffers with one sample a pixel, as one file: depth (Z, metres), view-space normal (N),
    /// linear albedo, accessibility (ao.Y) and light / pi before accessibility, with the camera's
    /// matrices. Where the camera sees nothing, depth is kBackgroundDepth_m, accessibility 1, the
    /// rest 0.
    [[nodiscard]] renderer::FloatImage render_buffers(const Stimulus& stimulus);

    /// Why nobody could tell the condition's two images apart, as a clause (pairs.h).
    [[nodiscard]] std::string reason_of_likeness(const Condition& condition);

    /// What the manifest says of a rendered image but its accuracy; file hashes are left empty.
    [[nodiscard]] ManifestImage describe(const Stimulus& stimulus, const renderer::Frame& frame);

    /// A rendered image's accessibility against the truth of its pair, which is traced where no
    /// image before had the same. Nothing where there is no truth to ask for.
    [[nodiscard]] std::optional<Accuracy> accuracy(const Stimulus& stimulus,
                                                   const renderer::Frame& frame);

    /// SHA-256 of everything the image follows from: this program, the driver, the scene's source
    /// with the bytes of its files, camera, validity and settings, technique and every parameter,
    /// the resolution.
    [[nodiscard]] std::string inputs_sha256(const Stimulus& stimulus) const;

  private:
    /// The scene of a source, kept until another one is wanted.
    struct Loaded {
        std::string source;
        double scale = 1.0;
        OpenedScene opened;
        std::unique_ptr<renderer::GpuScene> gpu;
        std::unique_ptr<renderer::ReferenceScene> reference;  ///< once an image needs it
        /// Of its views so far, whatever their light, by camera with settings and the radius.
        std::map<std::pair<std::string, double>, std::optional<SparseTruth>> truths;
    };
    /// The scene, ready to be drawn, its light and the view.
    struct View {
        const renderer::Lighting& lighting;
        const renderer::Camera& camera;
    };
    View view_of(const Stimulus& stimulus);
    /// The factor of the image's light, nothing where the study leaves it as it is.
    std::optional<double> exposure_factor(const Stimulus& stimulus);
    /// The image, or one with fewer columns and rows by that factor.
    renderer::Frame render_at(const Stimulus& stimulus, const renderer::ViewBuffers& known,
                              int fewer);
    renderer::Frame render_exposed(const Stimulus& stimulus, double factor,
                                   const renderer::ViewBuffers& known, int fewer = 1);
    renderer::Frame render_with(const Stimulus& stimulus, const renderer::FrameOptions& options,
                                const renderer::ViewBuffers& known = {}, int fewer = 1);
    renderer::Frame render_everything(const Stimulus& stimulus, const renderer::ViewBuffers& known,
                                      int fewer);
    /// The rays of the scene that is loaded, for the techniques that ask for them.
    const renderer::ReferenceScene& rays();
    renderer::RaysOfScene rays_of_scene() {
        return [this]() -> const renderer::ReferenceScene& { return rays(); };
    }
    renderer::TracedAccessibility tracer();
    void load(const StudyScene& scene);
    const renderer::Lighting& lighting_of(const StudyScene& scene);
    [[nodiscard]] const std::vector<renderer::ImportedFile>& files_of(
        const StudyScene& scene) const;

    const Study& study_;
    const std::vector<BuiltinScene>& catalogue_;
    renderer::Renderer renderer_;
    Loaded loaded_;
    std::string known_scene_;  ///< id of the scene that known_ is of
    renderer::ViewBuffers known_;
    /// Of the small images of one scene id, which only compile shaders.
    struct Compiled {
        std::string scene = {};
        renderer::ViewBuffers planned = {};
        renderer::ViewBuffers everything = {};
    };
    Compiled compiled_;
    std::map<std::string, renderer::Lighting> lightings_;  ///< by the scene's id
    std::map<std::string, double> exposure_factors_;       ///< by the condition's id
    mutable std::map<std::string, std::vector<renderer::ImportedFile>> files_;  ///< the same
    std::string environment_sha256_;  ///< of program, driver and shaders
};

/// The frame's image as pixels.
[[nodiscard]] RgbImage image_of(const renderer::Frame& frame);

}  // namespace obscura::stimuli
