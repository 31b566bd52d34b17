// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/variant_setting.h"

#include <charconv>

#include "renderer/technique/technique.h"

namespace obscura::renderer {

bool set(Variant& variant, const std::string& setting) {
    const std::size_t equals = setting.find('=');
    const std::string key = setting.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : setting.substr(equals + 1);
    if (const VariantOption* option = find_option(key)) {
        variant.*option->value = value;
        return true;
    }
    const char* const end = value.data() + value.size();
    double number = 0.0;
    const auto [rest, error] = std::from_chars(value.data(), end, number);
    if (key.empty() || error != std::errc() || rest != end) return false;
    variant.parameters[key] = number;
    return true;
}

}  // namespace obscura::renderer
