// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/images/images.h"

#include <dlfcn.h>

#include "renderer/base/error.h"

namespace obscura::images {
namespace {

const Library& loaded() {
    // As installed and as built: bin/obscura, lib/obscura/obscura_images.so. Never unloaded.
    const std::filesystem::path file =
        std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path() / "lib" /
        "obscura" / "obscura_images.so";
    void* module = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
        throw base::failure("the part of the program that reads and writes images is missing: {}",
                            ::dlerror());
    }
    using Entry = const Library& (*)();
    auto* entry = reinterpret_cast<Entry>(::dlsym(module, "obscura_images"));
    if (entry == nullptr) {
        throw base::failure("{} is of another version: {}", file.string(), ::dlerror());
    }
    return entry();
}

}  // namespace

const Library& library() {
    static const Library& library = loaded();
    return library;
}

}  // namespace obscura::images
