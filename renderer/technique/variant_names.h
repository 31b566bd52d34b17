// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

/// A name for each choice, as short as tells those in the list apart: technique and samples
/// (TechniqueChoice::variant_name()), and behind it what differs where two would have one name:
/// `Blizzard8 R 0.2`, `Blizzard24 denoise none`. Of several settings that differ, the first that
/// parts them is named, in the order radius, other parameters, denoise, depth format; a further one
/// only for those that it does not part. Choices that make the same accessibility have the same
/// name, all others have different ones; the order of the list does not matter.
[[nodiscard]] std::vector<std::string> variant_names(const std::vector<TechniqueChoice>& choices);

}  // namespace obscura::renderer
