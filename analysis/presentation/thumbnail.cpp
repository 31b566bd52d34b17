// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/presentation/thumbnail.h"

#include "renderer/base/error.h"
#include "renderer/images/images.h"

namespace obscura::analysis {

std::string thumbnail(std::string_view image_file, const std::string& name, int width_px) {
    std::string why;
    std::string bytes = images::library().thumbnail(image_file, width_px, why);
    if (bytes.empty()) throw base::bad_input("{}: no thumbnail can be made: {}", name, why);
    return bytes;
}

}  // namespace obscura::analysis
