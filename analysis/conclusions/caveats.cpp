// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/caveats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "analysis/conclusions/balance_met.h"
#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/words.h"

namespace obscura::analysis {
namespace {

/// `18 to 21`, or `18` where both are the same.
std::string range_words(std::int64_t low, std::int64_t high) {
    return low == high ? std::to_string(low) : fmt::format("{} to {}", low, high);
}

Caveat sides(const Tally& tally) {
    if (!tally.order.has_value()) {
        return {"Sides",
                fmt::format("Which image was shown first is not known: {}.", tally.order.reason)};
    }
    std::int64_t low = 0;
    std::int64_t high = 0;
    std::int64_t most = 0;
    std::string apart;
    for (const ConditionVotes& condition : tally.conditions) {
        const auto n = static_cast<std::int64_t>(condition.answers.size());
        if (n == 0) continue;
        const auto a_first = std::count_if(condition.answers.begin(), condition.answers.end(),
                                           [](const Answer& answer) { return answer.b_second; });
        low = most == 0 ? a_first : std::min<std::int64_t>(low, a_first);
        high = std::max<std::int64_t>(high, a_first);
        most = std::max(most, n);
        if (2 * a_first != n) {
            apart += fmt::format("{}{} {} : {}", apart.empty() ? "" : ", ", condition.id, a_first,
                                 n - a_first);
        }
    }
    if (most == 0) return {"Sides", "Nobody answered."};
    if (apart.empty()) {
        return {"Sides", "Each image of a pair was shown first equally often in every pair."};
    }
    std::string text =
        fmt::format("A was shown first {} times of {}", range_words(low, high), most);
    const bool same = low == high;
    text += same ? fmt::format(" and B {} times, in every pair", most - low)
                 : fmt::format("; not even (A first : B first): {}", apart);
    return {"Sides", text + ". An effect of the order would shift the shares of B."};
}

Caveat positions(const BalanceMet& met) {
    if (!met.unknown.empty()) {
        return {"Places and carry-over",
                fmt::format("In which order the pairs came is not known: {}.", met.unknown)};
    }
    return {"Places and carry-over",
            fmt::format(
                "Each pair was at each place of the session {} times ({:.3g} would be even) and "
                "came directly after each other pair {} times ({:.3g} would be even).",
                range_words(met.at_place.low, met.at_place.high), met.at_place.even,
                range_words(met.after.low, met.after.high), met.after.even)};
}

/// What is shown, whatever the light; the condition's name where that is not known.
const std::string& view_of(const ConditionVotes& condition) {
    return condition.view.empty() ? condition.id : condition.view;
}

void add_scene_with_validity(std::vector<Caveat>& caveats, const Tally& tally) {
    std::map<std::string, std::set<std::string>> levels_of;
    std::set<std::string> levels;
    for (const ConditionVotes& condition : tally.conditions) {
        if (condition.validity.empty()) continue;
        levels.insert(condition.validity);
        levels_of[view_of(condition)].insert(condition.validity);
    }
    if (levels.size() < 2) return;
    std::vector<std::string> everywhere;
    std::vector<std::string> once;
    for (const auto& [view, own] : levels_of) {
        if (own.size() == levels.size()) everywhere.push_back(view);
        if (own.size() == 1) once.push_back(fmt::format("{} ({})", view, *own.begin()));
    }
    if (once.empty() && everywhere.size() == levels_of.size()) return;
    caveats.push_back(
        {"Scene with validity",
         fmt::format(
             "Of {}, {} {} shown at all {} levels of validity{}. A difference between levels "
             "can be one between scenes, except within a scene.",
             counted(static_cast<std::int64_t>(levels_of.size()), "view"),
             everywhere.empty() ? "none" : std::to_string(everywhere.size()),
             everywhere.size() == 1 || everywhere.empty() ? "is" : "are", levels.size(),
             once.empty() ? "" : fmt::format(", {} at one only: {}", once.size(), listed(once)))});
}

/// Both images of a condition.
struct ShownPair {
    const ConditionVotes* condition;
    const ShownImage* a;
    const ShownImage* b;
};

std::vector<ShownPair> shown_pairs(const Tally& tally, const std::vector<ShownImage>& images) {
    std::vector<ShownPair> pairs;
    for (const ConditionVotes& condition : tally.conditions) {
        const ShownImage* const a = shown_image(images, condition, 'A');
        const ShownImage* const b = shown_image(images, condition, 'B');
        if (a != nullptr && b != nullptr) pairs.push_back({&condition, a, b});
    }
    return pairs;
}

bool has_occlusion(const ShownImage& image) { return image.technique != "none"; }

void add_what_differs_together(std::vector<Caveat>& caveats, const std::vector<ShownPair>& pairs) {
    std::vector<std::string> words;
    for (const ShownPair& pair : pairs) {
        if (!has_occlusion(*pair.a) || !has_occlusion(*pair.b)) continue;
        if (pair.a->technique == pair.b->technique) continue;
        std::vector<std::string> with;
        if (pair.a->samples != pair.b->samples) {
            with.push_back(fmt::format("samples ({} : {})", pair.a->samples, pair.b->samples));
        }
        if (pair.a->denoise != pair.b->denoise) {
            with.push_back(fmt::format("denoise ({} : {})", pair.a->denoise, pair.b->denoise));
        }
        const auto radius = [](const ShownImage& image) {
            const auto found = image.parameters.find("radius_m");
            return found == image.parameters.end() ? 0.0 : found->second;
        };
        if (radius(*pair.a) > 0.0 && radius(*pair.b) > 0.0 && radius(*pair.a) != radius(*pair.b)) {
            with.push_back(fmt::format("radius ({:g} : {:g} m)", radius(*pair.a), radius(*pair.b)));
        }
        if (with.empty()) continue;
        words.push_back(fmt::format("{} ({} against {}) with {}", pair.condition->id,
                                    pair.condition->variant_a, pair.condition->variant_b,
                                    listed(with)));
    }
    if (words.empty()) return;
    caveats.push_back(
        {"Technique with its settings",
         fmt::format("In {} of {} the technique differs together with something else: {}. The "
                     "answers do not say which of them mattered.",
                     words.size(), counted(static_cast<std::int64_t>(pairs.size()), "pair"),
                     fmt::join(words, "; "))});
}

void add_darkness(std::vector<Caveat>& caveats, const std::vector<ShownPair>& pairs) {
    std::vector<std::string> words;
    std::int64_t darker_b = 0;
    for (const ShownPair& pair : pairs) {
        const auto& [condition, a, b] = pair;
        if (!a->mean_luminance || !b->mean_luminance) continue;
        if (*b->mean_luminance < *a->mean_luminance) ++darker_b;
        std::string text = fmt::format("{} {:.3f} : {:.3f}", condition->id, *a->mean_luminance,
                                       *b->mean_luminance);
        if (a->mean_occlusion && b->mean_occlusion) {
            text += fmt::format(" ({:.3f} : {:.3f})", *a->mean_occlusion, *b->mean_occlusion);
        }
        words.push_back(text);
    }
    if (pairs.empty()) return;
    if (words.empty()) {
        caveats.push_back({"Accuracy with darkness",
                           "How bright the images are is not known: their manifest does not say."});
        return;
    }
    const auto n = static_cast<std::int64_t>(words.size());
    caveats.push_back(
        {"Accuracy with darkness",
         fmt::format("B is the darker image in {} of {}, so that liking or disliking dark images "
                     "counts as liking B. Mean luminance (white is 1) A : B, in brackets mean "
                     "occlusion: {}.",
                     darker_b, counted(n, "pair"), fmt::join(words, ", "))});
}

/// Images that are the same to the byte, or where no file is known, of the same scene and settings.
void add_recurring(std::vector<Caveat>& caveats, const std::vector<ShownPair>& pairs) {
    std::map<std::string, std::pair<std::string, std::set<std::string>>> seen;
    for (const ShownPair& pair : pairs) {
        for (const ShownImage* image : {pair.a, pair.b}) {
            const bool is_a = image == pair.a;
            const std::string& variant =
                is_a ? pair.condition->variant_a : pair.condition->variant_b;
            const std::string scene = image->scene_id.empty() ? image->scene : image->scene_id;
            const std::string key =
                image->sha256.empty() ? fmt::format("{}\n{}\n{}\n{}\n{}", scene, image->camera,
                                                    image->validity, image->variant, image->denoise)
                                      : image->sha256;
            auto& [name, conditions] = seen[key];
            if (name.empty()) name = fmt::format("{} in {}", variant, scene);
            conditions.insert(pair.condition->id);
        }
    }
    std::vector<std::string> words;
    for (const auto& [key, image] : seen) {
        if (image.second.size() < 2) continue;
        words.push_back(fmt::format("{} ({})", image.first, fmt::join(image.second, ", ")));
    }
    if (words.empty()) return;
    std::sort(words.begin(), words.end());
    caveats.push_back(
        {"Images that recur",
         fmt::format(
             "{} in more than one pair: {}. Those pairs are not independent of each other.",
             words.size() == 1 ? "One image is" : fmt::format("{} images are", words.size()),
             listed(words))});
}

void add_views(std::vector<Caveat>& caveats, const std::vector<ShownPair>& pairs) {
    std::map<std::string, std::set<std::string>> cameras;
    for (const ShownPair& pair : pairs) cameras[pair.a->scene].insert(pair.a->camera);
    if (cameras.empty()) return;
    std::vector<std::string> once;
    for (const auto& [scene, own] : cameras) {
        if (own.size() == 1) once.push_back(scene);
    }
    if (once.empty()) return;
    caveats.push_back({"One view a scene",
                       fmt::format("{} of {} ({}) {} seen from one camera only.", once.size(),
                                   counted(static_cast<std::int64_t>(cameras.size()), "scene"),
                                   listed(once), once.size() == 1 ? "is" : "are")});
}

Caveat display(const Tally& tally, const Possible<Attendance>& attendance) {
    constexpr const char* kNever =
        "size, distance, luminance and gamma of the display and the light in the room";
    if (tally.kind == Kind::kSimulated) {
        return {"Display", "There was none: the observers are simulated."};
    }
    if (!attendance.has_value()) {
        return {"Display",
                fmt::format("Nothing of it is known ({}), nor {}.", attendance.reason, kNever)};
    }
    std::int64_t sessions = 0;
    std::vector<std::string> words;
    for (const auto& [name, count] : attendance->displays) {
        sessions += count;
        words.push_back(
            fmt::format("{} in {}", name.empty() ? "no name" : name, counted(count, "session")));
    }
    return {"Display",
            fmt::format("{} in {}: {}. The refresh rate is not known in {}. Not recorded in any: "
                        "{}.",
                        counted(static_cast<std::int64_t>(words.size()), "display"),
                        counted(sessions, "completed session"), listed(words),
                        attendance->unknown_refresh, kNever)};
}

}  // namespace

std::vector<Caveat> caveats_of(const Analysis& analysis, const std::vector<ShownImage>& images,
                               const Possible<Attendance>& attendance) {
    const Tally& tally = analysis.tally;
    std::vector<Caveat> caveats{sides(tally)};
    if (tally.conditions.size() > 1) caveats.push_back(positions(balance_met(tally)));
    add_scene_with_validity(caveats, tally);
    const std::vector<ShownPair> pairs = shown_pairs(tally, images);
    add_what_differs_together(caveats, pairs);
    add_recurring(caveats, pairs);
    const std::size_t of_images = caveats.size();
    add_darkness(caveats, pairs);
    add_views(caveats, pairs);
    if (is_published_votes(tally)) {
        for (std::size_t i = of_images; i < caveats.size(); ++i) {
            caveats[i].sentence =
                "Of this program's images, which are not those of 2010: " + caveats[i].sentence;
        }
    }
    caveats.push_back({"Scenes and views",
                       "They are fixed, not drawn: nothing here generalises to others, for which "
                       "many would have to be drawn (H. H. Clark 1973)."});
    caveats.push_back(display(tally, attendance));
    return caveats;
}

}  // namespace obscura::analysis
