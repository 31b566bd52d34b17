// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace obscura::analysis {

/// Whether a name comes first as people count: C2 before C10. Digits that stand together compare by
/// how many they are, then as they are; everything else by its bytes. No two different names are
/// equal in it.
[[nodiscard]] bool naturally_before(std::string_view one, std::string_view other);

}  // namespace obscura::analysis
