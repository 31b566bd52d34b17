// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/images/images.h"
#include "stimuli/variant_format.h"

namespace obscura::stimuli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kSides{"a", "b"};

/// null where there is none.
Json to_json(const ManifestToneMapping& tone) {
    if (tone.curve.empty()) return nullptr;
    return {{"curve", tone.curve}, {"exposure", tone.exposure}, {"white", tone.white}};
}

ManifestToneMapping tone_mapping_from(const Json& json) {
    if (json.is_null()) return {};
    return {json.at("curve"), json.at("exposure"), json.at("white")};
}

Json to_json(const std::vector<ManifestImage::SceneFile>& files) {
    Json json = Json::array();
    for (const auto& file : files) json.push_back({{"name", file.name}, {"sha256", file.sha256}});
    return json;
}

Json to_json(const std::optional<Accuracy>& accuracy) {
    if (!accuracy) return nullptr;
    return {{"rmse", accuracy->rmse},
            {"bias", accuracy->bias},
            {"truth_radius_m", accuracy->radius_m},
            {"pixels", accuracy->pixels}};
}

std::optional<Accuracy> accuracy_from(const Json& json) {
    if (json.is_null()) return std::nullopt;
    return Accuracy{json.at("rmse"), json.at("bias"), json.at("truth_radius_m"), json.at("pixels")};
}

Json to_json(const ManifestImage& image) {
    Json json = {{"file", image.file},
                 {"sha256", image.sha256},
                 {"condition", image.condition},
                 {"side", image.side},
                 {"scene", image.scene},
                 {"source", image.source},
                 {"camera", image.camera},
                 {"validity", image.validity},
                 {"settings", Json::parse(image.settings)},
                 {"scene_files", to_json(image.scene_files)},
                 {"scene_notes", image.scene_notes}};
    put_variant(json, image.variant);
    json["width"] = image.width;
    json["height"] = image.height;
    json["supersampling"] = image.supersampling;
    json["occluding_opacity"] =
        image.occluding_opacity ? Json(*image.occluding_opacity) : Json(nullptr);
    json["tone_mapping"] = to_json(image.tone_mapping);
    json["passes"] = image.passes;
    json["milliseconds"] = image.milliseconds;
    const auto or_null = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    json["mean_luminance"] = or_null(image.mean_luminance);
    json["contrast"] = or_null(image.contrast);
    json["exposure_factor"] = or_null(image.exposure_factor);
    json["mean_occlusion"] = or_null(image.mean_occlusion);
    json["accuracy"] = to_json(image.accuracy);
    json["inputs_sha256"] = image.inputs_sha256;
    return json;
}

ManifestImage image_from(const Json& json) {
    ManifestImage image;
    json.at("file").get_to(image.file);
    json.at("sha256").get_to(image.sha256);
    json.at("condition").get_to(image.condition);
    json.at("side").get_to(image.side);
    json.at("scene").get_to(image.scene);
    json.at("source").get_to(image.source);
    json.at("camera").get_to(image.camera);
    json.at("validity").get_to(image.validity);
    // Manifests of before scenes came from files have none of these.
    image.settings = json.value("settings", Json::object()).dump();
    for (const Json& file : json.value("scene_files", Json::array())) {
        image.scene_files.push_back({file.at("name"), file.at("sha256")});
    }
    image.scene_notes = json.value("scene_notes", std::vector<std::string>());
    image.variant = variant_from(json);
    json.at("width").get_to(image.width);
    json.at("height").get_to(image.height);
    image.supersampling = json.value("supersampling", 1);  // older manifests have none of these
    const Json occluding = json.value("occluding_opacity", Json());
    if (!occluding.is_null()) image.occluding_opacity = occluding.get<float>();
    image.tone_mapping = tone_mapping_from(json.value("tone_mapping", Json()));
    const auto read = [&json](const char* name, std::optional<double>& value) {
        const Json found = json.value(name, Json());
        if (!found.is_null()) value = found.get<double>();
    };
    read("mean_luminance", image.mean_luminance);
    read("contrast", image.contrast);
    read("exposure_factor", image.exposure_factor);
    read("mean_occlusion", image.mean_occlusion);
    image.accuracy = accuracy_from(json.value("accuracy", Json()));
    json.at("passes").get_to(image.passes);
    json.at("milliseconds").get_to(image.milliseconds);
    json.at("inputs_sha256").get_to(image.inputs_sha256);
    // The file is opened in the manifest's folder and nowhere else.
    if (image.file.empty() || image.file != std::filesystem::path(image.file).filename().string() ||
        image.file == "." || image.file == "..") {
        throw base::bad_input("file \"{}\" is no file name", image.file);
    }
    return image;
}

/// b's less a's; null where one of them is not known.
Json change_of(const std::optional<double>& a, const std::optional<double>& b) {
    return a && b ? Json(*b - *a) : Json(nullptr);
}

