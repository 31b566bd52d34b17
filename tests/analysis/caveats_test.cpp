// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What a report says without being asked, counted over answers and images made here.
#include <gmock/gmock.h>

#include <algorithm>

#include "analysis/conclusions/balance_met.h"
#include "analysis/conclusions/caveats.h"
#include "analysis/presentation/report.h"
#include "analysis/published_votes.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Possible<Attendance> kNobody = Possible<Attendance>::none("only votes are known");

/// Three participants who saw pairs one and two: 1 2, 1 2, 2 1; A first, A first, B first.
Tally three_people() {
    Tally tally;
    tally.study = "tiny";
    tally.kind = Kind::kParticipant;
    tally.n_participants = 3;
    tally.order = OrderVotes{6, 3};
    tally.participants = {{"p1", {}, {}}, {"p2", {}, {}}, {"p3", {}, {}}};
    for (int i = 0; i < 2; ++i) {
        ConditionVotes condition;
        condition.id = i == 0 ? "one" : "two";
        condition.hypothesis = "H1";
        condition.validity = i == 0 ? "low" : "high";
        condition.variant_a = "Crytek24";
        condition.variant_b = i == 0 ? "Blizzard24" : "Blizzard8";
        condition.view = i == 0 ? "relic" : "atrium";
        for (std::int32_t person = 0; person < 3; ++person) {
            const bool is_turned = person == 2;
            condition.answers.push_back({person, true, !is_turned, is_turned ? 1 - i : i, 1.0});
            ++condition.votes.b;
        }
        tally.conditions.push_back(condition);
    }
    return tally;
}

ShownImage image_of(const std::string& condition, char side, const std::string& technique,
                    int samples, const std::string& sha256, double luminance) {
    ShownImage image;
    image.condition = condition;
    image.side = side;
    image.scene = condition == "one" ? "relic" : "atrium";
    image.validity = condition == "one" ? "low" : "high";
    image.scene_id = image.scene + "-lit";
    image.camera = "front";
    image.technique = technique;
    image.samples = samples;
    image.variant = (technique == "crytek" ? "Crytek" : "Blizzard") + std::to_string(samples);
    image.sha256 = sha256;
    image.mean_luminance = luminance;
    image.mean_occlusion = 0.5 - luminance;
    return image;
}

std::vector<ShownImage> four_images() {
    return {image_of("one", 'A', "crytek", 24, "aa", .25),
            image_of("one", 'B', "blizzard", 24, "bb", .125),
            image_of("two", 'A', "crytek", 24, "aa", .25),
            image_of("two", 'B', "blizzard", 8, "cc", .375)};
}

/// The sentence on that; "" where there is none.
std::string sentence_on(const std::vector<Caveat>& caveats, const std::string& about) {
    const auto found = std::find_if(caveats.begin(), caveats.end(),
                                    [&](const Caveat& caveat) { return caveat.about == about; });
    return found == caveats.end() ? "" : found->sentence;
}

TEST(Caveats, CountSidesPlacesAndCarryOver) {
    const auto caveats = caveats_of(analyse(three_people()), four_images(), kNobody);
    EXPECT_THAT(sentence_on(caveats, "Sides"),
                HasSubstr("A was shown first 2 times of 3 and B 1 times, in every pair"));
    EXPECT_THAT(
        sentence_on(caveats, "Places and carry-over"),
        AllOf(HasSubstr("at each place of the session 1 to 2 times (1.5 would be even)"),
              HasSubstr("directly after each other pair 1 to 2 times (1.5 would be even)")));
    const BalanceMet met = balance_met(three_people());
    EXPECT_EQ(met.at_place.low, 1);
    EXPECT_EQ(met.after.high, 2);
}

TEST(Caveats, SayWhereSidesAreNotTheSameInEveryPair) {
    Tally tally = three_people();
    tally.conditions[1].answers[0].b_second = false;
    EXPECT_THAT(
        sentence_on(caveats_of(analyse(tally), {}, kNobody), "Sides"),
        AllOf(HasSubstr("A was shown first 1 to 2 times of 3"), HasSubstr("one 2 : 1, two 1 : 2")));
}

