// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/layout.h"

#include <algorithm>
#include <cmath>

namespace obscura::app::explorer {
namespace {

[[nodiscard]] float held(float value, float low, float high, float instead) {
    return std::isfinite(value) ? std::clamp(value, low, high) : instead;
}

}  // namespace

const char* to_string(Arrangement arrangement) {
    switch (arrangement) {
        case Arrangement::kOne:
            return "one";
        case Arrangement::kSplit:
            return "split";
        case Arrangement::kFour:
            return "four";
        case Arrangement::kFlicker:
            return "flicker";
    }
    return "";
}

std::string layer::meaning_of(const std::string& layer) {
    if (layer == kImage) return "The final image, as obscura render makes it";
    if (layer == kAccessibility) return "What the composite uses: white is open, black occluded";
    if (layer == kError) return "Accessibility less the truth: orange too dark, blue too light";
    if (layer == kTruth) return "Ray-traced accessibility, as far as it is known";
    if (layer == kTruthError) return "The truth's own standard error";
    if (layer == kAlbedo) return "The surfaces' colour";
    if (layer == kNormal) return "View-space normals: red right, green up, blue to the camera";
    if (layer == kDepth) return "View distance in metres";
    if (layer == kLight) return "Light on the surfaces / pi, before accessibility";
    if (layer == kEmission) return "Light that surfaces send out";
    return "A buffer of the technique itself";
}

std::vector<Pane> Layout::visible(double time_s) const {
    switch (arrangement) {
        case Arrangement::kOne:
            return {panes[0]};
        case Arrangement::kSplit:
            return {{'a', panes[0].layer}, {'b', panes[0].layer}};
        case Arrangement::kFour:
            return {panes.begin(), panes.end()};
        case Arrangement::kFlicker:
            break;
    }
    const bool first = std::fmod(time_s * flicker_hz, 2.0) < 1.0;
    return {{first ? 'a' : 'b', panes[0].layer}};
}

std::vector<Pane> Layout::ever_visible() const {
    if (arrangement != Arrangement::kFlicker) return visible(0.0);
    return {{'a', panes[0].layer}, {'b', panes[0].layer}};
}

Layout Layout::sane() const {
    Layout sane = *this;
    sane.split = held(split, 0.0F, 1.0F, 0.5F);
    sane.flicker_hz =
        std::isfinite(flicker_hz) ? std::clamp(flicker_hz, 0.1, kMostFlicker_hz) : 1.0;
    sane.zoom = zoom == 0.0F ? 0.0F : held(zoom, 0.25F, kMostZoom, 0.0F);
    sane.middle = {held(middle.x, 0.0F, 1.0F, 0.5F), held(middle.y, 0.0F, 1.0F, 0.5F)};
    sane.depth_low_m = held(depth_low_m, 0.0F, 1e7F, 0.0F);
    sane.depth_high_m = held(depth_high_m, 0.0F, 1e7F, 0.0F);
    if (sane.depth_high_m <= sane.depth_low_m) sane.depth_high_m = 0.0F;
    sane.error_range = held(error_range, 0.001F, 1.0F, 0.25F);
    for (Pane& pane : sane.panes) {
        if (pane.side != 'a' && pane.side != 'b') pane.side = 'a';
        const bool own = pane.layer.starts_with(layer::kOwn);
        const bool known =
            std::find(layer::kAll.begin(), layer::kAll.end(), pane.layer) != layer::kAll.end();
        if (!own && !known) pane.layer = layer::kImage;
    }
    return sane;
}

float next_zoom(float zoom, bool larger, float whole) {
    static constexpr std::array kZooms{0.25F, 0.5F,  1.0F,  2.0F,     4.0F,
                                       8.0F,  16.0F, 32.0F, kMostZoom};
    const float now = zoom > 0.0F ? zoom : whole;
    if (larger) {
        const auto above = std::upper_bound(kZooms.begin(), kZooms.end(), now);
        return above != kZooms.end() ? *above : kMostZoom;
    }
    const auto here = std::lower_bound(kZooms.begin(), kZooms.end(), now);
    const float below = here != kZooms.begin() ? *(here - 1) : 0.0F;
    return below > whole ? below : 0.0F;
}

}  // namespace obscura::app::explorer
