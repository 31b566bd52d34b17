// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "analysis/export/events.h"
#include "analysis/export/export.h"
#include "analysis/export/tables.h"
#include "analysis/questions/answers.h"

namespace obscura::analysis {

/// What an export is made of, in the order of its rows: the store's own, or, for an anonymous one,
/// participants by new names in a shuffled order.
class ExportSource {
  public:
    /// To be used within one Store::of_one_moment. Both must outlive it.
    ExportSource(Store& store, const ExportOptions& options);

    [[nodiscard]] bool anonymous() const { return anonymous_; }
    /// The columns that may be shown.
    template <typename Row>
    [[nodiscard]] std::vector<ExportColumn<Row>> columns(const ExportTable<Row>& table) const {
        std::vector<ExportColumn<Row>> shown;
        for (const auto& column : table.columns) {
            if (!anonymous_ || !column.personal) shown.push_back(column);
        }
        return shown;
    }

    void each_participant(const std::function<void(const ParticipantRecord&)>& take);
    void each_session(const std::function<void(const SessionRow&)>& take);
    /// What each session asked of its pairs.
    void each_asked(const std::function<void(const AskedQuestions&)>& take);
    /// Whether any asked more than which image is chosen.
    [[nodiscard]] bool has_questions();
    void each_answer(const std::function<void(const QuestionAnswer&, const SessionRecord&)>& take);
    /// Those of no session first; those that are answers are not among them.
    void each_event(const std::function<void(const EventRow&)>& take);
    /// Rows numbered from 1, with the images' files as STUDY/FILE. Counts them in `exported`.
    void each_trial(const std::function<void(const TrialRow&)>& take, Exported& exported);

  private:
    void read_all(std::uint64_t seed);
    /// A session and all of its events.
    void each_with_events(
        const std::function<void(const SessionRecord&, const std::vector<EventRecord>&)>& take);
    /// Pairs of a session, by its name in the store, in which the question `first` was answered by
    /// no difference.
    [[nodiscard]] std::set<int> without_difference(const std::string& session_id,
                                                   const std::string& first);

    Store& store_;
    const bool anonymous_;
    std::vector<ParticipantRecord> participants_;  ///< renamed; only of an anonymous export
    std::vector<SessionRecord> sessions_;
    std::vector<std::string> session_ids_;  ///< in the store
    struct Image {
        std::string sha256;
        std::string file;
        ExportedView view;
    };
    /// The image that the trial showed on that side; nullptr: not known.
    [[nodiscard]] const Image* image_of(const TrialRecord& trial, const SessionRecord& session,
                                        bool first) const;
    /// From the images, or from the study file that the session began with; nullptr: not known.
    [[nodiscard]] const ExportedView* view_of(const TrialRecord& trial,
                                              const SessionRecord& session,
                                              const Image* image) const;

    /// By study, then by condition: A and B.
    std::unordered_map<std::string, std::unordered_map<std::string, std::array<Image, 2>>> images_;
    const ExportOptions& options_;
    std::unordered_map<std::string, std::string> left_out_;  ///< by the session's name here
};

}  // namespace obscura::analysis
