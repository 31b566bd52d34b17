// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/text_sections.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "analysis/conclusions/words.h"
#include "analysis/presentation/cells.h"
#include "analysis/presentation/text_layout.h"

namespace obscura::analysis {
namespace {

constexpr double kPercent = 100.0;

std::string share(const Possible<double>& value) {
    return value.has_value() ? fmt::format("{:.4f}", *value) : kNoText;
}

/// Successes of all together and the participants' own shares, or that there were no such trials.
std::string attention_line(const char* what, const Successes& trials,
                           const Possible<Quartiles>& shares) {
    if (!shares.has_value()) return fmt::format("{}: none.\n", what);
    return fmt::format(
        "{}: {} of {} ({:.1f} %); of the own shares of {} the median is {:.1f} %, half lie "
        "between {:.1f} and {:.1f} %.\n",
        what, trials.successes, trials.n,
        kPercent * static_cast<double>(trials.successes) / static_cast<double>(trials.n),
        counted(shares->n, "participant"), kPercent * shares->median, kPercent * shares->first,
        kPercent * shares->third);
}

TextRow times_row(const std::string& name, const Possible<ResponseTimeSummary>& times) {
    if (!times.has_value()) return {name, "0", kNoText, kNoText, kNoText, kNoText};
    const Possible<Interval>& interval = times->median_interval;
    return {name,
            std::to_string(times->seconds.n),
            fmt::format("{:.3f}", times->seconds.median),
            interval.has_value() ? fmt::format("{:.3f} to {:.3f}", interval->low, interval->high)
                                 : kNoText,
            fmt::format("{:.3f}", times->seconds.first),
            fmt::format("{:.3f}", times->seconds.third)};
}

std::string learning_words(const Learning& learning) {
    std::string text = "Over the session: ";
    if (learning.time.has_value()) {
        const TimeTrend& trend = *learning.time;
        text += fmt::format("response times change by {:+.4f} s a trial (median slope of {}",
                            trend.slope_s, counted(trend.participants, "participant"));
        text += trend.interval.has_value()
                    ? fmt::format(", 95 % interval {:+.4f} to {:+.4f})", trend.interval->low,
                                  trend.interval->high)
                    : fmt::format("; no interval, {})", trend.interval.reason);
    } else {
        text += fmt::format("no trend of response times, {}", learning.time.reason);
    }
    if (!learning.choice.has_value()) {
        return text + fmt::format("; no trend of the choice, {}.\n", learning.choice.reason);
    }
    const StratifiedSlope& slope = *learning.choice;
    return text + fmt::format(
                      "; the log odds of choosing B change by {:+.4f} a trial (standard "
                      "error {:.4f}, likelihood ratio {:.4f}, df 1, {}).\n",
                      slope.slope, slope.standard_error, slope.likelihood_ratio.statistic,
                      p_words(slope.likelihood_ratio.p));
}

std::string left_out_words(const Attention& attention) {
    constexpr std::size_t kMostNamed = 20;
    std::string text;
    std::size_t named = 0;
    std::size_t count = 0;
    for (const ParticipantResult& who : attention.participants) {
        if (who.left_out.empty() || ++count > kMostNamed) continue;
        ++named;
        text += fmt::format("  {}: {}\n", who.id, fmt::join(who.left_out, "; "));
    }
    if (count > named) text += fmt::format("  and {} more\n", count - named);
    return text;
}

}  // namespace

std::string verdicts_text(const Analysis& analysis) {
    std::string text = "\n";
    for (const Verdict& verdict : analysis.verdicts) text += verdict.sentence + '\n';
    if (analysis.registration.has_value()) {
        text += registration_words(*analysis.registration) + '\n';
    }
    if (analysis.look.has_value()) text += analysis.look->words + '\n';
    return wrapped(text + analysis.family.words + ' ' + verdict_rule() + '\n');
}

std::string power_text(const Possible<RunPower>& power) {
    if (!power.has_value()) return wrapped(fmt::format("\nPower: {}.\n", power.reason));
    std::string text = wrapped(fmt::format(
        "\nPower of what was run: the chance that {} a condition {} significant at {:g}, "
        "for a true share of the preferred image; with Holm's correction for {}, at the "
        "level that passes whatever the others do. True size: the same where nothing is "
        "preferred.\n",
        counted(power->n, "vote"), power->n == 1 ? "is" : "are", kSignificance,
        counted(static_cast<std::int64_t>(power->tests), "test")));
    std::vector<TextRow> rows{{"share", "exact", "exact, Holm", "chi-square"}};
    for (const RunPower::At& at : power->shares) {
        rows.push_back({fmt::format("{:g}", at.share), fmt::format("{:.4f}", at.exact.power),
                        fmt::format("{:.4f}", at.holm.power),
                        fmt::format("{:.4f}", at.chi_square.power)});
    }
    const RunPower::At& any = power->shares.front();
    rows.push_back({"true size", fmt::format("{:.4f}", any.exact.true_size),
                    fmt::format("{:.4f}", any.holm.true_size),
                    fmt::format("{:.4f}", any.chi_square.true_size)});
    rows.push_back({fmt::format("share at {:g} % power", kPercent * kAskedPower),
                    share(power->detectable), share(power->detectable_holm), ""});
    return text + aligned(rows, 1) +
           wrapped(
               "What the answers leave possible, their intervals say: power at the share that was "
               "observed would say no more than p does (Hoenig and Heisey 2001).\n");
}

std::string attention_text(const Analysis& analysis) {
    if (!analysis.attention.has_value()) return "";
    const Attention& attention = *analysis.attention;
    Successes majority;
    for (const ParticipantResult& who : attention.participants) {
        majority.n += who.with_majority.n;
        majority.successes += who.with_majority.successes;
    }
    return wrapped(
        '\n' +
        attention_line("Catch trials with the expected answer", attention.catch_trials,
                       attention.catch_share) +
        attention_line("Repeated conditions with the same answer", attention.repeats,
                       attention.repeat_share) +
        attention_line("Votes with most of the others", majority, attention.majority_share));
}

std::string response_times_text(const Analysis& analysis) {
    std::string text;
    if (analysis.response_times.has_value()) {
        text += wrapped(
            "\nResponse times in s, each participant with one median; the interval is "
            "of the median, from order statistics.\n");
        std::vector<TextRow> rows{{"condition", "participants", "median", "95 % interval",
                                   "first quartile", "third quartile"}};
        const auto& by_condition = analysis.response_times->by_condition;
        for (std::size_t i = 0; i < by_condition.size(); ++i) {
            rows.push_back(times_row(analysis.conditions[i].condition.id, by_condition[i]));
        }
        rows.push_back(times_row("all", analysis.response_times->overall));
        text += aligned(rows, 1);
    }
    if (analysis.learning.has_value()) text += wrapped(learning_words(*analysis.learning));
    return text;
}

std::string exclusions_text(const Analysis& analysis) {
    if (!analysis.exclusions.has_value()) return "";
    const Exclusions& exclusions = *analysis.exclusions;
    std::string text =
        fmt::format("\nThe study's rule, fixed before the data, leaves out who has {}: {} of {}.\n",
                    rule_words(exclusions.rule), exclusions.left_out,
                    counted(exclusions.participants, "participant"));
    if (exclusions.left_out == 0) return wrapped(text);
    text += left_out_words(*analysis.attention);
    text += "All above is without them. With everybody:\n";
    for (const Verdict& verdict : exclusions.everybody->verdicts) text += verdict.sentence + '\n';
    if (exclusions.changes.empty()) text += "Leaving them out changes no conclusion.\n";
    for (const std::string& change : exclusions.changes) text += "Changed: " + change + '\n';
    return wrapped(text);
}

}  // namespace obscura::analysis
