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

/// `p = .031, corrected p = .062`
std::string tested(const Verdict& verdict, const PValue& p, const Possible<double>& p_holm) {
    const std::string words = p_words(p);
    if (!verdict.is_primary) return words + ", secondary and not corrected";
    if (!p_holm.has_value()) return words;
    return words + ", corrected " + p_words({*p_holm, 0.0});
}

/// Every comparison of a verdict on validity.
std::string compared_numbers(const Verdict& verdict) {
    std::string text;
    for (const ComparedVerdict& compared : verdict.compared) {
        text += "; " + listed(compared.conditions);
        if (compared.interval.has_value()) {
            text += fmt::format(": the share of B changes by {} (95 % CI)",
                                journal_points(*compared.interval));
        }
        if (compared.p.has_value()) text += ", " + tested(verdict, *compared.p, compared.p_holm);
    }
    return text;
}

}  // namespace

std::string journal_share(double share) { return percent(share, 1); }

std::string journal_interval(const Interval& interval) {
    return fmt::format("{:.1f} to {}", 100.0 * interval.low, journal_share(interval.high));
}

std::string journal_points(const Interval& interval) {
    return fmt::format("{:+.1f} to {:+.1f} points", 100.0 * interval.low, 100.0 * interval.high);
}

std::string verdict_line(const Analysis& analysis, const Verdict& verdict) {
    std::string text = verdict_words(verdict);
    if (verdict.conclusion == Conclusion::kNotTested) {  // its sentence says why
        text = verdict.sentence.substr(verdict.hypothesis.size() + 2);
        if (text.ends_with('.')) text.pop_back();
        return text;
    }
    if (!verdict.is_on_validity) {
        const auto result = std::find_if(
            analysis.hypotheses.begin(), analysis.hypotheses.end(),
            [&](const HypothesisResult& one) { return one.name == verdict.hypothesis; });
        if (result != analysis.hypotheses.end() && result->pooled.share_b.has_value()) {
            text += share_numbers(*result, verdict);
        }
    } else {
        return text + compared_numbers(verdict);
    }
    if (verdict.p.has_value()) text += ", " + tested(verdict, *verdict.p, verdict.p_holm);
    return text;
}

}  // namespace obscura::analysis
