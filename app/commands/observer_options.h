// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "app/commands/options.h"
#include "app/kiosk/choice_model.h"
#include "stimuli/study.h"

namespace obscura::app {

/// What simulated observers are told of themselves.
struct ObserverOptions {
    std::vector<std::string> shares = {};  ///< CONDITION=SHARE, or SHARE for all that are not named
    double sd = 0.0;
    double order_bias = 0.5;
    double careless = 0.0;
};

/// --sd, --order-bias, --careless.
std::vector<Option> add_own_options(const Options& app, ObserverOptions& options);

/// Those and --share.
void add_observer_options(const Options& app, ObserverOptions& options);

/// How they choose in that study; 1/2 where no share is given. Throws bad input naming the option,
/// the value and what is allowed.
[[nodiscard]] kiosk::ChoiceModel choices_from(const ObserverOptions& options,
                                              const stimuli::Study& study);

}  // namespace obscura::app
