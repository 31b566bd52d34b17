// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/export/source.h"

namespace obscura::analysis {

/// The table of participants with a column, form_ID, for each question that a study asked of them
/// itself; what they are comes from the rows.
[[nodiscard]] ExportTable<ParticipantRecord> participants_with_forms(ExportSource& source);

}  // namespace obscura::analysis
