// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "app/explorer/coarse_scene.h"
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

    /// Makes the scene that is drawn while something moves, where this one has too many triangles
    /// for that; comes to nothing where `go_on` says false.
    void make_coarse(const std::function<bool()>& go_on);
    /// That scene; nothing where there is none, or not yet. Stays as it is once it is there.
    [[nodiscard]] const CoarseScene* coarse() const { return coarse_made_ ? &*coarse_ : nullptr; }

  private:
    stimuli::OpenedScene opened_;
    renderer::Bounds bounds_;
    std::mutex mutex_;
    std::unique_ptr<renderer::ReferenceScene> rays_;
    std::optional<CoarseScene> coarse_;
    std::atomic<bool> coarse_made_ = false;
};

}  // namespace obscura::app::explorer
