// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/measure/kept_views.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"
#include "renderer/gl/drawing_hash.h"
#include "stimuli/variant_format.h"

namespace obscura::analysis {

template <typename Json, typename T>
void to_json(Json& json, const Possible<T>& possible) {
    if (possible.has_value()) {
        json = Json{{"value", *possible}};
    } else {
        json = Json{{"reason", possible.reason}};
    }
}

template <typename Json, typename T>
void from_json(const Json& json, Possible<T>& possible) {
    if (json.contains("value")) {
        possible = json.at("value").template get<T>();
    } else {
        possible = Possible<T>::none(json.at("reason").template get<std::string>());
    }
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(AccessibilityError, rmse, bias, mae, p99, psnr_db, pixels,
                                   nonfinite)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FinalImageError, rmse, max, yee_failed)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TimeSummary, min_ms, median_ms, p95_ms)

}  // namespace obscura::analysis

template <typename T>
struct nlohmann::adl_serializer<std::optional<T>> {
    static void to_json(json& json, const std::optional<T>& value) {
        json = value ? nlohmann::json(*value) : nlohmann::json(nullptr);
    }
    static void from_json(const json& json, std::optional<T>& value) {
        value = json.is_null() ? std::optional<T>() : std::optional<T>(json.template get<T>());
    }
};

namespace obscura::analysis {

// `on_front` is marked over all views at the end.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(MeasurementRow, scene_id, scene, camera, validity, technique,
                                   variant, samples, denoise, ao_scale, depth_format, noise,
                                   options, width, height, device, timer, fitted, values, published,
                                   parameters, reference_radius_m, truth_stderr, cost,
                                   accessibility, filter, frame, runs, layer_ms, fetches_per_px,
                                   bytes, nonfinite, error, interior, image)

}  // namespace obscura::analysis

namespace obscura::app {
namespace {

using Json = nlohmann::json;

/// The bytes of numbers as they lie in memory: a kept view never leaves its machine.
template <typename T>
std::string_view bytes_of(const std::vector<T>& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

Json map_to_json(const analysis::ErrorMap& map) {
    const std::string_view bytes = bytes_of(map.difference);
    return {{"width", map.width},
            {"height", map.height},
            {"limit", map.limit},
            {"difference", Json::binary({bytes.begin(), bytes.end()})}};
}

analysis::ErrorMap map_from_json(const Json& json) {
    analysis::ErrorMap map;
    map.width = json.at("width").get<int>();
    map.height = json.at("height").get<int>();
    map.limit = json.at("limit").get<double>();
    const std::vector<std::uint8_t>& bytes = json.at("difference").get_binary();
    map.difference.resize(bytes.size() / sizeof(float));
    std::memcpy(map.difference.data(), bytes.data(), map.difference.size() * sizeof(float));
    return map;
}

/// A hash of what follows, which is the view in CBOR (RFC 8949).
std::string encode(const SweptView& view) {
    Json json{{"rows", view.rows}, {"maps", Json::array()}, {"house_ms", view.house_ms}};
    for (const auto& [row, map] : view.maps) {
        json["maps"].push_back({{"row", row}, {"map", map_to_json(map)}});
    }
    std::string bytes;
    Json::to_cbor(json, bytes);
    return base::sha256_hex(bytes) + bytes;
}

SweptView decode(const std::string& file) {
    constexpr std::size_t kHash = 64;
    if (file.size() < kHash || base::sha256_hex(file.substr(kHash)) != file.substr(0, kHash)) {
        throw base::bad_input("its bytes are not those that were written");
    }
    const Json json = Json::from_cbor(file.begin() + kHash, file.end());
    SweptView view;
    view.rows = json.at("rows").get<std::vector<analysis::MeasurementRow>>();
    json.at("house_ms").get_to(view.house_ms);
    for (const Json& map : json.at("maps")) {
        view.maps.emplace_back(map.at("row").get<std::size_t>(), map_from_json(map.at("map")));
    }
    return view;
}

}  // namespace

std::filesystem::path KeptViews::file_of(const std::string& description) const {
    return folder_ / (base::sha256_hex(description) + ".cbor");
}

std::optional<SweptView> KeptViews::find(const std::string& description) {
    const std::filesystem::path file = file_of(description);
    if (folder_.empty() || !std::filesystem::exists(file)) return std::nullopt;
    files_.insert(file);
    try {
        return decode(base::read_file(file));
    } catch (const std::exception& error) {
        base::log::warn("{} is damaged, the view is measured again: {}", file.string(),
                        error.what());
        return std::nullopt;
    }
}

void KeptViews::keep(const std::string& description, const SweptView& view) {
    if (folder_.empty()) return;
    const std::filesystem::path file = file_of(description);
    base::write_file_atomically(file, encode(view));
    files_.insert(file);
}

void KeptViews::give_up() {
    for (const std::filesystem::path& file : files_) {
        std::error_code gone_already;
        std::filesystem::remove(file, gone_already);
    }
    files_.clear();
}

std::string description_of(MeasuredScene& stage, const MeasureRequest& request,
                           const MeasuredView& view, const std::vector<Setting>& settings,
                           const TimerCheck& timers) {
    Json json{{"drawing", renderer::drawing_sha256()},
              {"timer", timers.timer()},
              {"rays", *request.rays},
              {"runs", *request.runs},
              {"view", {view.scene_id, view.scene->source, view.camera}},
              {"settings", Json::array()},
              {"truths", Json::object()}};
    for (const Setting& setting : settings) {
        nlohmann::ordered_json choice;
        stimuli::put_variant(choice, setting.choice);
        const std::string radius = fmt::format("{}", setting.truth_radius_m);
        json["settings"].push_back(
            {choice.dump(), radius, to_string(setting.values), setting.shown});
        if (json["truths"].contains(radius)) continue;
        const renderer::ReferenceImage& truth = stage.truth(
            view, setting.truth_radius_m, *request.width, *request.height, *request.rays);
        const std::vector<std::uint8_t> image =
            stage.true_image(view, truth, setting.truth_radius_m);
        json["truths"][radius] = {truth.width, truth.height,
                                  base::sha256_hex(bytes_of(truth.accessibility)),
                                  base::sha256_hex(bytes_of(image))};
    }
    return json.dump();
}

}  // namespace obscura::app
