// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/files_read.h"

#include <algorithm>
#include <cctype>
#include <charconv>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/import/json_cursor.h"

namespace obscura::renderer::import_detail {
namespace {

namespace fs = std::filesystem;

bool same_but_for_case(const std::string& a, const std::string& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
               return std::tolower(static_cast<unsigned char>(x)) ==
                      std::tolower(static_cast<unsigned char>(y));
           });
}

/// The path below `folder`; each part that is not there is looked for in any case.
fs::path find_below(const fs::path& folder, const fs::path& name) {
    std::error_code error;
    if (name.is_absolute() || fs::exists(folder / name, error)) return folder / name;
    fs::path found = folder;
    for (const fs::path& part : name) {
        fs::path next = found / part;
        if (!fs::exists(next, error)) {
            const fs::path here = found.empty() ? fs::path(".") : found;
            for (const auto& entry : fs::directory_iterator(here, error)) {
                if (same_but_for_case(entry.path().filename().string(), part.string())) {
                    next = found / entry.path().filename();
                }
            }
        }
        found = next;
    }
    return found;
}

}  // namespace

std::optional<std::string> FilesRead::read(const std::string& name, std::string& why) {
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    std::error_code error;
    const bool nul = slashes.find('\0') != std::string::npos;
    const fs::path path = nul ? fs::path() : find_below(folder_, fs::path(slashes));
    if (nul || slashes.empty() || !fs::exists(path, error)) {
        why = "the file is missing";
        return std::nullopt;
    }
    if (!fs::is_regular_file(path, error)) {
        why = "it is no ordinary file";
        return std::nullopt;
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (error || size > left_bytes_) {
        why = error ? error.message()
                    : fmt::format("it has {} bytes, of the {} allowed for a scene {} are left",
                                  size, ImportLimits::kFileBytes, left_bytes_);
        return std::nullopt;
    }
    try {
        std::string bytes = base::read_file(path);
        left_bytes_ -= std::min(bytes.size(), left_bytes_);
        list_.push_back({path, base::sha256_hex(bytes)});
        return bytes;
    } catch (const base::Error& unreadable) {
        why = unreadable.what();
        return std::nullopt;
    }
}

std::string percent_decoded(std::string_view uri) {
    std::string decoded;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned value = 0;
        if (uri[i] == '%' && i + 2 < uri.size()) {
            const char* first = uri.data() + i + 1;
            const auto [end, error] = std::from_chars(first, first + 2, value, 16);
            if (error == std::errc() && end == first + 2) {
                decoded += static_cast<char>(value);
                i += 2;
                continue;
            }
        }
        decoded += uri[i];
    }
    return decoded;
}

}  // namespace obscura::renderer::import_detail
