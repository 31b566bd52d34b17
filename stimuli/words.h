// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace obscura::stimuli {

/// What stands for a name in braces: {pair}.
using WordValues = std::vector<std::pair<std::string_view, std::string>>;

/// The kiosk's own words in one language, by the keys of the catalogue (words/en.po).
class Words {
  public:
    using Texts = std::map<std::string, std::string, std::less<>>;

    /// Those of a language (BCP 47; a part that the catalogue does not tell apart is left out:
    /// de-AT is de); where it has none the English ones; `own` replaces any of them.
    explicit Words(const std::string& language = "en", const Texts& own = {});

    [[nodiscard]] const std::string& language() const { return language_; }
    /// Whether the language is written from right to left, and the pages therefore mirrored.
    [[nodiscard]] bool right_to_left() const { return right_to_left_; }

    /// Throws std::out_of_range for a key that is none.
    [[nodiscard]] const std::string& operator()(std::string_view key) const;
    /// With each {name} replaced by its value.
    [[nodiscard]] std::string operator()(std::string_view key, const WordValues& values) const;
    [[nodiscard]] const Texts& all() const { return texts_; }

  private:
    std::string language_;
    bool right_to_left_ = false;
    Texts texts_;
};

/// The languages of the catalogue, English first.
[[nodiscard]] const std::vector<std::string>& word_languages();

/// The keys that the catalogue lacks in a language, in order; all where it has no such language.
[[nodiscard]] std::vector<std::string> missing_words(const std::string& language);

/// The catalogue's texts of one of its languages; English where it lacks one.
[[nodiscard]] const Words::Texts& catalogue_words(const std::string& language);

/// Whether that is a language tag of BCP 47 whose language exists.
[[nodiscard]] bool is_language(const std::string& tag);

/// The names in braces of a text, sorted: {done} of {count} has count and done.
[[nodiscard]] std::vector<std::string> placeholders_of(std::string_view text);

/// One entry of a catalogue in gettext's PO form.
struct PoEntry {
    std::string context;  ///< msgctxt: the key
    std::string source;   ///< msgid: the English
    std::string text;     ///< msgstr; empty: not translated
};
/// The entries but the header. Plurals, obsolete and fuzzy entries are not taken. Throws failure
/// that names `name` and the line of what is no such entry.
[[nodiscard]] std::vector<PoEntry> parse_po(std::string_view text, std::string_view name);

}  // namespace obscura::stimuli