TEST(Caveats, NameWhatDiffersTogether) {
    const auto caveats = caveats_of(analyse(three_people()), four_images(), kNobody);
    EXPECT_THAT(sentence_on(caveats, "Scene with validity"),
                AllOf(HasSubstr("Of 2 views, none is shown at all 2 levels"),
                      HasSubstr("2 at one only: atrium (high) and relic (low)")));
    EXPECT_THAT(sentence_on(caveats, "Technique with its settings"),
                AllOf(HasSubstr("In 1 of 2 pairs"),
                      HasSubstr("two (Crytek24 against Blizzard8) with samples (24 : 8)")));
    EXPECT_THAT(sentence_on(caveats, "Accuracy with darkness"),
                AllOf(HasSubstr("B is the darker image in 1 of 2 pairs"),
                      HasSubstr("one 0.250 : 0.125 (0.250 : 0.375), two 0.250 : 0.375")));
    EXPECT_THAT(sentence_on(caveats, "Images that recur"),
                HasSubstr("One image is in more than one pair: Crytek24 in relic-lit (one, two)"));
    EXPECT_THAT(sentence_on(caveats, "One view a scene"),
                HasSubstr("2 of 2 scenes (atrium and relic) are seen from one camera only"));
}

TEST(Caveats, LeaveOutWhatTheStudyKeepsApart) {
    Tally tally = three_people();
    for (ConditionVotes& condition : tally.conditions) condition.validity = "high";
    std::vector<ShownImage> images = four_images();
    for (ShownImage& image : images) image.validity = "high";
    images[2].sha256 = "dd";
    images[3].samples = 24;
    images[3].variant = "Blizzard24";
    tally.conditions[1].variant_b = "Blizzard24";
    const auto caveats = caveats_of(analyse(tally), images, kNobody);
    EXPECT_EQ(sentence_on(caveats, "Scene with validity"), "");
    EXPECT_EQ(sentence_on(caveats, "Technique with its settings"), "");
    EXPECT_EQ(sentence_on(caveats, "Images that recur"), "");
}

TEST(Caveats, SayWhatIsKnownOfTheDisplayAndWhatIsNot) {
    Attendance attendance;
    attendance.displays = {{"Eizo 1920x1080 59 Hz", 2}, {"", 1}};
    attendance.unknown_refresh = 1;
    EXPECT_THAT(sentence_on(caveats_of(analyse(three_people()), {}, attendance), "Display"),
                AllOf(HasSubstr("2 displays in 3 completed sessions"),
                      HasSubstr("Eizo 1920x1080 59 Hz in 2 sessions"), HasSubstr("not known in 1"),
                      HasSubstr("distance")));
    EXPECT_THAT(sentence_on(caveats_of(analyse(three_people()), {}, kNobody), "Display"),
                HasSubstr("only votes are known"));
}

TEST(Caveats, OfCountsAloneSayWhyNothingCanBeCounted) {
    const auto caveats = caveats_of(analyse(published_votes()), {}, kNobody);
    EXPECT_THAT(sentence_on(caveats, "Sides"), HasSubstr("not known"));
    EXPECT_THAT(sentence_on(caveats, "Places and carry-over"), HasSubstr("not known"));
    EXPECT_THAT(sentence_on(caveats, "Scene with validity"), HasSubstr("the dragon (low)"));
}

TEST(Caveats, StandInABoxOfTheReportAndInItsText) {
    ReportInput input;
    input.analysis = analyse(three_people());
    input.images = four_images();
    const auto files = report_files(input);
    const auto bytes = [&](const std::string& name) {
        const auto found = std::find_if(files.begin(), files.end(),
                                        [&](const ReportFile& file) { return file.name == name; });
        return found == files.end() ? std::string() : found->bytes;
    };
    EXPECT_THAT(bytes("report.html"),
                AllOf(HasSubstr("<aside class=\"box\">"), HasSubstr("B is the darker image in 1")));
    EXPECT_THAT(bytes("report.md"), HasSubstr("- Sides: A was shown first 2 times"));
    EXPECT_THAT(bytes("analysis.txt"), HasSubstr("B is the darker image in 1 of 2 pairs"));
}

}  // namespace
}  // namespace obscura::analysis
