// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// What is ready for a paper, and what a terminal shows: the numbers of the analysis, in the digits
// that journals print.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <map>

#include "analysis/conclusions/words.h"
#include "analysis/counts_file.h"
#include "analysis/presentation/journal.h"
#include "analysis/presentation/latex.h"
#include "analysis/presentation/paper_words.h"
#include "analysis/presentation/report.h"
#include "analysis/presentation/summary.h"
#include "analysis/published_votes.h"
#include "analysis/table/csv.h"
#include "tests/analysis/records_for_test.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::map<std::string, std::string> paper_of(const ReportInput& input) {
    std::map<std::string, std::string> paper;
    for (const ReportFile& file : report_files(input)) {
        if (file.name.starts_with("paper/")) paper[file.name.substr(6)] = file.bytes;
    }
    return paper;
}

ReportInput published_input() {
    ReportInput input;
    input.analysis = analyse(published_votes());
    input.study = {"Title", "Which image looked the most realistic?",
                   "one after the other, with a grey screen for 2 s between them", "latin-square"};
    input.software = "obscura 1.2";
    return input;
}

/// Eight people who answered seven pairs, each in his own way.
Analysis of_people() {
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;
    for (int i = 0; i < 8; ++i) {
        sessions.push_back(tests::a_session(i));
        sessions.back().state = SessionState::kCompleted;
        for (int k = 0; k < 7; ++k) {
            trials.push_back(tests::a_trial(i, k));
            trials.back().is_A_selected = (i + k) % 3 == 0;
            trials.back().response_first = trials.back().is_A_selected;
        }
    }
    return analyse(tally_trials("s", sessions, trials, "", Kind::kParticipant));
}

TEST(Journal, PrintsPValuesAsJournalsDo) {
    EXPECT_EQ(p_number(PValue{.031234, -1.5}), ".031");
    EXPECT_EQ(p_number(PValue{.00051, -3.3}), ".001");
    EXPECT_EQ(p_number(PValue{.00049, -3.3}), "< .001");
    EXPECT_EQ(p_number(PValue{0.0, -1004.0}), "< .001");
    EXPECT_EQ(p_number(PValue{1.0, 0.0}), "> .999");
    EXPECT_EQ(p_number(PValue{.9994, 0.0}), ".999");
    EXPECT_EQ(p_words(PValue{.031234, -1.5}), "p = .031");
    EXPECT_EQ(p_words(PValue{1e-9, -9.0}), "p < .001");
    EXPECT_EQ(p_number(Possible<double>::none("no votes")), "none");
}

TEST(Latex, MakesEveryLetterSafeAndCitesByKey) {
    EXPECT_EQ(latex_text("5 % of A_1 & B#2 {x} ~ ^ \\ $"),
              "5 \\% of A\\_1 \\& B\\#2 \\{x\\} \\textasciitilde{} \\textasciicircum{} "
              "\\textbackslash{} \\$");
    EXPECT_EQ(latex_text("after Holm [@holm1979; @wilson1927]."),
              "after Holm \\cite{holm1979,wilson1927}.");
    EXPECT_EQ(latex_text("[1, 2] \u201cyes\u201d 4\u00a0%"), "[1, 2] ``yes'' 4~\\%");
    EXPECT_EQ(latex_text("open [@never"), "open [@never");
    EXPECT_EQ(latex_text("-3.1 to -0.5 (-2), well-known 2-3"),
              "$-$3.1 to $-$0.5 ($-$2), well-known 2-3");
}

TEST(Latex, GivesOnlyTheEntriesThatAreCited) {
    const std::string entries = cited_entries("after Holm [@holm1979]");
    EXPECT_THAT(entries, AllOf(HasSubstr("@article{holm1979,"), HasSubstr("65--70"),
                               Not(HasSubstr("wilson1927"))));
}

TEST(Paper, HasAnEntryForEveryCitationAndNoOther) {
    for (const ReportInput& input : {published_input(), [] {
                                         ReportInput people;
                                         people.analysis = of_people();
                                         return people;
                                     }()}) {
        const auto paper = paper_of(input);
        const std::string& text = paper.at("paper.md");
        std::size_t cited = 0;
        for (std::size_t at = text.find("@"); at != std::string::npos;
             at = text.find("@", at + 1)) {
            const std::string key = text.substr(at + 1, text.find_first_of(";]", at) - at - 1);
            EXPECT_THAT(paper.at("references.bib"), HasSubstr("{" + key + ",")) << key;
            ++cited;
        }
        EXPECT_GE(cited, 4U);
        const std::string& tex = paper.at("paper.tex");
        EXPECT_EQ(std::count(tex.begin(), tex.end(), '{'), std::count(tex.begin(), tex.end(), '}'));
        EXPECT_THAT(tex, Not(HasSubstr("[@")));
    }
}

