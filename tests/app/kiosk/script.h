// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "app/kiosk/procedure.h"
#include "tests/app/kiosk/small_study.h"

namespace obscura::app::kiosk {

/// A procedure with a script: every call happens at the time given.
class Script {
  public:
    explicit Script(const stimuli::Study& study, bool swapped = false)
        : procedure(study, small_plan(study, swapped)) {}
    Script(const stimuli::Study& study, SessionPlan plan) : procedure(study, std::move(plan)) {}

    void at(double time_s, const Event& event) {
        for (Row& row : procedure.step(event, {time_s, fmt::format("t{}", time_s)})) {
            rows.push_back(std::move(row));
        }
    }
    void shown_at(double time_s) { at(time_s, ScreenPresented{}); }

    /// From the start to the page of pairs, visible at 10 s; the session begins at 4 s.
    void reach_pairs() {
        shown_at(0);
        at(1, StartPressed{});
        shown_at(2);
        at(4, FormSubmitted{filled_form()});
        shown_at(5);
        at(9, InstructionsRead{});
        shown_at(10);
    }

    /// One pair from time `t`: first image from t+1 for 3 s, second from t+6.02 for 4 s, question
    /// from t+11 for 1.5 s; then the next screen at t+13.
    void answer_pair(double t, int pair, bool first) {
        at(t, PairPressed{pair});
        shown_at(t + 1);
        at(t + 4, SpacePressed{});
        shown_at(t + 4.01);
        at(t + 6.01, Tick{t + 6.01});
        shown_at(t + 6.02);
        at(t + 10.02, SpacePressed{});
        shown_at(t + 11);
        at(t + 12.5, Answered{first});
        shown_at(t + 13);
    }

    static Form filled_form() {
        return {.age_years = 30,
                .gender = "female",
                .normal_vision = true,
                .naive = std::nullopt,
                .consent = true};
    }

    template <typename T>
    [[nodiscard]] std::vector<T> rows_of() const {
        std::vector<T> found;
        for (const Row& row : rows) {
            if (const T* match = std::get_if<T>(&row)) found.push_back(*match);
        }
        return found;
    }

    Procedure procedure;
    std::vector<Row> rows;
};

}  // namespace obscura::app::kiosk
