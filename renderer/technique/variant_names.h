// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "renderer/technique/variant.h"

namespace obscura::renderer {

/// A name for each variant, as short as tells those in the list apart: technique and samples
/// (Variant::variant_name()), and behind it what differs where two would have one name:
/// `Blizzard8 R 0.2`, `Blizzard24 denoise none`. Of several settings that differ, the first that
/// parts them is named, in the order radius, other parameters, denoise, options; a further one
/// only for those that it does not part. Variants that are equal have the same
/// name, all others have different ones; the order of the list does not matter.
[[nodiscard]] std::vector<std::string> variant_names(const std::vector<Variant>& variants);

}  // namespace obscura::renderer
