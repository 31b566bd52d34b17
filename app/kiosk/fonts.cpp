// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/fonts.h"

#include <fontconfig/fontconfig.h>
#include <imgui.h>
#include <imgui_freetype.h>

#include <algorithm>
#include <memory>

#include "renderer/base/error.h"
#include "renderer/base/log.h"

namespace obscura::app::kiosk {
namespace {

/// Heights of the text for a window 1000 pixels high.
constexpr float kReferenceHeight = 1000.0F;
constexpr float kText_px = 25.0F;
constexpr float kHeading_px = 38.0F;
constexpr float kSmall_px = 19.0F;
constexpr float kSmallestScale = 0.72F;
constexpr float kLargestScale = 2.0F;

template <auto Destroy>
struct Deleter {
    template <typename T>
    void operator()(T* pointer) const {
        Destroy(pointer);
    }
};
using Pattern = std::unique_ptr<FcPattern, Deleter<FcPatternDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Deleter<FcCharSetDestroy>>;

struct FontFile {
    std::string path;
    int index = 0;
    CharSet characters;
};

/// The font that fontconfig finds best, with `wanted` characters where given.
[[nodiscard]] FontFile find_font(const char* family, const FcCharSet* wanted) {
    Pattern pattern(FcPatternCreate());
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
    if (wanted != nullptr) FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted);
    FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    const Pattern match(FcFontMatch(nullptr, pattern.get(), &result));
    FcChar8* path = nullptr;
    if (!match || FcPatternGetString(match.get(), FC_FILE, 0, &path) != FcResultMatch) return {};
    FontFile font;
    font.path = reinterpret_cast<const char*>(path);
    FcPatternGetInteger(match.get(), FC_INDEX, 0, &font.index);
    FcCharSet* characters = nullptr;
    if (FcPatternGetCharSet(match.get(), FC_CHARSET, 0, &characters) == FcResultMatch) {
        font.characters.reset(FcCharSetCopy(characters));
    }
    return font;
}

/// The characters of the texts.
[[nodiscard]] CharSet characters_of(const std::vector<std::string>& texts) {
    CharSet characters(FcCharSetCreate());
    for (const std::string& text : texts) {
        const auto* at = reinterpret_cast<const FcChar8*>(text.data());
        int left = static_cast<int>(text.size());
        while (left > 0) {
            FcChar32 character = 0;
            const int used = FcUtf8ToUcs4(at, &character, left);
            if (used <= 0) break;
            if (character >= ' ') FcCharSetAddChar(characters.get(), character);
            at += used;
            left -= used;
        }
    }
    return characters;
}

/// DejaVu Sans, then fonts for what is still missing.
[[nodiscard]] std::vector<FontFile> choose_fonts(const FcCharSet* needed) {
    std::vector<FontFile> fonts;
    fonts.push_back(find_font("DejaVu Sans", nullptr));
    if (fonts.back().path.empty()) {
        throw base::failure("fontconfig finds no TrueType font; install fonts-dejavu-core");
    }
    CharSet missing(FcCharSetSubtract(needed, fonts.back().characters.get()));
    while (FcCharSetCount(missing.get()) > 0) {
        FontFile font = find_font("sans-serif", missing.get());
        if (font.path.empty() || !font.characters ||
            FcCharSetIntersectCount(missing.get(), font.characters.get()) == 0) {
            spdlog::warn("no font on this system has {} of the characters of the study's texts",
                         FcCharSetCount(missing.get()));
            break;
        }
        missing.reset(FcCharSetSubtract(missing.get(), font.characters.get()));
        fonts.push_back(std::move(font));
    }
    return fonts;
}

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

Fonts load_fonts(const std::vector<std::string>& texts, int window_height) {
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

    const CharSet needed = characters_of(texts);
    const std::vector<FontFile> fonts = choose_fonts(needed.get());
    const float scale = std::clamp(static_cast<float>(window_height) / kReferenceHeight,
                                   kSmallestScale, kLargestScale);
    Fonts loaded;
    loaded.text = add_font(fonts, kText_px * scale, ranges);
    loaded.heading = add_font(fonts, kHeading_px * scale, ranges);
    loaded.small = add_font(fonts, kSmall_px * scale, ranges);
    if (!atlas.Build()) throw base::failure("cannot draw the font {}", fonts.front().path);
    return loaded;
}

}  // namespace obscura::app::kiosk
