// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/journal.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/conclusions/words.h"

namespace obscura::analysis {
namespace {

std::string share_numbers(const HypothesisResult& result, const Verdict& verdict) {
    const Votes& votes = result.pooled.votes;
    std::string text = fmt::format("; B in {} of {} ({}", votes.b, counted(votes.n(), "vote"),
                                   journal_share(*result.pooled.share_b));
    if (verdict.interval.has_value()) {
        text += fmt::format(", 95 % CI {}", journal_interval(*verdict.interval));
    }
    return text + ')';
}

}  // namespace

std::string journal_p(const PValue& p) {
    constexpr double kSmallest = .0005;
    constexpr double kLargest = .9995;
    if (p.p < kSmallest) return "< .001";
    if (p.p >= kLargest) return "> .999";
    return fmt::format("{:.3f}", p.p).substr(1);
}

std::string journal_p(const Possible<double>& p) {
    return p.has_value() ? journal_p(PValue{*p, 0.0}) : "none";
}

std::string journal_p_words(const PValue& p) {
    const std::string number = journal_p(p);
    return number.front() == '.' ? "p = " + number : "p " + number;
}

std::string journal_share(double share) { return percent(share, 1); }

std::string journal_interval(const Interval& interval) {
    return fmt::format("{:.1f} to {}", 100.0 * interval.low, journal_share(interval.high));
}

std::string journal_points(const Interval& interval) {
    return fmt::format("{:+.1f} to {:+.1f} points", 100.0 * interval.low, 100.0 * interval.high);
}

std::string verdict_line(const Analysis& analysis, const Verdict& verdict) {
    std::string text = verdict_words(verdict);
    if (!verdict.is_on_validity) {
        const auto result = std::find_if(
            analysis.hypotheses.begin(), analysis.hypotheses.end(),
            [&](const HypothesisResult& one) { return one.name == verdict.hypothesis; });
        if (result != analysis.hypotheses.end() && result->pooled.share_b.has_value()) {
            text += share_numbers(*result, verdict);
        }
    } else if (verdict.interval.has_value()) {
        text += fmt::format("; the share of B changes by {} (95 % CI)",
                            journal_points(*verdict.interval));
    }
    if (verdict.p.has_value()) text += ", " + journal_p_words(*verdict.p);
    if (verdict.p_holm.has_value()) {
        text += ", corrected " + journal_p(verdict.p_holm);
    }
    return text;
}

}  // namespace obscura::analysis
