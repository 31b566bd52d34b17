// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace obscura::analysis {

/// What is wrong with a file, so that all of it is said at once: each problem once, with the line
/// where it was met first and the number of further lines; the first hundred in full. Control
/// characters of the file never reach a message.
class FileProblems {
  public:
    /// `file` stands for the file in messages and must outlive this.
    explicit FileProblems(const std::string& file) : file_(file) {}

    void add(int line, std::string_view what);
    [[nodiscard]] bool none() const { return problems_.empty(); }
    /// Throws bad input that lists what was added.
    void throw_if_any() const;

  private:
    struct Problem {
        int line = 0;
        std::string what;
        std::size_t more = 0;  ///< lines with the same
        int last_line = 0;
    };

    const std::string& file_;
    std::vector<Problem> problems_;
    std::unordered_map<std::string, std::size_t> places_;  ///< by what is wrong
    std::size_t left_off_ = 0;
};

/// Lines with something in common, for a note: how many, and the first of them.
class Lines {
  public:
    void add(int line) {
        constexpr std::size_t kShown = 5;
        if (++count_ <= kShown) first_.push_back(line);
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    /// "line 7" or "lines 4, 9, 12 and 31 more".
    [[nodiscard]] std::string words() const;

  private:
    std::size_t count_ = 0;
    std::vector<int> first_;
};

}  // namespace obscura::analysis
