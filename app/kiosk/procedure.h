// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "analysis/store/records.h"
#include "app/kiosk/form_answers.h"
#include "app/kiosk/session_plan.h"
#include "stimuli/study.h"

namespace obscura::app::kiosk {

/// What is to be on the screen.
enum class Screen {
    kStart,         ///< waits for a participant
    kInformation,   ///< the study's text before all else, where it has one
    kConsent,       ///< what the participant agrees to, where the study has it on a page of its own
    kForm,          ///< who takes part
    kKnownCode,     ///< a code that took part before: the operator decides
    kInstructions,  ///< the study's text
    kPairs,         ///< one button for each pair, of which only the next is enabled; or just that
    kFirstImage,
    kInterval,  ///< between the two images; nothing shortens it
    kSecondImage,
    kBothImages,    ///< in place of these three, where they are shown side by side
    kQuestion,      ///< which of the two? And what else the study asks, one page each
    kFeedback,      ///< whether the answer to a pair of practice was the expected one
    kPracticeOver,  ///< from now on it counts
    kBreak,
    kThanks,        ///< the session is complete
    kConfirmLeave,  ///< the operator asked to leave
    kDone,          ///< the participant is done: the next one gets a new Procedure
    kLeft,          ///< the operator left: the program ends
};

/// What the participant filled in.
struct Form {
    std::vector<FieldAnswer> fields = {};  ///< in the order of the study's own, where it has them
    std::optional<int> age_years = {};
    std::string gender = {};  ///< free text, or kRatherNotSayStored; empty: no answer
    std::optional<bool> normal_vision = {};
    std::optional<bool> naive = {};
    bool consent = false;
};
/// What the store keeps where someone chose not to say.
inline constexpr const char* kRatherNotSayStored = "rather not say";
inline constexpr int kYoungest_years = 1;
inline constexpr int kOldest_years = 120;

/// What keeps the form from being accepted. Of the kiosk's own an age from 1 to 120 is needed, of a
/// study's own what it requires; and the consent, unless that has a page of its own.
struct FormProblems {
    bool age = false;
    bool fields = false;  ///< any of the study's
    bool consent = false;
    [[nodiscard]] bool none() const { return !age && !fields && !consent; }
};
[[nodiscard]] FormProblems problems_of(const Form& form, const stimuli::Study& study);

// What can happen. An event that the screen has no use for is ignored.
struct StartPressed {};
struct InformationRead {};
struct ConsentGiven {};  ///< to each of its items
/// The code on the form was a mistake.
struct CodeTakenBack {};
/// The operator goes on with a code that took part before.
struct CodeConfirmed {};
struct FormSubmitted {
    Form form;
};
struct InstructionsRead {};
struct PairPressed {
    int pair = 0;  ///< as Progress counts them
};
struct SpacePressed {};  ///< or what else the study lets end the look at an image
struct Answered {
    bool first = false;  ///< the image shown first was chosen
};
/// An answer of the question on the screen, of which Answered is the first or the second.
struct AnswerPressed {
    int answer = 0;  ///< from 0, in the order of the question's labels
};
/// From feedback, the end of practice or a break.
struct WentOn {};
struct NextParticipant {};
/// The first frame of the screen asked for last is visible.
struct ScreenPresented {
    int dropped_frames = 0;   ///< whole refresh periods by which it came too late
    bool end_in_view = true;  ///< nothing of the page is left to scroll to
};
/// The end of a page that is taller than the window has come into view.
struct EndSeen {};
/// Time passes. A screen asked for now would be visible at `expected_onset_s`.
struct Tick {
    double expected_onset_s = 0.0;
};
/// From now on the screen is not to be seen whole and in front, or takes no input.
struct ScreenHidden {
    std::string why;  ///< the event's name: lost focus, iconified, covered, resized, monitor lost
};
/// It is to be seen again, and to be shown anew.
struct ScreenSeen {};
struct LeaveRequested {};
struct LeaveConfirmed {};
struct LeaveCancelled {};
using Event =
    std::variant<StartPressed, InformationRead, ConsentGiven, CodeTakenBack, CodeConfirmed,
                 FormSubmitted, InstructionsRead, PairPressed, SpacePressed, Answered,
                 AnswerPressed, WentOn, NextParticipant, ScreenPresented, EndSeen, Tick,
                 ScreenHidden, ScreenSeen, LeaveRequested, LeaveConfirmed, LeaveCancelled>;

/// When an event happened.
struct Moment {
    double time_s = 0.0;  ///< one monotonic clock
    std::string utc;      ///< ISO 8601 with Z
    /// When the key or button went down that made it happen; a click happens when it goes up.
    double pressed_s = time_s;
};

/// The event that tells that the instructions were read.
inline constexpr const char* kInstructionsReadEvent = "instructions read";

// What must be on the disk before the next screen is shown.
struct BeginSession {
    analysis::ParticipantRecord participant;
    analysis::SessionRecord session;
    std::vector<analysis::EventRecord> events;  ///< in the same transaction
};
struct CompleteSession {
    std::string session_id;
    std::string ended_utc;
};
using Row =
    std::variant<BeginSession, analysis::TrialRecord, CompleteSession, analysis::EventRecord>;

/// Where a participant is in the pairs, as the pages say it: in practice or in what counts.
struct Progress {
    int pair = 0;  ///< next or being shown, from 0
    int count = 0;
    bool practice = false;
};

/// A page of the questions of a pair.
struct AskedPage {
    const stimuli::Question* question = nullptr;  ///< nullptr: the study's one question, a choice
    int image = 0;  ///< that it is about: 1 the first shown, 2 the second; 0: the pair
    [[nodiscard]] int answer_count() const {
        return question == nullptr ? 2 : question->answer_count();
    }
};
/// What stands on that answer's button, in the study's words or the kiosk's; a step of a scale
/// without words of its own is its number.
[[nodiscard]] std::string label_of(const stimuli::Study& study, const AskedPage& page, int answer);
/// The words for one of the two images by its place, from 1: first and second, or where they were
/// side by side left and right.
[[nodiscard]] std::string name_of_image(const stimuli::Study& study, int image);

/// One participant's way through a study, as in Jakobsen 2010, 5.4 and appendix D unless the study
/// says otherwise: form, instructions, and for each pair its button, the first image until space,
/// the grey interval, the second image until space, the question. Practice comes before the pairs
/// that count, breaks between them. There is no way back to an image.
///
/// It knows no window, clock or database. Events go in; out come the rows to commit, and then the
/// screen to show. Nothing a participant does counts before the screen is visible
/// (ScreenPresented) and its end was in view, nor what was pressed before the study's input delay
/// after that; and no event counts that is stamped earlier than one already taken, so no time in a
/// row is ever negative. While a screen is hidden nothing is taken but the operator's wish to
/// leave. Time that the operator's question covers a screen, or that it is hidden, is no viewing or
/// response time but the trial's hidden_ms; a grey interval it interrupts starts anew.
class Procedure {
  public:
    /// A new participant. `study` must outlive the procedure.
    Procedure(const stimuli::Study& study, SessionPlan plan);

