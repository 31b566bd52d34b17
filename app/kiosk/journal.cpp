// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/kiosk/journal.h"

#include <fmt/format.h>

#include <exception>
#include <utility>

namespace obscura::app::kiosk {
namespace {

struct NameOf {
    std::string operator()(const BeginSession& row) const {
        return fmt::format("the beginning of session {}", row.session.session_id);
    }
    std::string operator()(const analysis::TrialRecord& row) const {
        return fmt::format("the answer to pair {}", row.trial_index + 1);
    }
    std::string operator()(const CompleteSession& row) const {
        return fmt::format("the end of session {}", row.session_id);
    }
    std::string operator()(const analysis::EventRecord& row) const {
        return fmt::format("the event \"{}\"", row.name);
    }
};

}  // namespace

void Journal::add(std::vector<Row> rows) {
    for (Row& row : rows) waiting_.push_back(std::move(row));
}

std::optional<std::string> Journal::flush() {
    try {
        require_in_place_();
        while (!waiting_.empty()) {
            commit_(waiting_.front());
            waiting_.pop_front();
        }
    } catch (const std::exception& error) {
        return error.what();
    }
    return std::nullopt;
}

std::string name_of(const Row& row) { return std::visit(NameOf{}, row); }

std::string describe(const Row& row) {
    const auto* trial = std::get_if<analysis::TrialRecord>(&row);
    if (trial == nullptr) return name_of(row);
    return fmt::format(
        "{} of session {}: condition {}, {} shown first, {} chosen, response time {:.3f} s, views "
        "{:.0f} and {:.0f} ms, grey {:.1f} ms, hidden {:.0f} ms, {}",
        name_of(row), trial->session_id, trial->condition, trial->first_shown,
        trial->is_A_selected ? 'A' : 'B', trial->response_time_s, trial->first_view_ms,
        trial->second_view_ms, trial->grey_ms_measured, trial->hidden_ms.value_or(0.0),
        trial->answered_utc);
}

}  // namespace obscura::app::kiosk
