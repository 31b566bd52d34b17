// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "analysis/store/store.h"
#include "app/kiosk/journal.h"
#include "app/kiosk/spool.h"

namespace obscura::app::kiosk {

/// Commits one row, in one transaction. A row that an earlier try has already brought to the disk
/// is left as it is, so that a try can be repeated after an error whose outcome is unknown.
void commit(analysis::Store& store, const Row& row);

/// A journal that commits to that store, which must outlive it.
[[nodiscard]] Journal journal_to(analysis::Store& store);

/// The same for the rows of `procedure`, where others may begin sessions in the store meanwhile: a
/// session whose slot another one has taken since it was planned begins with the next free slot,
/// and the procedure goes on with the order of that. All must outlive the journal.
[[nodiscard]] Journal journal_to(analysis::Store& store, const stimuli::Study& study,
                                 Procedure& procedure);

/// The same for a store on a server, whose rows `spool` keeps while that is away. A session begins
/// only while it is there, since its place in the order comes from there.
[[nodiscard]] Journal journal_to(analysis::Store& store, const stimuli::Study& study,
                                 Procedure& procedure, Spool& spool);

}  // namespace obscura::app::kiosk
