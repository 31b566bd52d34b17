// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "app/kiosk/session_plan.h"
#include "stimuli/manifest.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// A study of `count` conditions C1, C2, ..., made by hand.
inline stimuli::Study small_study(int count, int grey_ms = 2000) {
    stimuli::Study study;
    study.name = "small";
    study.title = "A small study";
    study.question = "Which image looked the most realistic?";
    study.instructions = "Look at both images.";
    study.presentation.grey_ms = grey_ms;
    study.seed = 5;
    study.sha256 = std::string(64, '5');
    study.scenes.push_back({"court", "atrium", "nave", stimuli::Validity::kHigh});
    for (int i = 1; i <= count; ++i) {
        stimuli::Condition condition;
        condition.id = fmt::format("C{}", i);
        condition.scene = "court";
        condition.hypothesis = "H1";
        condition.a.technique = "none";
        condition.b.technique = "crytek";
        condition.b.samples = 8 * i;
        study.conditions.push_back(condition);
    }
    return study;
}

/// A manifest of that study, whose hashes name their image: 'a1' repeated for C1's A.
inline stimuli::Manifest small_manifest(const stimuli::Study& study) {
    stimuli::Manifest manifest;
    manifest.study = study.name;
    manifest.seed = study.seed;
    int number = 0;
    for (const stimuli::Condition& condition : study.conditions) {
        ++number;
        for (const char* side : {"a", "b"}) {
            stimuli::ManifestImage image;
            image.file = condition.id + "-" + side + ".png";
            image.condition = condition.id;
            image.side = side;
            for (int i = 0; i < 32; ++i) image.sha256 += fmt::format("{}{}", side, number % 10);
            manifest.images.push_back(image);
        }
    }
    return manifest;
}

inline SessionPlan small_plan(const stimuli::Study& study, bool swapped = false) {
    SessionPlan plan;
    plan.participant_id = "p-1";
    plan.session_id = "s-1";
    plan.order.slot = 3;
    plan.order.latin_square = 0;
    plan.order.latin_row = 3;
    plan.order.swapped = swapped;
    for (int i = study.pair_count() - 1; i >= 0; --i) {
        plan.order.conditions.push_back(i);
    }
    plan.machine = {"obscura 1", "an operating system", "a renderer", "a display", 60.0};
    plan.images = images_of(study, small_manifest(study));
    return plan;
}

}  // namespace obscura::app::kiosk
