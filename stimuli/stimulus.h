// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "renderer/frame/renderer.h"
#include "renderer/reference/reference.h"
#include "stimuli/manifest.h"
#include "stimuli/png.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// One image of a study: a condition's side.
struct Stimulus {
    const Condition* condition = nullptr;
    char side = 'a';  ///< a or b

    [[nodiscard]] const renderer::TechniqueChoice& choice() const {
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

    /// All buffers of the image.
    [[nodiscard]] renderer::Frame render(const Stimulus& stimulus);

    /// What the manifest says of a rendered image; file hashes are left empty.
    [[nodiscard]] ManifestImage describe(const Stimulus& stimulus,
                                         const renderer::Frame& frame) const;

    /// SHA-256 of everything the image follows from: this program, the driver, the scene's source,
    /// camera and validity, technique and every parameter, the resolution.
    [[nodiscard]] std::string inputs_sha256(const Stimulus& stimulus) const;

  private:
    struct Loaded {
        std::string source;
        renderer::Scene scene;
        std::unique_ptr<renderer::GpuScene> gpu;
        std::unique_ptr<renderer::ReferenceScene> reference;  ///< once an image needs it
    };
    void load(const std::string& source);
    [[nodiscard]] const BuiltinScene& builtin(const std::string& source) const;

    const Study& study_;
    const std::vector<BuiltinScene>& catalogue_;
    renderer::Renderer renderer_;
    Loaded loaded_;
    std::map<std::pair<std::string, Validity>, renderer::Lighting> lightings_;
    std::string environment_sha256_;  ///< of program, driver and shaders
};

/// The frame's image as pixels.
[[nodiscard]] RgbImage image_of(const renderer::Frame& frame);

}  // namespace obscura::stimuli
