// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/thumbnail.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"

namespace obscura::analysis {
namespace {

constexpr int kThumbnail_px = 600;

using Hashes = std::map<std::pair<std::string, char>, std::set<std::string>>;

/// One image of a pair, made small, or why it cannot be shown.
struct Thumbnail {
    std::string jpeg;
    std::string problem;
};

Thumbnail thumbnail_of(const ShownImage& image, const Hashes& hashes) {
    const std::string name = fmt::format("{}-{}", image.condition, image.side);
    if (image.file.empty() || !std::filesystem::exists(image.file)) {
        return {"", fmt::format("{}: the file is not there", name)};
    }
    const std::string bytes = base::read_file(image.file);
    if (base::sha256_hex(bytes) != image.sha256) {
        return {"", fmt::format("{}: the file was changed after it was made", name)};
    }
    const auto shown = hashes.find({image.condition, image.side});
    if (shown != hashes.end() && shown->second != std::set<std::string>{image.sha256}) {
        return {"", fmt::format("{}: the file is not the one that was shown", name)};
    }
    return {thumbnail(bytes, image.file.string(), kThumbnail_px), ""};
}

std::string caption_of(const ConditionVotes& condition, char side) {
    const bool is_a = side == 'A';
    return fmt::format("{} {}: {}, chosen by {} of {}", condition.id, side,
                       is_a ? condition.variant_a : condition.variant_b,
                       is_a ? condition.votes.a : condition.votes.b, condition.votes.n());
}

/// The condition's two images, or what keeps them from being shown.
void add_pair(ReportDraft& draft, const ConditionVotes& condition, const Hashes& hashes,
              std::vector<std::string>& problems) {
    std::string bytes[2];
    std::string files[2];
    std::string captions[2];
    for (int i = 0; i < 2; ++i) {
        const char side = i == 0 ? 'A' : 'B';
        const ShownImage* image = shown_image(draft.input.images, condition, side);
        if (image == nullptr) {
            problems.push_back(fmt::format("{}-{}: there is no such image", condition.id, side));
            return;
        }
        Thumbnail small = thumbnail_of(*image, hashes);
        if (small.jpeg.empty()) {
            problems.push_back(small.problem);
            return;
        }
        bytes[i] = std::move(small.jpeg);
        files[i] = fmt::format("thumbnails/{}-{}.jpg", condition.id, i == 0 ? 'a' : 'b');
        captions[i] = caption_of(condition, side);
    }
    draft.page.pair(bytes, kThumbnailType, files, captions);
    for (int i = 0; i < 2; ++i) draft.file(files[i], bytes[i]);
}

PageTable conditions_table(const ReportInput& input) {
    PageTable table{{"Condition", "Hypothesis", "Validity", "Scene", "Image A", "Image B"}, {}};
    for (const ConditionResult* result : by_validity(input.analysis)) {
        const ConditionVotes& condition = result->condition;
        const ShownImage* image = shown_image(input.images, condition, 'A');
        table.rows.push_back(
            {condition.id, condition.hypothesis.empty() ? kNoValue : condition.hypothesis,
             condition.validity.empty() ? kNoValue : condition.validity,
             image == nullptr ? kNoValue : fmt::format("{}, {}", image->scene, image->camera),
             condition.variant_a, condition.variant_b});
    }
    return table;
}

/// Brightness, contrast and error of each pair's images; no rows where nothing is known.
PageTable image_facts_table(const ReportInput& input) {
    PageTable table{{"Condition", "Pixels that differ (%)", "Luminance A", "Luminance B",
                     "B against A (%)", "Contrast A", "Contrast B", "RMSE A", "RMSE B"},
                    {}};
    const auto number = [](const std::optional<double>& value, int decimals) {
        return value ? fmt::format("{:.{}f}", *value, decimals) : std::string(kNoValue);
    };
    for (const ConditionResult* result : by_validity(input.analysis)) {
        const ConditionVotes& condition = result->condition;
        const ShownImage* a = shown_image(input.images, condition, 'A');
        const ShownImage* b = shown_image(input.images, condition, 'B');
        if (a == nullptr || b == nullptr || !a->mean_luminance || !b->mean_luminance) continue;
        std::optional<double> change;
        if (*a->mean_luminance > 0.0) {
            change = 100.0 * (*b->mean_luminance / *a->mean_luminance - 1.0);
        }
        std::optional<double> share = b->noticeable_share;
        if (share) *share *= 100.0;
        table.rows.push_back({condition.id, number(share, 1), number(a->mean_luminance, 4),
                              number(b->mean_luminance, 4),
                              change ? fmt::format("{:+.1f}", *change) : kNoValue,
                              number(a->contrast, 3), number(b->contrast, 3), number(a->rmse, 4),
                              number(b->rmse, 4)});
    }
    return table;
}

/// The conditions whose second image was exposed to be as bright as the first, with the factor.
std::string exposed_words(const ReportInput& input) {
    std::vector<std::string> words;
    for (const ShownImage& image : input.images) {
        if (!image.exposure_factor) continue;
        words.push_back(fmt::format("{} {:.4f}", image.condition, *image.exposure_factor));
    }
    if (words.empty()) return "";
    return fmt::format(" Image B was made as bright as image A; its light was multiplied by: {}.",
                       fmt::join(words, ", "));
}

}  // namespace

void add_stimuli(ReportDraft& draft) {
    const ReportInput& input = draft.input;
    const bool is_published = is_published_votes(input.analysis.tally);
    draft.page.heading("What was compared");
    if (!input.study.question.empty()) {
        draft.page.paragraph(fmt::format(
            "Each participant saw the two images of a pair {}, and was asked: “{}” One of "
            "the two had to be chosen. The images of a pair differ in their ambient "
            "occlusion and in nothing else.",
            input.study.shown, input.study.question));
    }
    draft.page.table(
        conditions_table(input),
        "The pairs, by ecological validity of the scene's lighting: low has constant "
        "ambient light only, moderate irradiance from an environment, high that and a "
        "sun with shadows. The number in a variant's name counts its samples; behind it stands "
        "what differs where two would have the same name (R: radius in m).");
    if (PageTable differences = image_facts_table(input); !differences.rows.empty()) {
        draft.page.table(
            differences,
            "What the two images of a pair differ in. Pixels that differ: by a just-noticeable 2.3 "
            "in CIELAB or more. Luminance: mean, as a share of display white. Contrast: standard "
            "deviation of luminance over its mean. RMSE: of accessibility, 0 to 1, against the "
            "ray-traced truth, in every so many pixels of the image." +
                exposed_words(input));
    }
    if (std::all_of(input.images.begin(), input.images.end(),
                    [](const ShownImage& image) { return image.file.empty(); })) {
        draft.page.paragraph(fmt::format("The images are not shown: {}.", input.images_unknown));
        return;
    }
    const Hashes hashes = input.attendance.has_value() ? input.attendance->shown_sha256 : Hashes{};
    std::vector<std::string> problems;
    if (is_published) {
        draft.page.notice(
            "These are this program's own images of the seven conditions. The participants of 2010 "
            "saw other scenes (the Stanford dragon, Sponza, two characters) from the thesis's own "
            "renderer.");
    } else if (hashes.empty()) {
        draft.page.paragraph(
            "The answers do not say which image files were shown; these are those of the study.");
    }
    for (const ConditionResult* result : by_validity(input.analysis)) {
        add_pair(draft, result->condition, hashes, problems);
    }
    if (!problems.empty()) {
        draft.page.paragraph("Pairs that are not shown:");
        draft.page.list(problems);
    }
}

}  // namespace obscura::analysis
