// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/table/decode.h"

#include <iconv.h>
#include <utf8.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr const char* kRemedy = "save it as UTF-8, in a spreadsheet as \"CSV UTF-8\"";

struct Mark {
    std::string_view bytes;
    const char* encoding;
};
/// Byte order marks (Unicode 15, 23.8), the longer before those that begin like them.
constexpr std::array<Mark, 5> kMarks{{{"\xEF\xBB\xBF", "UTF-8"},
                                      {std::string_view("\xFF\xFE\0\0", 4), "UTF-32LE"},
                                      {std::string_view("\0\0\xFE\xFF", 4), "UTF-32BE"},
                                      {"\xFF\xFE", "UTF-16LE"},
                                      {"\xFE\xFF", "UTF-16BE"}}};

int line_of(std::string_view text, std::size_t place) {
    const std::string_view before = text.substr(0, place);
    const char end = before.find('\n') == std::string_view::npos ? '\r' : '\n';
    return 1 + static_cast<int>(std::count(before.begin(), before.end(), end));
}

/// Text without a mark whose every second byte is NUL, as Latin letters are in UTF-16.
const char* unmarked_utf16(std::string_view bytes) {
    constexpr std::size_t kLooked = 1000;
    const std::string_view head =
        bytes.substr(0, std::min(bytes.size(), kLooked) & ~std::size_t{1});
    std::array<std::size_t, 2> nuls{};
    for (std::size_t i = 0; i < head.size(); ++i) nuls.at(i % 2) += head[i] == '\0' ? 1 : 0;
    const std::size_t half = head.size() / 2;
    if (half == 0) return nullptr;
    if (nuls[0] == 0 && nuls[1] > half * 3 / 4) return "UTF-16LE";
    if (nuls[1] == 0 && nuls[0] > half * 3 / 4) return "UTF-16BE";
    return nullptr;
}

/// The bytes as UTF-8. Throws bad input at the first that have no meaning in that encoding.
std::string converted(std::string_view bytes, const char* encoding, const std::string& name) {
    const iconv_t converter = ::iconv_open("UTF-8", encoding);
    if (converter == reinterpret_cast<iconv_t>(-1)) {  // NOLINT: that is how iconv says it
        throw base::bad_input("{}:1: the text is {}, which this system cannot convert: {}", name,
                              encoding, kRemedy);
    }
    std::string text(bytes.size() * 3 + 4, '\0');  // a letter of two bytes becomes one of three
    char* from = const_cast<char*>(bytes.data());  // NOLINT: iconv does not write there
    char* to = text.data();
    std::size_t left = bytes.size();
    std::size_t room = text.size();
    const bool failed =
        ::iconv(converter, &from, &left, &to, &room) == static_cast<std::size_t>(-1);
    ::iconv_close(converter);
    text.resize(text.size() - room);
    if (failed) {
        throw base::bad_input("{}:{}: the text is taken for {}, but has bytes that are none: {}",
                              name, line_of(text, text.size()), encoding, kRemedy);
    }
    return text;
}

void refuse_nul(std::string_view text, const std::string& name) {
    const std::size_t nul = text.find('\0');
    if (nul == std::string_view::npos) return;
    throw base::bad_input("{}:{}: there is a NUL byte, which no text has", name,
                          line_of(text, nul));
}

/// Whether letters of several bytes are among them, as damaged UTF-8 has and Windows-1252 has not.
bool has_letters_of_utf8(std::string_view bytes) {
    while (!bytes.empty()) {
        const auto wrong = utf8::find_invalid(bytes.begin(), bytes.end());
        if (std::any_of(bytes.begin(), wrong,
                        [](char byte) { return static_cast<unsigned char>(byte) >= 0x80U; })) {
            return true;
        }
        bytes.remove_prefix(static_cast<std::size_t>(wrong - bytes.begin()) +
                            (wrong == bytes.end() ? 0 : 1));
    }
    return false;
}

/// Bytes that are no UTF-8: Windows-1252 where nothing speaks against it.
DecodedText from_one_byte_letters(std::string_view bytes, std::size_t wrong, bool marked,
                                  const std::string& name) {
    const bool was_utf8 = marked || has_letters_of_utf8(bytes);
    const bool old_macintosh =
        bytes.find('\n') == std::string_view::npos && bytes.find('\r') != std::string_view::npos;
    if (was_utf8 || old_macintosh) {
        throw base::bad_input("{}:{}: the text is not UTF-8{}: {}", name, line_of(bytes, wrong),
                              was_utf8 ? ", though other letters of it are"
                                       : ", and by its line ends perhaps Mac Roman",
                              kRemedy);
    }
    return {converted(bytes, "WINDOWS-1252", name), "Windows-1252 (Latin-1)"};
}

}  // namespace

DecodedText decode(std::string bytes, const std::string& name) {
    bool marked = false;
    for (const Mark& mark : kMarks) {
        if (!bytes.starts_with(mark.bytes)) continue;
        bytes.erase(0, mark.bytes.size());
        marked = std::string_view(mark.encoding) == "UTF-8";
        if (marked) break;
        DecodedText decoded{converted(bytes, mark.encoding, name), mark.encoding};
        refuse_nul(decoded.text, name);
        return decoded;
    }
    if (bytes.find('\0') != std::string::npos) {
        const char* encoding = unmarked_utf16(bytes);
        if (encoding == nullptr) refuse_nul(bytes, name);
        DecodedText decoded{converted(bytes, encoding, name), encoding};
        refuse_nul(decoded.text, name);
        return decoded;
    }
    const auto wrong = utf8::find_invalid(bytes.begin(), bytes.end());
    if (wrong == bytes.end()) return {std::move(bytes), ""};
    return from_one_byte_letters(bytes, static_cast<std::size_t>(wrong - bytes.begin()), marked,
                                 name);
}

}  // namespace obscura::analysis
