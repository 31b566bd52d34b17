// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace obscura::base {

/// How long work will take that has steps of several kinds, each kind with a duration of its own:
/// those to come are taken to last as long as the mean of their kind has.
class TimeLeft {
  public:
    /// How many steps there are of each kind.
    explicit TimeLeft(std::vector<std::size_t> counts);

    /// One more step of a kind is done, and took that long, in seconds.
    void done(std::size_t kind, double seconds);
    /// What a step of a kind is taken to last until one of it is done; 0 until said.
    void expect(std::size_t kind, double seconds) { kinds_.at(kind).expected_s = seconds; }
    /// That many steps to come of a kind need not be done.
    void leave_out(std::size_t kind, std::size_t steps);

    [[nodiscard]] std::size_t steps() const;  ///< of all kinds, done and to come
    [[nodiscard]] std::size_t steps_done() const;
    [[nodiscard]] double seconds() const;

  private:
    struct Kind {
        std::size_t count = 0;
        std::size_t done = 0;
        double spent_s = 0.0;
        double expected_s = 0.0;
    };
    std::vector<Kind> kinds_;
};

}  // namespace obscura::base
