// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/machine.h"

#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <random>

#include "app/kiosk/clock.h"

namespace obscura::app::kiosk {
namespace {

/// PRETTY_NAME of os-release(5), or nothing.
[[nodiscard]] std::string distribution() {
    std::ifstream file("/etc/os-release");
    const std::string key = "PRETTY_NAME=";
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(key)) continue;
        line.erase(0, key.size());
        std::erase(line, '"');
        return line;
    }
    return "";
}

}  // namespace

std::string operating_system() {
    utsname names{};
    ::uname(&names);
    const std::string kernel = fmt::format("{} {} {}", names.sysname, names.release, names.machine);
    const std::string name = distribution();
    return name.empty() ? kernel : fmt::format("{}, {}", name, kernel);
}

std::string unique_id(const std::string& stem) {
    std::string time = utc_now().substr(0, 19);
    std::erase_if(time, [](char c) { return c == '-' || c == ':'; });
    return fmt::format("{}-{}Z-{:08x}", stem, time, std::random_device{}());
}

}  // namespace obscura::app::kiosk
