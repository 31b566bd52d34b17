// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/shown_image.h"

namespace obscura::analysis {
namespace {

bool shows(const ShownImage& image, const ConditionVotes& condition, const std::string& variant) {
    return image.condition == condition.id &&
           (condition.validity.empty() || image.validity == condition.validity) &&
           (image.variant == variant || image.variant.starts_with(variant + ' '));
}

}  // namespace

const ShownImage* shown_image(const std::vector<ShownImage>& images,
                              const ConditionVotes& condition, char side) {
    const std::string& variant = side == 'A' ? condition.variant_a : condition.variant_b;
    // Answers may call A what the study calls B; where both sides fit, the study's side is meant.
    const ShownImage* found = nullptr;
    for (const ShownImage& image : images) {
        if (!shows(image, condition, variant)) continue;
        if (found == nullptr || image.side == side) found = &image;
    }
    return found;
}

}  // namespace obscura::analysis
