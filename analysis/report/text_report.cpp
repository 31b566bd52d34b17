// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <sstream>

#include "analysis/report/analysis.h"

namespace obscura::analysis {
namespace {

using TextRow = std::vector<std::string>;

/// Letters on screen: UTF-8 bytes that begin one.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    }));
}

/// Columns two blanks apart; the first `left` are set to the left, the others to the right.
std::string aligned(const std::vector<TextRow>& rows, std::size_t left) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const TextRow& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], width_of(row[i]));
        }
    }
    std::string text;
    for (const TextRow& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string blanks(widths[i] - width_of(row[i]), ' ');
            if (i > 0) line += "  ";
            line += i < left ? row[i] + blanks : blanks + row[i];
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

/// Lines of at most 100 letters, broken at blanks and continued two blanks further in.
std::string wrapped(const std::string& text) {
    constexpr std::size_t kWidth = 100;
    std::istringstream lines(text);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        const std::string indent(line.find_first_not_of(' ') == 2 ? 4 : 2, ' ');
        while (width_of(line) > kWidth) {
            std::size_t end = line.rfind(' ', kWidth);
            if (end == std::string::npos || end < indent.size()) break;
            result += line.substr(0, end) + '\n';
            line = indent + line.substr(end + 1);
        }
        result += line + '\n';
    }
    return result;
}

constexpr const char* kNoValue = "-";

std::string number(const Possible<double>& value, const char* sign = "") {
    if (!value.has_value()) return kNoValue;
    return fmt::format(fmt::runtime(fmt::format("{{:{}.4f}}", sign)), *value);
}

std::string chi_square(const Possible<ChiSquareTest>& test) {
    constexpr double kShownInFull = 1e5;
    if (!test.has_value()) return kNoValue;
    return test->statistic < kShownInFull ? fmt::format("{:.4f}", test->statistic)
                                          : fmt::format("{:.6g}", test->statistic);
}

std::string interval(const Possible<Interval>& value) {
    return value.has_value() ? fmt::format("{:.4f} to {:.4f}", value->low, value->high) : kNoValue;
}

std::string p_value(const Possible<PValue>& value) {
    return value.has_value() ? p_text(*value) : kNoValue;
}

/// Corrected p-values carry no logarithm.
std::string p_holm(const Possible<double>& value) {
    constexpr double kSmallest = 1e-290;
    if (!value.has_value()) return kNoValue;
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
            tested ? p_text(preference.chi_square->p) : kNoValue,
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
    if (tally.n_participants.has_value()) {
        text += fmt::format("{} {}, {} conditions\n", *tally.n_participants, who,
                            tally.conditions.size());
    } else {
        text += fmt::format("Number of {} not known ({}), {} conditions\n", who,
                            tally.n_participants.reason, tally.conditions.size());
    }
    return text;
}

std::string pair_row(const Comparison& pair) {
    std::string text = fmt::format(
        "  {} against {}: {} ({}) {}:{}, {} ({}) {}:{}: ", pair.variant_a, pair.variant_b,
        pair.conditions[0], pair.levels[0], pair.votes[0].a, pair.votes[0].b, pair.conditions[1],
        pair.levels[1], pair.votes[1].a, pair.votes[1].b);
    if (!pair.test.has_value()) return text + fmt::format("no test, {}\n", pair.test.reason);
    return text + fmt::format("chi-square {:.4g}, df {}, p {}\n", pair.test->statistic,
                              pair.test->df, p_text(pair.test->p));
}

std::string order_bias_line(const Analysis& analysis) {
    if (!analysis.order_bias.has_value()) {
        return fmt::format("Order bias: not tested, {}.\n", analysis.order_bias.reason);
    }
    const OrderBias& bias = *analysis.order_bias;
    return fmt::format(
        "Order bias: the image shown second was chosen {} of {} times, exact p {}.\n",
        bias.votes.second_chosen, bias.votes.n, p_value(bias.exact));
}

}  // namespace

std::string text_report(const Analysis& analysis) {
    std::vector<TextRow> rows{{"condition", "for", "validity", "A", "B", "votes A:B", "share B",
                               "95 % interval", "g", "chi-sq", "p", "p exact", "p Holm"}};
    for (const ConditionResult& result : analysis.conditions) {
        rows.push_back(condition_row(result));
    }
    std::string text = heading(analysis.tally) + '\n' + aligned(rows, 5) + '\n';
    std::string words =
        "chi-sq, p: Pearson's chi-square test against an equal split, df 1, no continuity "
        "correction.\n"
        "p exact: two-sided exact binomial test. p Holm: p after Holm's correction over all "
        "conditions.\n"
        "95 % interval: Wilson's, of the share of B. g: Cohen's g, share of B minus one half.\n\n";
    words += analysis.sentence + '\n';
    for (const HypothesisResult& hypothesis : analysis.hypotheses) {
        words += hypothesis.sentence + '\n';
    }
    words += "H3: " + analysis.validity.sentence + '\n';
    for (const Comparison& pair : analysis.validity.by_pair) words += pair_row(pair);
    words +=
        "Votes that are pooled or compared here come from the same participants, which these "
        "tests of counts take as independent.\n";
    return text + wrapped(words + order_bias_line(analysis));
}

}  // namespace obscura::analysis
