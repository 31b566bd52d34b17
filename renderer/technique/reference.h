// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/reference/reference.h"
#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// What the technique `reference` asks of the ray tracer: its samples are rays. The choice must
/// have no problems.
[[nodiscard]] ReferenceOptions reference_options(const Variant& choice);

}  // namespace obscura::renderer
