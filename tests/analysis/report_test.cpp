// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "analysis/conclusions/analysis.h"
#include "analysis/conclusions/words.h"
#include "analysis/counts_file.h"
#include "analysis/presentation/json_report.h"
#include "analysis/presentation/text_report.h"
#include "analysis/statistics/exact_binomial.h"
#include "renderer/base/error.h"
#include "tests/analysis/records_for_test.h"
#include "tests/analysis/table_4.h"

namespace obscura::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kReportHeader =
    "condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n";

Analysis of_published_votes() {
    return analyse(read_counts(OBSCURA_SOURCE_DIR "/analysis/data/jakobsen2010.csv"));
}

json json_of(const Analysis& analysis) { return json::parse(json_report(analysis)); }

/// The comparison over exactly these conditions.
json comparison(const json& list, const std::vector<std::string>& conditions) {
    for (const json& entry : list) {
        if (entry["conditions"] == conditions) return entry;
    }
    ADD_FAILURE() << "no comparison of these conditions in " << list;
    return {};
}

TEST(JsonReport, GivesTable4OfJakobsen2010) {
    const json report = json_of(of_published_votes());
    EXPECT_EQ(report["n_participants"], 36);
    ASSERT_EQ(report["conditions"].size(), kTable4.size());
    for (std::size_t i = 0; i < kTable4.size(); ++i) {
        const json& condition = report["conditions"][i];
        const Table4Row& row = kTable4[i];
        SCOPED_TRACE(row.condition);
        EXPECT_EQ(condition["id"], row.condition);
        EXPECT_EQ(condition["count_a"], row.votes.a);
        EXPECT_EQ(condition["count_b"], row.votes.b);
        EXPECT_EQ(condition["n"], 36);
        EXPECT_EQ(condition["df"], 1);
        const auto share = static_cast<double>(row.votes.b) / 36.0;
        for (const auto& [name, value] :
             std::initializer_list<std::pair<const char*, double>>{{"chi_square", row.chi_square},
                                                                   {"p_value", row.p},
                                                                   {"p_exact", row.p_exact},
                                                                   {"share_b", share},
                                                                   {"wilson_low", row.wilson_low},
                                                                   {"wilson_high", row.wilson_high},
                                                                   {"cohens_g", row.cohens_g},
                                                                   {"p_holm", row.p_exact_holm}}) {
            EXPECT_NEAR(condition[name].get<double>(), value, 1e-6) << name;
        }
    }
    EXPECT_EQ(report["conditions"][3]["variant_b"], "RayMarching30");
    EXPECT_EQ(report["conditions"][3]["hypothesis"], "H2");
    EXPECT_EQ(report["conditions"][3]["validity"], "moderate");
}

TEST(JsonReport, AnswersTheHypotheses) {
    const json hypotheses = json_of(of_published_votes())["hypotheses"];
    const json& h1 = hypotheses["H1"];
    EXPECT_EQ(h1["conditions"], json({"II", "V", "VII"}));
    EXPECT_EQ(h1["count_a"], 46);
    EXPECT_EQ(h1["count_b"], 62);
    EXPECT_NEAR(h1["chi_square"].get<double>(), 2.370370, 1e-6);
    EXPECT_NEAR(h1["p_value"].get<double>(), .123658, 1e-6);
    EXPECT_EQ(h1["n_significant"], 1);
    EXPECT_EQ(h1["n_significant_holm"], 0);
    EXPECT_EQ(hypotheses["H2"]["count_b"], 61) << "IV is secondary";

    const json& h3 = hypotheses["H3"];
    // Like with like: the same two variants in the same scene at two levels.
    EXPECT_EQ(h3["comparisons"].size(), 2U);
    const json sponza = comparison(h3["comparisons"], {"III", "VI"});
    EXPECT_NEAR(sponza["chi_square"].get<double>(), 2.829190, 1e-6);
    EXPECT_NEAR(sponza["p_value"].get<double>(), .092565, 1e-6);
    EXPECT_NEAR(sponza["p_fisher"].get<double>(), .148839, 1e-6);
    const json none = comparison(h3["comparisons"], {"II", "V"});
    EXPECT_NEAR(none["chi_square"].get<double>(), .551489, 1e-6);
    EXPECT_NEAR(none["p_value"].get<double>(), .457710, 1e-6);
    EXPECT_EQ(h3["without_partner"], json({"I", "IV", "VII"}));
    // What the thesis compared is over different scenes, and no part of the verdict.
    const json levels = comparison(h3["across_scenes"], {"I", "III", "VI"});
    EXPECT_NEAR(levels["chi_square"].get<double>(), 3.691664, 1e-6);
    EXPECT_EQ(levels["df"], 2);
    EXPECT_NEAR(levels["p_value"].get<double>(), .157894, 1e-6);
    EXPECT_THAT(h3["sentence"].get<std::string>(),
                HasSubstr("no significant difference between the levels"));
}

