// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "renderer/frame/plan.h"
#include "renderer/gl/handles.h"

namespace obscura::renderer {

/// The textures of frames that are gone, for the next frame: memory that a software renderer asks
/// for anew has to be mapped and zeroed, which takes longer than many a pass. What the next frame
/// has no use for is freed then. On the thread of the context.
class TexturePool {
  public:
    TexturePool();
    ~TexturePool();
    TexturePool(const TexturePool&) = delete;
    TexturePool& operator=(const TexturePool&) = delete;

    /// A texture with whatever content; it comes back when its last owner lets it go.
    [[nodiscard]] std::shared_ptr<gl::Texture> take(const PlannedTarget& target);
    /// Frees what lies unused.
    void free_unused();

  private:
    using Unused = std::vector<std::pair<PlannedTarget, gl::Texture>>;
    std::shared_ptr<Unused> unused_;
};

}  // namespace obscura::renderer
