// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/store/store.h"
#include "app/kiosk/journal.h"

namespace obscura::app::kiosk {

/// Commits one row, in one transaction. A row that an earlier try has already brought to the disk
/// is left as it is, so that a try can be repeated after an error whose outcome is unknown.
void commit(analysis::Store& store, const Row& row);

/// A journal that commits to that store, which must outlive it.
[[nodiscard]] Journal journal_to(analysis::Store& store);

}  // namespace obscura::app::kiosk
