// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/own_folder.h"

#include <set>

#include "renderer/base/error.h"

namespace obscura::base {

void require_own_folder(const std::filesystem::path& folder, std::string_view option,
                        const std::function<bool(const std::string& name)>& is_own) {
    std::error_code error;
    std::set<std::string> others;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        std::error_code ignored;
        if (entry.is_regular_file(ignored) && !name.starts_with(".") && !is_own(name)) {
            others.insert(name);
        }
    }
    if (others.empty()) return;
    throw bad_input("{}: {} holds other files ({}{}); name a new folder or an empty one", option,
                    folder.string(), *others.begin(), others.size() > 1 ? ", ..." : "");
}

}  // namespace obscura::base
