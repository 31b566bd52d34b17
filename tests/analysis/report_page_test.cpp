// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "analysis/conclusions/published_study.h"
#include "analysis/counts_file.h"
#include "analysis/presentation/report.h"
#include "analysis/published_votes.h"
#include "renderer/base/error.h"
#include "tests/analysis/records_for_test.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kPageHeader =
    "condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n";

ReportInput input_of(const Tally& tally) {
    ReportInput input;
    input.analysis = analyse(tally);
    input.images_unknown = "there is no manifest.json";
    input.measurement_unknown = "there is no measure.csv";
    return input;
}

std::string file_of(const std::vector<ReportFile>& files, const std::string& name) {
    const auto found = std::find_if(files.begin(), files.end(),
                                    [&](const ReportFile& file) { return file.name == name; });
    if (found == files.end()) ADD_FAILURE() << name << " is not in the report";
    return found == files.end() ? "" : found->bytes;
}

TEST(Report, OfThePublishedVotesGivesTable4AndWhatTheThesisDidNotSay) {
    const auto files = report_files(input_of(published_votes()));
    const std::string page = file_of(files, "report.md");
    // The values of R 4.2.2 that the analysis is held against, as a reader sees them.
    EXPECT_THAT(page,
                AllOf(HasSubstr("| III | Crytek24 | Blizzard24 | 11 : 25 | 5.444 | 0.020 | "
                                "5.445 | 0.019 | 0.137 | 0.029 | 0.202 |"),
                      HasSubstr("| II | None | Blizzard24 | 14 : 22 | 1.778 | 0.182 | 1.778 | "
                                "0.182 | 0.912 | 0.243 |"),
                      HasSubstr("| VII | None | Blizzard24 | 21 : 15 | 1.000 | 0.317 | 1 | "
                                "0.317 |")));
    EXPECT_THAT(page, AllOf(HasSubstr("none shows a preference that stays significant"),
                            HasSubstr("Nothing stays significant after correcting for seven tests"),
                            HasSubstr("Over all three levels it gives p = .158"),
                            HasSubstr("p = .093 between moderate and high"),
                            HasSubstr("36 people aged 18 to 56, 26 men and 10 women")));
    // Counts do not say these; the page does not leave holes.
    EXPECT_THAT(page, AllOf(HasSubstr("counts do not say which image was shown first"),
                            HasSubstr("there is no measure.csv"),
                            Not(testing::ContainsRegex("[| (:](nan|inf|-nan|-inf)[ )|]")),
                            Not(HasSubstr("SIMULATED"))));
}

TEST(Report, SaysTheAnswerBeforeAnyPlot) {
    const std::string page = file_of(report_files(input_of(published_votes())), "report.html");
    const std::size_t verdict = page.find("class=\"verdict\"");
    ASSERT_NE(verdict, std::string::npos);
    EXPECT_LT(verdict, page.find("<svg"));
    EXPECT_LT(verdict, page.find("<table"));
}

TEST(Report, HasAFileForEverythingItsMarkdownNames) {
    const auto files = report_files(input_of(published_votes()));
    const std::string page = file_of(files, "report.md");
    std::size_t named = 0;
    for (std::size_t at = page.find("]("); at != std::string::npos; at = page.find("](", at + 1)) {
        const std::string name = page.substr(at + 2, page.find(')', at) - at - 2);
        EXPECT_FALSE(file_of(files, name).empty());
        ++named;
    }
    EXPECT_GE(named, 3U);
    EXPECT_THAT(file_of(files, "plots/shares.gnuplot"), HasSubstr("shares.tsv"));
    EXPECT_THAT(file_of(files, "plots/shares.tsv"), HasSubstr("69.4444444"));
}

TEST(Report, IsTheSameBytesForTheSameVotes) {
    const auto one = report_files(input_of(published_votes()));
    const auto other = report_files(input_of(published_votes()));
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].bytes, other[i].bytes);
}

TEST(Report, TellsThePublishedVotesFromAnyOthers) {
    Tally tally = published_votes();
    EXPECT_TRUE(is_published_votes(tally));
    tally.conditions[0].votes.a = 17;
    EXPECT_FALSE(is_published_votes(tally));
    tally = published_votes();
    tally.kind = Kind::kSimulated;
    EXPECT_FALSE(is_published_votes(tally));
}

TEST(Report, HoldsWithOneConditionWithFortyAndWithoutAnswers) {
    std::string forty = kPageHeader;
    for (int i = 1; i <= 40; ++i) {
        forty += "C" + std::to_string(i) + ",H1," + (i % 2 == 0 ? "low" : "high") + ",Variant" +
                 std::to_string(i) + ",None," + std::to_string(i) + ",20\n";
    }
    for (const std::string& votes :
         {kPageHeader + "only,H1,low,A,B,3,5\n", kPageHeader + "only,,low,A,B,0,0\n",
          kPageHeader + "one,H1,low,A,B,0,9\ntwo,H1,low,A,B,9,0\n",
          kPageHeader + "I,H1,low,A,B,500000000,500100000\n", forty}) {
        const auto files = report_files(input_of(parse_counts(votes, "votes.csv")));
        EXPECT_THAT(file_of(files, "plots/shares.svg"), HasSubstr("</svg>"));
        const std::string page = file_of(files, "report.md");
        EXPECT_THAT(page, Not(testing::ContainsRegex("[| (:](nan|inf|-nan|-inf)[ )|]")));
    }
}

TEST(Report, DrawsNoMoreRowsThanAnyoneCanReadAndSaysSo) {
    std::string many = kPageHeader;
    for (int i = 1; i <= 150; ++i) many += fmt::format("C{},H1,low,A{},B,3,5\n", i, i);
    const auto files = report_files(input_of(parse_counts(many, "votes.csv")));
    EXPECT_THAT(file_of(files, "plots/shares.svg"),
                AllOf(HasSubstr("(the first 100 of 150)"), Not(HasSubstr("C101 "))));
    EXPECT_THAT(file_of(files, "report.md"), HasSubstr("| C150 |"));
}

TEST(Report, NamesConditionsThatNobodyAnswered) {
    const auto files = report_files(input_of(
        parse_counts(kPageHeader + "I,H1,low,A,B,3,5\nII,H2,high,A,B,0,0\n", "votes.csv")));
    EXPECT_THAT(file_of(files, "report.md"), HasSubstr("Nobody answered II"));
}

TEST(Report, MarksSimulatedDataOnThePageAndInEveryPlot) {
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
    for (int i = 0; i < 8; ++i) {
        sessions.push_back(tests::a_session(i));
        sessions.back().kind = Kind::kSimulated;
        sessions.back().state = SessionState::kCompleted;
        for (int k = 0; k < 7; ++k) {
            trials.push_back(tests::a_trial(i, k));
            trials.back().kind = Kind::kSimulated;
            trials.back().is_A_selected = (i + k) % 3 == 0;
        }
    }
    ReportInput input = input_of(tally_trials("s", sessions, trials, "", Kind::kSimulated));
    const auto files = report_files(input);
    EXPECT_THAT(file_of(files, "report.html"), HasSubstr("<p class=\"mark\">SIMULATED DATA"));
    EXPECT_THAT(file_of(files, "report.md"), HasSubstr("SIMULATED DATA"));
    for (const ReportFile& file : files) {
        if (file.name.ends_with(".svg")) {
            EXPECT_THAT(file.bytes, HasSubstr("SIMULATED")) << file.name;
        }
    }
}

}  // namespace
}  // namespace obscura::analysis
