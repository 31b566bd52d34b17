// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "analysis/conclusions/model_check.h"
#include "analysis/conclusions/pooled_share.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/presentation/report_plots.h"
#include "analysis/statistics/mixed_logistic.h"

namespace obscura::analysis {
namespace {

const std::vector<std::string> kLevelNames{"low validity", "moderate validity", "high validity",
                                           "other"};

Plot shares_plot(const Analysis& analysis) {
    IntervalPlot plot;
    plot.name = "shares";
    plot.title = "Which image was chosen";
    plot.axis = "answers for image B (%), with 95 % Wilson interval";
    plot.groups = kLevelNames;
    plot.has_line = true;
    plot.line = 50.0;
    plot.left = "A preferred";
    plot.right = "B preferred";
    plot.x_low = 0.0;
    plot.x_high = 100.0;
    for (const ConditionResult* result : by_validity(analysis)) {
        const ConditionVotes& condition = result->condition;
        IntervalRow row;
        row.label =
            fmt::format("{}   {} | {}", condition.id, condition.variant_a, condition.variant_b);
        row.note = fmt::format("{} : {}", condition.votes.a, condition.votes.b);
        row.group = level_number(condition.validity);
        const Preference& preference = result->preference;
        if (preference.share_b.has_value() && preference.wilson.has_value()) {
            row.has_value = true;
            row.value = 100.0 * *preference.share_b;
            row.low = 100.0 * preference.wilson->low;
            row.high = 100.0 * preference.wilson->high;
        }
        plot.rows.push_back(row);
    }
    return interval_plot(plot);
}

std::string share_cell(const Possible<Interval>& interval) {
    if (!interval.has_value()) return kNoValue;
    return fmt::format("{:.1f} to {:.1f}", 100.0 * interval->low, 100.0 * interval->high);
}

PageTable shares_table(const Analysis& analysis) {
    PageTable table{{"Condition", "A", "B", "Votes A : B", "B (%)", "95 % interval (%)",
                     "Cohen's g", "Chi-square", "p", "p, exact", "p, Holm", "p, BH"},
                    {}};
    for (const ConditionResult* result : by_validity(analysis)) {
        const ConditionVotes& condition = result->condition;
        const Preference& tests = result->preference;
        const bool tested = tests.chi_square.has_value();
        table.rows.push_back(
            {condition.id, condition.variant_a, condition.variant_b,
             fmt::format("{} : {}", condition.votes.a, condition.votes.b),
             tests.share_b.has_value() ? fmt::format("{:.1f}", 100.0 * *tests.share_b) : kNoValue,
             share_cell(tests.wilson),
             tests.cohens_g.has_value() ? fmt::format("{:+.3f}", *tests.cohens_g) : kNoValue,
             tested ? fmt::format("{:.3f}", tests.chi_square->statistic) : kNoValue,
             tested ? p_cell(Possible<PValue>(tests.chi_square->p)) : kNoValue, p_cell(tests.exact),
             p_cell(result->p_holm), p_cell(result->p_bh)});
    }
    return table;
}

std::string bayes_cell(const Possible<BayesFactor>& factor) {
    constexpr double kShownAsPower = 4.0;
    if (!factor.has_value()) return kNoValue;
    if (std::abs(factor->log10_bf10) > kShownAsPower) {
        return fmt::format("10^{:.1f}", factor->log10_bf10);
    }
    return fmt::format("{:.2f}", *factor->bf10);
}

PageTable belief_table(const Analysis& analysis) {
    PageTable table{
        {"Condition", "Expected B (%)", "95 % credible (%)", "P(B preferred)", "Bayes factor"}, {}};
    for (const ConditionResult* result : by_validity(analysis)) {
        const Possible<Posterior>& belief = result->preference.posterior;
        const bool known = belief.has_value();
        table.rows.push_back({result->condition.id,
                              known ? fmt::format("{:.1f}", 100.0 * belief->mean) : kNoValue,
                              known ? share_cell(belief->interval) : kNoValue,
                              known ? p_cell(Possible<PValue>(belief->above_half)) : kNoValue,
                              bayes_cell(result->preference.bayes_factor)});
    }
    return table;
}

/// The conditions that nobody answered.
std::vector<std::string> unanswered(const Analysis& analysis) {
    std::vector<std::string> ids;
    for (const ConditionResult& result : analysis.conditions) {
        if (result.condition.votes.n() == 0) ids.push_back(result.condition.id);
    }
    return ids;
}

/// A test of several rows of votes as cells: statistic, df, p.
void add_test(std::vector<std::string>& row, const Possible<ChiSquareTest>& test) {
    row.push_back(test.has_value() ? fmt::format("{:.3f}", test->statistic) : kNoValue);
    row.push_back(test.has_value() ? std::to_string(test->df) : kNoValue);
    row.push_back(test.has_value() ? p_cell(Possible<PValue>(test->p)) : kNoValue);
}

/// The test over the same participants in few words.
std::string same_words(const SameParticipants& same) {
    if (same.mcnemar.has_value()) {
        return fmt::format("{} to A, {} to B, {} (McNemar, n {})", same.changed.a, same.changed.b,
                           p_words(same.mcnemar->exact), same.n);
    }
    if (!same.cochran_q.has_value()) return "none: " + same.cochran_q.reason;
    return fmt::format("Q {:.2f}, df {}, {} (Cochran, n {})", same.cochran_q->statistic,
                       same.cochran_q->df, p_words(same.cochran_q->p), same.n);
}

/// By how much the share of B differs between levels.
PageTable differences_table(const Analysis& analysis) {
    PageTable table{{"Variants A | B", "From", "To", "B changes by (points)",
                     "95 % interval (points)", "Interval from"},
                    {}};
    for (const Comparison& comparison : analysis.validity->by_level) {
        for (const LevelDifference& difference : comparison.differences) {
            table.rows.push_back(
                {fmt::format("{} | {}", comparison.variant_a, comparison.variant_b),
                 comparison.levels[difference.from], comparison.levels[difference.to],
                 fmt::format("{:+.1f}", 100.0 * difference.difference),
                 fmt::format("{:+.1f} to {:+.1f}", 100.0 * difference.interval.low,
                             100.0 * difference.interval.high),
                 std::string(to_string(difference.kind))});
        }
    }
    return table;
}

std::string heterogeneity_cell(const Possible<Heterogeneity>& heterogeneity) {
    if (!heterogeneity.has_value()) return kNoValue;
    return fmt::format("Q {:.2f}, df {}, {}", heterogeneity->test.statistic, heterogeneity->test.df,
                       p_words(heterogeneity->test.p));
}

/// The votes of each hypothesis together.
PageTable hypotheses_table(const Analysis& analysis) {
    PageTable table{{"Hypothesis", "Conditions", "Votes A : B", "B (%)", "95 % interval (%)", "p",
                     "95 % credible (%)", "P(B preferred)", "Do its conditions differ?"},
                    {}};
    for (const HypothesisResult& result : analysis.hypotheses) {
        const Preference& pooled = result.pooled;
        std::vector<std::string> row{result.name,
                                     fmt::format("{}", fmt::join(result.conditions, ", "))};
        if (!result.pooling.has_value()) {
            row.insert(row.end(),
                       {"not pooled", kNoValue, kNoValue, kNoValue, kNoValue, kNoValue, kNoValue});
            table.rows.push_back(row);
            continue;
        }
        const Possible<Posterior>& belief = result.posterior;
        row.insert(
            row.end(),
            {fmt::format("{} : {}", pooled.votes.a, pooled.votes.b),
             pooled.share_b.has_value() ? fmt::format("{:.1f}", 100.0 * *pooled.share_b) : kNoValue,
             result.interval.has_value() ? share_cell(Possible<Interval>(result.interval->bounds))
                                         : kNoValue,
             p_cell(p_of(result)),
             belief.has_value() ? share_cell(Possible<Interval>(belief->interval)) : kNoValue,
             belief.has_value() ? p_cell(Possible<PValue>(belief->above_half)) : kNoValue,
             heterogeneity_cell(result.heterogeneity)});
        table.rows.push_back(row);
    }
    return table;
}

std::vector<std::string> comparison_row(const Comparison& comparison) {
    std::vector<std::string> shares;
    for (std::size_t i = 0; i < comparison.votes.size(); ++i) {
        const Votes& votes = comparison.votes[i];
        shares.push_back(fmt::format("{} {}:{}", comparison.levels[i], votes.a, votes.b));
    }
    std::vector<std::string> row{fmt::format("{} | {}", comparison.variant_a, comparison.variant_b),
                                 comparison.view.empty() ? "several" : comparison.view,
                                 fmt::format("{}", fmt::join(comparison.conditions, ", ")),
                                 fmt::format("{}", fmt::join(shares, ", "))};
    add_test(row, comparison.test);
    row.push_back(p_cell(comparison.fisher));
    if (comparison.contrast.has_value()) {
        row.push_back(test_words(comparison));
    } else if (comparison.same_participants.has_value()) {
        row.push_back(same_words(*comparison.same_participants));
    } else {
        row.push_back(fmt::format("none: {}", comparison.same_participants.reason));
    }
    return row;
}

std::vector<std::string> model_row(const std::string& name, const Possible<ModelCheck>& model,
                                   const Possible<PValue>& tested) {
    if (!model.has_value()) {
        return {name,     "none: " + model.reason, kNoValue, kNoValue, kNoValue,
                kNoValue, p_cell(tested)};
    }
    const Possible<ModelTerm>& effect = model->effect;
    const bool has_one = effect.has_value();
    return {name,
            has_one ? fmt::format("{:+.3f} ({:.3f})", effect->log_odds, effect->standard_error)
                    : effect.reason,
            has_one ? fmt::format("{:+.2f} to {:+.2f}", effect->interval.low, effect->interval.high)
                    : kNoValue,
            p_cell(p_of(*model)),
            fmt::format("{:.3f}", model->sd),
            model->order.has_value() ? fmt::format("{:+.3f} ({:.3f})", model->order->log_odds,
                                                   model->order->standard_error)
                                     : kNoValue,
            p_cell(tested)};
}

/// The mixed models beside the tests of the verdicts.
void add_models(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    if (!analysis.has_model) return;
    draft.page.heading("The same by a mixed model", 3);
    PageTable table{{"What", "Log odds (SE)", "95 % interval", "p, model", "SD of participants",
                     "Order (SE)", "p, test"},
                    {}};
    for (const HypothesisResult& result : analysis.hypotheses) {
        table.rows.push_back(model_row(result.name, result.model, p_of(result)));
    }
    if (analysis.validity.has_value()) {
        for (const Comparison& comparison : analysis.validity->by_level) {
            table.rows.push_back(
                model_row(what_is_compared(comparison), comparison.model, p_of(comparison)));
        }
    }
    draft.page.table(
        table,
        fmt::format("A check of the verdicts' tests: logistic models with an intercept for each "
                    "participant, conditions and the order of showing fixed, by adaptive "
                    "Gauss-Hermite quadrature with {} nodes. Log odds of B, of a hypothesis the "
                    "mean over its conditions, of levels the change from the first to the second; "
                    "order: for the image shown second. p before correction.",
                    kMixedNodes));
    draft.page.paragraph(kScenesAreFixed);
}

void add_validity(ReportDraft& draft, const ValidityResult& validity) {
    draft.page.heading("Does the preference depend on validity?", 3);
    if (validity.by_level.empty()) {
        draft.page.paragraph(validity.sentence);
        return;
    }
    PageTable table{{"Variants A | B", "Scene", "Conditions", "Votes A : B", "Chi-square", "df",
                     "p", "p, Fisher", "Same participants"},
                    {}};
    for (const auto* list : {&validity.by_level, &validity.by_pair}) {
        for (const Comparison& comparison : *list) table.rows.push_back(comparison_row(comparison));
    }
    draft.page.table(
        table,
        "Is the share of B the same at each level, in the same scene? Chi-square, df, p: test of "
        "homogeneity from the counts, as if different people had answered at each level; Fisher's "
        "exact test where two are compared. Same participants: Cochran's Q, McNemar's test or, of "
        "several conditions at a level, the test by flipping the signs of each participant's "
        "change, which are the ones to read where each participant's answers are known (how many "
        "changed to A "
        "and to B).");
    if (!validity.without_partner.empty()) {
        draft.page.paragraph(capital(partner_words(validity.without_partner)));
    }
    const PageTable differences = differences_table(draft.input.analysis);
    if (differences.rows.empty()) return;
    draft.page.table(
        differences,
        "By how many percentage points the share of B changes from one level to another. Interval "
        "from: the same participants (exact limits of how many changed), t of the same "
        "participants' "
        "differences over several pairs, or counts (Newcombe).");
}

}  // namespace

void add_preferences(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("Which image was preferred");
    draft.plot(
        shares_plot(analysis),
        "Share of answers for image B in each pair, from low validity to high, with its 95 % "
        "Wilson interval. An interval that crosses the dashed line at 50 % leaves open which "
        "image people prefer. On the right the votes, A : B.");
    draft.page.table(
        shares_table(analysis),
        "Chi-square and p: Pearson's test against an equal split, df 1, no continuity correction. "
        "p, exact: two-sided binomial test. p, Holm: p, exact after Holm's correction over all "
        "conditions "
        "(the chance of any false alarm stays at 5 %); p, BH: after Benjamini and Hochberg's (the "
        "share of false alarms). Cohen's g: share of B minus one half; .05 is small, .15 medium, "
        ".25 large.");
    if (const auto empty = unanswered(analysis); !empty.empty()) {
        draft.page.paragraph(
            fmt::format("Nobody answered {}, so there is nothing to test there.", listed(empty)));
    }
    draft.page.heading("The same as degrees of belief", 3);
    draft.page.table(
        belief_table(analysis),
        "When every share was thought equally likely before: the share of B expected now, the "
        "interval that holds it with 95 % probability, the probability that B is preferred by more "
        "than half, and how many times likelier the votes are under some preference than under "
        "none "
        "(below 1 speaks against a preference).");
}

void add_hypotheses(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("The hypotheses in numbers");
    if (!analysis.hypotheses.empty()) {
        draft.page.table(
            hypotheses_table(analysis),
            "The votes of each hypothesis's conditions together, where B means the same in each of "
            "them. p and the intervals are those of the verdict, before correction: they take the "
            "votes of a participant as hanging together. Credible, P: of the share of B among "
            "people, each of whom has an own share, when every share and every correlation "
            "between two votes of a participant was thought equally likely before. Do its "
            "conditions differ: Cochran's Q of the participants who answered each.");
        std::vector<std::string> meanings;
        for (const HypothesisResult& result : analysis.hypotheses) {
            meanings.push_back(fmt::format(
                "{}: {}.", result.name,
                result.pooling.has_value() ? result.pooling->words : result.pooling.reason));
        }
        draft.page.list(meanings);
    }
    if (analysis.validity.has_value()) add_validity(draft, *analysis.validity);
    add_models(draft);
}

}  // namespace obscura::analysis
