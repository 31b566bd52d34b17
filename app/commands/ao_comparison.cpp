// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/ao_comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/commands/scene_argument.h"
#include "app/explorer/colour_scale.h"
#include "app/measure/measured_settings.h"
#include "app/measure/sweep.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/passes/shared_constants.h"
#include "renderer/technique/reference.h"
#include "stimuli/png.h"

namespace obscura::app {
namespace {

using analysis::AccessibilityError;
using renderer::FloatImage;

constexpr float kFullColour = 0.5F;  // of the difference's image

/// The truth's values, and of what it is.
struct Truth {
    std::vector<float> accessibility;
    std::vector<float> standard_error;  ///< empty: not known
    std::vector<float> depth_m;
    std::string in_words;
};

/// What rays see, one a pixel.
std::vector<float> depth_of(AoBuffers& buffers, const renderer::Camera& camera) {
    renderer::ReferenceOptions options;
    options.rays = 1;
    return buffers.trace(camera, options).depth_m;
}

std::string attribute_of(const FloatImage& image, const std::string& key) {
    const auto found = image.texts.find("obscura:" + key);
    return found == image.texts.end() ? "" : found->second;
}

/// A file of another scene or camera gives a figure that means nothing.
void refuse_another_view(const FloatImage& truth, const FloatImage& measured,
                         const std::string& file) {
    if (truth.width != measured.width || truth.height != measured.height) {
        throw base::bad_input("--against: {} is {}x{} pixels, the buffer {}x{}; see --size", file,
                              truth.width, truth.height, measured.width, measured.height);
    }
    for (const char* key : {"scene", "camera"}) {
        const std::string of_truth = attribute_of(truth, key);
        if (of_truth.empty() || of_truth == attribute_of(measured, key)) continue;
        throw base::bad_input("--against: {} is of the {} {}, the buffer of {}", file, key,
                              of_truth, attribute_of(measured, key));
    }
}

Truth truth_of_file(AoBuffers& buffers, const renderer::Camera& camera, const FloatImage& measured,
                    const std::string& file, std::vector<std::string>& notes) {
    const FloatImage image = renderer::decode_exr(base::read_file(file), file);
    refuse_another_view(image, measured, file);
    const std::vector<float>* const accessibility = image.find("ao.Y");
    if (accessibility == nullptr) {
        std::string names;
        for (const auto& channel : image.channels) names += ' ' + channel.name;
        throw base::bad_input("--against: {} has no channel ao.Y; it has{}", file, names);
    }
    const std::string radius = attribute_of(image, "radius_m");
    const std::string own = attribute_of(measured, "radius_m");
    if (!radius.empty() && !own.empty() && radius != own) {
        notes.push_back(
            fmt::format("{} is of the radius {} m, the buffer of {} m", file, radius, own));
    }
    const std::vector<float>* const spread = image.find("ao.stderr");
    return {*accessibility, spread != nullptr ? *spread : std::vector<float>(),
            depth_of(buffers, camera),
            radius.empty() ? file : fmt::format("{}, R {} m", file, radius)};
}

Truth traced_truth(AoBuffers& buffers, const renderer::Camera& camera,
                   const renderer::Variant& variant, const AoTruth& truth) {
    const renderer::Technique& technique = *renderer::find_technique(variant.technique);
    const renderer::Parameter* const radius = technique.find_parameter(kTruthRadius);
    renderer::ReferenceOptions options;
    options.rays = truth.rays;
    options.radius_m = radius != nullptr ? variant.value_of(*radius) : truth.radius_m;
    renderer::ReferenceImage image = buffers.trace(camera, options);
    return {std::move(image.accessibility), std::move(image.standard_error),
            std::move(image.depth_m),
            fmt::format("reference, {} rays, R {:g} m", truth.rays, options.radius_m)};
}

nlohmann::ordered_json json_of_error(const analysis::Possible<AccessibilityError>& error) {
    if (!error.has_value()) return {{"reason", error.reason}};
    return {{"rmse", error->rmse}, {"bias", error->bias},     {"mae", error->mae},
            {"p99", error->p99},   {"pixels", error->pixels}, {"nonfinite", error->nonfinite}};
}

std::string columns_of(const analysis::Possible<AccessibilityError>& error) {
    if (!error.has_value()) return fmt::format("{:>8}{:>9}{:>8}{:>8}", "-", "-", "-", "-");
    return fmt::format("{:>8.4f}{:>+9.4f}{:>8.4f}{:>8.4f}", error->rmse, error->bias, error->mae,
                       error->p99);
}

}  // namespace

AoComparison compare_ao(AoBuffers& buffers, const renderer::Camera& camera,
                        const renderer::Variant& variant, const FloatImage& measured,
                        const AoTruth& wanted) {
    AoComparison result;
    result.camera = camera.name.empty() ? "view" : camera.name;
    result.variant = variant.variant_name();
    result.width = measured.width;
    result.height = measured.height;
    const Truth truth = wanted.file.empty()
                            ? traced_truth(buffers, camera, variant, wanted)
                            : truth_of_file(buffers, camera, measured, wanted.file, result.notes);
    result.truth = truth.in_words;
    const std::vector<float>& values = *measured.find("ao.Y");
    std::vector<std::uint8_t> inside =
        analysis::interior_mask(measured.width, measured.height, kInteriorMargin);
    double squares = 0.0;
    double surfaces = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool shows = truth.depth_m[i] < kBackgroundLimit_m;
        result.is_surface.push_back(shows ? 1 : 0);
        inside[i] &= result.is_surface.back();
        result.difference.push_back(shows ? values[i] - truth.accessibility[i] : 0.0F);
        if (!shows) continue;
        surfaces += 1.0;
        if (!truth.standard_error.empty()) {
            squares += static_cast<double>(truth.standard_error[i]) *
                       static_cast<double>(truth.standard_error[i]);
        }
    }
    result.truth_stderr = surfaces > 0.0 ? std::sqrt(squares / surfaces) : 0.0;
    result.surfaces = analysis::accessibility_error(values, truth.accessibility, result.is_surface);
    result.inside = analysis::accessibility_error(values, truth.accessibility, inside);
    return result;
}

