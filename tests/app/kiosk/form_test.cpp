// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What a study asks before the instructions: information, consent, its own form, a code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/kiosk/form_answers.h"
#include "tests/app/kiosk/script.h"

namespace obscura::app::kiosk {
namespace {

using stimuli::FieldKind;
using stimuli::FormField;
using testing::IsEmpty;

stimuli::Study asking_study() {
    stimuli::Study study = small_study(2);
    study.information = "What this is about.";
    study.consent = stimuli::Consent{"2026-11", "Text", {"I agree to take part", "I am 18"}};
    study.form = {
        {.id = "code", .kind = FieldKind::kCode, .label = "Code", .required = true},
        {.id = "age", .kind = FieldKind::kNumber, .label = "Age", .min = 18, .max = 99},
        {.id = "gender", .kind = FieldKind::kText, .label = "Gender"},
        {.id = "games", .kind = FieldKind::kChoices, .label = "Plays", .choices = {"chess", "go"}}};
    return study;
}

Form answered(const std::string& code, const std::string& age) {
    Form form;
    form.fields = {{code, {}}, {age, {}}, {" woman ", {}}, {"", {"go"}}};
    return form;
}

/// Information, consent, and the form in sight.
void reach_form(Script& script) {
    script.shown_at(0);
    script.at(1, StartPressed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInformation);
    script.shown_at(2);
    script.at(3, ConsentGiven{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInformation) << "nothing is passed over";
    script.at(4, InformationRead{});
    EXPECT_EQ(script.procedure.screen(), Screen::kConsent);
    script.shown_at(5);
    script.at(6, ConsentGiven{});
    EXPECT_EQ(script.procedure.screen(), Screen::kForm);
    script.shown_at(7);
}

TEST(StudyForm, WhatIsAgreedToAndAnsweredIsStoredWithVersionAndTime) {
    const stimuli::Study study = asking_study();
    Script script(study);
    reach_form(script);
    script.at(8, FormSubmitted{answered("K7", "41")});
    EXPECT_EQ(script.procedure.screen(), Screen::kInstructions);
    const auto begun = script.rows_of<BeginSession>();
    ASSERT_EQ(begun.size(), 1U);
    const analysis::ParticipantRecord& stored = begun.front().participant;
    EXPECT_TRUE(stored.consent);
    EXPECT_EQ(stored.consent_version, "2026-11");
    EXPECT_EQ(stored.consent_items, R"(["I agree to take part","I am 18"])");
    EXPECT_EQ(stored.consent_utc, "t6");
    EXPECT_EQ(stored.created_utc, "t8");
    EXPECT_EQ(stored.code, "K7");
    EXPECT_EQ(stored.age_years, 41);
    EXPECT_EQ(stored.gender, "woman");
    const auto form = nlohmann::json::parse(stored.form);
    ASSERT_EQ(form.size(), 4U);
    EXPECT_EQ(form[0]["value"], "K7");
    EXPECT_EQ(form[1]["value"], 41);
    EXPECT_EQ(form[1]["label"], "Age");
    EXPECT_EQ(form[3]["value"], nlohmann::json::array({"go"}));
}

TEST(StudyForm, AFormThatLacksWhatIsRequiredStaysAndNothingIsStored) {
    const stimuli::Study study = asking_study();
    for (const Form& form : {answered("", "41"), answered("K7", "17"), answered("K7", "old")}) {
        Script script(study);
        reach_form(script);
        script.at(8, FormSubmitted{form});
        EXPECT_EQ(script.procedure.screen(), Screen::kForm);
        EXPECT_THAT(script.rows, IsEmpty());
    }
}

TEST(StudyForm, ACodeThatTookPartBeforeIsSaidAndOnlyTheOperatorGoesOnWithIt) {
    const stimuli::Study study = asking_study();
    SessionPlan plan = small_plan(study);
    plan.known_codes = {"k7", "A1"};
    Script script(study, plan);
    reach_form(script);
    script.at(8, FormSubmitted{answered("K7", "41")});
    EXPECT_EQ(script.procedure.screen(), Screen::kKnownCode);
    EXPECT_EQ(script.procedure.known_code(), "K7");
    EXPECT_THAT(script.rows, IsEmpty());
    script.shown_at(9);
    script.at(10, CodeTakenBack{});
    EXPECT_EQ(script.procedure.screen(), Screen::kForm);
    script.shown_at(11);
    script.at(12, FormSubmitted{answered("K7", "41")});
    script.shown_at(13);
    script.at(14, CodeConfirmed{});
    EXPECT_EQ(script.procedure.screen(), Screen::kInstructions);
    const auto begun = script.rows_of<BeginSession>();
    ASSERT_EQ(begun.size(), 1U);
    ASSERT_EQ(begun.front().events.size(), 2U);
    EXPECT_EQ(begun.front().events[1].name, "code known");
    Script other(study, plan);
    reach_form(other);
    other.at(8, FormSubmitted{answered("K8", "")});
    EXPECT_EQ(other.procedure.screen(), Screen::kInstructions) << "age may be left out";
}

TEST(StudyForm, NumbersAreTakenWithPointOrCommaAndNothingElse) {
    EXPECT_EQ(number_in(" 1.5 "), 1.5);
    EXPECT_EQ(number_in("1,5"), 1.5);
    EXPECT_EQ(number_in("-3"), -3.0);
    for (const char* text :
         {"", " ", "1,000.5", "1 2", "inf", "nan", "0x1F", "1e999", "ten", "1.", "--1"}) {
        if (std::string(text) == "1.") continue;  // as typed half way
        EXPECT_EQ(number_in(text), std::nullopt) << text;
    }
    FormField scale{.id = "s", .kind = FieldKind::kScale, .label = "", .min = 1, .max = 7};
    EXPECT_EQ(problem_of(scale, {"7", {}}), FieldProblem::kNone);
    EXPECT_EQ(problem_of(scale, {"8", {}}), FieldProblem::kOutOfRange);
    EXPECT_EQ(problem_of(scale, {"", {}}), FieldProblem::kNone);
    scale.required = true;
    EXPECT_EQ(problem_of(scale, {" ", {}}), FieldProblem::kMissing);
}

TEST(StudyForm, WhatWasAskedIsStoredBesideTheAnswer) {
    const std::vector<FormField> fields{
        {.id = "games",
         .kind = FieldKind::kScale,
         .label = "Plays",
         .min = 1,
         .max = 7,
         .labels = {"never", "daily"}},
        {.id = "hand", .kind = FieldKind::kChoice, .label = "Hand", .choices = {"left", "right"}}};
    EXPECT_EQ(form_json(fields, {{"3", {}}, {"left", {}}}),
              R"([{"field":"games","kind":"scale","label":"Plays",)"
              R"("levels":{"1":"never","7":"daily"},"value":3},)"
              R"({"field":"hand","kind":"choice","label":"Hand",)"
              R"("choices":["left","right"],"value":"left"}])");
}

TEST(StudyForm, AMadeCodeIsOfSixSignsThatAreNotMistakenAndIsNoneThatIsKnown) {
    std::vector<std::string> known;
    for (int i = 0; i < 200; ++i) {
        const std::string code = make_code(known);
        EXPECT_EQ(code.size(), 6U);
        EXPECT_EQ(code.find_first_of("ILOU"), std::string::npos);
        for (const std::string& other : known) EXPECT_FALSE(is_same_code(code, other));
        known.push_back(code);
    }
}

}  // namespace
}  // namespace obscura::app::kiosk
