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

std::string p_number(const PValue& p) {
    constexpr double kSmallest = .0005;
    constexpr double kLargest = .9995;
    if (p.p < kSmallest) return "< .001";
    if (p.p >= kLargest) return "> .999";
    return fmt::format("{:.3f}", p.p).substr(1);
}

std::string p_number(const Possible<double>& p) {
    return p.has_value() ? p_number(PValue{*p, 0.0}) : "none";
}

std::string p_words(const PValue& p) {
    const std::string number = p_number(p);
    return number.front() == '.' ? "p = " + number : "p " + number;
}

std::string points_words(double margin) { return fmt::format("{:g} points", 100.0 * margin); }

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
