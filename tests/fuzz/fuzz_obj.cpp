// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "renderer/base/error.h"
#include "renderer/import/obj_check.h"

/// What is checked can be checked again and is the same to the count: the text that the mesh
/// library gets is sound.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace obscura::renderer::import_detail;
    Notes notes;
    try {
        const CheckedObj once =
            check_obj(std::string_view(reinterpret_cast<const char*>(data), size), "fuzz", notes);
        const CheckedObj twice = check_obj(once.text, "fuzz", notes);
        if (once.triangles != twice.triangles || once.text != twice.text) std::abort();
    } catch (const obscura::base::Error& error) {
        if (error.code() != obscura::base::ExitCode::kBadInput) std::abort();
    }
    return 0;
}
