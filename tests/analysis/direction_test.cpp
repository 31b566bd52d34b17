// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Which variant is A comes from the variants: neither the order of rows nor the way round that a
// row names its pair changes anything.
#include "analysis/direction.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <random>

#include "analysis/conclusions/analysis.h"
#include "analysis/counts_file.h"
#include "analysis/presentation/json_report.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"
#include "tests/analysis/records_for_test.h"
#include "tests/analysis/trials_text.h"
#include "tests/support/temporary_folder.h"

namespace obscura::analysis {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

constexpr int kShuffles = 200;

/// One row of a table of trials; what depends on the way round is kept apart.
struct AnswerRow {
    std::string before;  ///< cells before the pair
    std::string a;
    std::string b;
    bool a_selected = false;
    char first_shown = 'A';
    char expected = 0;
    std::string after;

    void turn() {
        std::swap(a, b);
        a_selected = !a_selected;
        first_shown = first_shown == 'A' ? 'B' : 'A';
        if (expected != 0) expected = expected == 'A' ? 'B' : 'A';
    }
    [[nodiscard]] std::string text(bool has_order) const {
        std::string line = fmt::format("{}{},{},{}", before, a, b, a_selected ? 1 : 0);
        if (has_order) line += fmt::format(",{}", first_shown);
        if (expected != 0) return line + fmt::format(",{}{}\n", expected, after);
        return line + fmt::format(",{}\n", after);
    }
};

struct AnswerTable {
    std::string header;
    bool has_order = true;
    std::vector<AnswerRow> rows;

    [[nodiscard]] std::string text() const {
        std::string text = header;
        for (const AnswerRow& row : rows) text += row.text(has_order);
        return text;
    }
};

std::string direction_json(const AnswerTable& table) {
    return json_report(
        analyse(tally_of(parse_trials(table.text(), "t.csv"), "", Kind::kParticipant)));
}

/// Answers of 24 people, enough to draw anew from, or of 9, with catch trials, repeats, times and a
/// rule of exclusion; the columns condition and study may be there.
AnswerTable random_table(bool has_condition, bool has_study, bool has_order) {
    struct Shown {
        const char* condition;
        const char* scene;
        const char* level;
        const char* hypothesis;
        const char* a;
        const char* b;
    };
    constexpr std::array shown{Shown{"c1", "hall", "moderate", "H1", "none", "blizzard"},
                               Shown{"c2", "hall", "high", "H1", "none", "blizzard"},
                               Shown{"c3", "court", "high", "H1", "none", "Blizzard8"},
                               Shown{"c10", "court", "high", "H2", "Crytek24", "RayMarching30"},
                               Shown{"c4", "court", "low", "own", "x2", "x10"}};
    std::mt19937 random(20100501);
    std::bernoulli_distribution chooses_b(.85);
    std::bernoulli_distribution coin(.5);
    std::uniform_int_distribution<int> time_ms(400, 9000);
    AnswerTable table;
    table.has_order = has_order;
    table.header = fmt::format(
        "observer,session_id,scene,validity,hypothesis{}{},trial_index,kind,exclusion,condition_A,"
        "condition_B,is_A_selected{},expected,repeats,response_time\n",
        has_condition ? ",condition" : "", has_study ? ",study" : "",
        has_order ? ",first_shown" : "");
    const int people = has_condition && has_order ? 24 : 9;
    for (int who = 0; who < people; ++who) {
        const auto add = [&](const Shown& pair, int index, const char* kind,
                             const std::string& condition, const std::string& repeats) {
            AnswerRow row;
            row.before = fmt::format(
                "P{},s{},{},{},{}{}{},{},{},\"{{\"\"min_repeat_agreement\"\": 0.5}}\",", who, who,
                pair.scene, pair.level, pair.hypothesis, has_condition ? "," + condition : "",
                has_study ? ",my-study" : "", index, kind);
            row.a = pair.a;
            row.b = pair.b;
            row.a_selected = !chooses_b(random);
            row.first_shown = coin(random) ? 'A' : 'B';
            if (std::string(kind) == "catch") row.expected = 'B';
            row.after = fmt::format(",{},{:.3f}", repeats, time_ms(random) / 1000.0);
            table.rows.push_back(row);
        };
        int index = 0;
        for (const Shown& pair : shown) add(pair, index++, "participant", pair.condition, "");
        if (!has_condition) continue;
        add(shown[0], index++, "participant", "again", "c1");
        add(shown[1], index++, "catch", "caught", "");
    }
    return table;
}

TEST(Direction, IsOneStrictOrderOfAllVariants) {
    const std::vector<std::string> ordered{"None",
                                           "crytek",
                                           "Crytek8",
                                           "Crytek24",
                                           "Crytek24 R 0.2",
                                           "Blizzard8 R 0.2",
                                           "Blizzard8 R 0.9",
                                           "Blizzard8 R 1.0",
                                           "blizzard24",
                                           "RayMarching30",
                                           "alchemy12",
                                           "HBAO",
                                           "hbao16",
                                           "nonesuch",
                                           "x2",
                                           "x10",
                                           "Reference256"};
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        for (std::size_t k = 0; k < ordered.size(); ++k) {
            EXPECT_EQ(is_a_of(ordered[i], ordered[k]), i < k) << ordered[i] << ", " << ordered[k];
        }
    }
    EXPECT_NE(is_a_of("HBAO", "hbao"), is_a_of("hbao", "HBAO"))
        << "different names are never equal";
}

