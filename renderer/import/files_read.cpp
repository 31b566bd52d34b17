// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/import/files_read.h"

#include <fmt/format.h>

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

constexpr const char* kOutside =
    "it lies outside the scene's folder and is not read; --allow FOLDER lets it be";

bool same_but_for_case(const std::string& a, const std::string& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [](char x, char y) {
               return std::tolower(static_cast<unsigned char>(x)) ==
                      std::tolower(static_cast<unsigned char>(y));
           });
}

/// The path without links, or as far as it exists; empty where it cannot be followed.
fs::path without_links(const fs::path& path) {
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    if (error) return {};
    fs::path followed = fs::weakly_canonical(absolute, error);
    return error ? fs::path() : followed;
}

/// Whether the path is the folder or below it; neither holds links or dots.
bool is_below(const fs::path& path, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first ==
           folder.end();
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

/// Of another place than a disk, such as https://...
bool is_on_network(const std::string& name) {
    const std::size_t mark = name.find("://");
    return mark != std::string::npos && mark > 1 &&
           std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(mark),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '+'; });
}

/// The path in a URI of the scheme file (RFC 8089), which may name a host; else the name itself.
std::string path_of_uri(const std::string& name) {
    if (!same_but_for_case(name.substr(0, 5), "file:")) return name;
    const std::string path = name.substr(5);
    return path.starts_with("//") ? path.substr(std::min(path.find('/', 2), path.size())) : path;
}

std::string with_slashes(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return name;
}

}  // namespace

FilesRead::FilesRead(const fs::path& folder, const std::vector<fs::path>& allowed_folders,
                     Notes& notes)
    : folder_(folder), notes_(notes) {
    allowed_.push_back(without_links(folder.empty() ? fs::path(".") : folder));
    for (const fs::path& allowed : allowed_folders) allowed_.push_back(without_links(allowed));
    std::erase(allowed_, fs::path());
}

bool FilesRead::is_allowed(const fs::path& path) const {
    return !path.empty() && std::any_of(allowed_.begin(), allowed_.end(),
                                        [&](const fs::path& one) { return is_below(path, one); });
}

FilesRead::Looked FilesRead::look_for(const std::string& given) {
    const std::string name = path_of_uri(given);
    if (name.empty() || name.find('\0') != std::string::npos) {
        return {std::nullopt, "the file is missing"};
    }
    if (is_on_network(name)) return {std::nullopt, "it is not on this machine"};
    std::error_code error;
    // A name may hold backslashes; where there is no such file they are another system's slashes.
    for (const std::string& spelt : {name, with_slashes(name)}) {
        const fs::path meant = without_links(folder_ / spelt);
        if (meant.empty()) continue;
        if (!is_allowed(meant)) return {std::nullopt, kOutside};
        const fs::path path = find_below(folder_, fs::path(spelt));
        if (!fs::exists(path, error)) continue;
        fs::path key = without_links(path);
        if (!is_allowed(key)) return {std::nullopt, kOutside};
        if (!fs::is_regular_file(key, error)) return {std::nullopt, "it is no ordinary file"};
        if (path != folder_ / spelt) {
            notes_.add("files whose names differ in case are taken for those that are meant",
                       fmt::format("{} for {}", one_line(path.filename().string()),
                                   one_line(fs::path(spelt).filename().string())));
        }
        return {FoundFile{path, std::move(key)}, ""};
    }
    return {std::nullopt, "the file is missing"};
}

std::optional<FoundFile> FilesRead::find(const std::string& name, std::string& why) {
    auto known = known_.find(name);
    if (known == known_.end()) known = known_.emplace(name, look_for(name)).first;
    if (!known->second.file) why = known->second.why;
    return known->second.file;
}

std::optional<std::string> FilesRead::read(const FoundFile& found, std::string& why) {
    std::error_code error;
    const std::uintmax_t size = fs::file_size(found.key, error);
    const bool again = read_.contains(found.key);
    if (error || (!again && size > left_bytes_)) {
        why = error ? error.message()
                    : fmt::format("it has {} bytes, of the {} allowed for a scene {} are left",
                                  size, ImportLimits::kFileBytes, left_bytes_);
        return std::nullopt;
    }
    try {
        std::string bytes = base::read_file(found.key);
        if (again) return bytes;
        left_bytes_ -= std::min(bytes.size(), left_bytes_);
        read_.insert(found.key);
        list_.push_back({found.path, base::sha256_hex(bytes)});
        return bytes;
    } catch (const base::Error& unreadable) {
        why = unreadable.what();
        return std::nullopt;
    }
}

std::optional<std::string> FilesRead::read(const std::string& name, std::string& why) {
    const auto found = find(name, why);
    return found ? read(*found, why) : std::nullopt;
}

std::optional<std::string> FilesRead::read_scene(const std::string& name, std::string& why) {
    const fs::path path = find_below(folder_, fs::path(name));
    std::error_code error;
    if (!fs::exists(path, error)) {
        why = "the file is missing";
        return std::nullopt;
    }
    if (!fs::is_regular_file(path, error)) {
        why = "it is no ordinary file";
        return std::nullopt;
    }
    return read(FoundFile{path, without_links(path)}, why);
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
