// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "stimuli/presentation.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {

/// The keys of [study] that say how pairs are shown and answered; notes those that contradict each
/// other or have no effect beside another.
void read_presentation(TableReader& reader, Presentation& presentation);

}  // namespace obscura::stimuli
