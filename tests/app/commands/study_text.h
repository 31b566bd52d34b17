// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace obscura::app {

/// The table [study], seven lines, with `more` below it.
inline std::string study_head(std::string_view name, std::string_view order,
                              std::string_view more = "") {
    return fmt::format(
        "[study]\nname = \"{}\"\ntitle = \"A title\"\nquestion = \"Which?\"\n"
        "instructions = \"Look.\"\norder = \"{}\"\nseed = 7\n{}",
        name, order, more);
}

/// A scene by its source's only camera.
inline std::string scene_text(std::string_view id, std::string_view source,
                              std::string_view validity) {
    return fmt::format(
        "[[scene]]\nid = \"{}\"\nsource = \"{}\"\ncamera = \"{}\"\n"
        "validity = \"{}\"\n",
        id, source, source == "atrium" ? "nave" : "front", validity);
}

/// `a` and `b`: techniques with their settings, `"crytek", samples = 8`.
inline std::string condition_text(std::string_view id, std::string_view scene, std::string_view a,
                                  std::string_view b) {
    return fmt::format(
        "[[condition]]\nid = \"{}\"\nscene = \"{}\"\n"
        "a = {{ technique = {} }}\nb = {{ technique = {} }}\n",
        id, scene, a, b);
}

/// One pair of small images, which software renders in a second.
inline std::string tiny_study(std::string_view name) {
    return study_head(name, "fixed", "resolution = [64, 48]\n") +
           scene_text("stone", "relic", "low") +
           condition_text("one", "stone", "\"none\"", "\"crytek\", samples = 8");
}

}  // namespace obscura::app
