// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "app/kiosk/choice_model.h"
#include "stimuli/manifest.h"
#include "stimuli/questions.h"
#include "stimuli/study.h"

namespace obscura::app {

/// The URL of a store in that file.
[[nodiscard]] std::string store_url_of(const std::filesystem::path& file);

/// A store of simulated answers is made anew each time; one that holds anybody's real answers is
/// not replaced. Throws bad input naming the option that the file comes from.
void refuse_real_answers(const std::filesystem::path& file, const std::string& option);

/// Who is simulated, and into which file.
struct Simulation {
    std::filesystem::path file;  ///< replaced once all is in it
    std::string option;          ///< that names it, for messages
    int participants = 36;
    std::uint64_t seed = 0;
    bool quiet = false;
    stimuli::Questions questions = {};  ///< that the study asks of each pair
};

/// Lets observers go through the kiosk's procedure into a new store, where every row says that they
/// are simulated. `manifest` is of the images that they would have seen.
void simulate_into_store(const stimuli::Study& study, const stimuli::Manifest& manifest,
                         const kiosk::ChoiceModel& choices, const Simulation& simulation);

}  // namespace obscura::app
