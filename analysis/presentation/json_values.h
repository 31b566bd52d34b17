// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/statistics/possible.h"
#include "analysis/statistics/quartiles.h"
#include "analysis/statistics/wilson.h"

namespace obscura::analysis {

using Json = nlohmann::ordered_json;

/// NAME: null and NAME_reason, where there is no value.
inline void put_none(Json& object, const std::string& name, const std::string& reason) {
    object[name] = nullptr;
    object[name + "_reason"] = reason;
}

template <typename T>
void put(Json& object, const std::string& name, const Possible<T>& value) {
    if (value.has_value()) {
        object[name] = *value;
    } else {
        put_none(object, name, value.reason);
    }
}

inline void put_p(Json& object, const std::string& name, const Possible<PValue>& value) {
    if (value.has_value()) {
        object[name] = value->p;
        object["log10_" + name] = value->log10_p;
    } else {
        put_none(object, name, value.reason);
    }
}

/// NAME_low and NAME_high of an Interval or Interval.
template <typename Range>
void put_interval(Json& object, const std::string& name, const Possible<Range>& interval) {
    if (interval.has_value()) {
        object[name + "_low"] = interval->low;
        object[name + "_high"] = interval->high;
    } else {
        put_none(object, name + "_low", interval.reason);
        put_none(object, name + "_high", interval.reason);
    }
}

}  // namespace obscura::analysis
