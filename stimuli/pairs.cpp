// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::stimuli {
namespace {

/// The images' difference; nothing where a file is missing or is no such image, which
/// problems_of_stimuli tells of.
std::optional<ImageDifference> difference_of_files(const std::filesystem::path& a,
                                                   const std::filesystem::path& b) {
    try {
        return difference_of(decode_png(base::read_file(a), a.string()),
                             decode_png(base::read_file(b), b.string()));
    } catch (const base::Error&) {
        return std::nullopt;
    }
}

/// Whether the folder holds it and it shows what the study asks for today.
bool is_there(const Study& study, const ManifestImage* image, const std::filesystem::path& folder) {
    std::error_code error;
    return image != nullptr && shows_what_is_asked(study, *image) &&
           std::filesystem::is_regular_file(folder / image->file, error);
}

std::string sentence_of(const ManifestPair& pair) {
    const ImageDifference& difference = pair.difference;
    const std::string because = pair.reason.empty() ? "" : "; likely because " + pair.reason;
    if (difference.none()) {
        return fmt::format("condition \"{}\": its two images are the same to the byte{}",
                           pair.condition, because);
    }
    return fmt::format(
        "condition \"{}\": its two images differ less than anyone can see: {:.3g} % of their "
        "pixels "
        "differ, the most by {:.2g} in CIELAB; {:.2g} % by a just-noticeable {} or as much in "
        "fewer, visible is {} %{}",
        pair.condition, 100.0 * difference.differing, difference.largest_delta_e,
        100.0 * difference.visible, kJustNoticeable_delta_e, 100.0 * kLeastVisible, because);
}

}  // namespace

std::vector<ManifestPair> compared_pairs(const Study& study, const Manifest& manifest,
                                         const std::filesystem::path& folder) {
    std::vector<ManifestPair> pairs;
    for (const Condition& condition : study.conditions) {
        const ManifestImage* a = manifest.find(condition.id, "a");
        const ManifestImage* b = manifest.find(condition.id, "b");
        if (!is_there(study, a, folder) || !is_there(study, b, folder)) continue;
        const auto known =
            std::find_if(manifest.pairs.begin(), manifest.pairs.end(), [&](const auto& pair) {
                return pair.condition == condition.id && pair.a_sha256 == a->sha256 &&
                       pair.b_sha256 == b->sha256;
            });
        if (known != manifest.pairs.end()) {
            pairs.push_back(*known);
        } else if (const auto found = difference_of_files(folder / a->file, folder / b->file)) {
            pairs.push_back({condition.id, a->sha256, b->sha256, *found, ""});
        }
    }
    return pairs;
}

std::vector<ManifestPair> compared_pairs(const Study& study, const std::filesystem::path& folder) {
    try {
        return compared_pairs(study, load_manifest(folder / "manifest.json"), folder);
    } catch (const base::Error&) {
        return {};
    }
}

void PairsInTheMaking::add(const ManifestImage& entry, RgbImage image) {
    if (entry.side == "b" && entry.condition == condition_) {
        pairs_.push_back(
            {condition_, sha256_, entry.sha256, difference_of(image_, image), /*reason=*/""});
    }
    condition_ = entry.side == "a" ? entry.condition : "";
    sha256_ = entry.sha256;
    image_ = std::move(image);
}

std::vector<std::string> alike_pairs(const Study& study, const std::vector<ManifestPair>& pairs) {
    std::vector<std::string> sentences;
    for (const ManifestPair& pair : pairs) {
        const Condition* condition = study.find_condition(pair.condition);
        if (condition == nullptr || condition->identical || pair.difference.can_be_seen()) continue;
        sentences.push_back(sentence_of(pair));
    }
    return sentences;
}

std::vector<std::string> falsely_identical_pairs(const Study& study,
                                                 const std::vector<ManifestPair>& pairs) {
    std::vector<std::string> sentences;
    for (const ManifestPair& pair : pairs) {
        const Condition* condition = study.find_condition(pair.condition);
        if (condition == nullptr || !condition->identical || !pair.difference.can_be_seen()) {
            continue;
        }
        sentences.push_back(fmt::format(
            "condition \"{}\": it is marked as identical, but {:.3g} % of the pixels of its two "
            "images are a just-noticeable {} in CIELAB or more apart, the most {:.3g}",
            pair.condition, 100.0 * pair.difference.over_threshold, kJustNoticeable_delta_e,
            pair.difference.largest_delta_e));
    }
    return sentences;
}

std::vector<std::string> faint_pairs(const Study& study, const std::vector<ManifestPair>& pairs) {
    std::vector<std::string> sentences;
    for (const ManifestPair& pair : pairs) {
        const Condition* condition = study.find_condition(pair.condition);
        if (condition == nullptr || condition->identical || !pair.difference.can_be_seen())
            continue;
        const bool is_catch = condition->expected != '\0';
        if (pair.difference.visible >= (is_catch ? kObvious : kHardlyVisible)) continue;
        sentences.push_back(fmt::format(
            "condition \"{}\": its two images hardly differ ({:.3g} % of the pixels by a "
            "just-noticeable {} in CIELAB or more, the most {:.3g}): {}",
            pair.condition, 100.0 * pair.difference.over_threshold, kJustNoticeable_delta_e,
            pair.difference.largest_delta_e,
            is_catch ? "as an attention check (catch) it is hard to see, and attentive observers "
                       "may fail it"
                     : "most observers will guess"));
    }
    return sentences;
}

std::vector<std::string> warnings_of(const Study& study, const std::vector<ManifestPair>& pairs) {
    std::vector<std::string> sentences = alike_pairs(study, pairs);
    for (std::string& sentence : faint_pairs(study, pairs)) {
        sentences.push_back(std::move(sentence));
    }
    for (std::string& sentence : falsely_identical_pairs(study, pairs)) {
        sentences.push_back(std::move(sentence));
    }
    return sentences;
}

}  // namespace obscura::stimuli
