// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/presentation_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace obscura::stimuli {

std::string_view to_string(Layout layout) {
    return layout == Layout::kSideBySide ? "side-by-side" : "sequential";
}

std::string_view to_string(Interval interval) {
    switch (interval) {
        case Interval::kGrey:
            return "grey";
        case Interval::kFixation:
            return "fixation";
        case Interval::kMask:
            return "mask";
    }
    return "";
}

std::string_view to_string(PairsPage page) { return page == PairsPage::kNext ? "next" : "list"; }

std::string to_words(const Presentation& presentation) {
    constexpr double kMsPerS = 1000.0;
    std::string words =
        presentation.layout == Layout::kSideBySide ? "side by side" : "one after the other";
    if (presentation.exposure_ms > 0) {
        words +=
            fmt::format(", {}for {:g} s", presentation.layout == Layout::kSideBySide ? "" : "each ",
                        presentation.exposure_ms / kMsPerS);
    }
    if (presentation.layout == Layout::kSideBySide || presentation.grey_ms == 0) return words;
    const char* what = "a grey screen";
    if (presentation.interval == Interval::kFixation) what = "a fixation cross on grey";
    if (presentation.interval == Interval::kMask) what = "a mask of noise";
    return words +
           fmt::format(", with {} for {:g} s between them", what, presentation.grey_ms / kMsPerS);
}

bool is_key_name(const std::string& name) {
    const bool named =
        std::find(kAdvanceKeys.begin(), kAdvanceKeys.end(), name) != kAdvanceKeys.end();
    const bool one = name.size() == 1 &&
                     ((name[0] >= 'a' && name[0] <= 'z') || (name[0] >= '0' && name[0] <= '9'));
    return named || one;
}

namespace {

using Need = TableReader::Need;

constexpr std::int64_t kMostShownMs = 60000;
constexpr std::int64_t kMostInputDelayMs = 5000;
constexpr std::int64_t kMostBreakS = 3600;

void read_advance(TableReader& reader, Presentation& presentation) {
    const std::string wanted = fmt::format("an array of {}, a letter a to z or a digit",
                                           listed({kAdvanceKeys.begin(), kAdvanceKeys.end()}));
    const toml::array* keys = reader.array("advance", Need::kOptional, wanted);
    if (keys == nullptr) return;
    presentation.advance.clear();
    for (const toml::node& node : *keys) {
        const std::string key = node.value<std::string>().value_or("");
        if (is_key_name(key)) {
            presentation.advance.push_back(key);
        } else if (node.is_string()) {
            reader.add("advance",
                       fmt::format("{} is no key, allowed is {}", in_quotes(key), wanted));
        } else {
            reader.add("advance",
                       fmt::format("holds something else than a string, allowed is {}", wanted));
        }
    }
    if (keys->empty() && !presentation.pointer) {
        reader.add(
            "advance",
            "is empty and pointer is false: nobody could leave an image; allowed is " + wanted);
    }
}

/// The whole number of that key, or what stands in `value` already.
void read_int(TableReader& reader, const std::string& key, std::int64_t low, std::int64_t high,
              int& value) {
    value = static_cast<int>(reader.integer(key, Need::kOptional, low, high).value_or(value));
}

template <typename List, typename Value>
void read_name(TableReader& reader, const std::string& key, const List& list, Value& value) {
    const auto name = reader.choice(key, Need::kOptional, names_of(list));
    for (const auto& known : list) {
        if (name && to_string(known) == *name) value = known;
    }
}

/// Keys that another one takes the effect from.
void refuse_idle_keys(TableReader& reader, const Presentation& presentation) {
    const auto refuse = [&](const char* key, const std::string& why) {
        if (reader.has(key)) reader.add(key, "has no effect beside " + why);
    };
    if (presentation.layout == Layout::kSideBySide) {
        const std::string why = "presentation = \"side-by-side\": there is no interval";
        refuse("interval", why);
        refuse("grey_ms", why);
    }
    if (presentation.exposure_ms > 0) {
        const std::string why = "exposure_ms: an image goes by itself";
        for (const char* key : {"min_view_ms", "advance", "pointer"}) refuse(key, why);
    }
    if (presentation.break_after == 0 && reader.has("break_min_s")) {
        reader.add("break_min_s", "has no effect without break_after: there is no break");
    }
}

}  // namespace

void read_presentation(TableReader& reader, Presentation& presentation) {
    read_name(reader, "presentation", kLayouts, presentation.layout);
    read_name(reader, "interval", kIntervals, presentation.interval);
    read_int(reader, "grey_ms", 0, kMostShownMs, presentation.grey_ms);
    read_int(reader, "grey_level", 0, 255, presentation.grey_level);
    read_int(reader, "exposure_ms", 0, kMostShownMs, presentation.exposure_ms);
    read_int(reader, "input_delay_ms", 0, kMostInputDelayMs, presentation.input_delay_ms);
    read_int(reader, "min_view_ms", 0, kMostShownMs, presentation.min_view_ms);
    read_int(reader, "min_response_ms", 0, kMostShownMs, presentation.min_response_ms);
    read_int(reader, "break_after", 0, kMostConditions, presentation.break_after);
    read_int(reader, "break_min_s", 0, kMostBreakS, presentation.break_min_s);
    read_name(reader, "pairs_page", kPairsPages, presentation.pairs_page);
    presentation.pointer =
        reader.boolean("pointer", Need::kOptional).value_or(presentation.pointer);
    read_advance(reader, presentation);
    refuse_idle_keys(reader, presentation);
}

}  // namespace obscura::stimuli
