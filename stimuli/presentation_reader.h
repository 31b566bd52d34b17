// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "stimuli/presentation.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {

/// Whether a study file may call a key so: a name of kAdvanceKeys, a lower-case letter or a digit.
[[nodiscard]] bool is_key_name(const std::string& name);

/// The keys of [study] that say how pairs are shown and answered; notes those that contradict each
/// other or have no effect beside another.
void read_presentation(TableReader& reader, Presentation& presentation);

}  // namespace obscura::stimuli