TEST(Direction, OfTrialsHangsNeitherOnTheOrderOfRowsNorOnTheWayRoundOfAny) {
    for (const bool has_condition : {false, true}) {
        for (const bool has_study : {false, true}) {
            for (const bool has_order : {false, true}) {
                AnswerTable table = random_table(has_condition, has_study, has_order);
                const std::string expected = direction_json(table);
                ASSERT_THAT(expected, HasSubstr("\"variant_b\": \"Blizzard8\""));
                std::mt19937 random(7);
                std::bernoulli_distribution coin(.5);
                for (int i = 0; i < kShuffles / 8; ++i) {
                    std::shuffle(table.rows.begin(), table.rows.end(), random);
                    for (AnswerRow& row : table.rows) {
                        if (coin(random)) row.turn();
                    }
                    ASSERT_EQ(direction_json(table), expected)
                        << has_condition << has_study << has_order << " shuffle " << i;
                }
            }
        }
    }
}

TEST(Direction, OfCountsHangsNeitherOnTheOrderOfRowsNorOnTheWayRoundOfAny) {
    struct Count {
        std::string before;
        std::string a;
        std::string b;
        int count_a;
        int count_b;
    };
    std::vector<Count> rows{{"c1,H1,moderate", "none", "blizzard", 2, 18},
                            {"c2,H1,high", "none", "blizzard", 3, 17},
                            {"c3,H2,high", "Crytek24", "Blizzard24", 17, 3},
                            {"c4,H2,low", "Blizzard8", "RayMarching30", 1, 19},
                            {"c12,,low", "x2", "x10", 16, 4}};
    const auto text = [&] {
        std::string csv = "condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n";
        for (const Count& row : rows) {
            csv +=
                fmt::format("{},{},{},{},{}\n", row.before, row.a, row.b, row.count_a, row.count_b);
        }
        return json_report(analyse(parse_counts(csv, "c.csv")));
    };
    const std::string expected = text();
    const json h1 = json::parse(expected)["hypotheses"]["H1"];
    EXPECT_EQ(h1["count_b"], 35);
    EXPECT_EQ(h1["pooled_as"], "A is none and B is blizzard");
    std::mt19937 random(7);
    std::bernoulli_distribution coin(.5);
    for (int i = 0; i < kShuffles; ++i) {
        std::shuffle(rows.begin(), rows.end(), random);
        for (Count& row : rows) {
            if (!coin(random)) continue;
            std::swap(row.a, row.b);
            std::swap(row.count_a, row.count_b);
        }
        ASSERT_EQ(text(), expected) << "shuffle " << i;
    }
}

