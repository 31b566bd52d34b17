// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "stimuli/questions.h"
#include "tests/app/kiosk/small_study.h"

namespace obscura::app::kiosk {

/// A choice, how sure it is, and a rating of each image.
inline stimuli::Questions asking_questions() {
    using stimuli::QuestionKind;
    return {
        {{"real", QuestionKind::kChoice, "Which image looked more real?"},
         {"sure", QuestionKind::kConfidence, "How sure are you?", {"not sure", "very"}, {}, 1, 5},
         {"like",
          QuestionKind::kRating,
          "How real did it look?",
          {"not at all", "wholly"},
          {},
          1,
          7,
          true}}};
}

/// small_plan() with these questions.
inline SessionPlan asking_plan(const stimuli::Study& study, bool swapped = false) {
    SessionPlan plan = small_plan(study, swapped);
    plan.questions = asking_questions();
    return plan;
}

}  // namespace obscura::app::kiosk
