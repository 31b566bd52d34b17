// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "analysis/store/store.h"

namespace obscura::analysis {

/// Texts that are kept once and known by number, from 0; number 0 is the empty text.
class Names {
  public:
    Names() { (void)number_of(""); }
    Names(Names&&) = default;
    Names& operator=(Names&&) = default;
    Names(const Names&) = delete;  // the keys point into the texts
    Names& operator=(const Names&) = delete;
    ~Names() = default;

    /// The number of the text, a new one when it is new. `guess` is what it may well be.
    std::uint32_t number_of(std::string_view text, std::uint32_t guess = 0) {
        if (texts_.size() > guess && texts_[guess] == text) return guess;
        if (const auto known = numbers_.find(text); known != numbers_.end()) return known->second;
        const auto number = static_cast<std::uint32_t>(texts_.size());
        numbers_.emplace(texts_.emplace_back(text), number);
        return number;
    }
    [[nodiscard]] const std::string& operator[](std::uint32_t number) const {
        return texts_[number];
    }
    [[nodiscard]] std::size_t size() const { return texts_.size(); }

  private:
    std::deque<std::string> texts_;  // which does not move what it holds
    std::unordered_map<std::string_view, std::uint32_t> numbers_;
};

/// What an analysis needs of a session; texts are numbers in AnswerTable::names.
struct SessionEntry {
    std::uint32_t name = 0;
    std::uint32_t participant = 0;
    std::uint32_t study = 0;
    std::uint32_t exclusion = 0;  ///< SessionRecord::exclusion
    Kind kind = Kind::kParticipant;
    SessionState state = SessionState::kOpen;
    std::uint32_t study_sha256 = 0;  ///< of the study's file; 0: not known
    std::uint32_t study_plan = 0;    ///< SessionRecord::study_plan
};

/// What a condition showed; texts are numbers in AnswerTable::names.
struct ConditionEntry {
    std::uint32_t id = 0;
    std::uint32_t hypothesis = 0;
    std::uint32_t validity = 0;
    std::uint32_t variant_a = 0;
    std::uint32_t variant_b = 0;
    std::uint32_t scene = 0;
    std::uint32_t study_a = 0;  ///< the variant that the study calls A; 0: it does not say

    bool operator==(const ConditionEntry&) const = default;
};

struct ConditionHash {
    std::size_t operator()(const ConditionEntry& condition) const;
};

/// What an analysis needs of a trial.
struct AnswerEntry {
    double response_time_s = 0.0;   ///< 0: not known
    std::uint32_t session = 0;      ///< place in AnswerTable::sessions
    std::uint32_t condition = 0;    ///< place in AnswerTable::conditions
    std::uint32_t repeats = 0;      ///< the repeated condition's id in AnswerTable::names, or 0
    std::int32_t trial_index = -1;  ///< from 0; -1: not known
    Kind kind = Kind::kParticipant;
    bool a_selected = false;
    char first_shown = 'A';
    char expected = 0;  ///< 'A', 'B' or 0
};

/// The answers of a store or file, small enough that a million fit in some 50 MB.
class AnswerTable {
  public:
    std::string source;  ///< the store's URL or the file
    Names names;
    std::vector<SessionEntry> sessions;
    std::vector<ConditionEntry> conditions;  ///< each different one once
    std::vector<AnswerEntry> answers;
    std::string order_unknown;       ///< why first_shown has no meaning; empty where it has
    std::vector<std::string> notes;  ///< what a reader passed over or took for granted

    /// The place of the condition, a new one when it is new.
    std::uint32_t place_of(const ConditionEntry& condition);
    /// Gives conditions other ids, by number; nothing may be added to the table afterwards.
    void rename(const std::unordered_map<std::uint32_t, std::uint32_t>& ids);

    void add(const SessionRecord& session);
    /// Trials of sessions that were not added are passed over: they cannot count.
    void add(const TrialRecord& trial);

  private:
    static constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;
    std::uint32_t place_of(const TrialRecord& trial);

    std::unordered_map<ConditionEntry, std::uint32_t, ConditionHash> condition_places_;
    std::vector<std::uint32_t> session_places_;  ///< of records, by name; kNowhere: none
    std::uint32_t last_session_ = 0;             ///< name of a trial's
    /// The place of what each condition showed last, by its id.
    std::unordered_map<std::uint32_t, std::uint32_t> last_places_;
};

/// The answers of a store, all of one moment, read a row at a time. `url` stands for it.
[[nodiscard]] AnswerTable read_answers(Store& store, const std::string& url);

}  // namespace obscura::analysis
