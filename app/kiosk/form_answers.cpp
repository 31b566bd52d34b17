// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/form_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

namespace obscura::app::kiosk {
namespace {

using stimuli::FieldKind;
using stimuli::FormField;

/// Crockford's base 32: no I, L, O, U.
constexpr std::string_view kCodeLetters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
constexpr int kCodeLength = 6;

[[nodiscard]] bool is_number_field(FieldKind kind) {
    return kind == FieldKind::kNumber || kind == FieldKind::kScale;
}

[[nodiscard]] nlohmann::ordered_json value_of(const FormField& field, const FieldAnswer& answer) {
    if (field.kind == FieldKind::kChoices) return answer.chosen;
    const std::string text = trimmed(answer.text);
    if (text.empty()) return nullptr;
    if (!is_number_field(field.kind)) return text;
    const double number = number_in(text).value_or(0.0);
    constexpr double kWhole = 9007199254740992.0;  // 2^53
    if (std::abs(number) < kWhole && number == std::floor(number)) {
        return static_cast<std::int64_t>(number);
    }
    return number;
}

}  // namespace

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<double> number_in(const std::string& text) {
    std::string digits = trimmed(text);
    if (digits.find('.') == std::string::npos) std::replace(digits.begin(), digits.end(), ',', '.');
    double number = 0.0;
    const char* const end = digits.data() + digits.size();
    const auto [stopped, error] = std::from_chars(digits.data(), end, number);
    if (digits.empty() || error != std::errc() || stopped != end || !std::isfinite(number)) {
        return std::nullopt;
    }
    return number;
}

FieldProblem problem_of(const FormField& field, const FieldAnswer& answer) {
    const std::string text = trimmed(answer.text);
    const bool is_empty = field.kind == FieldKind::kChoices ? answer.chosen.empty() : text.empty();
    if (is_empty) return field.required ? FieldProblem::kMissing : FieldProblem::kNone;
    if (!is_number_field(field.kind)) return FieldProblem::kNone;
    const std::optional<double> number = number_in(text);
    if (!number) return FieldProblem::kNoNumber;
    const bool below = field.min && *number < *field.min;
    const bool above = field.max && *number > *field.max;
    return below || above ? FieldProblem::kOutOfRange : FieldProblem::kNone;
}

std::string form_json(const std::vector<FormField>& fields,
                      const std::vector<FieldAnswer>& answers) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const FormField& field = fields[i];
        nlohmann::ordered_json row = {
            {"field", field.id}, {"kind", to_string(field.kind)}, {"label", field.label}};
        if (!field.unit.empty()) row["unit"] = field.unit;
        if (!field.choices.empty()) row["choices"] = field.choices;
        if (field.labels.size() == 2) {
            row["levels"][fmt::format("{}", *field.min)] = field.labels[0];
            row["levels"][fmt::format("{}", *field.max)] = field.labels[1];
        }
        row["value"] = value_of(field, i < answers.size() ? answers[i] : FieldAnswer{});
        rows.push_back(std::move(row));
    }
    return rows.dump();
}

std::string code_in(const std::vector<FormField>& fields, const std::vector<FieldAnswer>& answers) {
    for (std::size_t i = 0; i < fields.size() && i < answers.size(); ++i) {
        if (fields[i].kind == FieldKind::kCode) return trimmed(answers[i].text);
    }
    return "";
}

std::string make_code(const std::vector<std::string>& known) {
    std::random_device random;
    std::uniform_int_distribution<std::size_t> letter(0, kCodeLetters.size() - 1);
    while (true) {
        std::string code;
        for (int i = 0; i < kCodeLength; ++i) code += kCodeLetters[letter(random)];
        const bool is_known = std::any_of(known.begin(), known.end(), [&](const auto& other) {
            return is_same_code(code, other);
        });
        if (!is_known) return code;
    }
}

bool is_same_code(const std::string& one, const std::string& other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(), [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    });
}

}  // namespace obscura::app::kiosk
