// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/text_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unicode/uchar.h>
#include <unicode/uscript.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "app/kiosk/typesetter.h"
#include "app/window/font_files.h"

namespace obscura::app::kiosk {
namespace {

constexpr std::size_t kNamed = 6;  // characters that a sentence names

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

/// What is no text on a page, whatever the fonts.
[[nodiscard]] bool is_control(char32_t character) {
    const bool layout = character == U'\t' || character == U'\n' || character == U'\r';
    return !layout && (U_GET_GC_MASK(static_cast<UChar32>(character)) & U_GC_CC_MASK) != 0;
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
            if (emoji) return "fonts-noto-color-emoji";
            if (width == U_EA_WIDE || width == U_EA_FULLWIDTH) return "fonts-noto-cjk";
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

[[nodiscard]] std::vector<std::string> problems_with(Typesetter& typesetter,
                                                     const std::string& text) {
    std::set<char32_t> control;
    for (const char32_t character : window::characters_of({text})) {
        if (is_control(character)) control.insert(character);
    }
    std::map<std::string, std::set<char32_t>> packages;
    for (const char32_t character : typesetter.characters_without_glyph(text)) {
        if (!control.contains(character)) packages[package_for(character)].insert(character);
    }
    std::vector<std::string> problems;
    if (!control.empty()) {
        problems.push_back(fmt::format(
            "cannot be shown: {}: a control character is no text: take it out", listed(control)));
    }
    for (const auto& [package, characters] : packages) {
        problems.push_back(
            fmt::format("cannot be shown: {}: no font of this machine has {}; install {}",
                        listed(characters), characters.size() == 1 ? "it" : "them", package));
    }
    return problems;
}

[[nodiscard]] bool is_from_the_right(const std::string& language) {
    return stimuli::Words(language).right_to_left();
}

}  // namespace

std::vector<std::string> problems_of_text(const std::string& text, const std::string& language) {
    Typesetter typesetter(language, is_from_the_right(language), Typesetter::Draws::kNothing);
    return problems_with(typesetter, text);
}

std::vector<stimuli::StudyProblem> problems_of_texts(const stimuli::Study& study) {
    const std::string& language = study.words.language();
    Typesetter typesetter(language, study.words.right_to_left(), Typesetter::Draws::kNothing);
    std::vector<stimuli::StudyProblem> problems;
    for (const stimuli::ShownText& shown : study.shown_texts) {
        for (const std::string& problem : problems_with(typesetter, shown.text)) {
            problems.push_back({shown.line, fmt::format("{}: {}", shown.key, problem)});
        }
    }
    std::string all_words;
    const auto& catalogue = stimuli::catalogue_words(language);
    for (const auto& [key, text] : study.words.all()) {
        if (text == catalogue.at(key)) all_words += text + '\n';
    }
    for (const std::string& problem : problems_with(typesetter, all_words)) {
        problems.push_back(
            {0, fmt::format("the kiosk's own words in the language {}: {}", language, problem)});
    }
    return problems;
}

std::string note_on_words(const stimuli::Study& study) {
    const std::string& language = study.words.language();
    std::vector<std::string> english;
    for (const std::string& key : stimuli::missing_words(language)) {
        if (study.words(key) == stimuli::catalogue_words("en").at(key)) english.push_back(key);
    }
    if (english.empty()) return "";
    return fmt::format(
        "the kiosk's own words are English where the language {} lacks them; [texts] can say "
        "them: {}",
        language, fmt::join(english, ", "));
}

}  // namespace obscura::app::kiosk
