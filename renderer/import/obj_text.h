// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace obscura::renderer::import_detail {

/// One statement of a Wavefront OBJ or MTL text: a line, with those that it goes on in.
struct ObjLine {
    std::string text;
    int number = 0;  ///< of its first line, from 1 on

    /// Words between blanks, up to a comment. A '#' begins one but within the numbers that
    /// Microsoft's library writes where there is none (-1.#IND, 1.#INF, 1.#QNAN).
    [[nodiscard]] std::vector<std::string_view> words() const;
    /// The first word in small letters, "" where there is none.
    [[nodiscard]] std::string key() const;
    /// All that follows the first word, without the blanks around it: names may hold blanks and
    /// '#'.
    [[nodiscard]] std::string_view rest() const;
};

/// Takes lines off a text, whether they end in LF, CR LF or CR. A line that ends in a backslash
/// goes on in the next one, unless it is a comment or gives a material's name, which may end in
/// one.
class ObjLines {
  public:
    /// A byte order mark at its beginning is passed over.
    explicit ObjLines(std::string_view text);
    /// The next one that holds a statement; false at the end.
    [[nodiscard]] bool next(ObjLine& line);

  private:
    [[nodiscard]] std::string_view take();

    std::string_view rest_;
    int taken_ = 0;
};

/// A finite number that is the whole word.
[[nodiscard]] bool parse_number(std::string_view word, double& value);

[[nodiscard]] std::string lower(std::string_view word);

/// Without blanks, tabs and CR at both ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// A name without what may be a comment after it: up to the first '#' behind a blank.
[[nodiscard]] std::string_view without_comment(std::string_view name);

/// A name without the quotes around it.
[[nodiscard]] std::string_view without_quotes(std::string_view name);

}  // namespace obscura::renderer::import_detail
