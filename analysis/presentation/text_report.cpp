// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/text_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "analysis/conclusions/model_check.h"
#include "analysis/conclusions/order_words.h"
#include "analysis/conclusions/pooled_share.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/text_layout.h"
#include "analysis/presentation/text_sections.h"
#include "analysis/statistics/mixed_logistic.h"

namespace obscura::analysis {
namespace {

std::string number(const Possible<double>& value, const char* sign = "") {
    if (!value.has_value()) return kNoText;
    return fmt::format(fmt::runtime(fmt::format("{{:{}.4f}}", sign)), *value);
}

std::string chi_square(const Possible<ChiSquareTest>& test) {
    constexpr double kShownInFull = 1e5;
    if (!test.has_value()) return kNoText;
    return test->statistic < kShownInFull ? fmt::format("{:.4f}", test->statistic)
                                          : fmt::format("{:.6g}", test->statistic);
}

std::string interval(const Possible<Interval>& value) {
    return value.has_value() ? fmt::format("{:.4f} to {:.4f}", value->low, value->high) : kNoText;
}

std::string p_value(const Possible<PValue>& value) {
    return value.has_value() ? p_text(*value) : kNoText;
}

/// Corrected p-values carry no logarithm.
std::string p_holm(const Possible<double>& value) {
    constexpr double kSmallest = 1e-290;
    if (!value.has_value()) return kNoText;
    return *value < kSmallest ? fmt::format("<{:g}", kSmallest) : p_text({*value, 0.0});
}

TextRow condition_row(const ConditionResult& result) {
    const ConditionVotes& condition = result.condition;
    const Preference& preference = result.preference;
    const bool tested = preference.chi_square.has_value();
    return {condition.id,
            condition.hypothesis,
            condition.validity,
            condition.variant_a,
            condition.variant_b,
            fmt::format("{}:{}", condition.votes.a, condition.votes.b),
            number(preference.share_b),
            interval(preference.wilson),
            number(preference.cohens_g, "+"),
            chi_square(preference.chi_square),
            tested ? p_text(preference.chi_square->p) : kNoText,
            p_value(preference.exact),
            p_holm(result.p_holm)};
}

std::string heading(const Tally& tally) {
    std::string text = fmt::format("Answers in {}", tally.source);
    if (!tally.study.empty()) text += fmt::format(", study {}", tally.study);
    text += '\n';
    if (tally.kind == Kind::kSimulated) {
        text += "SIMULATED DATA: these answers were made by simulated observers, not by people.\n";
    }
    const char* who = tally.kind == Kind::kSimulated ? "simulated observers" : "participants";
    const std::string conditions =
        counted(static_cast<std::int64_t>(tally.conditions.size()), "condition");
    if (tally.n_participants.has_value()) {
        const std::string_view all_of_them = who;
        text +=
            fmt::format("{} {}, {}\n", *tally.n_participants,
                        *tally.n_participants == 1 ? all_of_them.substr(0, all_of_them.size() - 1)
                                                   : all_of_them,
                        conditions);
    } else {
        text += fmt::format("Number of {} not known ({}), {}\n", who, tally.n_participants.reason,
                            conditions);
    }
    return text;
}

std::string pair_row(const Comparison& pair) {
    return fmt::format("  {} against {}: {} ({}) {}:{}, {} ({}) {}:{}: {}\n", pair.variant_a,
                       pair.variant_b, pair.conditions[0], pair.levels[0], pair.votes[0].a,
                       pair.votes[0].b, pair.conditions[1], pair.levels[1], pair.votes[1].a,
                       pair.votes[1].b, test_words(pair));
}

/// What was found on validity; nothing where it was not asked.
std::string validity_words(const Possible<ValidityResult>& validity) {
    if (!validity.has_value()) return "";
    std::string words = fmt::format("{}: {}\n", validity->name, validity->sentence);
    for (const Comparison& pair : validity->by_pair) words += pair_row(pair);
    for (const Comparison& levels : validity->across_scenes) {
        words += fmt::format(
            "  Over different scenes, as the thesis compared them, and so no test of validity: {}: "
            "{}.\n",
            what_is_compared(levels), test_words(levels));
    }
    return words;
}

std::string order_bias_line(const Analysis& analysis) {
    if (!analysis.order_bias.has_value()) {
        return fmt::format("Order bias: not tested, {}.\n", analysis.order_bias.reason);
    }
    const OrderBias& bias = *analysis.order_bias;
    std::string text =
        fmt::format("Order bias: the image shown second was chosen {} of {} times. {}",
                    bias.votes.second_chosen, bias.votes.n, order_words(analysis));
    if (!bias.logistic.has_value()) {
        return text + fmt::format(" No logistic regression: {}.\n", bias.logistic.reason);
    }
    const OrderBiasTest& test = *bias.logistic;
    return text + fmt::format(
                      " Logistic regression over {}, which takes every answer as independent: of "
                      "two equally liked images the second is "
                      "chosen {:.1f} % of the time (order term {:+.4f}, standard error {:.4f}), "
                      "likelihood "
                      "ratio {:.4f}, df 1, {}.\n",
                      counted(test.conditions, "condition"), 100.0 * test.second_share,
                      test.order_term, test.standard_error, test.likelihood_ratio.statistic,
                      p_words(test.likelihood_ratio.p));
}

std::string bayes_factor_text(const Possible<BayesFactor>& factor) {
    constexpr double kShownAsPower = 6.0;
    if (!factor.has_value()) return kNoText;
    if (std::abs(factor->log10_bf10) > kShownAsPower) {
        return fmt::format("10^{:.2f}", factor->log10_bf10);
    }
    return fmt::format("{:.4g}", *factor->bf10);
}

/// What to believe of each share after the votes.
std::string belief_lines(const Analysis& analysis) {
    std::vector<TextRow> rows{
        {"condition", "share B expected", "95 % credible", "P(B preferred)", "BF10"}};
    for (const ConditionResult& result : analysis.conditions) {
        const Possible<Posterior>& posterior = result.preference.posterior;
        const bool known = posterior.has_value();
        rows.push_back({result.condition.id,
                        known ? fmt::format("{:.4f}", posterior->mean) : kNoText,
                        known ? interval(posterior->interval) : kNoText,
                        known ? p_text(posterior->above_half) : kNoText,
                        bayes_factor_text(result.preference.bayes_factor)});
    }
    return aligned(rows, 1);
}

/// The variants of one connected group, or why they have no scale.
std::string scale_text(const VariantScale& scale) {
    const std::string names = fmt::format("{}", fmt::join(scale.variants, ", "));
    if (!scale.thurstone.has_value()) {
        return wrapped(fmt::format("No scale of {}: {}.\n", names, scale.thurstone.reason));
    }
    std::vector<TextRow> rows{
        {"variant", "JOD", "standard error", "95 % interval", "log odds", "standard error"}};
    const bool has_errors = scale.jod_intervals.has_value();
    for (std::size_t i = 0; i < scale.variants.size(); ++i) {
        const Possible<Scale>& odds = scale.bradley_terry;
        const auto error = [&](const Possible<Scale>& own) {
            return has_errors && own.has_value() ? fmt::format("{:.4f}", own->standard_errors[i])
                                                 : std::string(kNoText);
        };
        rows.push_back(
            {scale.variants[i], fmt::format("{:+.4f}", scale.thurstone->values[i]),
             error(scale.thurstone),
             has_errors ? fmt::format("{:+.4f} to {:+.4f}", (*scale.jod_intervals)[i].low,
                                      (*scale.jod_intervals)[i].high)
                        : kNoText,
             odds.has_value() ? fmt::format("{:+.4f}", odds->values[i]) : kNoText, error(odds)});
    }
    return aligned(rows, 1) + wrapped(scale_words(scale) + '\n');
}

std::string scales_text(const Analysis& analysis) {
    if (analysis.scales.empty()) return "";
    std::string text = wrapped(
        "\nOne scale over the variants that pairs connect, all conditions together, against the "
        "first. JOD: Thurstone's Case V, 1 JOD is chosen by 75 %. Log odds: Bradley-Terry.\n");
    for (const VariantScale& scale : analysis.scales) text += '\n' + scale_text(scale);
    return text;
}

/// The mixed models beside the tests of the verdicts; nothing where they were not asked for.
std::string models_text(const Analysis& analysis) {
    if (!analysis.has_model) return "";
    std::string text = fmt::format(
        "\nMixed models as a check of the verdicts' tests: logistic, conditions and order fixed, "
        "an "
        "intercept for each participant, maximum likelihood by adaptive Gauss-Hermite quadrature "
        "with {} nodes, errors from the Hessian. Of hypotheses the mean log odds of B over their "
        "conditions, of levels the change from one to the other.\n",
        kMixedNodes);
    for (const HypothesisResult& result : analysis.hypotheses) {
        text += fmt::format("{}: {}.\n", result.name, model_words(result.model, p_of(result)));
    }
    if (analysis.validity.has_value()) {
        for (const Comparison& comparison : analysis.validity->by_level) {
            text +=
                fmt::format("{}, {}: {}.\n", analysis.validity->name, what_is_compared(comparison),
                            model_words(comparison.model, p_of(comparison)));
        }
    }
    return wrapped(text + kScenesAreFixed + '\n');
}

std::string caveats_text(const std::vector<Caveat>& caveats) {
    if (caveats.empty()) return "";
    std::string text = "\nTo know before believing it:\n";
    for (const Caveat& caveat : caveats) {
        text += fmt::format("- {}: {}\n", caveat.about, caveat.sentence);
    }
    return wrapped(text);
}

}  // namespace

std::string text_report(const Analysis& analysis, const std::vector<Caveat>& caveats) {
    std::vector<TextRow> rows{{"condition", "for", "validity", "A", "B", "votes A:B", "share B",
                               "95 % interval", "g", "chi-sq", "p", "p exact", "p Holm"}};
    for (const ConditionResult& result : analysis.conditions) {
        rows.push_back(condition_row(result));
    }
    std::string text = heading(analysis.tally) + '\n' + aligned(rows, 5) + '\n';
    std::string words =
        "chi-sq, p: Pearson's chi-square test against an equal split, df 1, no continuity "
        "correction.\n"
        "p exact: two-sided exact binomial test. p Holm: p exact after Holm's correction over all "
        "conditions.\n"
        "95 % interval: Wilson's, of the share of B. g: Cohen's g, share of B minus one half.\n\n";
    text += wrapped(words) + belief_lines(analysis) + '\n';
    words =
        "Expected, credible, P: of the share of B, when every share was thought equally likely "
        "before (posterior with a flat prior). BF10: how many times likelier the votes are when "
        "the share may be anything than when it is one half.\n\n";
    words += analysis.sentence + '\n';
    for (const HypothesisResult& hypothesis : analysis.hypotheses) {
        words += hypothesis.sentence + '\n';
    }
    words += validity_words(analysis.validity);
    words +=
        "Votes that are pooled or compared here come from the same participants, which tests of "
        "counts take as independent; Cochran's, McNemar's and the test by flipping signs do "
        "not.\n";
    return text + wrapped(words + order_bias_line(analysis)) + verdicts_text(analysis) +
           models_text(analysis) + caveats_text(caveats) + power_text(analysis.power) +
           scales_text(analysis) + attention_text(analysis) + response_times_text(analysis) +
           exclusions_text(analysis);
}

}  // namespace obscura::analysis
