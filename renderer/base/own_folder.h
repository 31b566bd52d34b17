// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace obscura::base {

/// What a command writes never lies among somebody's other files: throws bad input naming `option`
/// and the first file of the folder (not of those below it) that `is_own` does not take for one of
/// that command's. A folder that is not there yet is nobody's.
void require_own_folder(const std::filesystem::path& folder, std::string_view option,
                        const std::function<bool(const std::string& name)>& is_own);

}  // namespace obscura::base
