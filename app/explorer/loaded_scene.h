// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <mutex>

#include "renderer/light/shadow.h"
#include "renderer/reference/reference.h"
#include "stimuli/scenes/open_scene.h"

namespace obscura::app::explorer {

/// A scene that is open, shared by those who draw it and those who trace rays through it.
class LoadedScene {
  public:
    explicit LoadedScene(stimuli::OpenedScene opened);

    [[nodiscard]] const stimuli::OpenedScene& opened() const { return opened_; }
    [[nodiscard]] const renderer::Bounds& bounds() const { return bounds_; }
    /// Built when first asked for, by whichever thread asks. Throws as ReferenceScene does.
    [[nodiscard]] const renderer::ReferenceScene& rays();

  private:
    stimuli::OpenedScene opened_;
    renderer::Bounds bounds_;
    std::mutex mutex_;
    std::unique_ptr<renderer::ReferenceScene> rays_;
};

}  // namespace obscura::app::explorer
