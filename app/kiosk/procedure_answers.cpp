// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// The questions of a pair, one page each: the choice first, which is the trial.
#include <algorithm>

#include "analysis/questions/answers.h"
#include "app/kiosk/procedure.h"
#include "renderer/base/hash.h"

namespace obscura::app::kiosk {

using stimuli::QuestionKind;

std::string name_of_image(const stimuli::Study& study, int image) {
    if (study.presentation.layout == stimuli::Layout::kSideBySide) {
        // The first is where reading begins.
        const bool is_left = (image == 1) != study.words.right_to_left();
        return study.words(is_left ? "left_image" : "right_image");
    }
    return study.words(image == 1 ? "first_image" : "second_image");
}

std::string label_of(const stimuli::Study& study, const AskedPage& page, int answer) {
    if (page.question != nullptr) {
        const std::string own = page.question->label_of(answer);
        if (!own.empty()) return own;
        if (page.question->is_scale()) return std::to_string(page.question->min + answer);
    }
    return answer < 2 ? name_of_image(study, answer + 1) : study.words("no_difference");
}

AskedPage Procedure::page_at(std::size_t page) const {
    if (pages_.empty()) return {};
    const PageEntry& entry = pages_.at(page);
    return {&plan_.questions.list.at(entry.question), entry.image};
}

std::string Procedure::about(const AskedPage& page, int pair) const {
    if (page.image == 0) return analysis::kAboutPair;
    return (page.image == 1) == plan_.b_first(pair) ? "B" : "A";
}

std::vector<Row> Procedure::answer(int answer, const Moment& now) {
    if (answer < 0 || answer >= asked().answer_count()) return {};
    if (page_ == 0) return choose(answer, now);
    std::vector<Row> rows{answer_record(answer, now)};
    go_on_asking(rows, now);
    return rows;
}

std::vector<Row> Procedure::choose(int answer, const Moment& now) {
    const AskedPage page = asked();
    const bool none = answer == 2;
    const bool first = none ? coin_shows_first() : answer == 0;
    std::vector<Row> rows;
    // Before the trial, so that no trial stands without it.
    if (page.question != nullptr && page.question->kind == QuestionKind::kChoiceOrNone) {
        rows.emplace_back(answer_record(answer, now));
    }
    rows.emplace_back(trial_record(first, now));
    const stimuli::Condition& condition = study_->conditions.at(plan_.condition_of(pair_));
    const bool chose_b = first == plan_.b_first(pair_);
    was_expected_ = chose_b == (condition.expected == 'B');
    if (!none) chose_first_ = first;
    go_on_asking(rows, now);
    return rows;
}

void Procedure::go_on_asking(std::vector<Row>& rows, const Moment& now) {
    if (++page_ < pages_.size()) {
        show(Screen::kQuestion);
        return;
    }
    const stimuli::Condition& condition = study_->conditions.at(plan_.condition_of(pair_));
    ++pair_;
    show(condition.practice && condition.expected != '\0' ? Screen::kFeedback : after_pair());
    if (pair_ == pair_count()) rows.emplace_back(CompleteSession{plan_.session_id, now.utc});
}

bool Procedure::coin_shows_first() const {
    const stimuli::Condition& condition = study_->conditions.at(plan_.condition_of(pair_));
    bool a = false;
    if (condition.expected != '\0') {
        a = condition.expected == 'B';
    } else {
        const std::string& shown = condition.repeats.empty() ? condition.id : condition.repeats;
        const std::string digits = base::sha256_hex(plan_.session_id + '/' + shown);
        a = std::string_view("02468ace").find(digits.back()) != std::string_view::npos;
    }
    return a != plan_.b_first(pair_);
}

analysis::EventRecord Procedure::answer_record(int answer, const Moment& now) const {
    const AskedPage page = asked();
    const stimuli::Question& question = *page.question;
    analysis::QuestionAnswer row;
    row.session_id = plan_.session_id;
    row.trial_index = pair_;
    row.condition = study_->conditions.at(plan_.condition_of(pair_)).id;
    row.question = question.id;
    row.question_kind = std::string(to_string(question.kind));
    row.about = about(page, pair_);
    if (question.is_scale()) {
        row.answer = std::to_string(question.min + answer);
    } else if (answer == 2) {
        row.answer = analysis::kNoDifference;
    } else {
        row.answer = (answer == 0) == plan_.b_first(pair_) ? "B" : "A";
    }
    row.label = label_of(*study_, page, answer);
    row.response_time_s = seen_s(now.time_s);
    row.answered_utc = now.utc;
    return to_event(row);
}

std::optional<std::size_t> Procedure::open_page(
    int trial_index, const std::vector<analysis::EventRecord>& events) const {
    std::vector<analysis::EventRecord> own;
    std::copy_if(events.begin(), events.end(), std::back_inserter(own),
                 [&](const auto& event) { return event.session_id == plan_.session_id; });
    const auto answers = analysis::answers_among(own);
    for (std::size_t page = 1; page < pages_.size(); ++page) {
        const AskedPage asked = page_at(page);
        const std::string image = about(asked, trial_index);
        const bool is_answered = std::any_of(answers.begin(), answers.end(), [&](const auto& one) {
            return one.trial_index == trial_index && one.question == asked.question->id &&
                   one.about == image;
        });
        if (!is_answered) return page;
    }
    return std::nullopt;
}

}  // namespace obscura::app::kiosk
