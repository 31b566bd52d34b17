// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/statistics/power.h"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/presentation/text_layout.h"
#include "app/commands/list.h"
#include "app/commands/observer_options.h"
#include "app/commands/power_of_study.h"
#include "app/commands/study_argument.h"
#include "app/commands/study_power_text.h"
#include "renderer/base/check.h"

namespace obscura::app {
namespace {

using analysis::SplitTest;
using analysis::TestPower;
using Json = nlohmann::ordered_json;

struct PowerOptions {
    std::string study;           ///< empty: of one condition, from the binomial distribution
    std::vector<double> shares;  ///< empty: kShares, or of a study PowerRequest's
    ObserverOptions observers{.sd = PowerRequest().sd};
    int studies = PowerRequest().studies;
    std::uint64_t seed = PowerRequest().seed;
    double level = 0.05;
    double power = 0.8;
    int conditions = 1;
    std::optional<std::int64_t> participants;
    std::string curve;
    bool json = false;
    bool csv = false;

    /// What one condition must meet so that it passes Holm's correction whatever the others do.
    [[nodiscard]] double corrected_level() const { return level / conditions; }
};

/// Numbers of participants: first, first + step ... last.
struct Range {
    std::int64_t first = 0;
    std::int64_t last = 0;
    std::int64_t step = 1;
};

constexpr std::int64_t kMostRows = 10'000;
constexpr double kShares[] = {.55, .60, .65, .70, .75, .80};

Range range_from(const std::string& text) {
    Range range;
    const char* at = text.data();
    const char* const end = text.data() + text.size();
    const auto number = [&](std::int64_t& value) {
        const auto [next, error] = std::from_chars(at, end, value);
        const bool ok = error == std::errc() && value >= 1;
        at = next;
        return ok;
    };
    const auto colon = [&] { return at != end && *at++ == ':'; };
    const bool ok = number(range.first) && colon() && number(range.last) &&
                    (at == end || (colon() && number(range.step))) && at == end;
    if (!ok || range.last < range.first || range.last > analysis::kMostParticipants ||
        (range.last - range.first) / range.step >= kMostRows) {
        throw base::bad_input(
            "--curve {}: allowed is FROM:TO or FROM:TO:STEP, whole numbers 1 to {} that rise, at "
            "most {} of them",
            text, analysis::kMostParticipants, kMostRows);
    }
    return range;
}

void check(const PowerOptions& options) {
    const auto check_open = [](const char* name, double value) {
        if (!(value > 0.0 && value < 1.0)) {
            throw base::bad_input("{} {}: allowed is more than 0 and less than 1", name, value);
        }
    };
    for (const double share : options.shares) check_open("--share", share);
    check_open("--level", options.level);
    check_open("--power", options.power);
    base::check_range("power", "--conditions", options.conditions, 1, 1'000'000);
    if (options.participants) {
        base::check_range("power", "--participants", *options.participants, std::int64_t{1},
                          analysis::kMostParticipants);
    }
}

/// How many are needed for each share, and what a number of participants achieves.
struct PowerAnswers {
    struct Needed {
        double share;
        analysis::Possible<std::int64_t> exact;
        analysis::Possible<std::int64_t> chi_square;
        analysis::Possible<std::int64_t> corrected;  ///< exact, at the corrected level
    };
    struct Achieved {
        double share;
        TestPower exact;
        TestPower chi_square;
        TestPower corrected;
    };
    std::vector<Needed> needed;
    std::vector<Achieved> achieved;
    std::vector<Achieved> curve;  ///< by number of participants, then share
};

PowerAnswers::Achieved achieved_at(std::int64_t n, double share, const PowerOptions& options) {
    return {share, analysis::power_of(SplitTest::kExact, n, share, options.level),
            analysis::power_of(SplitTest::kChiSquare, n, share, options.level),
            analysis::power_of(SplitTest::kExact, n, share, options.corrected_level())};
}

PowerAnswers answers_to(const PowerOptions& options) {
    PowerAnswers answers;
    for (const double share : options.shares) {
        const auto needed = [&](SplitTest test, double level) {
            return analysis::participants_needed(test, share, level, options.power);
        };
        const auto exact = needed(SplitTest::kExact, options.level);
        answers.needed.push_back({share, exact, needed(SplitTest::kChiSquare, options.level),
                                  options.conditions == 1
                                      ? exact
                                      : needed(SplitTest::kExact, options.corrected_level())});
        if (options.participants) {
            answers.achieved.push_back(achieved_at(*options.participants, share, options));
        }
    }
    if (options.curve.empty()) return answers;
    const Range range = range_from(options.curve);
    for (std::int64_t n = range.first; n <= range.last; n += range.step) {
        for (const double share : options.shares) {
            answers.curve.push_back(achieved_at(n, share, options));
        }
    }
    return answers;
}

std::string number(const analysis::Possible<std::int64_t>& value) {
    return value.has_value() ? std::to_string(*value) : "-";
}

std::string needed_table(const PowerAnswers& answers, const PowerOptions& options) {
    std::vector<analysis::TextRow> rows{{"share", "exact", "chi-square"}};
    if (options.conditions > 1) rows.front().emplace_back("exact, Holm");
    for (const PowerAnswers::Needed& needed : answers.needed) {
        rows.push_back(
            {fmt::format("{:g}", needed.share), number(needed.exact), number(needed.chi_square)});
        if (options.conditions > 1) rows.back().push_back(number(needed.corrected));
    }
    return analysis::aligned(rows, 1);
}

std::string achieved_table(const std::vector<PowerAnswers::Achieved>& list,
                           const PowerOptions& options) {
    std::vector<analysis::TextRow> rows{
        {"participants", "share", "exact: power", "true size", "chi-square: power", "true size"}};
    if (options.conditions > 1) rows.front().emplace_back("exact, Holm: power");
    for (const PowerAnswers::Achieved& at : list) {
        rows.push_back({std::to_string(at.exact.n), fmt::format("{:g}", at.share),
                        fmt::format("{:.6f}", at.exact.power),
                        fmt::format("{:.6f}", at.exact.true_size),
                        fmt::format("{:.6f}", at.chi_square.power),
                        fmt::format("{:.6f}", at.chi_square.true_size)});
        if (options.conditions > 1)
            rows.back().push_back(fmt::format("{:.6f}", at.corrected.power));
    }
    return analysis::aligned(rows, 0);
}

std::string text_of(const PowerAnswers& answers, const PowerOptions& options) {
    std::string words = fmt::format(
        "Participants needed for {:g} % power at level {:g} (two-sided test of an equal split of "
        "one condition; the power stays there for the next {} numbers):\n",
        100.0 * options.power, options.level, analysis::kStaysForNext);
    std::string text = analysis::wrapped(words) + needed_table(answers, options);
    if (options.conditions > 1) {
        text += analysis::wrapped(fmt::format(
            "Holm: p below {:g} / {} = {:g}, with which a condition passes the correction for {} "
            "conditions whatever the others do.\n",
            options.level, options.conditions, options.corrected_level(), options.conditions));
    }
    if (!answers.achieved.empty()) {
        text += '\n' + achieved_table(answers.achieved, options) +
                analysis::wrapped(
                    "True size: the chance of a significant result where nothing is preferred; "
                    "above the level, the test claims more than it keeps.\n");
    }
    if (!answers.curve.empty()) text += '\n' + achieved_table(answers.curve, options);
    return text;
}

void put(Json& object, const char* name, const analysis::Possible<std::int64_t>& value) {
    if (value.has_value()) {
        object[name] = *value;
    } else {
        object[name] = nullptr;
        object[std::string(name) + "_reason"] = value.reason;
    }
}

Json json_of(const TestPower& power) {
    Json object;
    put(object, "critical_votes", power.critical_votes);
    object["power"] = power.power;
    object["true_size"] = power.true_size;
    return object;
}

Json json_of(const std::vector<PowerAnswers::Achieved>& list) {
    Json array = Json::array();
    for (const PowerAnswers::Achieved& at : list) {
        array.push_back({{"n", at.exact.n},
                         {"share", at.share},
                         {"exact", json_of(at.exact)},
                         {"chi_square", json_of(at.chi_square)},
                         {"exact_holm", json_of(at.corrected)}});
    }
    return array;
}

std::string json_of(const PowerAnswers& answers, const PowerOptions& options) {
    Json report;
    report["level"] = options.level;
    report["power"] = options.power;
    report["conditions"] = options.conditions;
    report["corrected_level"] = options.corrected_level();
    report["needed"] = Json::array();
    for (const PowerAnswers::Needed& needed : answers.needed) {
        Json& entry = report["needed"].emplace_back();
        entry["share"] = needed.share;
        put(entry, "exact", needed.exact);
        put(entry, "chi_square", needed.chi_square);
        put(entry, "exact_holm", needed.corrected);
    }
    report["at_participants"] = json_of(answers.achieved);
    report["curve"] = json_of(answers.curve);
    return report.dump(2) + '\n';
}

/// The curve, a row for each number of participants and share.
std::string csv_of(const std::vector<PowerAnswers::Achieved>& curve) {
    std::string text =
        "participants,share,exact_power,exact_true_size,chi_square_power,chi_square_true_size,"
        "exact_holm_power,exact_holm_true_size\n";
    for (const PowerAnswers::Achieved& at : curve) {
        text += fmt::format("{},{},{},{},{},{},{},{}\n", at.exact.n, at.share, at.exact.power,
                            at.exact.true_size, at.chi_square.power, at.chi_square.true_size,
                            at.corrected.power, at.corrected.true_size);
    }
    return text;
}

base::ExitCode power_of_conditions(PowerOptions options) {
    if (options.shares.empty()) options.shares.assign(std::begin(kShares), std::end(kShares));
    check(options);
    if (options.csv) {
        fmt::print("{}", csv_of(answers_to(options).curve));
        return base::ExitCode::kDone;
    }
    const PowerAnswers answers = answers_to(options);
    fmt::print("{}", options.json ? json_of(answers, options) : text_of(answers, options));
    return base::ExitCode::kDone;
}

PowerRequest request_of(const PowerOptions& options, bool quiet) {
    PowerRequest request;
    if (!options.shares.empty()) request.shares = options.shares;
    for (const double share : request.shares) {
        if (!(share > 0.5 && share < 1.0)) {
            throw base::bad_input("--share {}: allowed is more than .5 and less than 1", share);
        }
    }
    if (!(options.power > 0.0 && options.power < 1.0)) {
        throw base::bad_input("--power {}: allowed is more than 0 and less than 1", options.power);
    }
    if (options.participants) {
        base::check_range("power", "--participants", *options.participants, std::int64_t{1},
                          std::int64_t{kMostSimulated});
        request.participants = static_cast<int>(*options.participants);
    }
    base::check_range("power", "--studies", options.studies, 100, 100'000);
    request.sd = options.observers.sd;
    request.order_bias = options.observers.order_bias;
    request.careless = options.observers.careless;
    request.studies = options.studies;
    request.seed = options.seed;
    request.power = options.power;
    request.quiet = quiet;
    return request;
}

base::ExitCode power_of_verdicts(const PowerOptions& options, const Globals& globals) {
    const stimuli::Study study =
        stimuli::load_study(study_named(options.study, globals), stimuli::SceneFiles::kTrusted);
    (void)choices_from(options.observers, study);  // what it refuses
    const PowerRequest request = request_of(options, globals.quiet || options.json);
    const auto results = power_of_study(study, request);
    fmt::print("{}", options.json ? study_power_json(study, request, results)
                                  : study_power_text(study, request, results));
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_power(const Options& app, const Globals& globals) {
    auto options = std::make_shared<PowerOptions>();
    const Option study = add_study(app, options->study,
                                   "none: of one condition alone; of a study it is the power of "
                                   "its verdicts, by simulating it as planned");
    for (const Option& own : add_own_options(app, options->observers)) own.needs(study);
    app.add("--studies", options->studies, "Simulated studies for each number (100 to 100000)")
        .shows_default()
        .needs(study);
    app.add("--seed", options->seed, "Seed of the simulation").shows_default().needs(study);
    app.add("--share", options->shares,
            "True share of votes for B, at least .001 from .5 (0 to 1): one or several to compare "
            "(default: .55 .60 .65 .70 .75 .80; of a study .65)");
    const Option level =
        app.add("--level", options->level, "p below which a result is significant (0 to 1)")
            .shows_default();
    app.add("--power", options->power, "Chance of a significant result (0 to 1)").shows_default();
    const Option conditions = app.add("--conditions", options->conditions,
                                      "Conditions that are tested, corrected by Holm's method")
                                  .shows_default();
    app.add("--participants", options->participants,
            "Say what power this number of participants has");
    const Option curve = app.add("--curve", options->curve, "Power over numbers of participants")
                             .type("FROM:TO[:STEP]");
    const Option json = app.add_flag("--json", options->json, "Print JSON");
    app.add_flag("--csv", options->csv, "Print the curve alone, as CSV")
        .needs(curve)
        .excludes({json});
    study.excludes({level, conditions, curve});
    return [options, &globals] {
        return options->study.empty() ? power_of_conditions(*options)
                                      : power_of_verdicts(*options, globals);
    };
}

}  // namespace

Command power_command() {
    return {"power", "Find how many participants a study needs", attach_power};
}

}  // namespace obscura::app
