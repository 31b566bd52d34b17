// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace obscura::renderer::import_detail {

/// What an import left out or replaced: a sentence and the things it is true of, in the order met.
class Notes {
  public:
    /// `what` is a sentence without end, `thing` a name; the same thing counts once in a row.
    void add(const std::string& what, const std::string& thing = {});

    /// One line each: `what: thing, thing and 7 more`.
    [[nodiscard]] std::vector<std::string> lines() const;

  private:
    struct Note {
        std::string what;
        std::vector<std::string> things;  ///< the first few
        std::size_t count = 0;
    };
    std::vector<Note> notes_;
};

}  // namespace obscura::renderer::import_detail
