// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "renderer/import/files_read.h"
#include "renderer/import/import.h"
#include "renderer/import/notes.h"

namespace obscura::renderer::import_detail {

/// The scene of a glTF document; `name` stands for it in messages. A camera without a far plane
/// has far_m = 0.
[[nodiscard]] ImportedScene import_gltf(std::string bytes, const std::string& name,
                                        const ImportOptions& options, FilesRead& files,
                                        Notes& notes);

/// The scene of a Wavefront OBJ text.
[[nodiscard]] ImportedScene import_obj(std::string_view text, const std::string& name,
                                       const ImportOptions& options, FilesRead& files,
                                       Notes& notes);

/// What every import ends with: at least one triangle and one camera, coordinates within the
/// limit, camera names unique, far planes behind everything.
void finish_import(ImportedScene& imported, const std::string& name, Notes& notes);

}  // namespace obscura::renderer::import_detail
