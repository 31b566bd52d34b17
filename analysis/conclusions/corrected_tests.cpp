// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/conclusions/corrected_tests.h"

#include <fmt/format.h>

#include "analysis/conclusions/words.h"
#include "analysis/statistics/holm.h"

namespace obscura::analysis {

std::size_t CorrectedTests::add(const Possible<PValue>& p) {
    p_values_.push_back(!p.has_value() ? 1.0 : look_.has_value() ? look_->spent(p->p) : p->p);
    is_computed_.push_back(p.has_value());
    return p_values_.size() - 1;
}

void CorrectedTests::correct() { corrected_ = holm(p_values_); }

Possible<double> CorrectedTests::at(std::size_t place) const {
    if (!is_computed_[place]) return Possible<double>::none("no test");
    return corrected_[place];
}

std::string CorrectedTests::words(const Possible<double>& p_holm, bool is_primary) const {
    if (!is_primary) return " (secondary, not corrected)";
    if (!p_holm.has_value()) return "";
    const bool is_spent = look_.has_value() && look_->spending != Spending::kNone;
    return fmt::format(" ({} after {}Holm's correction for {})", p_number(p_holm),
                       is_spent ? "spending for this look and " : "",
                       counted(static_cast<std::int64_t>(size()), "test"));
}

bool is_significant(const Possible<double>& p) { return p.has_value() && *p < kSignificance; }

}  // namespace obscura::analysis
