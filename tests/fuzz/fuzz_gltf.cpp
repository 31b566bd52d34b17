// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "renderer/base/error.h"
#include "renderer/import/gltf_import.h"

/// Any bytes are a sound scene or refused as bad input. No file beside them can be read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace obscura::renderer;
    import_detail::Notes notes;
    import_detail::FilesRead files("/nowhere", {}, notes);
    try {
        ImportedScene imported = import_detail::import_gltf(
            std::string(reinterpret_cast<const char*>(data), size), "fuzz", {}, files, notes);
        import_detail::finish_import(imported, "fuzz", notes);
        for (const Mesh& mesh : imported.scene.meshes) {
            if (mesh.material >= imported.scene.materials.size()) std::abort();
            for (const std::uint32_t index : mesh.indices) {
                if (index >= mesh.vertices.size()) std::abort();
            }
        }
    } catch (const obscura::base::Error& error) {
        if (error.code() != obscura::base::ExitCode::kBadInput) std::abort();
    }
    return 0;
}
