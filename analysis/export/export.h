// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "analysis/store/store.h"

namespace obscura::analysis {

/// What kind of files an export is made of.
enum class ExportFormat {
    kCsv,        ///< participants, sessions, trials, conditions, events as CSV (RFC 4180)
    kTsv,        ///< the same with tabs
    kJsonLines,  ///< the same, an object a line
    kBids,       ///< a behavioural dataset of the Brain Imaging Data Structure 1.9
    kPsychDs,    ///< a Psych-DS dataset
};

inline constexpr std::array kExportFormats{ExportFormat::kCsv, ExportFormat::kTsv,
                                           ExportFormat::kJsonLines, ExportFormat::kBids,
                                           ExportFormat::kPsychDs};

/// `csv`, `tsv`, `json`, `bids` or `psych-ds`, as on the command line.
[[nodiscard]] std::string_view to_string(ExportFormat format);
[[nodiscard]] std::optional<ExportFormat> export_format_from(std::string_view name);

/// An image as the manifest lists it.
struct ExportedImage {
    std::string condition;
    char side = 'A';                ///< 'A' or 'B'
    std::string file;               ///< in ExportedStudy::image_folder
    std::string sha256;             ///< of its bytes
    std::string scene_source = {};  ///< built-in scene or file; empty: not known
    std::string camera = {};        ///< of that scene
};

/// What a scene of a study looks at.
struct ExportedView {
    std::string scene_source;  ///< built-in scene or file
    std::string camera;
    std::string name = {};  ///< what an analysis calls it, the same for scenes that differ in light
};

/// A study whose sessions are exported, as far as it is at hand.
struct ExportedStudy {
    std::string name;
    std::string title;  ///< empty: not known, like all below
    std::string question;
    std::string instructions;
    std::string file_text;                           ///< the study file's bytes
    std::string sha256 = {};                         ///< of the study file
    std::map<std::string, ExportedView> views = {};  ///< by the study's name of the scene
    std::string manifest_text;                       ///< the bytes of manifest.json
    std::vector<ExportedImage> images;  ///< those of the manifest whose files are there
    std::filesystem::path image_folder;
};

/// One condition of a test that the analysis makes over participants. Each participant's
/// difference is the sum of weight * (+1 for an answer B, -1 for A) over the test's conditions, and
/// the signs of the differences are flipped.
struct ExportedTest {
    std::string study;
    Kind kind = Kind::kParticipant;
    std::string test = {};  ///< a hypothesis, with what is compared where it has several tests
    std::string role = {};  ///< primary: Holm's correction is over these; or secondary
    std::string question =
        {};  ///< preference, interaction, levels; none: not one that tables repeat
    std::string condition = {};
    std::string level = {};   ///< of validity
    std::string weight = {};  ///< a whole number; empty for levels, where Cochran's Q is the test
};

struct ExportOptions {
    ExportFormat format = ExportFormat::kCsv;
    std::filesystem::path folder;
    bool overwrite = false;
    /// Leaves out what may tell who it was (age, gender, times of day, the place in the sequence of
    /// participants) and numbers participants anew, in an order shuffled by this seed; who knows
    /// the seed can undo that.
    std::optional<std::uint64_t> anonymous_seed;
    std::vector<ExportedStudy> studies;
    std::string software;  ///< name and version of this program
    /// By session: why the study's rule leaves its participant out; empty: it does not. A session
    /// that is not here was not completed, or nothing is known.
    std::unordered_map<std::string, std::string> left_out;
    std::vector<ExportedTest> tests;
};

/// What went into an export.
struct Exported {
    std::size_t participants = 0;
    std::size_t sessions = 0;
    std::size_t simulated = 0;  ///< sessions of those
    std::size_t trials = 0;
    std::size_t unknown_images = 0;  ///< trials with an image that is in no manifest
};

/// Writes everything that the store holds at one moment, all files or none. Beside the tables there
/// are, for each study, its file and manifest (stimuli/STUDY/, in Psych-DS materials/STUDY/); BIDS
/// also has the images that were shown. Each format describes every column: data_dictionary.json
/// (BIDS keys Description, Levels, Units), BIDS's sidecars, or variableMeasured. The tests of the
/// analysis are a table too, and main_tests.R and main_tests.py repeat them from the tables. Text
/// is UTF-8, doubles have the shortest digits that read back the same. Rows are streamed; only an
/// anonymous export keeps the sessions in memory. Throws bad input when the folder cannot be
/// written or holds something that may not be overwritten; failure, with nothing left behind, when
/// writing fails.
[[nodiscard]] Exported export_store(Store& store, const ExportOptions& options);

}  // namespace obscura::analysis
