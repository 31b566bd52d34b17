// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "renderer/base/error.h"
#include "renderer/import/mtl_text.h"
#include "renderer/import/obj_check.h"

/// What is checked can be checked again and is the same to the count: the text that the mesh
/// library gets is sound. Any bytes are materials.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace obscura::renderer::import_detail;
    Notes notes;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const MtlMaterial& material : read_mtl(text, "fuzz", notes)) {
        if (material.d && !(*material.d >= 0.0 && *material.d <= 1.0)) std::abort();
    }
    try {
        const CheckedObj once = check_obj(text, "fuzz", notes);
        const CheckedObj twice = check_obj(once.text, "fuzz", notes);
        if (once.triangles != twice.triangles || once.text != twice.text) std::abort();
    } catch (const obscura::base::Error& error) {
        if (error.code() != obscura::base::ExitCode::kBadInput) std::abort();
    }
    return 0;
}
