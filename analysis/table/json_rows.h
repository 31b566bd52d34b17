// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "analysis/table/csv.h"

namespace obscura::analysis {

/// The outermost objects of JSON text as rows, whatever arrays they stand in: first a header of all
/// their members, in the order of first appearance, then a row for each object, empty where it
/// lacks a member or that is null. Members of an object within are `name.member`, elements of an
/// array of at most 8 `name[0]`; what is larger or deeper stays JSON text. Throws bad input as
/// `name:line: what is wrong`. The text is UTF-8.
void for_each_json_row(std::string_view text, const std::string& name,
                       const std::function<void(const CsvRow&)>& take);

}  // namespace obscura::analysis
