// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/looks.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "analysis/conclusions/analysis.h"
#include "analysis/statistics/sign_flip.h"
#include "renderer/base/random.h"

namespace obscura::analysis {
namespace {

/// Beyond these the large-sample value stands for the simulated one.
constexpr std::int64_t kMostSimulated = 300;
constexpr int kStudies = 2000;

/// How many votes of a participant the largest hypothesis pools.
std::size_t most_pooled(const Tally& tally) {
    std::size_t most = 1;
    const Family family = family_of(tally);
    for (const PlannedHypothesis& hypothesis : family.hypotheses) {
        most = std::max(most, hypothesis.conditions.size());
    }
    return most;
}

/// The same test as of a preference, on studies in which nothing is preferred, at every look.
double simulated_error(const std::vector<std::int64_t>& looks, std::size_t votes) {
    base::Random random(kAnalysisSeed);
    int found = 0;
    for (int study = 0; study < kStudies; ++study) {
        std::vector<std::int64_t> differences;
        for (const std::int64_t participants : looks) {
            while (static_cast<std::int64_t>(differences.size()) < participants) {
                std::int64_t difference = 0;
                for (std::size_t i = 0; i < votes; ++i) difference += random.bits() % 2 ? 1 : -1;
                differences.push_back(difference);
            }
            const auto test = sign_flip(differences);
            if (!test.has_value() || test->p.p >= kSignificance) continue;
            ++found;
            break;
        }
    }
    return static_cast<double>(found) / kStudies;
}

double error_of(const Tally& tally, const std::vector<std::int64_t>& looks) {
    return looks.back() > kMostSimulated ? repeated_look_error(kSignificance, looks)
                                         : simulated_error(looks, most_pooled(tally));
}

std::string numbers(const std::vector<std::int64_t>& looks) {
    std::string text;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        text += i == 0 ? "" : i + 1 == looks.size() ? " and " : ", ";
        text += std::to_string(looks[i]);
    }
    return text;
}

/// Looks that nothing was spent for.
std::string uncorrected_words(const LookResult& look) {
    if (look.looks.size() < 2) return "";
    return fmt::format(
        " The answers were looked at {} times, with {} participants, and nothing was spent for it: "
        "a test at {:g} then finds something in {:.1f} % of the studies in which there is nothing "
        "to find, not in 5 %. The p-values here do not account for that.",
        look.looks.size(), numbers(look.looks), kSignificance, 100.0 * look.error);
}

std::string planned_words(const LookResult& look) {
    if (look.planned.empty()) return "The study planned no looks.";
    std::string text = fmt::format(
        "The study planned {} at {} participants",
        look.planned.size() == 1 ? "one look," : fmt::format("{} looks,", look.planned.size()),
        numbers(look.planned));
    const std::int64_t now = look.looks.back();
    if (look.is_planned) return text + fmt::format("; this is the one at {}.", now);
    return text + fmt::format("; this one, at {}, {}.", now,
                              look.is_interim ? "was not planned" : "is after all of them");
}

std::string spending_words(const LookResult& look) {
    return fmt::format(
        " It is look {}, by which {} spending (Lan and DeMets 1983) has used up {:.4f} of {:g}: a "
        "test alone counts from |z| {:.4f}, p {:.4f}. Every p-value of a verdict is that after "
        "spending.{}",
        look.looks.size(),
        look.spending == Spending::kPocock ? "Pocock's" : "O'Brien and Fleming's",
        look.boundary.spent, kSignificance, look.boundary.z, look.boundary.p,
        look.is_interim ? " More participants are planned: that images are equal is concluded only "
                          "at the last look."
                        : "");
}

/// The looks before this one that were planned, and those that are known to have been.
std::vector<std::int64_t> looks_until(const Tally& tally, const std::vector<std::int64_t>& planned,
                                      std::int64_t now) {
    std::vector<std::int64_t> looks = tally.looks_before;
    looks.insert(looks.end(), planned.begin(), planned.end());
    std::erase_if(looks, [&](std::int64_t look) { return look >= now; });
    looks.push_back(now);
    std::sort(looks.begin(), looks.end());
    looks.erase(std::unique(looks.begin(), looks.end()), looks.end());
    // The latest count: fewer looks spend no more.
    if (looks.size() > kMostLooks) looks.erase(looks.begin(), looks.end() - kMostLooks);
    return looks;
}

}  // namespace

double LookResult::spent(double p) const {
    return spending == Spending::kNone ? p : p_after_spending(p, spending, looks, planned.back());
}

Possible<LookResult> look_of(const Tally& tally) {
    using None = Possible<LookResult>;
    const auto now = static_cast<std::int64_t>(tally.participants.size());
    if (now == 0) return None::none("who voted is not known");
    LookResult look;
    if (tally.plan.has_value() && tally.plan->stopping) {
        look.planned = tally.plan->stopping->looks;
        look.spending = tally.plan->stopping->spending;
    }
    const bool is_spent = look.spending != Spending::kNone;
    // Without spending only those looks count that somebody had.
    look.looks = looks_until(tally, is_spent ? look.planned : std::vector<std::int64_t>(), now);
    if (look.planned.empty() && look.looks.size() < 2) {
        return None::none("the study plans no looks, and this is the first that is known");
    }
    look.is_planned =
        std::find(look.planned.begin(), look.planned.end(), now) != look.planned.end();
    look.is_interim = !look.planned.empty() && now < look.planned.back();
    if (is_spent) {
        look.boundary =
            look_boundaries(look.spending, kSignificance, look.looks, look.planned.back()).back();
        look.error = kSignificance;
    } else {
        look.boundary = look_boundaries(Spending::kNone, kSignificance, {now}, now).back();
        look.error = look.looks.size() > 1 ? error_of(tally, look.looks) : kSignificance;
    }
    look.words = planned_words(look) + (is_spent ? spending_words(look) : uncorrected_words(look));
    return look;
}

}  // namespace obscura::analysis
