// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

namespace obscura::renderer {

/// The most rays a pixel that the technique `reference` takes: its samples.
inline constexpr int kMostReferenceRays = 65536;

}  // namespace obscura::renderer
