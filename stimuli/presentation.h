// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace obscura::stimuli {

/// How the two images of a pair are shown: `sequential`, as in the thesis, or `side-by-side`.
enum class Layout { kSequential, kSideBySide };
inline constexpr std::array kLayouts{Layout::kSequential, Layout::kSideBySide};
[[nodiscard]] std::string_view to_string(Layout layout);

/// What fills the interval between them: `grey`, as in the thesis; `fixation`, a cross in its
/// middle; `mask`, noise in the images' place.
enum class Interval { kGrey, kFixation, kMask };
inline constexpr std::array kIntervals{Interval::kGrey, Interval::kFixation, Interval::kMask};
[[nodiscard]] std::string_view to_string(Interval interval);

/// How a participant gets to the next pair: `list`, a button for each, as in the thesis; `next`,
/// one button with the progress.
enum class PairsPage { kList, kNext };
inline constexpr std::array kPairsPages{PairsPage::kList, PairsPage::kNext};
[[nodiscard]] std::string_view to_string(PairsPage page);

/// The keys with a name that may end the look at an image, beside the letters and digits.
inline constexpr std::array kAdvanceKeys{"space", "enter", "left",    "right",
                                         "up",    "down",  "page-up", "page-down"};

/// How the pairs are shown and answered; what is not said is the thesis's way.
struct Presentation {
    Layout layout = Layout::kSequential;
    Interval interval = Interval::kGrey;
    int grey_ms = 2000;  ///< how long the interval lasts
    int grey_level = 128;
    int exposure_ms = 0;       ///< of each image; 0: as long as the participant wants
    int input_delay_ms = 300;  ///< a page or image takes nothing that is pressed before that
    int min_view_ms = 0;       ///< an image cannot be left before
    int min_response_ms = 0;   ///< the question cannot be answered before
    int break_after = 0;       ///< pairs between two breaks; 0: none
    int break_min_s = 0;       ///< a break lasts at least
    std::optional<PairsPage> pairs_page;  ///< nothing: the list up to kMostListed pairs
    /// Keys that end the look at an image: names of kAdvanceKeys, one letter or one digit.
    std::vector<std::string> advance = {"space"};
    bool pointer = false;  ///< a click or touch anywhere does too
};

/// How the two images are shown, as the end of a sentence: `one after the other, with a grey screen
/// for 2 s between them`, `side by side, for 0.5 s`.
[[nodiscard]] std::string to_words(const Presentation& presentation);

/// More pairs than that have one button instead of a list, unless the study says otherwise.
inline constexpr int kMostListed = 20;

}  // namespace obscura::stimuli