/// With what follows from its two images, for who reads the file without this program.
Json to_json(const ManifestPair& pair, const Manifest& manifest) {
    Json json = {{"condition", pair.condition},
                 {"a_sha256", pair.a_sha256},
                 {"b_sha256", pair.b_sha256},
                 {"differing_share", pair.difference.differing},
                 {"noticeable_share", pair.difference.over_threshold},
                 {"visible", pair.difference.visible},
                 {"largest_delta_e", pair.difference.largest_delta_e},
                 {"reason", pair.reason}};
    const ManifestImage* const a = manifest.find(pair.condition, "a");
    const ManifestImage* const b = manifest.find(pair.condition, "b");
    if (a == nullptr || b == nullptr) return json;
    json["mean_luminance_change"] = change_of(a->mean_luminance, b->mean_luminance);
    json["contrast_change"] = change_of(a->contrast, b->contrast);
    const char side = more_accurate(*a, *b);
    json["more_accurate"] = side == '\0' ? Json(nullptr) : Json(std::string(1, side));
    return json;
}

ManifestPair pair_from(const Json& json) {
    ManifestPair pair;
    json.at("condition").get_to(pair.condition);
    json.at("a_sha256").get_to(pair.a_sha256);
    json.at("b_sha256").get_to(pair.b_sha256);
    json.at("differing_share").get_to(pair.difference.differing);
    json.at("noticeable_share").get_to(pair.difference.over_threshold);
    json.at("visible").get_to(pair.difference.visible);
    json.at("largest_delta_e").get_to(pair.difference.largest_delta_e);
    json.at("reason").get_to(pair.reason);
    return pair;
}

/// Looks at the file itself, since a manifest can be edited.
std::string problem_of_size(const Study& study, const std::filesystem::path& path) {
    std::string why;
    const std::unique_ptr<images::Reader> image = images::library().open(path, why);
    if (!image) return fmt::format("{}: no image that can be read: {}", path.string(), why);
    if (image->width == study.width && image->height == study.height) return "";
    return fmt::format("{}: the image is {}x{} pixels, the study asks for {}x{}", path.string(),
                       image->width, image->height, study.width, study.height);
}

/// What an image shows: a name and a value each.
using Content = std::map<std::string, std::string>;

Content content_of(const std::string& source, const std::string& camera, std::string_view validity,
                   const std::string& scene_settings, const renderer::Variant& variant) {
    Content content{{"scene", source},
                    {"camera", camera},
                    {"validity", std::string(validity)},
                    {"variant", variant.variant_name()},
                    {"denoise", variant.denoise}};
    const Json settings = Json::parse(scene_settings).flatten();
    for (const auto& [path, value] : settings.items()) {
        if (!path.empty()) content[path.substr(1)] = value.dump();
    }
    for (const auto& [name, value] : variant.all_parameters()) {
        content[name] = fmt::format("{}", value);
    }
    for (const renderer::VariantOption& option : renderer::variant_options()) {
        content[std::string(option.name)] = variant.*option.value;
    }
    return content;
}

/// What two images differ in, as `power 16, the study asks for 8`; a parameter that only one of two
/// techniques has goes without saying.
std::string changes_of(const Content& shown, const Content& wanted) {
    std::string words;
    for (const auto& [name, value] : shown) {
        const auto other = wanted.find(name);
        const bool same_technique = shown.at("variant") == wanted.at("variant");
        if (other == wanted.end() ? !same_technique : other->second == value) continue;
        words += fmt::format("{}{} {}, the study asks for {}", words.empty() ? "" : "; ", name,
                             value, other == wanted.end() ? "none" : other->second);
    }
    for (const auto& [name, value] : wanted) {
        if (shown.contains(name) || shown.at("variant") != wanted.at("variant")) continue;
        words +=
            fmt::format("{}no {}, the study asks for {}", words.empty() ? "" : "; ", name, value);
    }
    return words.empty() ? "another size, supersampling, opacity or match of luminance than the "
                           "study asks for"
                         : words;
}

/// An image of before the study was edited is as sound a file as any, but shows something else.
std::string problem_of_content(const Study& study, const Condition& condition,
                               const ManifestImage& image, const std::filesystem::path& path) {
    if (shows_what_is_asked(study, image)) return "";
    const StudyScene& scene = study.scene_of(condition);
    const renderer::Variant& wanted = image.side == "a" ? condition.a : condition.b;
    return fmt::format("{}: it shows {}; obscura render makes it anew", path.string(),
                       changes_of(content_of(image.source, image.camera, image.validity,
                                             image.settings, image.variant),
                                  content_of(scene.source, scene.camera, to_string(scene.validity),
                                             to_json(scene.settings), wanted)));
}

