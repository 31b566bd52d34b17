// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace obscura::analysis {

/// What the dictionaries of several tables say alike: values with their meanings, and descriptions.
using Levels = std::vector<std::pair<std::string, std::string>>;

inline const Levels kYesNo{{"1", "yes"}, {"0", "no"}};
inline const Levels kSubjectKinds{
    {"participant", "a person took part"},
    {"simulated", "answers made by a simulated observer, not a person"}};
inline const Levels kTrialKinds{
    {"participant", "an answer of a person that counts"},
    {"practice", "a practice trial, never analysed"},
    {"catch", "an attention check, never a vote"},
    {"simulated", "an answer made by a simulated observer, not a person"}};
inline const Levels kStates{{"open", "running, or cut off"},
                            {"completed", "all conditions answered; only these are analysed"},
                            {"abandoned", "broken off"}};
inline const Levels kValidities{{"low", "constant ambient light only"},
                                {"moderate", "irradiance from an environment map"},
                                {"high", "irradiance and a directional light with shadows"}};
inline const Levels kSides{{"A", "variant A of the condition"},
                           {"B", "variant B of the condition"}};

inline constexpr const char* kUtc = "Time in UTC, ISO 8601";
inline constexpr const char* kSha256 = "SHA-256 of the image file, 64 hexadecimal digits";
inline constexpr const char* kSeed = "Seed of the study, from which the order was drawn";
inline constexpr const char* kSwapped =
    "Whether variant B was shown first in every pair of the session; where the study balances the "
    "sides within a session, in the pairs of every other condition only: first_shown of a trial "
    "says it";
inline constexpr const char* kSquare = "Number of the square that gave the order, from 0";
inline constexpr const char* kRow = "Row of that square, from 0";
inline constexpr const char* kExclusion =
    "The study file's rule on whom to leave out, as JSON: smallest share of catch trials answered "
    "as expected, of repeated pairs answered alike, smallest median response time in seconds; "
    "empty: no rule";
inline constexpr const char* kTiming =
    "How the session's times came about, as a JSON object: source (GLX_OML_sync_control, the "
    "display's own time of a swap, or glFinish after the swap), frame_ms (between two frames "
    "handed "
    "over one after the other, median), waits (swapping waits for the refresh) and self_test, the "
    "last one on that monitor and GPU or null; empty: not measured";
inline constexpr const char* kStudyPlan =
    "What the study file fixed before there were data, as JSON: the hypotheses with the conditions "
    "that they take; empty: nothing";
inline constexpr const char* kExpected =
    "Variant that an attentive observer picks; empty: no attention check";
inline constexpr const char* kRepeats =
    "Condition whose answer this one repeats, which is then no vote; empty: none";
inline constexpr const char* kVariant =
    "Technique and samples, with what differs where two would have one name, of variant ";

}  // namespace obscura::analysis
