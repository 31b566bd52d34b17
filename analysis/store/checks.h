// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/store/records.h"

namespace obscura::analysis {

/// Throw bad input naming the record, the field, the value and what is allowed. They say in words
/// what the schema's constraints enforce; the constraints stay the last word.
void check(const ParticipantRecord& participant);
void check(const SessionRecord& session);
void check(const TrialRecord& trial);
void check(const EventRecord& event);

/// A time as records carry it: ISO 8601 in UTC, 2010-05-01T12:00:00Z, with or without a fraction.
void check_utc(const std::string& where, const char* name, const std::string& value);

}  // namespace obscura::analysis
