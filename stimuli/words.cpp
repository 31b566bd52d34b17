// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/words.h"

#include <unicode/uloc.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>

#include "renderer/base/error.h"
#include "stimuli/embedded.h"

namespace obscura::stimuli {
namespace {

constexpr std::string_view kFolder = "words/";
constexpr std::string_view kEnglish = "en";

/// What the catalogue has of one language.
struct WordLanguage {
    Words::Texts texts;
    std::vector<std::string> missing;
};

[[nodiscard]] WordLanguage load_language(const std::string& language) {
    const std::string file = fmt::format("{}{}.po", kFolder, language);
    WordLanguage loaded;
    for (const PoEntry& entry : parse_po(embedded(file), file)) {
        if (entry.text.empty()) loaded.missing.push_back(entry.context);
        loaded.texts[entry.context] = entry.text.empty() ? entry.source : entry.text;
    }
    return loaded;
}

[[nodiscard]] const std::map<std::string, WordLanguage>& catalogue() {
    static const auto loaded = [] {
        std::map<std::string, WordLanguage> languages;
        for (const std::string& language : word_languages()) {
            languages[language] = load_language(language);
        }
        // What a language's file does not even name.
        const WordLanguage& english = languages.at(std::string(kEnglish));
        for (auto& [language, words] : languages) {
            for (const auto& [key, text] : english.texts) {
                if (words.texts.emplace(key, text).second) words.missing.push_back(key);
            }
            std::sort(words.missing.begin(), words.missing.end());
        }
        return languages;
    }();
    return loaded;
}

/// The language of a tag as the catalogue calls it: pt-BR is pt.
[[nodiscard]] std::string primary_language(const std::string& tag) {
    return tag.substr(0, tag.find('-'));
}

/// The tag as ICU writes it: de_AT.
[[nodiscard]] std::string locale_of(const std::string& tag) {
    std::array<char, ULOC_FULLNAME_CAPACITY> locale{};
    std::int32_t used = 0;
    UErrorCode error = U_ZERO_ERROR;
    uloc_forLanguageTag(tag.c_str(), locale.data(), static_cast<int>(locale.size()), &used, &error);
    if (U_FAILURE(error) || used != static_cast<std::int32_t>(tag.size())) return "";
    return locale.data();
}

/// Around each value: nothing, or what keeps a time or a file's name in its own order within a text
/// from the right (UAX #9: first strong isolate, pop directional isolate).
struct WordBounds {
    std::string_view before;
    std::string_view after;
};
constexpr WordBounds kIsolating{"\u2068", "\u2069"};

[[nodiscard]] std::string filled(std::string_view text, const WordValues& values,
                                 const WordBounds& bounds) {
    std::string result;
    while (!text.empty()) {
        const auto open = text.find('{');
        result += text.substr(0, open);
        if (open == std::string_view::npos) break;
        text.remove_prefix(open);
        const auto value = std::find_if(values.begin(), values.end(), [&](const auto& pair) {
            return text.substr(1).starts_with(pair.first) &&
                   text.substr(1 + pair.first.size()).starts_with('}');
        });
        const bool known = value != values.end();
        if (known) {
            result.append(bounds.before).append(value->second).append(bounds.after);
        } else {
            result += '{';
        }
        text.remove_prefix(known ? value->first.size() + 2 : 1);
    }
    return result;
}

}  // namespace

Words::Words(const std::string& language, const Texts& own)
    : language_(language),
      right_to_left_(uloc_isRightToLeft(locale_of(language).c_str()) != 0),
      texts_(catalogue_words(language)) {
    for (const auto& [key, text] : own) texts_.at(key) = text;
}

const std::string& Words::operator()(std::string_view key) const {
    const auto found = texts_.find(key);
    if (found == texts_.end()) throw std::out_of_range("no word " + std::string(key));
    return found->second;
}

std::string Words::operator()(std::string_view key, const WordValues& values) const {
    return filled((*this)(key), values, right_to_left_ ? kIsolating : WordBounds{});
}

const std::vector<std::string>& word_languages() {
    static const auto languages = [] {
        std::vector<std::string> found{std::string(kEnglish)};
        for (const std::string_view name : embedded_names()) {
            if (!name.starts_with(kFolder)) continue;
            std::string language = std::filesystem::path(name).stem().string();
            if (language != kEnglish) found.push_back(std::move(language));
        }
        return found;
    }();
    return languages;
}

std::vector<std::string> missing_words(const std::string& language) {
    const auto found = catalogue().find(primary_language(language));
    if (found != catalogue().end()) return found->second.missing;
    std::vector<std::string> keys;
    for (const auto& [key, text] : catalogue_words(std::string(kEnglish))) keys.push_back(key);
    return keys;
}

const Words::Texts& catalogue_words(const std::string& language) {
    const auto found = catalogue().find(primary_language(language));
    return found != catalogue().end() ? found->second.texts
                                      : catalogue().at(std::string(kEnglish)).texts;
}

bool is_language(const std::string& tag) {
    const std::string locale = locale_of(tag);
    return !locale.empty() && std::string_view(uloc_getISO3Language(locale.c_str())) != "";
}

std::vector<std::string> placeholders_of(std::string_view text) {
    std::vector<std::string> names;
    for (auto open = text.find('{'); open != std::string_view::npos;
         open = text.find('{', open + 1)) {
        const auto close = text.find('}', open);
        if (close == std::string_view::npos) break;
        names.emplace_back(text.substr(open + 1, close - open - 1));
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

}  // namespace obscura::stimuli
