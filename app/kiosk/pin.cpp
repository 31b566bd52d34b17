// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/pin.h"

#include <crypt.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::app::kiosk {
namespace {

/// Hash of the PIN with the salt and method that `setting` begins with; empty: there is none.
[[nodiscard]] std::string hash_of(const std::string& pin, const std::string& setting) {
    const auto data = std::make_unique<crypt_data>();
    const char* const hash =
        crypt_rn(pin.c_str(), setting.c_str(), data.get(), static_cast<int>(sizeof *data));
    return hash != nullptr ? hash : "";
}

}  // namespace

std::filesystem::path pin_file(const std::filesystem::path& data) { return data / "operator-pin"; }

void set_pin(const std::filesystem::path& file, const std::string& pin) {
    namespace fs = std::filesystem;
    if (pin.empty()) {
        fs::remove(file);
        return;
    }
    const bool digits =
        std::all_of(pin.begin(), pin.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (!digits || pin.size() < kShortestPin || pin.size() > kLongestPin) {
        throw base::bad_input(
            "the operator's PIN: allowed are {} to {} digits, or nothing for none", kShortestPin,
            kLongestPin);
    }
    char setting[CRYPT_GENSALT_OUTPUT_SIZE];
    const bool salted = crypt_gensalt_rn("$y$", 0, nullptr, 0, setting,
                                         static_cast<int>(sizeof setting)) != nullptr;
    const std::string hash = salted ? hash_of(pin, setting) : "";
    if (hash.empty()) throw base::failure("libcrypt makes no hash of the operator's PIN");
    base::write_file_atomically(file, hash + "\n");
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
}

bool is_pin(const std::filesystem::path& file, const std::string& pin) {
    std::string kept = base::read_file(file);
    while (!kept.empty() && kept.back() == '\n') kept.pop_back();
    return !kept.empty() && hash_of(pin, kept) == kept;
}

double wait_after_wrong_s(int wrong) {
    constexpr double kLongest_s = 60.0;
    return wrong <= 0 ? 0.0 : std::min(kLongest_s, std::exp2(std::min(wrong - 1, 10)));
}

}  // namespace obscura::app::kiosk