    /// Takes an event and gives the rows to commit, in this order, before screen() is shown.
    [[nodiscard]] std::vector<Row> step(const Event& event, const Moment& now);

    /// Continues a session that was cut off, at the first pair without an answer; gives its rows.
    /// The instructions come first unless they were read and a pair was answered.
    /// `answered` holds its trials so far, from index 0 without a gap; `events` may hold more than
    /// its own, and of the last pair only those questions are asked that none of them answers;
    /// `elapsed_s` is the time since the session began. Throws bad input when the trials are not
    /// those of the plan.
    [[nodiscard]] std::vector<Row> resume(const std::vector<analysis::TrialRecord>& answered,
                                          bool instructions_read, double elapsed_s,
                                          const Moment& now,
                                          const std::vector<analysis::EventRecord>& events = {});

    /// Takes another order of the same conditions, for a session of which no pair was shown yet.
    void change_order(stimuli::SessionOrder order);

    [[nodiscard]] Screen screen() const { return screen_; }
    /// Grows by one whenever screen() is to be shown (again): ScreenPresented is due.
    [[nodiscard]] int request() const { return request_; }
    /// Whether the end of the visible screen was in view.
    [[nodiscard]] bool end_seen() const { return end_seen_; }
    /// The screen takes what is pressed from then on; nothing before it is visible. The operator's
    /// wish to leave is taken at any time.
    [[nodiscard]] double takes_presses_from_s() const { return takes_presses_from_s_; }
    /// The code that took part before, on the screen kKnownCode.
    [[nodiscard]] std::string known_code() const {
        return code_in(study_->form, submitted_.fields);
    }
    /// The pair that is next or being shown, from 0, practice first; pair_count() after the last.
    [[nodiscard]] int pair() const { return pair_; }
    [[nodiscard]] int pair_count() const { return plan_.pair_count(); }
    [[nodiscard]] Progress progress() const;
    /// On the screen kQuestion: what is asked.
    [[nodiscard]] AskedPage asked() const { return page_at(page_); }
    /// Its number among the pages of a pair, from 0.
    [[nodiscard]] int page() const { return static_cast<int>(page_); }
    /// On its later pages: whether the image shown first was chosen on the first; nothing: no
    /// difference was seen, or the choice was made before the session was cut off.
    [[nodiscard]] std::optional<bool> chose_first() const { return chose_first_; }
    /// On the screen kFeedback: whether the answer was the expected one.
    [[nodiscard]] bool was_expected() const { return was_expected_; }
    /// Whether the session has begun and is not complete.
    [[nodiscard]] bool session_open() const { return began_ && pair_ < pair_count(); }
    /// Whether the screen is hidden; it is shown, and ScreenPresented due, only after ScreenSeen.
    /// The operator's question is shown all the same.
    [[nodiscard]] bool hidden() const { return !hidden_why_.empty(); }
    /// The image of that pair shown first (position 0) or second (position 1).
    [[nodiscard]] const StimulusImage& image(int pair, int position) const;
    /// While the visible screen goes by itself, as the interval does: when the next one is due to
    /// be visible.
    [[nodiscard]] std::optional<double> next_due_s() const;
    /// The screen that comes after such a one.
    [[nodiscard]] Screen next_in_pair() const;
    [[nodiscard]] const SessionPlan& plan() const { return plan_; }
    /// The study's own questions on the form.
    [[nodiscard]] const std::vector<stimuli::FormField>& fields() const { return study_->form; }

