// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>

namespace obscura::app::kiosk {

/// One line of text as it is being typed: any character of Unicode, kept as it came.
class TextEntry {
  public:
    enum class Takes { kText, kDigits, kHiddenDigits };
    /// What was not taken of what was typed last.
    enum class Note { kNone, kOnlyDigits, kFull };

    /// At most `most` characters (code points).
    explicit TextEntry(std::size_t most, Takes takes = Takes::kText) : most_(most), takes_(takes) {}

    /// Puts a character at the caret. What cannot be taken is left out, and note() says so until
    /// the text changes: one too many, no digit where digits are wanted. Control characters and
    /// what is no character of Unicode are left out without a word.
    void type(char32_t character);
    void erase_before();
    void erase_after();
    /// By so many characters, within the text.
    void move(int by);
    void move_to(std::size_t caret);

    [[nodiscard]] const std::u32string& text() const { return text_; }
    [[nodiscard]] std::string utf8() const;
    /// Characters before it.
    [[nodiscard]] std::size_t caret() const { return caret_; }
    [[nodiscard]] Note note() const { return note_; }
    [[nodiscard]] std::size_t most() const { return most_; }
    /// Whether nobody is to read it.
    [[nodiscard]] bool hidden() const { return takes_ == Takes::kHiddenDigits; }

  private:
    std::size_t most_;
    Takes takes_;
    std::u32string text_;
    std::size_t caret_ = 0;
    Note note_ = Note::kNone;
};

/// One character in UTF-8.
[[nodiscard]] std::string utf8_of(char32_t character);

}  // namespace obscura::app::kiosk
