// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <type_traits>

#include "analysis/export/tables.h"
#include "analysis/text/text.h"

namespace obscura::analysis {

/// A value as it is exported; what is not known is empty, a yes or no is 1 or 0.
inline void append_cell(std::string& out, const std::string& value) { out += value; }
inline void append_cell(std::string& out, char value) {
    if (value != '\0') out += value;
}
inline void append_cell(std::string& out, bool value) { out += value ? '1' : '0'; }
inline void append_cell(std::string& out, double value) { append_shortest(out, value); }
inline void append_cell(std::string& out, Kind value) { out += to_string(value); }
inline void append_cell(std::string& out, SessionState value) { out += to_string(value); }
template <std::integral T>
void append_cell(std::string& out, T value) {
    std::array<char, 24> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    out.append(digits.data(), end.ptr);
}
template <typename T>
void append_cell(std::string& out, const std::optional<T>& value) {
    if (value) append_cell(out, *value);
}

template <typename T>
struct IsNumber : std::bool_constant<std::is_arithmetic_v<T> && !std::is_same_v<T, char>> {};
template <typename T>
struct IsNumber<std::optional<T>> : IsNumber<T> {};

template <typename Member>
struct MemberTraits;
template <typename R, typename T>
struct MemberTraits<T R::*> {
    using Record = R;
    static constexpr bool kNumber = IsNumber<T>::value;
};

template <auto kMember>
using RecordOf = typename MemberTraits<decltype(kMember)>::Record;
template <auto kMember>
constexpr bool is_number_v = MemberTraits<decltype(kMember)>::kNumber;

template <auto kMember>
inline const ExportCell<RecordOf<kMember>> of{
    [](const RecordOf<kMember>& record, std::string& out) { append_cell(out, record.*kMember); },
    is_number_v<kMember>};
template <auto kMember>
inline const ExportCell<TrialRow> of_trial{
    [](const TrialRow& row, std::string& out) { append_cell(out, row.trial->*kMember); },
    is_number_v<kMember>};
template <auto kMember>
inline const ExportCell<TrialRow> of_session{
    [](const TrialRow& row, std::string& out) { append_cell(out, row.session->*kMember); },
    is_number_v<kMember>};
template <auto kMember>
inline const ExportCell<SessionRow> of_own_session{
    [](const SessionRow& row, std::string& out) { append_cell(out, row.session->*kMember); },
    is_number_v<kMember>};
template <auto kMember>
inline const ExportCell<ConditionRow> of_shown{
    [](const ConditionRow& row, std::string& out) { append_cell(out, row.shown.*kMember); },
    is_number_v<kMember>};

}  // namespace obscura::analysis
