// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/questions/answers.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using AnswerJson = nlohmann::ordered_json;

QuestionAnswer answer_in(const EventRecord& event) {
    try {
        const AnswerJson json = AnswerJson::parse(event.detail);
        QuestionAnswer answer;
        answer.session_id = event.session_id;
        answer.trial_index = json.at("trial_index").get<int>();
        answer.condition = json.at("condition").get<std::string>();
        answer.question = json.at("question").get<std::string>();
        answer.question_kind = json.at("kind").get<std::string>();
        answer.about = json.at("about").get<std::string>();
        answer.answer = json.at("answer").get<std::string>();
        answer.label = json.at("label").get<std::string>();
        answer.response_time_s = json.at("response_time_s").get<double>();
        answer.answered_utc = event.time_utc;
        return answer;
    } catch (const nlohmann::json::exception& error) {
        throw base::failure("session {} has an event \"{}\" that is none: {}", event.session_id,
                            kAnswerEvent, error.what());
    }
}

}  // namespace

EventRecord to_event(const QuestionAnswer& answer) {
    const AnswerJson json = {{"trial_index", answer.trial_index},
                             {"condition", answer.condition},
                             {"question", answer.question},
                             {"kind", answer.question_kind},
                             {"about", answer.about},
                             {"answer", answer.answer},
                             {"label", answer.label},
                             {"response_time_s", answer.response_time_s}};
    return {answer.session_id, answer.answered_utc, kAnswerEvent, json.dump()};
}

std::vector<QuestionAnswer> answers_among(const std::vector<EventRecord>& events) {
    using Asked = std::tuple<std::string, int, std::string, std::string>;
    std::map<Asked, std::size_t> places;
    std::vector<QuestionAnswer> answers;
    for (const EventRecord& event : events) {
        if (event.name != kAnswerEvent) continue;
        QuestionAnswer answer = answer_in(event);
        const auto [place, is_new] = places.try_emplace(
            Asked{answer.session_id, answer.trial_index, answer.question, answer.about},
            answers.size());
        if (is_new) {
            answers.push_back(std::move(answer));
        } else {
            answers[place->second] = std::move(answer);
        }
    }
    return answers;
}

AskedQuestions asked_questions(std::string_view study_plan) {
    AskedQuestions asked;
    const auto json = AnswerJson::parse(study_plan, nullptr, false);
    if (!json.is_object()) return asked;
    asked.ties = json.value("ties", asked.ties);
    for (const AnswerJson& entry : json.value("questions", AnswerJson::array())) {
        AskedQuestion question{entry.value("id", ""), entry.value("kind", "")};
        question.text = entry.value("text", "");
        question.labels = entry.value("labels", std::vector<std::string>());
        question.each_image = entry.value("of", "") == "images";
        asked.list.push_back(std::move(question));
    }
    return asked;
}

}  // namespace obscura::analysis
