// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/paper_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/conclusions/order_words.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/journal.h"

namespace obscura::analysis {
namespace {

/// `36 participants`; what the published votes do not say stays open.
std::string people(const Tally& tally) {
    return tally.n_participants.has_value() ? who(tally, *tally.n_participants)
                                            : "An unknown number of participants";
}

std::string showing_words(const ReportInput& input) {
    const StudyWords& study = input.study;
    const Tally& tally = input.analysis.tally;
    std::string text =
        fmt::format("{} judged {} of images (Table 1). ", capital(people(tally)),
                    counted(static_cast<std::int64_t>(tally.conditions.size()), "pair"));
    if (tally.kind == Kind::kSimulated) {
        text += "The observers are a program; nobody looked at the images. ";
    }
    text += "The two images of a pair show the same scene and differ in their ambient occlusion. ";
    if (study.question.empty()) return text + "One of the two had to be chosen.";
    return text + fmt::format(
                      "They were shown {}. The question was: \u201c{}\u201d One of the two images "
                      "had to be chosen, without a reference.",
                      study.shown, study.question);
}

std::string order_of_pairs(const std::string& order) {
    if (order == "latin-square") {
        return "The order of the pairs followed random Latin squares, a row for each participant; "
               "which image of a pair came first was exchanged from one square to the next.";
    }
    if (order == "williams") {
        return "The order of the pairs followed Williams designs, which balance what comes after "
               "what; which image of a pair came first was exchanged from one block to the next.";
    }
    if (order == "random")
        return "Each participant saw the pairs in a random order, drawn for each.";
    if (order == "fixed") return "Every participant saw the pairs in the same order.";
    return "";
}

std::string exclusion_words(const Possible<Exclusions>& exclusions) {
    if (!exclusions.has_value()) return "";
    return fmt::format(
        "A rule of the study file, fixed before the data, left out {} of {}; the results are of "
        "those who stayed.",
        exclusions->left_out, counted(exclusions->participants, "participant"));
}

std::string pair_tests(const Analysis& analysis) {
    return fmt::format(
        "The votes of each pair were held against an equal split by the two-sided exact binomial "
        "test, corrected over {} after Holm [@holm1979]; 95 % intervals of their shares are "
        "Wilson's [@wilson1927].",
        counted(static_cast<std::int64_t>(analysis.conditions.size()), "pair"));
}

std::string hypothesis_words(const Analysis& analysis) {
    std::vector<std::string> names;
    for (const HypothesisResult& result : analysis.hypotheses) {
        if (!result.pooling.has_value()) continue;
        names.push_back(fmt::format("{} ({}; {})", result.name, listed(result.conditions),
                                    result.pooling->words));
    }
    if (names.empty()) return "";
    if (analysis.tally.participants.empty()) {
        return fmt::format(
            "The votes of {} were added up and tested by the exact binomial test as if each "
            "participant had voted once, because who gave them is not known.",
            listed(names));
    }
    return fmt::format(
        "{} {} tested over participants: by flipping the signs of their summed preferences "
        "[@fisher1935].",
        listed(names), names.size() == 1 ? "was" : "were each");
}

std::string validity_tests(const Analysis& analysis) {
    if (!analysis.validity.has_value() || analysis.validity->by_level.empty()) return "";
    const Comparison& first = analysis.validity->by_level.front();
    const bool by_person = first.same_participants.has_value();
    const bool many = first.levels.size() > 2;
    return fmt::format(
        "{} was tested on the same two variants in the same scene at different levels of validity "
        "({}), {}.",
        analysis.validity->name,
        counted(static_cast<std::int64_t>(analysis.validity->by_level.size()), "comparison"),
        first.contrast.has_value()
            ? "by flipping the signs of each participant's difference [@fisher1935]"
        : !by_person ? "from counts by Fisher's exact test, as if different people had answered"
        : many       ? "within participants by Cochran's Q [@cochran1950]"
                     : "within participants by McNemar's exact test [@mcnemar1947]");
}

std::string correction_words(const Analysis& analysis) {
    if (analysis.verdicts.empty()) return "";
    const auto tests = std::max_element(
        analysis.verdicts.begin(), analysis.verdicts.end(),
        [](const Verdict& one, const Verdict& other) { return one.tests < other.tests; });
    return fmt::format(
        "{} of hypotheses {} corrected together [@holm1979] at a level of {:g}; a share within "
        "{:g} "
        "points of one half was called practically equal where two one-sided tests, each at "
        "the same level and not corrected over the hypotheses, said so "
        "[@schuirmann1987]. Scenes and views were fixed and not drawn, so that the results do not "
        "generalise to others [@clark1973].",
        capital(counted(static_cast<std::int64_t>(tests->tests), "test")),
        tests->tests == 1 ? "was" : "were", kSignificance, 100.0 * kRelevantDifference);
}

std::string pair_words(const Analysis& analysis) {
    std::vector<std::string> alone;
    std::vector<std::string> corrected;
    for (const ConditionResult& result : analysis.conditions) {
        if (!result.p_holm.has_value() || !result.preference.exact.has_value()) continue;
        const Preference& tests = result.preference;
        const double share = *tests.share_b;
        const std::string words =
            fmt::format("{} ({} chose {}, {}, corrected {})", result.condition.id,
                        journal_share(std::max(share, 1.0 - share)),
                        share > .5 ? result.condition.variant_b : result.condition.variant_a,
                        p_words(*tests.exact), p_words(PValue{*result.p_holm, 0.0}));
        if (tests.exact->p < kSignificance) alone.push_back(words);
        if (*result.p_holm < kSignificance) corrected.push_back(words);
    }
    std::string text =
        fmt::format("Of {} (Table 1, Figure 1), {} showed a preference after correction{}.",
                    counted(static_cast<std::int64_t>(analysis.conditions.size()), "pair"),
                    corrected.empty() ? "none" : std::to_string(corrected.size()),
                    corrected.empty() ? "" : ": " + listed(corrected));
    if (alone.size() > corrected.size()) {
        text += fmt::format(" Taken alone, {} would have passed: {}.", alone.size(), listed(alone));
    }
    return text;
}

/// What the numbers could show, whatever they were.
std::string power_words(const Possible<RunPower>& power) {
    if (!power.has_value() || !power->detectable_holm.has_value()) return "";
    return fmt::format(
        "With {} a pair the exact test, corrected over {}, finds a share of {} or more with {} "
        "probability; weaker preferences may be there and be missed.",
        counted(power->n, "answer"), counted(static_cast<std::int64_t>(power->tests), "pair"),
        journal_share(*power->detectable_holm), percent(kAskedPower));
}

/// Paragraphs without those that have nothing to say, joined with blanks.
std::string joined(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) {
        if (!sentence.empty()) text += (text.empty() ? "" : " ") + sentence;
    }
    return text;
}

}  // namespace

