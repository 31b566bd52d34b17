// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// How often the tests of an analysis reject what is true, and its intervals hold it: simulated
// studies of the built-in study through the whole analysis, in per cent.
//   calibration_bench [STUDIES [STUDIES WITH THE MIXED MODEL [PARTICIPANTS]]]
// Nobody prefers anything over all people: a, no preference at all; b1, b2, likings of standard
// deviation 1 and 2 (log odds), shared over conditions; bl and bs, 2, apart for each level and each
// scene; order, b1 with the second image chosen by 60 %; careless, b1 with a fifth who always
// choose the first; varied, b1 with sides varied within a session. Preferences that differ between
// scenes only: scenes. What is there to be found: .65 a, every B preferred by that share, with b1's
// likings beside it .65 b1; high, by that share at the high level alone.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>

#include "tests/support/calibrated.h"

namespace {

using namespace obscura;

constexpr const char* kNames[]{"counts as independent",
                               "exact CMH by participant",
                               "sign flip of d",
                               "t of d",
                               "interval of d",
                               "H1, sign flip",
                               "H1, chi-square of votes",
                               "H1, mixed model",
                               "H1, within 15 points",
                               "H1, interval",
                               "H1, credible interval",
                               "H3, McNemar",
                               "H3, mixed model",
                               "H3, within 15 points",
                               "H3, interval",
                               "conditions differ, Q",
                               "conditions differ, mixed model",
                               "any verdict of the family",
                               "order",
                               "order, counts",
                               "order, interval",
                               "JOD, interval",
                               "JOD, 1.96 SE"};

void print(const std::vector<std::string>& head, const std::vector<tests::Rates>& columns) {
    fmt::print("{:31}", "");
    for (const std::string& name : head) fmt::print("{:>9}", name);
    fmt::print("\n");
    for (const char* name : kNames) {
        fmt::print("{:31}", name);
        for (const tests::Rates& rates : columns) {
            fmt::print("{:>9}",
                       rates.has(name) ? fmt::format("{:.1f}", 100.0 * rates.of(name)) : "-");
        }
        fmt::print("\n");
    }
}

}  // namespace

int main(int count, char** arguments) {
    const int studies = count > 1 ? std::atoi(arguments[1]) : 10'000;
    const int with_model = count > 2 ? std::atoi(arguments[2]) : 500;
    std::vector<tests::People> all = tests::nobody_prefers();
    all.push_back({.name = "varied", .sd = 1.0, .sides_vary = true});
    all.push_back(tests::scenes_differ());
    all.push_back({.name = ".65 a", .shares = {.65, .65, .65, .65, .65, .65, .65}});
    all.push_back({.name = ".65 b1", .sd = 1.0, .shares = {.65, .65, .65, .65, .65, .65, .65}});
    all.push_back({.name = "high", .sd = 1.0, .shares = {.5, .5, .5, .5, .65, .65, .65}});
    std::vector<int> sizes{12, 36, 120};
    if (count > 3) sizes = {std::atoi(arguments[3])};
    for (const int participants : sizes) {
        std::vector<std::string> head;
        std::vector<tests::Rates> columns;
        for (const tests::People& people : all) {
            head.push_back(people.name);
            tests::Rates& rates = columns.emplace_back();
            tests::count_studies(people, participants, studies, 1, false, rates);
            tests::count_studies(people, participants, with_model, 2, true, rates);
        }
        fmt::print("\n{} participants, {} studies ({} with the model), %\n", participants,
                   studies + with_model, with_model);
        print(head, columns);
        std::fflush(stdout);
    }
    return 0;
}
