// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "stimuli/pairs.h"

namespace obscura::stimuli {
namespace {

std::string accuracy_words(const ManifestImage& a, const ManifestImage& b) {
    if (!a.accuracy || !b.accuracy) return "accuracy not measured";
    const double rmse_a = a.accuracy->rmse;
    const double rmse_b = b.accuracy->rmse;
    const std::string errors =
        fmt::format("error a {:.4f}, b {:.4f} (RMSE of accessibility, truth within {:g} m)", rmse_a,
                    rmse_b, b.accuracy->radius_m);
    const char side = more_accurate(a, b);
    if (side == '\0') return errors + ": neither is clearly the more accurate";
    const double share = std::abs(rmse_a - rmse_b) / std::max(rmse_a, rmse_b);
    return errors + fmt::format(": {} is the more accurate by {:.0f} %", side, 100.0 * share);
}

std::string brightness_words(const ManifestImage& a, const ManifestImage& b) {
    if (!a.mean_luminance || !b.mean_luminance || !a.contrast || !b.contrast) {
        return "brightness not measured";
    }
    const double change =
        *a.mean_luminance > 0.0 ? 100.0 * (*b.mean_luminance / *a.mean_luminance - 1.0) : 0.0;
    std::string words = fmt::format(
        "mean luminance {:.4f} : {:.4f} ({:+.1f} %), contrast {:.3f} : "
        "{:.3f}",
        *a.mean_luminance, *b.mean_luminance, change, *a.contrast, *b.contrast);
    if (b.exposure_factor) words += fmt::format(", b exposed by {:.4f}", *b.exposure_factor);
    return words;
}

/// What is wrong with the claim that b is the more accurate; empty where it holds or is not known.
std::string contradiction(const ManifestImage& a, const ManifestImage& b) {
    if (!a.accuracy || !b.accuracy) return "";
    const char side = more_accurate(a, b);
    if (side == 'b') return "";
    return fmt::format("{} (RMSE of accessibility: a {:.4f}, b {:.4f})",
                       side == 'a' ? "a is, so that a vote for b speaks against it"
                                   : "neither is clearly the more accurate, so that it tests "
                                     "something else",
                       a.accuracy->rmse, b.accuracy->rmse);
}

}  // namespace

std::vector<std::string> facts_of(const Study& study, const Manifest& manifest,
                                  const std::vector<ManifestPair>& pairs) {
    std::vector<std::string> sentences;
    for (const ManifestPair& pair : pairs) {
        const ManifestImage* const a = manifest.find(pair.condition, "a");
        const ManifestImage* const b = manifest.find(pair.condition, "b");
        const Condition* const condition = study.find_condition(pair.condition);
        if (a == nullptr || b == nullptr || condition == nullptr || condition->identical) continue;
        sentences.push_back(
            fmt::format("condition \"{}\": {:.3g} % of the pixels differ noticeably; {}; {}",
                        pair.condition, 100.0 * pair.difference.over_threshold,
                        brightness_words(*a, *b), accuracy_words(*a, *b)));
    }
    return sentences;
}

std::vector<std::string> disordered_claims(const Study& study, const Manifest& manifest) {
    std::vector<std::string> sentences;
    for (const Hypothesis& hypothesis : study.hypotheses) {
        if (!hypothesis.accuracy) continue;
        for (const std::string& id : hypothesis.conditions) {
            const ManifestImage* const a = manifest.find(id, "a");
            const ManifestImage* const b = manifest.find(id, "b");
            if (a == nullptr || b == nullptr || !shows_what_is_asked(study, *a) ||
                !shows_what_is_asked(study, *b)) {
                continue;
            }
            const std::string why = contradiction(*a, *b);
            if (why.empty()) continue;
            sentences.push_back(
                fmt::format("condition \"{}\": hypothesis {} takes b for the more "
                            "accurate image, but {}",
                            id, hypothesis.id, why));
        }
    }
    return sentences;
}

}  // namespace obscura::stimuli