void write_difference(const std::string& stem, AoComparison& comparison) {
    FloatImage image;
    image.width = comparison.width;
    image.height = comparison.height;
    image.channels = {{"difference.Y", comparison.difference}};
    image.texts = {{"obscura:camera", comparison.camera},
                   {"obscura:variant", comparison.variant},
                   {"obscura:truth", comparison.truth}};
    stimuli::RgbImage picture{comparison.width, comparison.height, {}};
    for (std::size_t i = 0; i < comparison.difference.size(); ++i) {
        const float value = comparison.difference[i];
        explorer::Rgb colour{0, 0, 0};
        if (comparison.is_surface[i] != 0) {
            colour = std::isfinite(value) ? explorer::orange_to_blue(value / kFullColour)
                                          : explorer::kNotANumber;
        }
        picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
    }
    comparison.files.emplace_back(stem + "-difference.exr");
    base::write_file_atomically(comparison.files.back(), renderer::encode_exr(image));
    comparison.files.emplace_back(stem + "-difference.png");
    base::write_file_atomically(comparison.files.back(), stimuli::encode_png(picture));
}

std::string comparison_table(const std::vector<AoComparison>& comparisons) {
    std::size_t width = 10;
    for (const AoComparison& one : comparisons) {
        width = std::max(width, one.camera.size() + one.variant.size() + 3);
    }
    std::string text = fmt::format("{:<{}}{:>8}{:>9}{:>8}{:>8}  {:>8}{:>9}{:>8}{:>8}\n", "", width,
                                   "rmse", "bias", "mae", "p99", "inside", "bias", "mae", "p99");
    for (const AoComparison& one : comparisons) {
        text += fmt::format("{:<{}}{}  {}\n", one.camera + ", " + one.variant, width,
                            columns_of(one.surfaces), columns_of(one.inside));
    }
    text +=
        "Linear accessibility, measured - truth, over surfaces; inside leaves out a tenth of the "
        "image at each side.\n";
    std::string last;
    for (const AoComparison& one : comparisons) {
        const std::string truth =
            one.truth_stderr > 0.0
                ? fmt::format("{} (its own standard error {:.4f})", one.truth, one.truth_stderr)
                : one.truth;
        if (truth != last) text += fmt::format("truth of {}: {}\n", one.variant, truth);
        last = truth;
        if (!one.surfaces.has_value()) {
            text += fmt::format("{}, {}: {}\n", one.camera, one.variant, one.surfaces.reason);
        } else if (one.surfaces->nonfinite > 0) {
            text += fmt::format("{}, {}: {} values are not finite and do not count\n", one.camera,
                                one.variant, one.surfaces->nonfinite);
        }
        for (const std::string& note : one.notes) text += fmt::format("note: {}\n", note);
    }
    return text;
}

std::string comparison_json(const std::vector<AoComparison>& comparisons) {
    auto list = nlohmann::ordered_json::array();
    for (const AoComparison& one : comparisons) {
        std::vector<std::string> files;
        for (const std::filesystem::path& file : one.files) files.push_back(file.string());
        list.push_back({{"camera", one.camera},
                        {"variant", one.variant},
                        {"truth", one.truth},
                        {"truth_stderr", one.truth_stderr},
                        {"surfaces", json_of_error(one.surfaces)},
                        {"inside", json_of_error(one.inside)},
                        {"files", files},
                        {"notes", one.notes}});
    }
    return list.dump(2) + "\n";
}

}  // namespace obscura::app
