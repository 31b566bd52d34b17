// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/statistics/possible.h"
#include "app/kiosk/choice_model.h"
#include "stimuli/study.h"

namespace obscura::app {

/// What is simulated to learn the power of a study's verdicts.
struct PowerRequest {
    std::vector<double> shares{.65};  ///< true shares of the preferred image, more than .5
    double sd = 1.0;                  ///< ChoiceModel's
    double order_bias = 0.5;
    double careless = 0.0;
    std::optional<int> participants;  ///< nothing: only how many are needed
    int studies = 1000;               ///< simulated for each number
    std::uint64_t seed = 20100501;
    double power = 0.8;       ///< that is asked for
    bool asks_needed = true;  ///< how many participants are needed, which takes longest
    bool quiet = false;
};

/// How often simulated studies came to a verdict.
struct Frequency {
    int participants = 0;
    int studies = 0;
    int reached = 0;

    [[nodiscard]] double share() const { return static_cast<double>(reached) / studies; }
    /// Standard error that the number of studies leaves.
    [[nodiscard]] double error() const;
};

/// One hypothesis, where something is true of it and of no other.
struct VerdictPower {
    std::string hypothesis;
    bool is_primary = true;
    std::string truth;    ///< `a share of 65 %`
    std::string verdict;  ///< `the preferred image is preferred`
    bool is_true =
        true;  ///< false: the verdict would be wrong, so that this is an error, not power
    std::optional<Frequency> at;  ///< of the participants asked for
    /// The whole blocks of participants from which on it is reached as often as asked; their
    /// frequency beside it. No value, with the reason, for an error and where too many are needed.
    analysis::Possible<Frequency> needed = analysis::Possible<Frequency>::none("not asked");
};

/// More participants than this are not tried.
inline constexpr int kMostSimulated = 2000;

/// For each hypothesis of the study, through the analysis that its answers would get: that its
/// preference (share against one half) or its interaction (share at the second level against one
/// half at the first) is found, that equality is found where nothing is preferred, and how often a
/// preference or difference is then found all the same.
[[nodiscard]] std::vector<VerdictPower> power_of_study(const stimuli::Study& study,
                                                       const PowerRequest& request);

}  // namespace obscura::app
