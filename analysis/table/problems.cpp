// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/table/problems.h"

#include <fmt/ranges.h>

#include "analysis/text/text.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

constexpr std::size_t kProblemsShown = 100;
constexpr std::size_t kLongestProblem = 2000;  // bytes of one problem

}  // namespace

void FileProblems::add(int line, std::string_view what) {
    std::string shown = printable(what, kLongestProblem);
    if (const auto known = places_.find(shown); known != places_.end()) {
        Problem& problem = problems_[known->second];
        if (line != problem.line) ++problem.more;
        problem.last_line = line;
    } else if (problems_.size() == kProblemsShown) {
        ++left_off_;
    } else {
        places_.emplace(shown, problems_.size());
        problems_.push_back({line, std::move(shown), 0, line});
    }
}

void FileProblems::throw_if_any() const {
    if (none()) return;
    std::string text;
    for (const Problem& problem : problems_) {
        if (!text.empty()) text += '\n';
        text += fmt::format("{}:{}: {}", file_, problem.line, problem.what);
        if (problem.more == 0) continue;
        text += problem.more == 1 ? fmt::format(" (line {} too)", problem.last_line)
                                  : fmt::format(" ({} lines more, the last is {})", problem.more,
                                                problem.last_line);
    }
    if (left_off_ > 0) text += fmt::format("\n{}: and {} more like these", file_, left_off_);
    throw base::bad_input("{}", text);
}

std::string Lines::words() const {
    std::string text = fmt::format("line{} {}", count_ == 1 ? "" : "s", fmt::join(first_, ", "));
    if (count_ > first_.size()) text += fmt::format(" and {} more", count_ - first_.size());
    return text;
}

}  // namespace obscura::analysis
