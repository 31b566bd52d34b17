// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

namespace obscura::renderer::shaders {

/// The shader file of that path below renderer/; data() is null for no such file.
[[nodiscard]] std::string_view embedded(std::string_view name);
/// Every path.
[[nodiscard]] std::vector<std::string_view> embedded_names();

}  // namespace obscura::renderer::shaders
