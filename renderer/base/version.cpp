// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/base/version.h"

namespace obscura::base {

std::string program_version() { return "obscura " OBSCURA_VERSION; }

}  // namespace obscura::base
