// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/preference_and_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace obscura::analysis {
namespace {

using SettingRows = std::vector<const MeasuredSetting*>;

/// Whether the list of names, parted by blanks, commas or semicolons, has the name.
bool names_condition(const std::string& list, const std::string& name) {
    std::size_t begin = 0;
    while (begin < list.size()) {
        const std::size_t end = std::min(list.find_first_of(" ,;", begin), list.size());
        if (std::string_view(list).substr(begin, end - begin) == name) return true;
        begin = end + 1;
    }
    return false;
}

/// Whether the list names that side of that condition: `II a, IV b`.
bool names_side(const std::string& list, const ShownImage& image) {
    const std::string wanted = image.condition + (image.side == 'A' ? " a" : " b");
    const std::string all = ", " + list + ", ";
    return all.find(", " + wanted + ", ") != std::string::npos;
}

/// What the study calls the scene names the view; a table or an image that does not say it is known
/// by source and camera, which several views may have in common.
bool is_of_view(const MeasuredSetting& row, const ShownImage& image) {
    if (!row.scene_id.empty() && !image.scene_id.empty()) return row.scene_id == image.scene_id;
    return row.scene == image.scene && row.camera == image.camera && row.validity == image.validity;
}

/// Of two lists that both say something, whether every parameter that both name is the same. What
/// was fitted has other values on purpose.
bool has_the_same_parameters(const MeasuredSetting& row, const ShownImage& image) {
    return row.fitted ||
           std::all_of(row.parameters.begin(), row.parameters.end(), [&](const auto& parameter) {
               const auto other = image.parameters.find(parameter.first);
               return other == image.parameters.end() || other->second == parameter.second;
           });
}

bool shows_the_same(const MeasuredSetting& row, const ShownImage& image) {
    return is_of_view(row, image) && row.technique == image.technique &&
           row.samples == image.samples && has_the_same_parameters(row, image);
}

/// How well a row that shows the same stands for the image; larger is better.
auto fitness(const MeasuredSetting& row, const ShownImage& image) {
    return std::tuple(names_side(row.published, image),
                      names_condition(row.published, image.condition), !row.fitted,
                      row.denoise == image.denoise, row.depth_format == image.depth_format,
                      row.ao_scale == 1.0, row.rmse.has_value(), row.ms_median.has_value());
}

const MeasuredSetting* best_of(const SettingRows& rows, const ShownImage* image) {
    const MeasuredSetting* best = nullptr;
    if (image == nullptr) return best;
    for (const MeasuredSetting* row : rows) {
        if (!shows_the_same(*row, *image)) continue;
        if (best == nullptr || fitness(*best, *image) < fitness(*row, *image)) best = row;
    }
    return best;
}

Possible<double> difference(const Possible<double>& b, const Possible<double>& a) {
    if (!a.has_value()) return Possible<double>::none("A: " + a.reason);
    if (!b.has_value()) return Possible<double>::none("B: " + b.reason);
    return *b - *a;
}

std::string missing(const std::vector<ShownImage>& images, const ConditionVotes& condition,
                    const SettingRows& rows) {
    std::string text = fmt::format("{}:", condition.id);
    for (const char side : {'A', 'B'}) {
        const std::string& variant = side == 'A' ? condition.variant_a : condition.variant_b;
        const ShownImage* image = shown_image(images, condition, side);
        if (image == nullptr) {
            text += fmt::format(" it is not known how {} ({}) was rendered;", side, variant);
        } else if (best_of(rows, image) == nullptr) {
            text += fmt::format(" no row of {} on {}, camera {}, {} validity;", variant,
                                image->scene, image->camera, image->validity);
        }
    }
    text.back() = '.';
    return text;
}

/// The rows of each device at each size, in the order of the table.
std::vector<SettingRows> rows_by_device(const MeasurementTable& table) {
    std::vector<SettingRows> groups;
    std::map<std::tuple<std::string, int, int>, std::size_t> place;
    for (const MeasuredSetting& row : table.rows) {
        const auto [entry, is_new] =
            place.emplace(std::tuple(row.device, row.width, row.height), groups.size());
        if (is_new) groups.emplace_back();
        groups[entry->second].push_back(&row);
    }
    return groups;
}

std::vector<MeasuredPair> pairs_of(const std::vector<ConditionResult>& conditions,
                                   const std::vector<ShownImage>& images, const SettingRows& rows) {
    std::vector<MeasuredPair> pairs;
    for (const ConditionResult& result : conditions) {
        const MeasuredSetting* a = best_of(rows, shown_image(images, result.condition, 'A'));
        const MeasuredSetting* b = best_of(rows, shown_image(images, result.condition, 'B'));
        if (a == nullptr || b == nullptr) continue;
        pairs.push_back({&result, *a, *b, difference(b->rmse, a->rmse),
                         difference(b->ms_median, a->ms_median)});
    }
    return pairs;
}

PreferenceCurve curve_of(const std::vector<MeasuredPair>& pairs,
                         Possible<double> MeasuredPair::*difference) {
    std::vector<PreferencePoint> points;
    for (const MeasuredPair& pair : pairs) {
        const Possible<double>& value = pair.*difference;
        if (!value.has_value()) continue;
        const ConditionVotes& condition = pair.condition->condition;
        points.push_back({condition.id, condition.validity, *value, condition.votes});
    }
    return preference_curve(points);
}

}  // namespace

PreferenceAndCost preference_and_cost(const std::vector<ConditionResult>& conditions,
                                      const std::vector<ShownImage>& images,
                                      const MeasurementTable& measurement) {
    PreferenceAndCost result;
    SettingRows chosen;
    for (const SettingRows& rows : rows_by_device(measurement)) {
        std::vector<MeasuredPair> pairs = pairs_of(conditions, images, rows);
        if (!chosen.empty() && pairs.size() <= result.pairs.size()) continue;
        chosen = rows;
        result.pairs = std::move(pairs);
    }
    if (!chosen.empty()) {
        result.device = chosen.front()->device;
        result.width = chosen.front()->width;
        result.height = chosen.front()->height;
    }
    for (const ConditionResult& condition : conditions) {
        const bool is_joined =
            std::any_of(result.pairs.begin(), result.pairs.end(),
                        [&](const MeasuredPair& pair) { return pair.condition == &condition; });
        if (!is_joined) {
            result.not_joined.push_back(missing(images, condition.condition, chosen));
        }
    }
    result.by_error = curve_of(result.pairs, &MeasuredPair::error_difference);
    result.by_ms = curve_of(result.pairs, &MeasuredPair::ms_difference);
    return result;
}

}  // namespace obscura::analysis