/// 24 answers, 20 of them for blizzard, in two scenes; one row may name its pair the other way.
std::string two_scenes(bool one_is_turned) {
    std::string text = "observer,scene,validity,hypothesis,condition_A,condition_B,is_A_selected\n";
    for (int i = 0; i < 24; ++i) {
        const bool chose_none = i % 6 == 3;
        const bool is_turned = one_is_turned && i == 12;
        text += fmt::format("P{},{},H1,{},{}\n", i % 12, i < 12 ? "hall,moderate" : "court,high",
                            is_turned ? "blizzard,none" : "none,blizzard",
                            chose_none != is_turned ? 1 : 0);
    }
    return text;
}

TEST(Direction, OneRowTheOtherWayRoundLeavesTheVerdictAsItIs) {
    const auto report_of = [](bool one_is_turned) {
        return json_report(analyse(
            tally_of(parse_trials(two_scenes(one_is_turned), "t.csv"), "", Kind::kParticipant)));
    };
    EXPECT_EQ(report_of(true), report_of(false));
    const json h1 = json::parse(report_of(true))["hypotheses"]["H1"];
    EXPECT_EQ(h1["count_b"], 20);
    EXPECT_EQ(h1["n"], 24);
    EXPECT_EQ(h1["verdict"], "B preferred over A");
}

TEST(Direction, OfAStudyIsTheStudysOwnDefinition) {
    const std::string header =
        "observer,study,condition,condition_A,condition_B,study_A,is_A_selected,first_shown\n";
    const std::string ann = "ann,my-study,c1,blizzard,none,blizzard,1,A\n";
    for (const char* bob : {"bob,my-study,c1,blizzard,none,blizzard,0,B\n",
                            "bob,my-study,c1,none,blizzard,blizzard,1,A\n"}) {
        const Tally tally =
            tally_of(parse_trials(header + ann + bob, "t.csv"), "", Kind::kParticipant);
        EXPECT_EQ(tally.conditions.at(0).variant_a, "blizzard");
        EXPECT_EQ(tally.conditions[0].votes.a, 1);
        EXPECT_EQ(tally.conditions[0].votes.b, 1);
        EXPECT_FALSE(tally.conditions[0].answers.at(1).b_second);
    }
    EXPECT_THROW((void)parse_trials(header + "ann,my-study,c1,blizzard,none,crytek,1,A\n", "t.csv"),
                 base::Error);
}

TEST(Direction, OfAnExportIsThatOfTheStore) {
    StoreContents contents;
    for (int number = 0; number < 3; ++number) {
        SessionRecord session = tests::a_session(number);
        session.state = SessionState::kCompleted;
        contents.sessions.push_back(session);
        TrialRecord trial = tests::a_trial(number, 0);
        trial.condition_A = "Blizzard24";
        trial.condition_B = "None";
        contents.trials.push_back(trial);
    }
    const Tally of_store =
        tally_trials("s", contents.sessions, contents.trials, "", Kind::kParticipant);
    EXPECT_EQ(of_store.conditions.at(0).variant_a, "Blizzard24") << "as the study has it";
    const Tally of_file =
        tally_of(parse_trials(tests::trials_text(contents), "s"), "", Kind::kParticipant);
    EXPECT_EQ(json_report(analyse(of_file)), json_report(analyse(of_store)));
}

TEST(Direction, OneIdForDifferentPairsIsRefusedWithBothPlaces) {
    try {
        (void)parse_trials(
            "observer,condition,condition_A,condition_B,is_A_selected\n"
            "ann,c1,none,blizzard,1\nbob,c1,blizzard,none,1\ncleo,c1,crytek,blizzard,1\n",
            "t.csv");
        FAIL() << "accepted";
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        EXPECT_THAT(error.what(), AllOf(HasSubstr("t.csv:4: condition 'c1' is crytek against"),
                                        HasSubstr("allowed is what line 2 says: none against")));
    }
}

