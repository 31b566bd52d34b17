// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "app/commands/command.h"

namespace obscura::app {

/// What runs once the words of the command line were read.
using ChosenAct = std::shared_ptr<std::function<base::ExitCode()>>;

/// `scene cameras`: finds good views and prints them as lines of a study file.
void attach_cameras(const Options& scene, const ChosenAct& chosen);

/// `scene preview`: one image of a scene, as a study would show it.
void attach_preview(const Options& scene, const ChosenAct& chosen);

}  // namespace obscura::app
