// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "renderer/model/model.h"

namespace obscura::renderer {

/// What a format of Variant::ao_format may make of a value: it stores the nearest that it has, or
/// one beside that.
[[nodiscard]] Admitted as_stored(Admitted pixel, const std::string& format);

}  // namespace obscura::renderer
