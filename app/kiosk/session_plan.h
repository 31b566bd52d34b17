// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "analysis/store/records.h"
#include "stimuli/manifest.h"
#include "stimuli/order/order.h"
#include "stimuli/questions.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// What a session runs on.
struct Machine {
    std::string software;
    std::string operating_system;
    std::string gpu_renderer;
    std::string display;      ///< monitor's name, resolution, refresh rate
    double refresh_hz = 0.0;  ///< 0: unknown
    std::string timing = {};  ///< SessionRecord::timing
};

/// An image file of the study's folder, with the hash that the manifest gives it.
struct StimulusImage {
    std::string file;  ///< relative to the folder
    std::string sha256;
};

/// All of a session that is known before it begins.
struct SessionPlan {
    std::string participant_id;
    std::string session_id;
    analysis::Kind kind = analysis::Kind::kParticipant;
    stimuli::SessionOrder order;
    Machine machine;
    std::string override_reason = {};                  ///< TrialRecord::override_reason
    std::vector<std::string> known_codes = {};         ///< of those who took part before
    stimuli::Questions questions = {};                 ///< that the study asks of each pair
    std::vector<std::array<StimulusImage, 2>> images;  ///< by condition index: A, B

    // All pairs in order of showing, from 0: practice first, whose conditions are the study's last.
    [[nodiscard]] int practice_count() const {
        return static_cast<int>(images.size() - order.conditions.size());
    }
    [[nodiscard]] int pair_count() const { return static_cast<int>(images.size()); }
    /// Index of a pair's condition.
    [[nodiscard]] std::size_t condition_of(int pair) const;
    /// Whether image B is the first of that pair; of practice every other one.
    [[nodiscard]] bool b_first(int pair) const;
};

/// A and B of every condition. Throws bad input naming the image that the manifest lacks.
[[nodiscard]] std::vector<std::array<StimulusImage, 2>> images_of(
    const stimuli::Study& study, const stimuli::Manifest& manifest);

/// SHA-256 over the hashes of all images in the study's order: changes when any image does.
[[nodiscard]] std::string digest_of(const std::vector<std::array<StimulusImage, 2>>& images);

/// Name of the event that remembers digest_of() when a session begins.
inline constexpr const char* kStimuliEvent = analysis::kStimuliDigestEvent;

/// The plan of an open session, to continue it. Throws bad input that says why this cannot be: the
/// study file, the order or an image is not what the session began with. `events` are those of the
/// store, `trials` those of the session.
[[nodiscard]] SessionPlan plan_to_resume(const stimuli::Study& study,
                                         const stimuli::Manifest& manifest,
                                         const analysis::SessionRecord& session,
                                         const std::vector<analysis::TrialRecord>& trials,
                                         const std::vector<analysis::EventRecord>& events);

}  // namespace obscura::app::kiosk