std::string problem_of_image(const Study& study, const Condition& condition, const char* side,
                             const Manifest& manifest, const std::filesystem::path& folder) {
    const ManifestImage* image = manifest.find(condition.id, side);
    if (image == nullptr) {
        return fmt::format("{}: it has no entry for condition {}, image {}",
                           (folder / "manifest.json").string(), condition.id, side);
    }
    const std::filesystem::path path = folder / image->file;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) {
        return fmt::format("{}: the file is missing", path.string());
    }
    try {
        const std::string met = base::sha256_hex(base::read_file(path));
        if (met != image->sha256) {
            return fmt::format("{}: the file was changed: its SHA-256 is {}, the manifest says {}",
                               path.string(), met, image->sha256);
        }
    } catch (const base::Error& unreadable) {
        return unreadable.what();
    }
    std::string problem = problem_of_size(study, path);
    return problem.empty() ? problem_of_content(study, condition, *image, path) : problem;
}

}  // namespace

const ManifestImage* Manifest::find(const std::string& condition, const std::string& side) const {
    const auto found = std::find_if(images.begin(), images.end(), [&](const auto& image) {
        return image.condition == condition && image.side == side;
    });
    return found != images.end() ? &*found : nullptr;
}

char more_accurate(const ManifestImage& a, const ManifestImage& b) {
    if (!a.accuracy || !b.accuracy) return '\0';
    const auto [less, more] = std::minmax(a.accuracy->rmse, b.accuracy->rmse);
    if (more - less < kLeastOrder * more || more == 0.0) return '\0';
    return a.accuracy->rmse < b.accuracy->rmse ? 'a' : 'b';
}

bool shows_what_is_asked(const Study& study, const ManifestImage& image) {
    const Condition* condition = study.find_condition(image.condition);
    if (condition == nullptr) return false;
    const StudyScene& scene = study.scene_of(*condition);
    return image.source == scene.source && image.camera == scene.camera &&
           image.validity == to_string(scene.validity) &&
           image.settings == to_json(scene.settings) && image.width == study.width &&
           image.height == study.height && image.supersampling == study.supersampling &&
           image.occluding_opacity == study.occluding_opacity &&
           image.exposure_factor.has_value() == (study.match_luminance && image.side == "b") &&
           image.variant == (image.side == "a" ? condition->a : condition->b);
}

Manifest load_manifest(const std::filesystem::path& file) {
    return parse_manifest(base::read_file(file), file.string());
}

Manifest parse_manifest(const std::string& text, const std::string& name) {
    Manifest manifest;
    std::size_t index = 0;
    std::string_view list;
    try {
        const Json json = Json::parse(text);
        json.at("study").get_to(manifest.study);
        json.at("seed").get_to(manifest.seed);
        json.at("gpu_renderer").get_to(manifest.gpu_renderer);
        manifest.program = json.value("program", "");  // older manifests have none
        const Json& images = json.at("images");
        if (!images.is_array()) throw base::bad_input("images is no array");
        list = "images";
        for (; index < images.size(); ++index) {
            manifest.images.push_back(image_from(images[index]));
        }
        list = "pairs";  // older manifests have none
        index = 0;
        for (const Json& pair : json.value("pairs", Json::array())) {
            manifest.pairs.push_back(pair_from(pair));
            ++index;
        }
    } catch (const std::exception& error) {  // of nlohmann-json, or bad input from above
        const std::string where = list.empty() ? "" : fmt::format("{}[{}]: ", list, index);
        throw base::bad_input("{}: not a manifest of stimuli: {}{}", name, where, error.what());
    }
    return manifest;
}

void save_manifest(const std::filesystem::path& file, const Manifest& manifest) {
    Json json = {{"study", manifest.study},     {"seed", manifest.seed},
                 {"program", manifest.program}, {"gpu_renderer", manifest.gpu_renderer},
                 {"images", Json::array()},     {"pairs", Json::array()}};
    for (const ManifestImage& image : manifest.images) json["images"].push_back(to_json(image));
    for (const ManifestPair& pair : manifest.pairs) {
        json["pairs"].push_back(to_json(pair, manifest));
    }
    base::write_file_atomically(file, json.dump(2) + "\n");
}

std::filesystem::path stimuli_folder(const std::filesystem::path& data, const Study& study) {
    return data / "stimuli" / study.name;
}

std::vector<std::string> problems_of_stimuli(const Study& study,
                                             const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / "manifest.json";
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
        return {fmt::format("{}: the file is missing; obscura render makes it", file.string())};
    }
    Manifest manifest;
    try {
        manifest = load_manifest(file);
    } catch (const base::Error& wrong) {
        return {wrong.what()};
    }
    std::vector<std::string> problems;
    if (manifest.study != study.name) {
        problems.push_back(fmt::format("{}: it belongs to the study {}, not to {}", file.string(),
                                       manifest.study, study.name));
    }
    for (const Condition& condition : study.conditions) {
        for (const char* side : kSides) {
            std::string problem = problem_of_image(study, condition, side, manifest, folder);
            if (!problem.empty()) problems.push_back(std::move(problem));
        }
    }
    return problems;
}

}  // namespace obscura::stimuli
