// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "stimuli/scenes/builtin_scene.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/study.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {

/// Reads the [[scene]] tables of a study file. A file that several of them use is opened once.
class SceneReader {
  public:
    SceneReader(const std::vector<BuiltinScene>& catalogue, std::filesystem::path folder,
                SceneFiles files)
        : catalogue_(catalogue), folder_(std::move(folder)), files_(files) {}

    /// The scene of a table whose `id` was read already; what is wrong goes into `problems`, the
    /// list that `reader` fills as well.
    [[nodiscard]] StudyScene read(TableReader& reader, const std::string& id,
                                  std::vector<StudyProblem>& problems);

  private:
    /// What a study needs to know of a file.
    struct Known {
        std::vector<std::string> cameras;
        std::vector<renderer::ImportedFile> files;
        OpenedScene opened;   ///< of a scene's file
        std::string problem;  ///< empty: it can be read
    };

    void read_settings(TableReader& reader, SceneSettings& settings,
                       std::vector<StudyProblem>& problems);
    void read_environment(TableReader& reader, StudyScene& scene);
    void read_lights(TableReader& reader, SceneSettings& settings,
                     std::vector<StudyProblem>& problems);
    void read_source(TableReader& reader, StudyScene& scene);
    void read_camera(TableReader& reader, const std::vector<std::string>* names, StudyScene& scene,
                     std::vector<StudyProblem>& problems);
    const Known& open(const std::string& source, double scale);
    static void add_notes(const Known& known, StudyScene& scene);

    const std::vector<BuiltinScene>& catalogue_;
    std::filesystem::path folder_;
    SceneFiles files_;
    std::map<std::pair<std::string, double>, Known> known_;
    std::map<std::string, Known> environments_;
};

}  // namespace obscura::stimuli