std::vector<std::string> method_paragraphs(const ReportInput& input) {
    const Analysis& analysis = input.analysis;
    return {
        joined({showing_words(input), order_of_pairs(input.study.order),
                exclusion_words(analysis.exclusions)}),
        joined({pair_tests(analysis), hypothesis_words(analysis), validity_tests(analysis),
                correction_words(analysis), analysis.look.has_value() ? analysis.look->words : "",
                fmt::format("Everything was computed by {} (seed {} of all draws).",
                            input.software.empty() ? "Obscura" : input.software, kAnalysisSeed)})};
}

std::vector<std::string> result_paragraphs(const ReportInput& input) {
    const Analysis& analysis = input.analysis;
    std::vector<std::string> verdicts;
    for (const Verdict& verdict : analysis.verdicts) {
        verdicts.push_back(
            fmt::format("{}: {}.", verdict.hypothesis, verdict_line(analysis, verdict)));
    }
    std::vector<std::string> paragraphs{
        joined({pair_words(analysis), power_words(analysis.power)})};
    if (!verdicts.empty()) paragraphs.push_back(joined(verdicts) + " Table 2 has all of it.");
    if (analysis.order_bias.has_value()) {
        const OrderBias& bias = *analysis.order_bias;
        paragraphs.push_back(fmt::format("The image shown second was chosen {} of {} times. {}",
                                         bias.votes.second_chosen, bias.votes.n,
                                         order_words(analysis)));
    }
    return paragraphs;
}

}  // namespace obscura::analysis
