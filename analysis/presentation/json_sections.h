// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/conclusions/analysis.h"
#include "analysis/presentation/json_values.h"

namespace obscura::analysis {

/// Participants beyond this are not listed one by one in a report.
inline constexpr std::size_t kMostListed = 1000;

/// `verdict`, `verdict_sentence`, `verdict_p` and `verdict_p_holm` of a hypothesis.
void put_verdict(Json& hypothesis, const Verdict& verdict);
/// Each puts its part under a name of its own, or null and the reason.
void put_registration(Json& report, const Possible<RegistrationResult>& registration);
void put_look(Json& report, const Possible<LookResult>& look);
void put_power(Json& report, const Possible<RunPower>& power);
void put_attention(Json& report, const Possible<Attention>& attention);
void put_response_times(Json& report, const Analysis& analysis);
void put_learning(Json& report, const Possible<Learning>& learning);
void put_exclusions(Json& report, const Possible<Exclusions>& exclusions);

void put_scale(Json& object, const VariantScale& scale);
void put_model(Json& object, const Possible<ModelCheck>& model);

}  // namespace obscura::analysis
