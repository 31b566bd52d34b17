// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/model/model.h"
#include "renderer/recipe/recipe.h"
#include "renderer/technique/variant.h"

namespace obscura::renderer {

/// One number that shapes a technique. Command line, study file, help and shader all read this.
/// In the shader it is the uniform `p_<name>`.
struct Parameter {
    std::string name;       ///< as in a study file, with its unit where it has one: radius_m
    std::string meaning;    ///< one sentence
    std::string unit;       ///< m, or what it is a fraction of; empty for a pure number
    double low = 0.0;       ///< smallest allowed
    double high = 1.0;      ///< largest allowed
    double standard = 0.0;  ///< the default, from the technique's source
    bool whole = false;     ///< only whole numbers are allowed
    bool fit = true;        ///< whether a fit to the truth may vary it; false: it only sets units
};

/// How many samples a technique takes; 0 to 0 for one that takes none.
struct SampleRange {
    int low = 0;
    int high = 0;
    int standard = 0;
    int multiple_of = 1;
    std::string times = "";  ///< a parameter that multiplies this: steps
};

/// What a technique makes.
enum class Output {
    kNothing,        ///< accessibility is 1 everywhere
    kAccessibility,  ///< the last step of its recipe writes `accessibility`
    kColour,         ///< the last step writes `colour`, before the tone curve
};

/// What would hold of a perfect accessibility, and some techniques fail by their nature.
enum class Ideal {
    kOpenFacing,   ///< a wall that faces the camera, near nothing, has 1
    kOpenTilted,   ///< so has a tilted or convex surface
    kWholeScene,   ///< what lies outside the image occludes too
    kAnyImage,     ///< a value does not depend on the image's size in the scene
    kAnyFarPlane,  ///< nor on where the camera's far plane is
};

/// One way to compute ambient occlusion: what it computes in a frame and what can be set.
struct Technique {
    std::string name;      ///< in files and on the command line
    std::string variant;   ///< stem of a variant's name, as in the thesis: Blizzard -> Blizzard24
    std::string citation;  ///< the definition's source
    Output output = Output::kAccessibility;
    /// Accessibility comes from rays through the scene; without a recipe, by the tracer of the
    /// truth.
    bool ray_traced = false;
    SampleRange samples;
    std::vector<Parameter> parameters;
    Recipe (*recipe)(const Variant& variant) = nullptr;  ///< the variant has no problems
    /// Beside the standard values, which are as published: those that come nearest to the truth,
    /// one set without dimensions for all scenes; empty where there are none yet.
    std::map<std::string, double> fitted;
    std::string denoise = "separable";  ///< the filter that a study means where it names none
    /// The parameter that says how far samples reach; 0 puts them all on the pixel's own point.
    std::string reach;
    /// The definition in double precision; empty where there is none yet.
    Model model;
    /// What it fails by its definition, each with the reason.
    std::map<Ideal, std::string> by_nature;
    /// What the definition gives a wall that faces the camera, in closed form.
    double facing_wall = 1.0;

    /// Why it fails an ideal; empty where it does not.
    [[nodiscard]] std::string why_not(Ideal ideal) const;
    /// Whether it is what the others are held against.
    [[nodiscard]] bool is_truth() const { return ray_traced && recipe == nullptr; }
    [[nodiscard]] bool makes_accessibility() const { return output == Output::kAccessibility; }
    /// The recipe of its standard settings; empty where there is none.
    [[nodiscard]] Recipe standard_recipe() const;
    [[nodiscard]] const Parameter* find_parameter(std::string_view parameter_name) const;
};

/// All techniques, in the order of the documentation.
[[nodiscard]] const std::vector<Technique>& techniques();

/// The technique of that name, or nullptr.
[[nodiscard]] const Technique* find_technique(std::string_view name);

}  // namespace obscura::renderer
