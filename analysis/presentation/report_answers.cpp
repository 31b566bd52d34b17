// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/report_parts.h"
#include "analysis/statistics/holm.h"

namespace obscura::analysis {
namespace {

/// The verdict's sentence without the words that stand above it on the page.
std::string sentence_of(const Verdict& verdict) {
    const std::string said = fmt::format("{}: {}. ", verdict.hypothesis, verdict_words(verdict));
    return verdict.sentence.starts_with(said) ? verdict.sentence.substr(said.size())
                                              : verdict.sentence;
}

/// The published chi-square p-values after Holm's correction; every published condition has votes.
std::vector<double> chi_square_holm(const Analysis& analysis) {
    std::vector<double> p_values;
    for (const ConditionResult& result : analysis.conditions) {
        p_values.push_back(result.preference.chi_square->p.p);
    }
    return holm(p_values);
}

/// What the conditions say, before and after correction, in one or two sentences.
std::string overall_words(const Analysis& analysis) {
    std::vector<std::string> alone;
    std::vector<std::string> corrected;
    std::int64_t tests = 0;
    for (const ConditionResult& result : analysis.conditions) {
        if (!result.p_holm.has_value()) continue;
        ++tests;
        const Preference& preference = result.preference;
        const std::string words = fmt::format(
            "{} ({} preferred {})", result.condition.id,
            percent(std::max(*preference.share_b, 1.0 - *preference.share_b)),
            *preference.share_b > 0.5 ? result.condition.variant_b : result.condition.variant_a);
        if (preference.exact->p < kSignificance) alone.push_back(words);
        if (*result.p_holm < kSignificance) corrected.push_back(words);
    }
    if (tests == 0) return "There are no answers, so there is nothing to say.";
    std::string text = fmt::format(
        "{} {} compared, {} {} a preference that stays significant when the number of tests is "
        "accounted for{}",
        analysis.tally.n_participants.has_value()
            ? who(analysis.tally, *analysis.tally.n_participants) + " answered. Of"
            : "Of",
        counted(tests, "pair"), corrected.empty() ? "none" : std::to_string(corrected.size()),
        corrected.size() > 1 ? "show" : "shows",
        corrected.empty() ? "." : fmt::format(": {}.", listed(corrected)));
    if (alone.size() > corrected.size()) {
        text += fmt::format(" Taken alone, {} would have passed: {}.", alone.size(), listed(alone));
    }
    return text;
}

/// What a verdict answers, in the study's words where it has some.
std::string question_of(const Verdict& verdict) {
    const std::string role = verdict.is_primary ? "" : " (secondary)";
    if (!verdict.statement.empty()) {
        return fmt::format("{}{}: {}", verdict.hypothesis, role, verdict.statement);
    }
    return fmt::format("{}{}: {}", verdict.hypothesis, role,
                       verdict.is_on_validity ? "The preference depends on ecological validity."
                                              : "Image B is preferred in its conditions.");
}

/// How the thesis concluded on H3, and what a test says.
void add_validity_points(const ValidityResult& validity, std::vector<std::string>& points) {
    const auto crytek = [](const Comparison& comparison) {
        return comparison.variant_a == "Crytek24" && comparison.test.has_value();
    };
    const auto levels =
        std::find_if(validity.across_scenes.begin(), validity.across_scenes.end(), crytek);
    const auto pair = std::find_if(validity.by_level.begin(), validity.by_level.end(), crytek);
    if (levels == validity.across_scenes.end() || pair == validity.by_level.end()) return;
    points.push_back(fmt::format(
        "H3, the influence of validity, was concluded from one result being significant and "
        "another "
        "not, which is no test of their difference. Tested properly, Crytek24 against Blizzard24 "
        "gives {} between moderate and high in the same scene (Fisher's exact {}). Over all three "
        "levels it gives {} (chi-square {:.3f}, df {}), but the low one shows another scene, so "
        "that this is no test of validity.",
        p_words(pair->test->p), pair->fisher.has_value() ? p_words(*pair->fisher) : "none",
        p_words(levels->test->p), levels->test->statistic, levels->test->df));
}

}  // namespace

void add_answers(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    draft.page.heading("In short");
    draft.page.paragraph(overall_words(analysis));
    for (const Verdict& verdict : analysis.verdicts) {
        draft.page.answer(question_of(verdict), capital(verdict_words(verdict)),
                          capital(sentence_of(verdict)));
    }
    if (analysis.registration.has_value()) {
        draft.page.paragraph(registration_words(*analysis.registration));
    }
    if (analysis.look.has_value()) draft.page.paragraph(analysis.look->words);
    draft.page.fine_print("The rule behind the verdicts. " + analysis.family.words + ' ' +
                          verdict_rule());
}

void add_published_study(ReportDraft& draft) {
    const Analysis& analysis = draft.input.analysis;
    if (!is_published_votes(analysis.tally)) return;
    draft.page.heading("The thesis's Table 4, and what it did not say");
    PageTable table{{"Condition", "A", "B", "Votes A : B", "Chi-square", "p", "Printed chi-square",
                     "Printed p", "p, Holm", "p, exact", "p, exact, Holm"},
                    {}};
    const std::vector<double> by_chi_square = chi_square_holm(analysis);
    for (std::size_t i = 0; i < analysis.conditions.size(); ++i) {
        const ConditionResult& result = analysis.conditions[i];
        const PrintedTest& printed = printed_table_4()[i];
        table.rows.push_back(
            {result.condition.id, result.condition.variant_a, result.condition.variant_b,
             fmt::format("{} : {}", result.condition.votes.a, result.condition.votes.b),
             fmt::format("{:.3f}", result.preference.chi_square->statistic),
             fmt::format("{:.3f}", result.preference.chi_square->p.p), printed.chi_square,
             printed.p, fmt::format("{:.3f}", by_chi_square[i]),
             fmt::format("{:.3f}", result.preference.exact->p), cell(result.p_holm, 3)});
    }
    draft.page.table(
        table,
        "Pearson's chi-square against 18 : 18, df 1, without continuity correction, computed anew "
        "beside what the thesis prints (it cuts 0.0196 off to 0.019 and rounds 5.444 to 5.445). "
        "The thesis calls III and V significant.");
    std::vector<std::string> points{
        "Nothing stays significant after correcting for seven tests: the smallest p-value, 0.020 "
        "in III and V, becomes 0.137 by Holm's method, and 0.202 where the exact test is taken, "
        "which alone keeps what it says."};
    if (analysis.validity.has_value()) add_validity_points(*analysis.validity, points);
    points.push_back(
        "An even split such as 18 : 18 is not proof that people saw no difference: its 95 % "
        "interval reaches from 34 to 66 %.");
    points.push_back("What 36 answers a pair could have shown is in the part on power below.");
    draft.page.list(points);
}

}  // namespace obscura::analysis