  private:
    /// What is known of the trial under way.
    struct Trial {
        double first_onset_s = 0.0;
        double interval_onset_s = 0.0;
        double second_onset_s = 0.0;
        double question_onset_s = 0.0;
        double first_view_s = 0.0;
        double second_view_s = 0.0;
        double hidden_s = 0.0;
        int dropped_frames = 0;
    };

    void show(Screen screen);
    /// How long the screen is to be seen before it takes anything.
    [[nodiscard]] double least_seen_s() const;
    void presented(const ScreenPresented& event, double time_s);
    /// The screen is visible for the first time.
    void note_onset(double time_s);
    void end_came_into_view(double time_s);
    [[nodiscard]] bool takes(const Moment& pressed) const;
    std::vector<Row> participant_did(const Event& event, const Moment& now);
    std::vector<Row> submit(const Form& form, const Moment& now);
    std::vector<Row> begin(const Form& form, const Moment& now);
    // procedure_rows.cpp: what the rows say.
    [[nodiscard]] analysis::ParticipantRecord participant_record(const Form& form,
                                                                 const Moment& now) const;
    [[nodiscard]] analysis::SessionRecord session_record(const Moment& now) const;
    [[nodiscard]] Screen after(Screen screen) const;
    void begin_pair();
    /// The image on the screen is left for the next screen of the pair.
    void leave_image(double seen_s);
    void time_passed(double expected_onset_s);
    // procedure_answers.cpp: the questions of a pair.
    std::vector<Row> answer(int answer, const Moment& now);
    [[nodiscard]] AskedPage page_at(std::size_t page) const;
    /// What an answer of a page is about: pair, A or B.
    [[nodiscard]] std::string about(const AskedPage& page, int pair) const;
    /// On the first page: which image was chosen.
    std::vector<Row> choose(int answer, const Moment& now);
    /// To the next page, or on from the pair.
    void go_on_asking(std::vector<Row>& rows, const Moment& now);
    /// The page of the last answered pair that is still to be answered; nothing: none is.
    [[nodiscard]] std::optional<std::size_t> open_page(
        int trial_index, const std::vector<analysis::EventRecord>& events) const;
    /// For which image an answer without a difference counts in the trial's row: in an attention
    /// check the one that was not expected, else by a coin that session and condition fix, the same
    /// for a pair and what repeats it.
    [[nodiscard]] bool coin_shows_first() const;
    [[nodiscard]] analysis::EventRecord answer_record(int answer, const Moment& now) const;
    /// After an answer or its feedback.
    [[nodiscard]] Screen after_pair() const;
    std::vector<Row> end_break(const Moment& now);
    std::vector<Row> hide(const std::string& why, const Moment& now);
    std::vector<Row> see_again(const Moment& now);
    /// The screen ceases to be visible until it is presented again.
    void go_out_of_sight(double time_s);
    std::vector<Row> request_leave(const Moment& now);
    std::vector<Row> decide_leave(bool leave, const Moment& now);
    [[nodiscard]] analysis::TrialRecord trial_record(bool first, const Moment& now) const;
    [[nodiscard]] analysis::EventRecord event_record(std::string name, std::string detail,
                                                     const Moment& now) const;
    [[nodiscard]] std::string place() const;
    /// How long the participant has seen the screen, without what covered or hid it.
    [[nodiscard]] double seen_s(double time_s) const {
        return seen_before_s_ + (visible_ ? time_s - since_s_ : 0.0);
    }

