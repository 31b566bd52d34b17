// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/text_check.h"

#include <fmt/format.h>
#include <imgui.h>
#include <unicode/uchar.h>
#include <unicode/uscript.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "app/window/font_files.h"

namespace obscura::app::kiosk {
namespace {

/// Dear ImGui's type of a character ends here; Debian's has 16 bits.
constexpr char32_t kLast = sizeof(ImWchar) == 2 ? 0xFFFF : 0x10FFFF;

constexpr std::size_t kNamed = 6;  // characters that a sentence names

/// Scripts whose letters stand side by side from left to right, one glyph each.
constexpr std::array kPlainScripts{USCRIPT_COMMON,   USCRIPT_LATIN,    USCRIPT_GREEK,
                                   USCRIPT_CYRILLIC, USCRIPT_ARMENIAN, USCRIPT_GEORGIAN,
                                   USCRIPT_HAN,      USCRIPT_HIRAGANA, USCRIPT_KATAKANA,
                                   USCRIPT_HANGUL,   USCRIPT_BOPOMOFO, USCRIPT_YI,
                                   USCRIPT_ETHIOPIC, USCRIPT_CHEROKEE, USCRIPT_CANADIAN_ABORIGINAL,
                                   USCRIPT_TIFINAGH, USCRIPT_BRAILLE,  USCRIPT_COPTIC,
                                   USCRIPT_OGHAM,    USCRIPT_RUNIC,    USCRIPT_VAI,
                                   USCRIPT_INHERITED};

[[nodiscard]] UScriptCode script_of(char32_t character) {
    UErrorCode error = U_ZERO_ERROR;
    const UScriptCode script = uscript_getScript(static_cast<UChar32>(character), &error);
    return U_SUCCESS(error) ? script : USCRIPT_UNKNOWN;
}

[[nodiscard]] std::string name_of(char32_t character) {
    std::array<char, 128> name{};
    UErrorCode error = U_ZERO_ERROR;
    u_charName(static_cast<UChar32>(character), U_EXTENDED_CHAR_NAME, name.data(),
               static_cast<int>(name.size()), &error);
    return fmt::format("U+{:04X} {}", static_cast<std::uint32_t>(character), name.data());
}

[[nodiscard]] bool is_of(char32_t character, std::uint32_t categories) {
    return (U_GET_GC_MASK(static_cast<UChar32>(character)) & categories) != 0;
}

/// Why no font helps, and what does; empty where a font suffices.
[[nodiscard]] std::string obstacle_of(char32_t character) {
    const auto code = static_cast<UChar32>(character);
    const UScriptCode script = script_of(character);
    if (uscript_isRightToLeft(script) != 0) {
        return fmt::format(
            "the script {} is written from right to left, which the kiosk does not "
            "support yet",
            uscript_getName(script));
    }
    const bool plain =
        std::find(kPlainScripts.begin(), kPlainScripts.end(), script) != kPlainScripts.end();
    if (!plain && script != USCRIPT_UNKNOWN) {
        return fmt::format(
            "the kiosk does not support the script {} yet, whose letters may change or "
            "move beside each other",
            uscript_getName(script));
    }
    if (is_of(character, U_GC_CC_MASK | U_GC_ZL_MASK | U_GC_ZP_MASK | U_GC_CS_MASK)) {
        return character == U'\t' ? "" : "a control character is no text: take it out";
    }
    if (is_of(character, U_GC_CF_MASK)) {
        return "an invisible sign on how to set the text, which the kiosk does not follow: take it "
               "out";
    }
    if (is_of(character, U_GC_M_MASK)) {
        return "a mark that combines with the character before it, which the kiosk cannot place: "
               "write both as one character (Unicode's form NFC) where there is one, or leave the "
               "mark out";
    }
    const int syllable = u_getIntPropertyValue(code, UCHAR_HANGUL_SYLLABLE_TYPE);
    if (syllable == U_HST_LEADING_JAMO || syllable == U_HST_VOWEL_JAMO ||
        syllable == U_HST_TRAILING_JAMO) {
        return "a part of a syllable, which the kiosk cannot join: write whole syllables "
               "(Unicode's form NFC)";
    }
    if (character > kLast) {
        return "the kiosk cannot draw characters beyond U+FFFF (emoji, rare ideographs and signs) "
               "yet";
    }
    return "";
}

/// The Debian package whose fonts have the characters of a script.
[[nodiscard]] std::string package_for(char32_t character) {
    switch (script_of(character)) {
        case USCRIPT_HAN:
        case USCRIPT_HIRAGANA:
        case USCRIPT_KATAKANA:
        case USCRIPT_HANGUL:
        case USCRIPT_BOPOMOFO:
            return "fonts-noto-cjk";
        case USCRIPT_COMMON: {
            const int width =
                u_getIntPropertyValue(static_cast<UChar32>(character), UCHAR_EAST_ASIAN_WIDTH);
            const bool emoji = u_hasBinaryProperty(static_cast<UChar32>(character), UCHAR_EMOJI);
            if (!emoji && (width == U_EA_WIDE || width == U_EA_FULLWIDTH)) return "fonts-noto-cjk";
            return "fonts-noto-core or fonts-symbola";
        }
        default:
            return "fonts-noto-core";
    }
}

[[nodiscard]] std::string listed(const std::set<char32_t>& characters) {
    std::string names;
    std::size_t count = 0;
    for (const char32_t character : characters) {
        if (count == kNamed) {
            names += fmt::format(" and {} more", characters.size() - kNamed);
            break;
        }
        if (count++ > 0) names += ", ";
        names += name_of(character);
    }
    return names;
}

}  // namespace

std::vector<std::string> problems_of_text(const std::string& text) {
    std::map<std::string, std::set<char32_t>> obstacles;
    std::set<char32_t> settable;
    for (const char32_t character : window::characters_of({text})) {
        std::string obstacle = obstacle_of(character);
        if (obstacle.empty()) {
            settable.insert(character);
        } else {
            obstacles[std::move(obstacle)].insert(character);
        }
    }
    std::map<std::string, std::set<char32_t>> packages;
    for (const char32_t character : window::choose_fonts(settable).missing) {
        packages[package_for(character)].insert(character);
    }
    std::vector<std::string> problems;
    for (const auto& [obstacle, characters] : obstacles) {
        problems.push_back(fmt::format("cannot be shown: {}: {}", listed(characters), obstacle));
    }
    for (const auto& [package, characters] : packages) {
        problems.push_back(
            fmt::format("cannot be shown: {}: no font of this machine has {}; install {}",
                        listed(characters), characters.size() == 1 ? "it" : "them", package));
    }
    return problems;
}

std::vector<stimuli::StudyProblem> problems_of_texts(const std::vector<stimuli::ShownText>& texts) {
    std::vector<stimuli::StudyProblem> problems;
    for (const stimuli::ShownText& shown : texts) {
        for (const std::string& problem : problems_of_text(shown.text)) {
            problems.push_back({shown.line, fmt::format("study: {}: {}", shown.key, problem)});
        }
    }
    return problems;
}

}  // namespace obscura::app::kiosk
