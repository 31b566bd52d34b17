// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/remembered.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::app::explorer {
namespace {

using Json = nlohmann::ordered_json;

/// The member, where it is there and of that type.
template <typename T>
void take(const Json& object, const char* name, T& value) {
    const auto found = object.find(name);
    if (found == object.end()) return;
    try {
        value = found->get<T>();
    } catch (const Json::exception&) {
        return;
    }
}

[[nodiscard]] Layout layout_from(const Json& object) {
    Layout layout;
    std::string arrangement;
    take(object, "arrangement", arrangement);
    for (const Arrangement known : kArrangements) {
        if (arrangement == to_string(known)) layout.arrangement = known;
    }
    take(object, "split", layout.split);
    take(object, "flicker_hz", layout.flicker_hz);
    take(object, "error_range", layout.error_range);
    const auto panes = object.find("panes");
    if (panes != object.end() && panes->is_array()) {
        for (std::size_t i = 0; i < std::min(panes->size(), layout.panes.size()); ++i) {
            const Json& one = (*panes)[i];
            if (!one.is_object()) continue;
            std::string side(1, layout.panes[i].side);
            take(one, "side", side);
            if (!side.empty()) layout.panes[i].side = side.front();
            take(one, "layer", layout.panes[i].layer);
        }
    }
    return layout.sane();
}

}  // namespace

std::string to_json(const Remembered& remembered) {
    Json panes = Json::array();
    for (const Pane& pane : remembered.layout.panes) {
        panes.push_back({{"side", std::string(1, pane.side)}, {"layer", pane.layer}});
    }
    const Json object = {{"window", {remembered.window_width, remembered.window_height}},
                         {"what", remembered.what},
                         {"text_scale", remembered.text_scale},
                         {"panels", remembered.panels},
                         {"layout",
                          {{"arrangement", to_string(remembered.layout.arrangement)},
                           {"split", remembered.layout.split},
                           {"flicker_hz", remembered.layout.flicker_hz},
                           {"error_range", remembered.layout.error_range},
                           {"panes", panes}}}};
    return object.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

Remembered remembered_from(const std::string& json) {
    constexpr int kLargest = 16384;
    Remembered remembered;
    const Json object = Json::parse(json, nullptr, false);
    if (!object.is_object()) return remembered;
    const auto window = object.find("window");
    if (window != object.end() && window->is_array() && window->size() == 2 &&
        (*window)[0].is_number_integer() && (*window)[1].is_number_integer()) {
        remembered.window_width = std::clamp((*window)[0].get<int>(), 0, kLargest);
        remembered.window_height = std::clamp((*window)[1].get<int>(), 0, kLargest);
    }
    take(object, "what", remembered.what);
    take(object, "text_scale", remembered.text_scale);
    take(object, "panels", remembered.panels);
    if (!std::isfinite(remembered.text_scale)) remembered.text_scale = 1.0F;
    remembered.text_scale = std::clamp(remembered.text_scale, 0.5F, 3.0F);
    const auto layout = object.find("layout");
    if (layout != object.end() && layout->is_object()) remembered.layout = layout_from(*layout);
    return remembered;
}

std::optional<Remembered> load_remembered(const std::filesystem::path& data) {
    try {
        return remembered_from(base::read_file(data / "explorer.json"));
    } catch (const base::Error&) {
        return std::nullopt;
    }
}

void save_remembered(const std::filesystem::path& data, const Remembered& remembered) {
    base::write_file_atomically(data / "explorer.json", to_json(remembered));
}

}  // namespace obscura::app::explorer