TEST(JsonReport, KeepsDoublesBitForBit) {
    const Analysis analysis = of_published_votes();
    const json report = json_of(analysis);
    EXPECT_EQ(report["conditions"][1]["p_value"].get<double>(),
              analysis.conditions[1].preference.chi_square->p.p);
    EXPECT_EQ(report["conditions"][1]["wilson_low"].get<double>(),
              analysis.conditions[1].preference.wilson->low);
}

TEST(JsonReport, SaysWhyAValueIsMissing) {
    const json report = json_of(analyse(parse_counts(
        kReportHeader + "I,H1,low,A,B,0,0\nII,H1,high,A,B,0,9\nIII,,low,C,D,0,9\n", "votes.csv")));
    const json& condition = report["conditions"][0];
    for (const char* name :
         {"chi_square", "df", "p_value", "p_exact", "p_holm", "p_bh", "share_b", "wilson_low",
          "wilson_high", "clopper_pearson_low", "clopper_pearson_high", "cohens_g"}) {
        EXPECT_TRUE(condition[name].is_null()) << name;
        EXPECT_EQ(condition[std::string(name) + "_reason"], "no votes");
    }
    EXPECT_TRUE(report["n_participants"].is_null());
    EXPECT_TRUE(report["order_bias"].is_null());
    EXPECT_EQ(report["order_bias_reason"], "counts do not say which image was shown first");
    EXPECT_FALSE(report["hypotheses"].contains("H3"));
    EXPECT_TRUE(report["validity_question"].is_null());
    EXPECT_EQ(report["validity_question_reason"], "the study does not ask it");
    EXPECT_THAT(report.dump(), Not(HasSubstr("nan")));
}

TEST(JsonReport, CorrectsForEveryTestOfTheStudyWhoeverAnswered) {
    const Analysis analysis = analyse(parse_counts(
        kReportHeader + "I,H1,low,A,B,11,25\nII,H2,low,A,B,0,0\nIII,H3,low,A,B,18,18\n",
        "votes.csv"));
    const double p = exact_binomial(25, 36)->p;
    EXPECT_NEAR(*analysis.conditions[0].p_holm, 3.0 * p, 1e-15);
    ASSERT_EQ(analysis.verdicts.size(), 3U);
    EXPECT_EQ(analysis.verdicts[0].tests, 3U);
    EXPECT_NEAR(*analysis.verdicts[0].p_holm, 3.0 * p, 1e-15);
    EXPECT_EQ(analysis.verdicts[1].conclusion, Conclusion::kNotTested);
    EXPECT_FALSE(analysis.verdicts[1].p_holm.has_value());
}

