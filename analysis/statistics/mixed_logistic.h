// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "analysis/statistics/possible.h"

namespace obscura::analysis {

/// Answers of one participant with the same predictors.
struct MixedAnswers {
    std::vector<std::pair<std::size_t, double>> x;  ///< the predictors that are not 0, by number
    Votes votes;
};

/// Participants who answered alike.
struct MixedParticipants {
    std::vector<MixedAnswers> answers;
    std::int64_t participants = 1;
};

/// Logistic regression with an intercept for each participant, drawn from a normal distribution:
/// logit P(B) = x . coefficients + sd u, u of mean 0 and variance 1.
struct MixedLogistic {
    std::vector<double> coefficients;
    /// Of the coefficients, from the Hessian of the log likelihood with the standard deviation in
    /// it; row after row.
    std::vector<double> covariance;
    double sd = 0.0;              ///< of the participants, log odds; 0 where they do not differ
    double log_likelihood = 0.0;  ///< with the binomial coefficients
};

inline constexpr int kMixedNodes = 15;

/// The largest number of predictors.
inline constexpr std::size_t kMostPredictors = 60;

/// Maximum likelihood (N. E. Breslow and D. G. Clayton 1993 for the model), each participant
/// integrated by adaptive Gauss-Hermite quadrature with kMixedNodes nodes (Q. Liu and D. A. Pierce
/// 1994; J. C. Pinheiro and D. M. Bates 1995), by Newton's method with the derivatives of T. A.
/// Louis 1982. No value, with the reason, without answers, where predictors cannot be told apart,
/// and where the votes are separated, so that no finite coefficient is likeliest. Throws bad input
/// for votes outside 0 to kMaxCount, predictors that are not finite, and more than kMostPredictors
/// of them.
[[nodiscard]] Possible<MixedLogistic> mixed_logistic(const std::vector<MixedParticipants>& data,
                                                     std::size_t predictors);

/// The log likelihood at these coefficients with so many nodes (1 or more; 1 is Laplace's
/// approximation).
[[nodiscard]] double mixed_log_likelihood(const std::vector<MixedParticipants>& data,
                                          const std::vector<double>& coefficients, double sd,
                                          int nodes = kMixedNodes);

}  // namespace obscura::analysis
