// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "renderer/technique/variant.h"

namespace obscura::renderer {

/// Sets an option of every variant to a word, or a parameter to a number, by `KEY=VALUE`. Whether
/// the variant may have it is for problems_of. False for what is neither.
[[nodiscard]] bool set(Variant& variant, const std::string& setting);

}  // namespace obscura::renderer