TEST(JsonReport, LeavesTheSecondaryConditionOfTheBuiltInStudyOutOfItsHypothesis) {
    const Analysis analysis = of_published_votes();
    const HypothesisResult& h2 = analysis.hypotheses.at(1);
    EXPECT_EQ(h2.conditions, (std::vector<std::string>{"I", "III", "VI"}));
    EXPECT_EQ(h2.secondary, std::vector<std::string>{"IV"});
    EXPECT_EQ(h2.pooled.votes.a, 47);
    EXPECT_THAT(h2.sentence, HasSubstr("IV is secondary and no part of it."));
    const Analysis other = analyse(
        parse_counts(kReportHeader + "III,H2,low,A,B,11,25\nIV,H2,low,A,B,16,20\n", "votes.csv"));
    EXPECT_EQ(other.hypotheses.at(0).conditions, (std::vector<std::string>{"III", "IV"}));
}

TEST(TextReport, IsATableWithItsTestsInWords) {
    const std::string text = text_report(of_published_votes());
    EXPECT_THAT(text,
                AllOf(HasSubstr("36 participants, 7 conditions"), HasSubstr("  11:25  "),
                      HasSubstr("0.5314 to 0.8200"), HasSubstr("no continuity correction"),
                      HasSubstr("H1 (II, V, VII): together 46 votes for A and 62 for B"),
                      HasSubstr("each for itself: III, V. Still so after Holm's correction "
                                "for 7 tests: none."),
                      HasSubstr("chi-square 3.692, df 2, p"), HasSubstr("Order bias: not tested")));
    EXPECT_THAT(text, Not(HasSubstr("SIMULATED")));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(TextReport, AlignsItsColumnsAlsoBesideLettersOfTwoBytes) {
    std::istringstream lines(text_report(analyse(parse_counts(
        kReportHeader + "Æble,H1,low,Åben,Ærø,18,18\nII,H1,low,A,B,14,22\n", "x.csv"))));
    std::string line;
    std::vector<std::size_t> places;
    while (std::getline(lines, line)) {
        for (const char* votes : {"18:18", "14:22"}) {
            if (line.find(votes) == std::string::npos) continue;
            std::size_t letters = 0;
            for (const char byte : line.substr(0, line.find(votes))) {
                if ((static_cast<unsigned char>(byte) & 0xC0U) != 0x80U) ++letters;
            }
            places.push_back(letters);
        }
    }
    ASSERT_GE(places.size(), 2U);
    EXPECT_EQ(places[0], places[1]);
}

TEST(TextReport, ShowsAPowerOfTenWhereDoublesEnd) {
    EXPECT_EQ(p_text({0.0, -436.0432}), "10^-436.04");
    EXPECT_EQ(p_text({0.0196307, -1.707}), "0.019631");
    EXPECT_EQ(p_text({2.910383e-11, -10.536}), "2.910e-11");
    const std::string text = text_report(
        analyse(parse_counts(kReportHeader + "I,H1,low,A,B,0,1000000000\n", "votes.csv")));
    EXPECT_THAT(text, AllOf(HasSubstr("10^-217147245.55"), HasSubstr("10^-301029995.36"),
                            HasSubstr("<1e-290")));
}

/// Sessions with the given kinds and states; B is chosen, so that A, shown first, is not.
struct Rows {
    std::vector<SessionRecord> sessions;
    std::vector<TrialRecord> trials;

    void add(int number, Kind kind, SessionState state, int answers = 7) {
        auto session = tests::a_session(number);
        session.kind = kind;
        session.state = state;
        sessions.push_back(session);
        for (int index = 0; index < answers; ++index) {
            trials.push_back(tests::a_trial(number, index));
            trials.back().kind = kind;
        }
    }
};

TEST(Tally, CountsOnlyCompletedSessionsOfTheKind) {
    Rows rows;
    rows.add(0, Kind::kParticipant, SessionState::kCompleted);
    rows.add(1, Kind::kParticipant, SessionState::kAbandoned, 3);
    rows.add(2, Kind::kParticipant, SessionState::kOpen, 4);
    rows.add(3, Kind::kSimulated, SessionState::kCompleted);
    rows.add(4, Kind::kSimulated, SessionState::kCompleted);
    auto practice = tests::a_trial(0, 90);
    practice.kind = Kind::kPractice;
    rows.trials.push_back(practice);
    practice.kind = Kind::kCatch;
    rows.trials.push_back(practice);

    const Tally people = tally_trials("s", rows.sessions, rows.trials, "", Kind::kParticipant);
    EXPECT_EQ(*people.n_participants, 1);
    ASSERT_EQ(people.conditions.size(), 7U);
    EXPECT_EQ(people.conditions[0].votes.a, 0);
    EXPECT_EQ(people.conditions[0].votes.b, 1);
    EXPECT_EQ(people.order->n, 7);
    EXPECT_EQ(people.order->second_chosen, 7);
    EXPECT_EQ(people.study, "jakobsen2010");

    const Tally simulated = tally_trials("s", rows.sessions, rows.trials, "", Kind::kSimulated);
    EXPECT_EQ(*simulated.n_participants, 2);
    EXPECT_EQ(simulated.conditions[0].votes.b, 2);
    const Analysis analysis = analyse(simulated);
    EXPECT_THAT(text_report(analysis), HasSubstr("SIMULATED DATA"));
    const json report = json_of(analysis);
    EXPECT_EQ(report["simulated"], true);
    EXPECT_EQ(report["kind"], "simulated");
    EXPECT_EQ(report["order_bias"]["second_chosen"], 14);
    EXPECT_NEAR(report["order_bias"]["p_exact"].get<double>(), 0x1p-13, 1e-18);
}

std::string refusal_of_report(const Rows& rows, const std::string& study, Kind kind) {
    try {
        (void)tally_trials("the store", rows.sessions, rows.trials, study, kind);
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        return error.what();
    }
    return "accepted";
}

TEST(Tally, PointsToSimulatedSessionsWhereThereAreNoOthers) {
    Rows rows;
    EXPECT_THAT(refusal_of_report(rows, "", Kind::kParticipant), HasSubstr("nothing to analyse"));
    rows.add(0, Kind::kSimulated, SessionState::kCompleted);
    EXPECT_THAT(refusal_of_report(rows, "", Kind::kParticipant),
                HasSubstr("1 of kind simulated: --kind simulated analyses those"));
}

TEST(Tally, NeverMixesStudies) {
    Rows rows;
    rows.add(0, Kind::kParticipant, SessionState::kCompleted);
    rows.add(1, Kind::kParticipant, SessionState::kCompleted);
    rows.sessions.back().study = "another";
    EXPECT_THAT(refusal_of_report(rows, "", Kind::kParticipant),
                HasSubstr("STUDY must name one of: another, jakobsen2010"));
    EXPECT_THAT(refusal_of_report(rows, "third", Kind::kParticipant),
                HasSubstr("STUDY third: the store has no completed session of it"));
    EXPECT_EQ(*tally_trials("s", rows.sessions, rows.trials, "another", Kind::kParticipant)
                   .n_participants,
              1);
    rows.sessions.back().study = "jakobsen2010";
    rows.trials.back().condition_B = "Crytek24";
    EXPECT_THAT(refusal_of_report(rows, "", Kind::kParticipant), HasSubstr("cannot be added up"));
}

TEST(Tally, OrdersConditionsByTheirNumbers) {
    Rows rows;
    rows.add(0, Kind::kParticipant, SessionState::kCompleted);
    for (const char* name : {"C10", "C2", "C1", "B"}) {
        rows.trials[static_cast<std::size_t>(rows.trials.size() - 1)].condition = name;
        std::rotate(rows.trials.begin(), rows.trials.end() - 1, rows.trials.end());
    }
    const Tally tally = tally_trials("s", rows.sessions, rows.trials, "", Kind::kParticipant);
    std::vector<std::string> ids;
    for (const ConditionVotes& condition : tally.conditions) ids.push_back(condition.id);
    EXPECT_THAT(ids, testing::ElementsAre("B", "C0", "C1", "C2", "C10"));
}

}  // namespace
}  // namespace obscura::analysis
