// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/text_entry.h"

#include <utf8.h>

#include <algorithm>

namespace obscura::app::kiosk {
namespace {

constexpr char32_t kLastCharacter = 0x10FFFF;

[[nodiscard]] bool is_printable(char32_t c) {
    const bool control = c < 0x20 || (c >= 0x7F && c < 0xA0);
    const bool surrogate = c >= 0xD800 && c < 0xE000;
    return !control && !surrogate && c <= kLastCharacter;
}

}  // namespace

std::string utf8_of(char32_t c) {
    std::string bytes;
    utf8::append(c, bytes);
    return bytes;
}

void TextEntry::type(char32_t character) {
    if (!is_printable(character)) return;
    const bool digit = character >= U'0' && character <= U'9';
    if (takes_ != Takes::kText && !digit) {
        note_ = Note::kOnlyDigits;
    } else if (text_.size() >= most_) {
        note_ = Note::kFull;
    } else {
        text_.insert(caret_, 1, character);
        ++caret_;
        note_ = Note::kNone;
    }
}

void TextEntry::erase_before() {
    if (caret_ == 0) return;
    text_.erase(--caret_, 1);
    note_ = Note::kNone;
}

void TextEntry::erase_after() {
    if (caret_ == text_.size()) return;
    text_.erase(caret_, 1);
    note_ = Note::kNone;
}

void TextEntry::move(int by) {
    const auto end = static_cast<std::ptrdiff_t>(text_.size());
    const std::ptrdiff_t to = static_cast<std::ptrdiff_t>(caret_) + by;
    caret_ = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(to, 0, end));
}

void TextEntry::move_to(std::size_t caret) { caret_ = std::min(caret, text_.size()); }

std::string TextEntry::utf8() const {
    std::string bytes;
    for (const char32_t character : text_) bytes += utf8_of(character);
    return bytes;
}

}  // namespace obscura::app::kiosk
