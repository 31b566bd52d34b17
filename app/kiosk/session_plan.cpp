// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/session_plan.h"

#include <algorithm>

#include "renderer/base/error.h"
#include "renderer/base/hash.h"

namespace obscura::app::kiosk {
namespace {

[[nodiscard]] StimulusImage image_of(const stimuli::Manifest& manifest,
                                     const std::string& condition, const std::string& side) {
    const stimuli::ManifestImage* image = manifest.find(condition, side);
    if (image == nullptr) {
        throw base::bad_input("the manifest of {} has no image {} of condition {}", manifest.study,
                              side, condition);
    }
    return {image->file, image->sha256};
}

void require_same_images(const SessionPlan& plan, const std::vector<analysis::TrialRecord>& trials,
                         const std::vector<analysis::EventRecord>& events) {
    for (int i = 0; i < static_cast<int>(trials.size()) && i < plan.pair_count(); ++i) {
        const auto& pair = plan.images.at(plan.condition_of(i));
        const std::size_t first = plan.b_first(i) ? 1 : 0;
        const analysis::TrialRecord& trial = trials[static_cast<std::size_t>(i)];
        if (trial.first_sha256 != pair[first].sha256 ||
            trial.second_sha256 != pair[1 - first].sha256) {
            throw base::bad_input("the images {} and {} are not those that session {} showed",
                                  pair[0].file, pair[1].file, plan.session_id);
        }
    }
    const auto noted = std::find_if(events.begin(), events.end(), [&](const auto& event) {
        return event.session_id == plan.session_id && event.name == kStimuliEvent;
    });
    if (noted != events.end() && noted->detail != digest_of(plan.images)) {
        throw base::bad_input("the study's images have changed since session {} began",
                              plan.session_id);
    }
}

}  // namespace

std::size_t SessionPlan::condition_of(int pair) const {
    if (pair < practice_count()) return order.conditions.size() + static_cast<std::size_t>(pair);
    return static_cast<std::size_t>(
        order.conditions.at(static_cast<std::size_t>(pair - practice_count())));
}

bool SessionPlan::b_first(int pair) const {
    if (pair < practice_count()) return (pair % 2 != 0) != order.swapped;
    return order.b_first(static_cast<std::size_t>(pair - practice_count()));
}

std::vector<std::array<StimulusImage, 2>> images_of(const stimuli::Study& study,
                                                    const stimuli::Manifest& manifest) {
    std::vector<std::array<StimulusImage, 2>> images;
    for (const stimuli::Condition& condition : study.conditions) {
        images.push_back({image_of(manifest, condition.id, "a"),  //
                          image_of(manifest, condition.id, "b")});
    }
    return images;
}

std::string digest_of(const std::vector<std::array<StimulusImage, 2>>& images) {
    std::string hashes;
    for (const auto& pair : images) hashes += pair[0].sha256 + pair[1].sha256;
    return base::sha256_hex(hashes);
}

SessionPlan plan_to_resume(const stimuli::Study& study, const stimuli::Manifest& manifest,
                           const analysis::SessionRecord& session,
                           const std::vector<analysis::TrialRecord>& trials,
                           const std::vector<analysis::EventRecord>& events) {
    if (session.study_sha256 != study.sha256) {
        throw base::bad_input("the study file {} has changed since session {} began", study.name,
                              session.session_id);
    }
    SessionPlan plan;
    plan.participant_id = session.participant_id;
    plan.session_id = session.session_id;
    plan.kind = session.kind;
    plan.order = study.session_order(session.slot);
    if (plan.order.latin_square != session.latin_square ||
        plan.order.latin_row != session.latin_row || plan.order.swapped != session.swapped) {
        throw base::bad_input(
            "session {} saw row {} of square {}; this program would show row {} of square {}",
            session.session_id, session.latin_row, session.latin_square, plan.order.latin_row,
            plan.order.latin_square);
    }
    plan.images = images_of(study, manifest);
    plan.machine = {session.software, session.operating_system, session.gpu_renderer,
                    session.display,  session.refresh_hz,       session.timing};
    require_same_images(plan, trials, events);
    return plan;
}

}  // namespace obscura::app::kiosk
