// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/fit/minimise.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>

#include "renderer/base/check.h"
#include "renderer/base/random.h"

namespace obscura::analysis {
namespace {

void check(const Unknown& unknown) {
    const std::string where = "fit of " + unknown.name;
    if (!(unknown.high > unknown.low) || !std::isfinite(unknown.low) ||
        !std::isfinite(unknown.high)) {
        throw base::bad_input("{}: the range {} to {} is none", where, unknown.low, unknown.high);
    }
    if (unknown.logarithmic && !(unknown.low > 0.0)) {
        throw base::bad_input("{}: the lower end {} of a logarithmic range is not above 0", where,
                              unknown.low);
    }
    base::check_range(where, "start", unknown.start, unknown.low, unknown.high);
}

/// The search runs over the unit cube, so that a step means the same for every unknown.
double from_unit(const Unknown& unknown, double u) {
    u = std::clamp(u, 0.0, 1.0);
    const double value = unknown.logarithmic ? unknown.low * std::pow(unknown.high / unknown.low, u)
                                             : unknown.low + (unknown.high - unknown.low) * u;
    return std::clamp(value, unknown.low, unknown.high);
}

double to_unit(const Unknown& unknown, double value) {
    const double u = unknown.logarithmic
                         ? std::log(value / unknown.low) / std::log(unknown.high / unknown.low)
                         : (value - unknown.low) / (unknown.high - unknown.low);
    return std::clamp(u, 0.0, 1.0);  // rounding may lead beyond an end
}

constexpr double kVeryLarge = 1e100;

}  // namespace

Minimum minimise(const std::vector<Unknown>& unknowns,
                 const std::function<double(std::span<const double>)>& function,
                 const MinimiseOptions& options) {
    for (const Unknown& unknown : unknowns) check(unknown);
    base::check_range("fit", "starts", options.starts, 1, 1000);
    base::check_range("fit", "scouts", options.scouts, 0, 1'000'000);
    base::check_range("fit", "evaluations", options.evaluations, 1, 1'000'000);
    Minimum best;
    best.smallest = std::numeric_limits<double>::infinity();
    const std::function<double(const std::vector<double>&)> evaluate =
        [&](const std::vector<double>& values) {
            const double found = function(values);
            ++best.evaluations;
            const double value = std::isfinite(found) ? found : kVeryLarge;
            if (value < best.smallest) {
                best.smallest = value;
                best.values = values;
            }
            return value;
        };
    std::vector<double> start;
    for (const Unknown& unknown : unknowns) start.push_back(unknown.start);
    best.at_start = evaluate(start);
    if (unknowns.empty()) return best;

    struct Problem {
        const std::vector<Unknown>& unknowns;
        const std::function<double(const std::vector<double>&)>& evaluate;
        std::exception_ptr thrown;
    } problem{unknowns, evaluate, nullptr};
    const auto objective = [](const std::vector<double>& unit, std::vector<double>&, void* data) {
        auto& asked = *static_cast<Problem*>(data);
        std::vector<double> values;
        for (std::size_t i = 0; i < unit.size(); ++i) {
            values.push_back(from_unit(asked.unknowns[i], unit[i]));
        }
        try {
            return asked.evaluate(values);
        } catch (...) {
            asked.thrown = std::current_exception();  // NLopt would lose its type
            throw nlopt::forced_stop();
        }
    };
    base::Random random(options.seed);
    const auto random_point = [&] {
        std::vector<double> values;
        for (const Unknown& unknown : unknowns) {
            values.push_back(from_unit(unknown, random.uniform()));
        }
        return values;
    };
    for (int scout = 0; scout < options.scouts; ++scout) (void)evaluate(random_point());
    for (int search = 0; search < options.starts; ++search) {
        const std::vector<double> from = search == 0 ? best.values : random_point();
        std::vector<double> unit;
        for (std::size_t i = 0; i < from.size(); ++i) {
            unit.push_back(to_unit(unknowns[i], from[i]));
        }
        nlopt::opt optimiser(nlopt::LN_SBPLX, static_cast<unsigned>(unknowns.size()));
        optimiser.set_lower_bounds(0.0);
        optimiser.set_upper_bounds(1.0);
        optimiser.set_initial_step(0.15);
        optimiser.set_xtol_abs(options.tolerance);
        optimiser.set_maxeval(options.evaluations);
        optimiser.set_min_objective(+objective, &problem);
        double value = 0.0;
        try {
            optimiser.optimize(unit, value);
        } catch (const nlopt::roundoff_limited&) {
            // The search can go no further; the best point so far is kept.
        } catch (const nlopt::forced_stop&) {
            std::rethrow_exception(problem.thrown);
        }
    }
    return best;
}

}  // namespace obscura::analysis