TEST(Paper, SaysOfThePublishedVotesWhatTable4Says) {
    const auto paper = paper_of(published_input());
    EXPECT_THAT(
        paper.at("paper.md"),
        AllOf(HasSubstr("with a grey screen for 2 s between them"),
              HasSubstr("random Latin squares"), HasSubstr("obscura 1.2"), HasSubstr("Of 7 pairs"),
              HasSubstr("none showed a preference"),
              HasSubstr("III (69.4\u00a0% chose Blizzard24, p = .029, corrected p = .202)")));
    const auto table = parse_csv(paper.at("table-1.csv"), "table-1.csv");
    ASSERT_EQ(table.size(), 8U);
    for (const CsvRecord& row : table) {
        if (row.fields[0] != "III") continue;
        EXPECT_THAT(row.fields,
                    testing::ElementsAre("III", "moderate", "Crytek24", "Blizzard24", "11 : 25",
                                         "69.4", "53.1 to 82.0", ".029", ".202"));
    }
    EXPECT_THAT(paper.at("table-1.tex"), AllOf(HasSubstr("\\toprule"), HasSubstr("11 : 25")));
}

TEST(Paper, TakesEveryNumberOfAVerdictFromTheAnalysis) {
    const Analysis analysis = of_people();
    ReportInput input;
    input.analysis = analysis;
    std::string results;
    for (const std::string& paragraph : result_paragraphs(input)) results += paragraph + '\n';
    ASSERT_FALSE(analysis.verdicts.empty());
    for (const Verdict& verdict : analysis.verdicts) {
        const std::string line = verdict_line(analysis, verdict);
        EXPECT_THAT(results, HasSubstr(verdict.hypothesis + ": " + line + '.'));
        EXPECT_THAT(summary_text(analysis), HasSubstr(verdict.hypothesis + ": "));
        if (verdict.p.has_value()) {
            EXPECT_THAT(line, HasSubstr(p_words(*verdict.p)));
        }
    }
    const HypothesisResult& h1 = analysis.hypotheses.front();
    EXPECT_THAT(results, HasSubstr(fmt::format("B in {} of {} votes", h1.pooled.votes.b,
                                               h1.pooled.votes.n())));
}

TEST(Paper, NamesEveryComparisonOfAVerdictOnValidity) {
    const Analysis published = analyse(published_votes());
    const Verdict& verdict = published.verdicts.back();
    ASSERT_EQ(verdict.compared.size(), 2U);
    EXPECT_NEAR(verdict.compared[0].p->p, .621034, 5e-7);
    EXPECT_NEAR(verdict.compared[1].p->p, .148839, 5e-7);
    EXPECT_EQ(*verdict.compared[1].p_holm, *verdict.p_holm);
    const std::string line = verdict_line(published, verdict);
    EXPECT_THAT(line, AllOf(HasSubstr("; II and V: the share of B changes by -13.2 to +28.9 points "
                                      "(95 % CI), p = .621, corrected p > .999"),
                            HasSubstr("; III and VI: the share of B changes by -39.4 to +3.1 "
                                      "points (95 % CI), p = .149, corrected p = .595")));
    const auto table = parse_csv(paper_of(published_input()).at("table-2.csv"), "table-2.csv");
    EXPECT_EQ(table.size(), 7U) << "a heading, four verdicts and both comparisons";
}

TEST(Paper, SaysThatASecondaryHypothesisIsNotCorrected) {
    const Analysis published = analyse(published_votes());
    EXPECT_THAT(verdict_line(published, published.verdicts[2]),
                HasSubstr("p = .618, secondary and not corrected"));
}

TEST(Paper, HasFiguresAtJournalWidthsWithoutTitles) {
    const auto paper = paper_of(published_input());
    if (!paper.contains("figure-1.svg")) GTEST_SKIP() << "gnuplot is not there";
    EXPECT_THAT(paper.at("figure-1.svg"), AllOf(HasSubstr("width=\"321\""), HasSubstr("</svg>")));
    EXPECT_THAT(paper.at("figure-1-wide.svg"), HasSubstr("width=\"658\""));
    EXPECT_THAT(paper.at("figure-1.svg"), Not(HasSubstr("<text>Share of answers for B<")));
    ASSERT_TRUE(paper.contains("figure-1.pdf"));
    // 85 mm are 240.9 points, of which cairo keeps the whole ones.
    EXPECT_THAT(paper.at("figure-1.pdf"), HasSubstr("/MediaBox [ 0 0 240 "));
    EXPECT_EQ(paper.at("figure-1.pdf"), paper_of(published_input()).at("figure-1.pdf"));
}

TEST(Summary, FitsOnOneScreenWhateverTheNumberOfConditions) {
    std::string many = "condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n";
    for (int i = 1; i <= 40; ++i) many += fmt::format("C{},H1,low,A{},B,3,5\n", i, i);
    for (const Analysis& analysis :
         {analyse(published_votes()), of_people(), analyse(parse_counts(many, "votes.csv"))}) {
        const std::string text = summary_text(analysis);
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 30) << text;
        for (std::size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
            EXPECT_LE(text.find('\n', at) - at, 110U) << text.substr(at, 120);
        }
    }
    EXPECT_THAT(summary_text(analyse(parse_counts(many, "votes.csv"))),
                HasSubstr("... and 28 more"));
    EXPECT_THAT(summary_text(analyse(published_votes())),
                AllOf(HasSubstr("11 : 25"), HasSubstr(".029"), HasSubstr(".202")));
}

}  // namespace
}  // namespace obscura::analysis
