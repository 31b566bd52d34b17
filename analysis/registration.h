// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "analysis/tally.h"

namespace obscura::analysis {

/// What a pre-registration fixes, for a program to read: the object of JSON at the end of the
/// document.
struct Registration {
    std::string study;
    std::string study_sha256;
    std::string study_plan;  ///< SessionRecord::study_plan
    std::string exclusion;   ///< SessionRecord::exclusion
    std::int64_t participants = 0;
    std::uint64_t analysis_seed = 0;
    std::string software;
    std::string written_utc;
    std::map<std::string, std::string> images;  ///< SHA-256 by file
};

/// What stands for that in a document of Markdown, from its own line on.
[[nodiscard]] std::string registration_block(const Registration& registration);

/// The block of a document. Throws bad input naming the file for one that has none or a wrong one.
[[nodiscard]] Registration read_registration(const std::filesystem::path& document);

/// What an analysis knows of what a pre-registration fixes.
struct Conducted {
    std::string software;
    std::uint64_t analysis_seed = 0;
    bool asks_validity = false;  ///< though the plan does not
    /// SHA-256 of the images that were shown, by their file; empty with a reason: not known.
    Possible<std::map<std::string, std::vector<std::string>>> images =
        Possible<std::map<std::string, std::vector<std::string>>>::none("the answers do not say");
};

/// What came of a pre-registration.
struct RegistrationResult {
    std::string document;
    std::string written_utc;
    std::vector<std::string> deviations;  ///< a sentence each
    std::vector<std::string> unknown;     ///< what could not be compared, a sentence each
};

/// Compares; the tally is of all participants, before any is left out.
[[nodiscard]] RegistrationResult compare_registration(const Registration& registration,
                                                      const std::string& document,
                                                      const Tally& tally,
                                                      const Conducted& conducted);

/// All of it in sentences.
[[nodiscard]] std::string registration_words(const RegistrationResult& result);

}  // namespace obscura::analysis
