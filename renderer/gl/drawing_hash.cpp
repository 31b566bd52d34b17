// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/gl/drawing_hash.h"

#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/gl/context.h"
#include "renderer/gl/embedded_shaders.h"
#include "renderer/gl/program.h"

namespace obscura::renderer {

std::string drawing_sha256() {
    std::string all = base::sha256_hex(base::read_file("/proc/self/exe"));
    all += gpu_description();
    if (!gl::shader_folder().empty()) {
        for (const std::string_view path : shaders::embedded_names()) {
            all += gl::shader_source(std::string(path));
        }
    }
    return base::sha256_hex(all);
}

}  // namespace obscura::renderer
