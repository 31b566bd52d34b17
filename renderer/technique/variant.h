// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::renderer {

struct Parameter;
struct Technique;

/// A technique with all its settings: two variants that differ in any are two variants. Parameters
/// that are not named take their technique's standard. Its forms as text (TOML, JSON) are in
/// stimuli/variant_format.h, that of the command line in app/commands/variant_arguments.h.
struct Variant {
    std::string technique = "none";
    int samples = 0;
    std::map<std::string, double> parameters = {};
    std::string denoise = "none";
    // Each a VariantOption.
    std::string depth_format = "r32f";
    std::string normal_format = "rgb8";
    std::string noise = "tile4x4";
    std::string ao_scale = "1";
    std::string ao_format = "r32f";
    std::string position = "similar-triangles";
    std::string frames = "1";
    std::string pipeline = "g-buffer";
    int frame = 0;           ///< of `frames`: whose part of the kernel a recipe or a model is of
    bool unclamped = false;  ///< for checks: what is not a number is not clamped away at the end

    /// As in the thesis: technique and samples, `Blizzard24`; `None` where there are no samples.
    [[nodiscard]] std::string variant_name() const;
    /// The set value or the descriptor's standard. The parameter must exist.
    [[nodiscard]] double value_of(const Parameter& parameter) const;
    /// Every parameter, those at their standard too.
    [[nodiscard]] std::map<std::string, double> all_parameters() const;
    /// Every setting, for messages: `Blizzard24, radius_m 0.5, ..., denoise separable`, with the
    /// options that are not at their standard.
    [[nodiscard]] std::string in_words() const;

    /// Whether both make the same of any view: a parameter that is not named equals its standard.
    [[nodiscard]] bool operator==(const Variant& other) const;
};

/// A setting that variants of every technique have: a word out of a list. Study files, manifests,
/// the command line (--set), messages, equality and help read this table.
struct VariantOption {
    std::string name;  ///< the key everywhere
    std::string meaning;
    std::vector<std::string> allowed;  ///< the first is the standard
    std::string Variant::*value;
    bool number = false;  ///< the words are numbers, and study files say them as such

    [[nodiscard]] const std::string& standard() const { return allowed.front(); }
};
[[nodiscard]] const std::vector<VariantOption>& variant_options();

/// The options that are not at their standard: `ao_scale 0.5, noise blue64`; empty where all are.
[[nodiscard]] std::string options_in_words(const Variant& variant);

/// Whether every option of two is the same.
[[nodiscard]] bool same_options(const Variant& a, const Variant& b);

/// Which of the image's columns and rows a technique computes accessibility for: every first,
/// second or fourth, as `ao_scale` says.
[[nodiscard]] int ao_step(const Variant& variant);

/// How many frames share the kernel (Sunet 2018, 4.10): technique/progressive.h.
[[nodiscard]] int frames_of(const Variant& variant);

/// The option of that name, or nullptr.
[[nodiscard]] const VariantOption* find_option(std::string_view name);

/// Sets of a technique's values that have names: `published`, its standard values, and `fitted`.
[[nodiscard]] const std::vector<std::string>& preset_names();

/// Makes a preset's values those of the variant, which keeps what it sets itself. What is wrong
/// with the name; empty where nothing is.
[[nodiscard]] std::string apply_preset(const std::string& preset, Variant& variant);

/// The technique with its standard samples and parameters, and no filter.
[[nodiscard]] Variant standard_variant(const Technique& technique);

/// The filter that a study means where it names none: the truth is shown as it is, and what has no
/// buffer has none to smooth.
[[nodiscard]] std::string standard_denoise(const Technique& technique);

/// The most texture reads a pixel that the recipes of technique and filter may make; 0 for rays.
[[nodiscard]] int fetches_per_pixel(const Variant& variant);

/// Everything wrong with a variant, one sentence each naming the key, the value and what is
/// allowed; empty when it can be rendered.
struct VariantProblem {
    std::string key;      ///< technique, samples, denoise, an option's or a parameter's name
    std::string message;  ///< value met and what is allowed
};
[[nodiscard]] std::vector<VariantProblem> problems_of(const Variant& variant);

}  // namespace obscura::renderer
