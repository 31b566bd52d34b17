// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>

#include "stimuli/manifest.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// What each side of each condition is called in answers, tables and plots, by condition and side
/// ('a' or 'b'): renderer::variant_names() of all that the study shows, so that two that differ in
/// any setting have two names.
using VariantNames = std::map<std::pair<std::string, char>, std::string>;

[[nodiscard]] VariantNames variant_names(const Study& study);

/// The same of images as they were made.
[[nodiscard]] VariantNames variant_names(const Manifest& manifest);

}  // namespace obscura::stimuli
