// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "analysis/conclusions/published_study.h"
#include "analysis/conclusions/words.h"
#include "analysis/presentation/report_parts.h"

namespace obscura::analysis {
namespace {

using People = std::vector<ParticipantRecord>;

std::string age_words(const People& people) {
    std::vector<int> ages;
    for (const ParticipantRecord& person : people) {
        if (person.age_years) ages.push_back(*person.age_years);
    }
    if (ages.empty()) return "not asked";
    std::sort(ages.begin(), ages.end());
    const std::size_t half = ages.size() / 2;
    const double median = ages.size() % 2 == 1 ? ages[half] : (ages[half - 1] + ages[half]) / 2.0;
    const std::size_t unknown = people.size() - ages.size();
    return fmt::format("{} to {} years, median {:g}{}", ages.front(), ages.back(), median,
                       unknown == 0 ? "" : fmt::format(" ({} not said)", unknown));
}

std::string gender_words(const People& people) {
    std::map<std::string, int> counts;
    for (const ParticipantRecord& person : people)
        ++counts[person.gender.empty() ? "no answer" : person.gender];
    std::string text;
    for (const auto& [gender, count] : counts) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, gender);
    }
    return text;
}

std::string yes_no_words(const People& people, std::optional<bool> ParticipantRecord::*member) {
    int yes = 0;
    int no = 0;
    for (const ParticipantRecord& person : people) {
        if (!(person.*member)) continue;
        ++(*(person.*member) ? yes : no);
    }
    const auto unknown = static_cast<int>(people.size()) - yes - no;
    std::string text = fmt::format("{} yes, {} no", yes, no);
    if (unknown > 0) text += fmt::format(", {} not said", unknown);
    return text;
}

std::string sessions_words(const Attendance& attendance) {
    const auto count = [&](SessionState state) {
        const auto found = attendance.sessions.find(state);
        return found == attendance.sessions.end() ? 0 : found->second;
    };
    return fmt::format("{} completed, {} broken off, {} open", count(SessionState::kCompleted),
                       count(SessionState::kAbandoned), count(SessionState::kOpen));
}

}  // namespace

void add_participants(ReportDraft& draft) {
    const ReportInput& input = draft.input;
    const Tally& tally = input.analysis.tally;
    draft.page.heading("Who took part");
    if (tally.n_participants.has_value()) {
        draft.page.paragraph(
            fmt::format("{} answered. {}", who(tally, *tally.n_participants),
                        tally.kind == Kind::kSimulated ? "They are programs, not people."
                        : tally.kind == Kind::kParticipant
                            ? "Practice, catch and simulated answers are not among them."
                            : ""));
    } else {
        draft.page.paragraph(
            fmt::format("How many people answered is not known: {}.", tally.n_participants.reason));
    }
    if (is_published_votes(tally)) {
        draft.page.paragraph(published_participants());
        return;
    }
    if (!input.attendance.has_value()) {
        draft.page.paragraph(fmt::format("Nothing is known of their age, gender and vision: {}.",
                                         input.attendance.reason));
        return;
    }
    const People& people = input.attendance->completed;
    draft.page.table(
        {{"", "Participants"},
         {{"Sessions", sessions_words(*input.attendance)},
          {"Age", age_words(people)},
          {"Gender", gender_words(people)},
          {"Normal or corrected vision", yes_no_words(people, &ParticipantRecord::normal_vision)},
          {"Naive to the purpose", yes_no_words(people, &ParticipantRecord::naive)}}},
        fmt::format("What the {} who completed a session said of themselves. Answers of sessions "
                    "that were broken off are not analysed.",
                    who(tally, static_cast<std::int64_t>(people.size()))));
}

}  // namespace obscura::analysis
