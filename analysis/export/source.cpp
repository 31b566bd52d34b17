// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/source.h"

#include <fmt/format.h>

#include <numeric>
#include <utility>

#include "renderer/base/random.h"

namespace obscura::analysis {

ExportSource::ExportSource(Store& store, const ExportOptions& options)
    : store_(store),
      anonymous_(options.anonymous_seed.has_value()),
      options_(options),
      left_out_(options.left_out) {
    for (const ExportedStudy& study : options.studies) {
        auto& of_study = images_[study.name];
        for (const ExportedImage& image : study.images) {
            of_study[image.condition][image.side == 'A' ? 0 : 1] = {
                image.sha256, study.name + '/' + image.file, {image.scene_source, image.camera}};
        }
    }
    if (anonymous_) read_all(*options.anonymous_seed);
}

void ExportSource::read_all(std::uint64_t seed) {
    std::vector<ParticipantRecord> participants = store_.participants();
    std::vector<SessionRecord> sessions = store_.sessions();
    std::vector<std::size_t> order(participants.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    left_out_.clear();
    base::Random random(seed);
    random.shuffle(order);
    std::unordered_map<std::string, std::vector<SessionRecord*>> of_participant;
    for (SessionRecord& session : sessions) {
        of_participant[session.participant_id].push_back(&session);
    }
    const int digits = static_cast<int>(std::to_string(participants.size()).size());
    for (const std::size_t place : order) {
        ParticipantRecord& participant = participants_.emplace_back(std::move(participants[place]));
        const auto own = of_participant.find(participant.participant_id);
        participant.participant_id = fmt::format("p{:0{}}", participants_.size(), digits);
        if (own == of_participant.end()) continue;
        for (SessionRecord* session : own->second) {
            session_ids_.push_back(std::move(session->session_id));
            session->session_id = fmt::format("s{:0{}}", sessions_.size() + 1, digits);
            if (const auto known = options_.left_out.find(session_ids_.back());
                known != options_.left_out.end()) {
                left_out_[session->session_id] = known->second;
            }
            session->participant_id = participant.participant_id;
            sessions_.push_back(std::move(*session));
        }
    }
}

void ExportSource::each_participant(const std::function<void(const ParticipantRecord&)>& take) {
    if (!anonymous_) return store_.each_participant(take);
    for (const ParticipantRecord& participant : participants_) take(participant);
}

void ExportSource::each_with_events(
    const std::function<void(const SessionRecord&, const std::vector<EventRecord>&)>& take) {
    if (!anonymous_) return store_.each_session_with_events(take);
    for (std::size_t i = 0; i < sessions_.size(); ++i) {
        std::vector<EventRecord> events = store_.events_of(session_ids_[i]);
        for (EventRecord& event : events) event.session_id = sessions_[i].session_id;
        take(sessions_[i], events);
    }
}

void ExportSource::each_session(const std::function<void(const SessionRow&)>& take) {
    each_with_events([&](const SessionRecord& session, const std::vector<EventRecord>& all) {
        std::vector<EventRecord> events;
        std::vector<EventRecord> answers;
        for (const EventRecord& event : all) {
            (event.name == kAnswerEvent ? answers : events).push_back(event);
        }
        take({&session, &events, &answers});
    });
}

void ExportSource::each_asked(const std::function<void(const AskedQuestions&)>& take) {
    const auto one = [&](const SessionRecord& session) {
        const AskedQuestions asked = asked_questions(session.study_plan);
        if (!asked.list.empty()) take(asked);
    };
    if (!anonymous_) return store_.each_session(one);
    for (const SessionRecord& session : sessions_) one(session);
}

bool ExportSource::has_questions() {
    bool any = false;
    each_asked([&](const AskedQuestions&) { any = true; });
    return any;
}

void ExportSource::each_answer(
    const std::function<void(const QuestionAnswer&, const SessionRecord&)>& take) {
    each_session([&](const SessionRow& row) {
        for (const QuestionAnswer& answer : answers_among(*row.answers)) take(answer, *row.session);
    });
}

std::set<int> ExportSource::without_difference(const std::string& session_id,
                                               const std::string& first) {
    std::set<int> pairs;
    for (const QuestionAnswer& answer : answers_among(store_.events_of(session_id))) {
        if (answer.question == first && answer.answer == kNoDifference) {
            pairs.insert(answer.trial_index);
        }
    }
    return pairs;
}

void ExportSource::each_event(const std::function<void(const EventRow&)>& take) {
    for (const EventRecord& event : store_.other_events()) take({&event, nullptr});
    each_session([&](const SessionRow& row) {
        for (const EventRecord& event : *row.events) take({&event, row.session});
    });
}

void ExportSource::each_trial(const std::function<void(const TrialRow&)>& take,
                              Exported& exported) {
    std::string session_id;
    std::optional<std::set<int>> ties;
    const auto row = [&](const TrialRecord& trial, const SessionRecord& session,
                         const std::string& in_store) {
        if (in_store != session_id) {
            session_id = in_store;
            ties.reset();
            const AskedQuestions asked = asked_questions(session.study_plan);
            if (asked.first_has_ties()) {
                ties = without_difference(in_store, asked.list.front().id);
            }
        }
        const Image* const first = image_of(trial, session, true);
        const Image* const second = image_of(trial, session, false);
        if (first == nullptr || second == nullptr) ++exported.unknown_images;
        const auto left_out = left_out_.find(session.session_id);
        take({&trial, &session, ++exported.trials, first == nullptr ? nullptr : &first->file,
              second == nullptr ? nullptr : &second->file,
              left_out == left_out_.end() ? nullptr : &left_out->second,
              view_of(trial, session, first != nullptr ? first : second),
              ties ? std::optional<bool>(ties->contains(trial.trial_index)) : std::nullopt});
    };
    if (!anonymous_) {
        return store_.each_trial([&](const TrialRecord& trial, const SessionRecord& session) {
            row(trial, session, session.session_id);
        });
    }
    for (std::size_t i = 0; i < sessions_.size(); ++i) {
        for (TrialRecord& trial : store_.trials_of(session_ids_[i])) {
            trial.session_id = sessions_[i].session_id;
            row(trial, sessions_[i], session_ids_[i]);
        }
    }
}

const ExportSource::Image* ExportSource::image_of(const TrialRecord& trial,
                                                  const SessionRecord& session, bool first) const {
    const auto study = images_.find(session.study);
    if (study == images_.end()) return nullptr;
    const auto condition = study->second.find(trial.condition);
    if (condition == study->second.end()) return nullptr;
    const bool is_A = (trial.first_shown == 'A') == first;
    const Image& image = condition->second[is_A ? 0 : 1];
    return image.sha256 == (first ? trial.first_sha256 : trial.second_sha256) ? &image : nullptr;
}

const ExportedView* ExportSource::view_of(const TrialRecord& trial, const SessionRecord& session,
                                          const Image* image) const {
    if (image != nullptr && !image->view.scene_source.empty()) return &image->view;
    for (const ExportedStudy& study : options_.studies) {
        if (study.name != session.study || study.sha256 != session.study_sha256) continue;
        const auto view = study.views.find(trial.scene);
        return view == study.views.end() ? nullptr : &view->second;
    }
    return nullptr;
}

}  // namespace obscura::analysis
