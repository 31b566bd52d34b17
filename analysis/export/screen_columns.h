// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "analysis/export/tables.h"

namespace obscura::analysis {

/// Columns of the table of sessions with what the operator said of the monitor, and the degrees of
/// visual angle that follow from it.
[[nodiscard]] std::vector<ExportColumn<SessionRow>> screen_columns();

/// One of those, by its name; nothing: not known.
[[nodiscard]] std::optional<double> screen_fact(const SessionRecord& session, const char* name);

}  // namespace obscura::analysis
