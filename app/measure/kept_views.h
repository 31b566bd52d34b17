// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/measure/sweep.h"

namespace obscura::app {

/// Swept views on disk, so that a run that is ended half-way is not lost: each is kept when it is
/// finished, and given up when the whole run is.
class KeptViews {
  public:
    /// None is kept where the folder has no name.
    explicit KeptViews(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// The view that was kept with that description. One that is damaged is said and not used.
    [[nodiscard]] std::optional<SweptView> find(const std::string& description);
    /// Throws failure when it cannot be written.
    void keep(const std::string& description, const SweptView& view);
    /// Removes what was found and kept.
    void give_up();

  private:
    [[nodiscard]] std::filesystem::path file_of(const std::string& description) const;

    std::filesystem::path folder_;
    std::set<std::filesystem::path> files_;
};

/// All that the sweep of a view depends on, in one text: program, driver and shaders, sizes and
/// runs, the settings, and the view itself by the bytes of its truths and of its images with them.
[[nodiscard]] std::string description_of(MeasuredScene& stage, const MeasureRequest& request,
                                         const MeasuredView& view,
                                         const std::vector<Setting>& settings,
                                         const TimerCheck& timers);

}  // namespace obscura::app
