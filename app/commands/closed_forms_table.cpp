// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/closed_forms_table.h"

#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/reference/closed_forms.h"

namespace obscura::app {

void print_closed_forms(int rays, std::uint64_t seed) {
    fmt::print(
        "Accessibility, analytic and ray traced: means over 8x8 independent estimates of {} rays, "
        "seed {}.\n"
        "`se` is the mean's standard error, `pixel rms` the error of one estimate.\n"
        "Holds: difference <= 3 se + 2e-5, pixel rms <= 1e-3.\n\n"
        "{:<34} {:>9} {:>9} {:>8} {:>10} {:>9}\n",
        rays, seed, "scene", "analytic", "measured", "se", "difference", "pixel rms");
    const std::vector<renderer::ClosedForm> forms = renderer::closed_forms();
    int broken = 0;
    for (const renderer::ClosedForm& form : forms) {
        const renderer::ClosedFormCheck check = renderer::check_closed_form(form, rays, seed);
        fmt::print("{:<34} {:>9.6f} {:>9.6f} {:>8.1e} {:>+10.1e} {:>9.1e}  {}\n", check.name,
                   check.analytic, check.measured, check.standard_error,
                   check.measured - check.analytic, check.pixel_rms,
                   check.holds ? "holds" : "does not hold");
        if (!check.holds) ++broken;
    }
    const renderer::Convergence order = renderer::measure_convergence(forms, seed);
    fmt::print("\nError of one estimate over all of these with an error\n{:>6}  {:>8}\n", "rays",
               "rms");
    for (std::size_t i = 0; i < order.rays.size(); ++i) {
        fmt::print("{:>6}  {:>8.1e}\n", order.rays[i], order.rms[i]);
    }
    fmt::print("falls as rays^-{:.2f}; at least 0.70 is asked, plain Monte Carlo has 0.50: {}\n",
               order.order, order.holds ? "holds" : "does not hold");
    if (broken > 0 || !order.holds) {
        throw base::check_failed("{} of {} closed forms do not hold, order of convergence {:.2f}",
                                 broken, forms.size(), order.order);
    }
}

}  // namespace obscura::app
