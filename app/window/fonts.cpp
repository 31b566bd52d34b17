// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/window/fonts.h"

#include <imgui.h>
#include <imgui_freetype.h>

#include <algorithm>
#include <cmath>

#include "app/window/font_files.h"
#include "renderer/base/error.h"

namespace obscura::app::window {
namespace {

/// Heights of the text for a window 1000 pixels high.
constexpr float kReferenceHeight = 1000.0F;
constexpr float kText_px = 25.0F;
constexpr float kHeading_px = 38.0F;
constexpr float kSmall_px = 19.0F;
constexpr float kSmallestScale = 0.72F;
constexpr float kLargestScale = 2.0F;

[[nodiscard]] ImFont* add_font(const std::vector<FontFile>& fonts, float size_px,
                               const ImVector<ImWchar>& ranges) {
    ImFont* first = nullptr;
    for (const FontFile& font : fonts) {
        ImFontConfig config;
        config.FontNo = font.index;
        config.MergeMode = first != nullptr;
        ImFont* added = ImGui::GetIO().Fonts->AddFontFromFileTTF(font.path.c_str(), size_px,
                                                                 &config, ranges.Data);
        if (first == nullptr) first = added;
    }
    if (first == nullptr) throw base::failure("cannot read the font {}", fonts.front().path);
    return first;
}

}  // namespace

FontSizes sizes_of_pages(int window_height) {
    const float scale = std::clamp(static_cast<float>(window_height) / kReferenceHeight,
                                   kSmallestScale, kLargestScale);
    return {std::round(kText_px * scale), std::round(kHeading_px * scale),
            std::round(kSmall_px * scale)};
}

Fonts load_fonts(const std::vector<std::string>& texts, const FontSizes& sizes) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    ImFontGlyphRangesBuilder builder;
    // Letters that a participant may type, beside those of the texts.
    static constexpr ImWchar kEuropean[] = {0x0020, 0x024F, 0x0370, 0x03FF, 0x0400,
                                            0x04FF, 0x2010, 0x2026, 0};
    builder.AddRanges(kEuropean);
    for (const std::string& text : texts) {
        builder.AddText(text.c_str(), text.c_str() + text.size());
    }
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);

    const std::vector<FontFile> fonts = choose_fonts(characters_of(texts)).files;
    if (fonts.empty()) {
        throw base::failure("fontconfig finds no TrueType font; install fonts-dejavu-core");
    }
    Fonts loaded;
    loaded.text = add_font(fonts, sizes.text_px, ranges);
    loaded.heading = add_font(fonts, sizes.heading_px, ranges);
    loaded.small = add_font(fonts, sizes.small_px, ranges);
    if (!atlas.Build()) throw base::failure("cannot draw the font {}", fonts.front().path);
    return loaded;
}

}  // namespace obscura::app::window
