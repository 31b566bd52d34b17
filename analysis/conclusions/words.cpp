// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/words.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace obscura::analysis {
namespace {

constexpr const char* kNoBreakSpace = "\u00a0";
constexpr double kShownAsPower = 1e-290;
constexpr double kShownWithExponent = 1e-3;

}  // namespace

std::string p_number(const PValue& p, int decimals) {
    if (p.p < kShownAsPower) return fmt::format("10^{:.2f}", p.log10_p);
    return p.p < kShownWithExponent ? fmt::format("{:.1e}", p.p)
                                    : fmt::format("{:.{}f}", p.p, decimals);
}

std::string p_words(const PValue& p) { return "p = " + p_number(p, 3); }

std::string p_text(const PValue& p) {
    if (p.p < kShownAsPower) return fmt::format("10^{:.2f}", p.log10_p);
    return p.p < kShownWithExponent ? fmt::format("{:.3e}", p.p) : fmt::format("{:.6f}", p.p);
}

std::string percent(double share, int decimals) {
    return fmt::format("{:.{}f}{}%", 100.0 * share, decimals, kNoBreakSpace);
}

std::string percent(const Interval& interval) {
    return fmt::format("{:.0f} to {:.0f}{}%", 100.0 * interval.low, 100.0 * interval.high,
                       kNoBreakSpace);
}

std::string counted(std::int64_t n, std::string_view singular, std::string_view plural) {
    if (n == 1) return fmt::format("1 {}", singular);
    return plural.empty() ? fmt::format("{} {}s", n, singular) : fmt::format("{} {}", n, plural);
}

std::string listed(const std::vector<std::string>& words) {
    if (words.empty()) return "none";
    std::string text = words.front();
    for (std::size_t i = 1; i < words.size(); ++i) {
        text += (i + 1 == words.size() ? " and " : ", ") + words[i];
    }
    return text;
}

std::string capital(std::string text) {
    if (!text.empty()) {
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    }
    return text;
}

std::string what_is_compared(const Comparison& comparison) {
    return fmt::format("{} against {}{}{} over {} ({})", comparison.variant_a, comparison.variant_b,
                       comparison.view.empty() ? "" : " in ", comparison.view,
                       fmt::join(comparison.levels, ", "), fmt::join(comparison.conditions, ", "));
}

std::string partner_words(const std::vector<std::string>& without_partner) {
    return fmt::format("{} {} no partner at another level in the same scene.",
                       listed(without_partner), without_partner.size() == 1 ? "has" : "have");
}

std::string order_words(const Possible<OrderByParticipant>& order) {
    if (!order.has_value()) {
        return fmt::format("Over participants the order is not tested: {}.", order.reason);
    }
    std::string text = fmt::format(
        "Over {}{}, {}: the image shown second is chosen by {:+.1f} points more often than the "
        "first",
        counted(order->participants, "participant"),
        order->left_out > 0 ? fmt::format(" ({} who answered fewer left out)", order->left_out)
                            : "",
        order->kind == OrderTestKind::kSideGroups
            ? "of whom each saw the same variant first in every pair"
            : "who saw either variant first in some pairs",
        100.0 * order->difference);
    if (order->interval.has_value()) {
        text += fmt::format(" (95 % interval {:+.1f} to {:+.1f})", 100.0 * order->interval->low,
                            100.0 * order->interval->high);
    }
    text +=
        fmt::format(", {} {}, p {}.", order->is_exact ? "exact" : "large-sample",
                    order->kind == OrderTestKind::kSideGroups ? "permutation between the two groups"
                                                              : "test by flipping signs",
                    p_text(order->p));
    if (order->kind != OrderTestKind::kSideGroups) return text;
    // 4000 studies each, seed 1: three conditions pooled, sign flip at .05, standard deviation of
    // the observers 1 in log odds, whole blocks of 14.
    return text +
           " One side for all pairs of a session costs power, since a liking for a place then "
           "moves "
           "all votes of a participant the same way: of 28 simulated participants who choose the "
           "second of two alike images in 75 %, a true share of 65 % in three conditions is found "
           "in 39 % of the studies, and in 55 % where the sides change within a session (sides = "
           "\"trial\" in the study file).";
}

std::string scale_words(const VariantScale& scale) {
    std::string text;
    if (!scale.jod_intervals.has_value()) {
        text = fmt::format("No standard errors: {}.", scale.jod_intervals.reason);
    } else if (scale.errors == ScaleErrors::kParticipants) {
        text =
            "Standard errors are over participants, whose votes hang together (sandwich), and the "
            "intervals t's.";
    } else if (scale.errors == ScaleErrors::kVotes) {
        text =
            "Standard errors take the votes as independent, since who gave them is not known: they "
            "are too small where a participant's votes hang together.";
    } else {
        text = fmt::format(
            "No finite scale is likeliest: {}. This is the likeliest under a prior, normal around "
            "0 with standard deviation {:g} JOD for every difference between two variants that "
            "were compared; its errors are the posterior's standard deviations, with the votes "
            "taken as independent.",
            scale.separated, kScalePriorJod);
    }
    if (!scale.has_order_term) return text;
    text += fmt::format(" Order term: {:+.3f} log odds for the image shown second",
                        scale.bradley_terry->order_term);
    if (scale.jod_intervals.has_value()) {
        text += fmt::format(" (standard error {:.3f})", scale.bradley_terry->order_standard_error);
    }
    return text + '.';
}

std::string who(const Tally& tally, std::int64_t n) {
    return counted(n, tally.kind == Kind::kSimulated ? "simulated observer" : "participant");
}

std::size_t level_number(std::string_view validity) {
    constexpr std::array<std::string_view, 3> kLevels{"low", "moderate", "high"};
    return static_cast<std::size_t>(std::find(kLevels.begin(), kLevels.end(), validity) -
                                    kLevels.begin());
}

}  // namespace obscura::analysis
