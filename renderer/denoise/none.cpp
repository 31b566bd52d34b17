// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/denoise/denoise.h"

namespace obscura::renderer {

Denoise none_denoise() { return {"none", "no filter", {}}; }

}  // namespace obscura::renderer