    const stimuli::Study* study_;
    SessionPlan plan_;
    Screen screen_ = Screen::kStart;
    Screen covered_ = Screen::kStart;  ///< what the operator's question covers
    bool covered_first_time_ = true;   ///< that was not visible before
    int request_ = 1;
    bool visible_ = false;
    bool first_time_ = true;  ///< this screen has not been visible before
    double since_s_ = 0.0;    ///< visible without a break since then
    bool end_seen_ = false;
    double takes_presses_from_s_ = std::numeric_limits<double>::infinity();
    double seen_before_s_ = 0.0;
    std::optional<double> gone_since_s_;  ///< hidden or covered since then
    std::string hidden_why_;              ///< empty: not hidden
    double hidden_since_s_ = 0.0;
    double latest_s_;          ///< of all events taken
    Form submitted_;           ///< what the operator is asked about
    std::string consent_utc_;  ///< when it was given on its page
    bool began_ = false;
    double began_s_ = 0.0;
    int pair_ = 0;
    /// A page by the number of its question in the plan's list, and AskedPage::image.
    struct PageEntry {
        std::size_t question = 0;
        int image = 0;
    };
    std::vector<PageEntry> pages_;  ///< of each pair; none: the choice alone
    std::size_t page_ = 0;          ///< the one on the screen
    std::optional<bool> chose_first_;
    bool was_expected_ = false;
    /// Since when the image that just went by itself was seen; nothing: none did, or it was hidden.
    std::optional<double> went_by_itself_s_;
    Trial trial_;
};

}  // namespace obscura::app::kiosk
