// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/manifest.h"
#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/selection.h"
#include "stimuli/study.h"

namespace obscura::stimuli {

/// What a run of generate() did.
struct Generated {
    int made = 0;
    int copied = 0;         ///< of those, the same as another one and not rendered again
    int kept = 0;           ///< were there already, from the same inputs
    bool complete = false;  ///< every image of the study is there, and manifest.json lists them all
    std::vector<std::string> warnings;  ///< of pairs that are alike (pairs.h), a sentence each
    std::vector<ManifestPair> pairs;    ///< the selected ones, of which both images are finished
};

/// Makes the selected images in `folder`, without a display. Each file is written beside and
/// renamed; a finished one whose inputs are the same is kept. manifest.json lists, at any moment,
/// images that are finished and show what the study asks; parts (`shards` > 1) keep a list of their
/// own, manifest-K-of-N.json, and whichever part finds all images finished writes manifest.json and
/// removes those lists. Throws bad input for an
/// unknown pair or part, failure when a file cannot be written.
Generated generate(const Study& study, const Selection& selection,
                   const std::filesystem::path& folder, bool quiet,
                   const std::vector<BuiltinScene>& catalogue = builtin_scenes());

/// What verify() found.
struct Verified {
    int checked = 0;
    std::vector<std::string> problems;  ///< a sentence each, naming the file
    std::vector<std::string> warnings;  ///< of pairs that are alike (pairs.h), a sentence each
};

/// Renders the selected images in memory and says which files differ from what this program
/// renders, from the manifest, or are missing.
[[nodiscard]] Verified verify(const Study& study, const Selection& selection,
                              const std::filesystem::path& folder, bool quiet,
                              const std::vector<BuiltinScene>& catalogue = builtin_scenes());

}  // namespace obscura::stimuli
