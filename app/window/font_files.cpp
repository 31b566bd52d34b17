// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/window/font_files.h"

#include <fontconfig/fontconfig.h>

#include <memory>

namespace obscura::app::window {
namespace {

template <auto Destroy>
struct Deleter {
    template <typename T>
    void operator()(T* pointer) const {
        Destroy(pointer);
    }
};
using Pattern = std::unique_ptr<FcPattern, Deleter<FcPatternDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Deleter<FcCharSetDestroy>>;

[[nodiscard]] CharSet char_set(const std::set<char32_t>& characters) {
    CharSet set(FcCharSetCreate());
    for (const char32_t character : characters) FcCharSetAddChar(set.get(), character);
    return set;
}

[[nodiscard]] bool says(const FcPattern* font, const char* property) {
    FcBool value = FcFalse;
    return FcPatternGetBool(font, property, 0, &value) == FcResultMatch && value == FcTrue;
}

struct Found {
    FontFile file;
    CharSet characters;
};

/// The font that fontconfig finds best, with `wanted` characters where given; an empty path where
/// that is none that the pages can draw.
[[nodiscard]] Found find_font(const char* family, const FcCharSet* wanted) {
    const Pattern pattern(FcPatternCreate());
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_COLOR, FcFalse);
    if (wanted != nullptr) FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted);
    FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    const Pattern match(FcFontMatch(nullptr, pattern.get(), &result));
    // What matches best may match badly.
    if (!match || !says(match.get(), FC_OUTLINE) || says(match.get(), FC_COLOR)) return {};
    FcChar8* path = nullptr;
    FcCharSet* characters = nullptr;
    if (FcPatternGetString(match.get(), FC_FILE, 0, &path) != FcResultMatch ||
        FcPatternGetCharSet(match.get(), FC_CHARSET, 0, &characters) != FcResultMatch) {
        return {};
    }
    Found found;
    found.file.path = reinterpret_cast<const char*>(path);
    FcPatternGetInteger(match.get(), FC_INDEX, 0, &found.file.index);
    found.characters.reset(FcCharSetCopy(characters));
    return found;
}

}  // namespace

std::set<char32_t> characters_of(const std::vector<std::string>& texts) {
    std::set<char32_t> characters;
    for (const std::string& text : texts) {
        const auto* at = reinterpret_cast<const FcChar8*>(text.data());
        int left = static_cast<int>(text.size());
        while (left > 0) {
            FcChar32 character = 0;
            const int used = FcUtf8ToUcs4(at, &character, left);
            if (used <= 0) break;
            if (character != '\n' && character != '\r') characters.insert(character);
            at += used;
            left -= used;
        }
    }
    return characters;
}

FontChoice choose_fonts(const std::set<char32_t>& characters) {
    FontChoice choice{{}, characters};
    choice.missing.erase(U'\t');  // drawn as blanks
    const auto take = [&choice](Found found) {
        const auto taken = std::erase_if(choice.missing, [&](char32_t character) {
            return FcCharSetHasChar(found.characters.get(), character) == FcTrue;
        });
        if (taken > 0 || choice.files.empty()) choice.files.push_back(std::move(found.file));
        return taken > 0;
    };
    Found first = find_font("DejaVu Sans", nullptr);
    if (first.file.path.empty()) return choice;
    take(std::move(first));
    while (!choice.missing.empty()) {
        const CharSet wanted = char_set(choice.missing);
        Found font = find_font("sans-serif", wanted.get());
        if (font.file.path.empty() || !take(std::move(font))) break;
    }
    return choice;
}

}  // namespace obscura::app::window
