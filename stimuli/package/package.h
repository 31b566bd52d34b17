// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/study.h"

namespace obscura::stimuli {

/// Under which terms a scene and its light may be passed on, as far as that is known.
struct SceneLicence {
    std::string scene;    ///< id in the study
    std::string source;   ///< built-in scene or file
    std::string licence;  ///< in words; empty: nobody said
    std::string said_by;  ///< who says so: the program, the study's `licence`, the file
};

/// A study with all that it is made of, in one file that another machine can run.
struct Package {
    std::string study;         ///< its name
    std::string program;       ///< that packed it, obscura 0.1.0
    std::string gpu_renderer;  ///< that made its images
    std::vector<SceneLicence> licences;
    std::size_t files = 0;
};

/// Whether a command line's word is the name of a package: it ends in .zip.
[[nodiscard]] bool is_package(const std::string& word);

/// Packs the study of `source` with its scenes' files, the images of the folder and their manifest,
/// the hash of each, and the licences, into `out`. The study file stays the same to the byte, so
/// all that it names has to lie in its folder. Throws bad input naming everything that keeps it
/// from being packed: images that are missing or not what the study asks for, files outside.
Package pack(const StudySource& source, const std::filesystem::path& images,
             const std::filesystem::path& out);

/// Where a package lies once it is unpacked.
struct Unpacked {
    Package package;
    std::filesystem::path study;   ///< DATA/packages/NAME/FILE.toml
    std::filesystem::path images;  ///< DATA/stimuli/NAME
};

/// Unpacks into a data folder; what is there already and the same stays. Before anything is written
/// all of it was read and held against its hashes. Throws bad input naming the package: it cannot
/// be read (zip.h), it is of a later format, a file is missing, not listed or not that of its hash,
/// the study has a problem or lacks an image, or the folder holds another file of the same name.
[[nodiscard]] Unpacked unpack(const std::filesystem::path& package,
                              const std::filesystem::path& data);

}  // namespace obscura::stimuli