TEST(Direction, ASceneAtTwoLevelsIsTwoConditions) {
    const Tally tally =
        tally_of(parse_trials("observer,scene,validity,condition_A,condition_B,is_A_selected\n"
                              "ann,hall,low,none,blizzard,1\nann,hall,high,blizzard,none,1\n"
                              "ann,yard,high,blizzard,none,1\n",
                              "t.csv"),
                 "", Kind::kParticipant);
    ASSERT_EQ(tally.conditions.size(), 3U);
    EXPECT_EQ(tally.conditions[0].id, "hall: none - blizzard (high)");
    EXPECT_EQ(tally.conditions[1].id, "hall: none - blizzard (low)");
    EXPECT_EQ(tally.conditions[2].id, "yard: none - blizzard");
    EXPECT_EQ(tally.conditions[0].votes.b, 1);
    EXPECT_EQ(tally.conditions[0].view, "hall");
}

TEST(Direction, OfOneStudyFileShortAndLongNamesOfAVariantAreOne) {
    const auto tally_with = [](const std::string& sha256, const std::string& later) {
        const tests::TemporaryFolder folder;
        const std::string url = "sqlite3://" + (folder / "r.sqlite").string();
        Store store(url, Store::Access::kReadWrite);
        for (int number = 0; number < 2; ++number) {
            SessionRecord session = tests::a_session(number);
            session.condition_count = 1;
            if (number == 1) session.study_sha256 = sha256;
            store.begin_session(tests::a_participant(number), session);
            TrialRecord trial = tests::a_trial(number, 0);
            trial.response_first = false;
            trial.is_A_selected = false;
            if (number == 1) trial.condition_B = later;
            store.add_trial(trial);
            store.complete_session(session.session_id, tests::kUtc);
        }
        return tally_of(read_answers(store, url), "", Kind::kParticipant);
    };
    const std::string same(64, 'a');
    const Tally tally = tally_with(same, "Blizzard24 R 0.8");
    ASSERT_EQ(tally.conditions.size(), 1U);
    EXPECT_EQ(tally.conditions[0].variant_b, "Blizzard24 R 0.8");
    EXPECT_EQ(tally.conditions[0].view, "atrium");
    EXPECT_EQ(tally.conditions[0].votes.b, 2);
    EXPECT_THROW((void)tally_with(std::string(64, 'b'), "Blizzard24 R 0.8"), base::Error);
    EXPECT_THROW((void)tally_with(same, "Blizzard240"), base::Error);
}

TEST(Pooling, AddsUpOnlyWhatMeansTheSameInEachCondition) {
    const auto hypothesis = [](const std::string& rows) {
        const std::string header =
            "condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n";
        const std::string report = json_report(analyse(parse_counts(header + rows, "c.csv")));
        return json::parse(report)["hypotheses"]["Q"];
    };
    const json ranked = hypothesis(
        "a,Q,low,Crytek24,Blizzard24,3,7\nb,Q,low,RayMarching30,Blizzard8,8,2\n"
        "c,Q,low,Blizzard24,Blizzard8,6,4\n");
    EXPECT_EQ(ranked["count_b"], 7 + 8 + 6);
    EXPECT_THAT(ranked["pooled_as"].get<std::string>(),
                AllOf(HasSubstr("order that the thesis assumes"),
                      HasSubstr("Blizzard24 over Crytek24, RayMarching30 over Blizzard8, "
                                "Blizzard24 over Blizzard8")));
    const json with = hypothesis("a,Q,low,None,HBAO,3,7\nb,Q,low,Alchemy,None,8,2\n");
    EXPECT_EQ(with["count_b"], 15);
    EXPECT_THAT(with["pooled_as"].get<std::string>(),
                HasSubstr("without ambient occlusion and B the one with it: HBAO, Alchemy"));
    for (const char* rows : {"a,Q,low,HBAO,Alchemy,3,7\nb,Q,low,HBAO,GTAO,8,2\n",
                             "a,Q,low,Blizzard8 R 0.1,Blizzard8 R 0.3,3,7\n"
                             "b,Q,low,Blizzard8 R 0.3,Blizzard8 R 0.9,8,2\n"}) {
        const json apart = hypothesis(rows);
        EXPECT_TRUE(apart["count_b"].is_null());
        EXPECT_EQ(apart["verdict"], "not tested");
        EXPECT_TRUE(apart["verdict_p"].is_null());
        EXPECT_THAT(apart["verdict_sentence"].get<std::string>(),
                    HasSubstr("Its conditions compare different variants"));
    }
}

}  // namespace
}  // namespace obscura::analysis
