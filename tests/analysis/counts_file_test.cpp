// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/counts_file.h"

#include <gmock/gmock.h>

#include "analysis/table/csv.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string kCountsHeader =
    "condition,hypothesis,validity,variant_a,variant_b,count_a,count_b\n";

std::string refusal_of_counts(const std::string& text) {
    try {
        (void)parse_counts(text, "votes.csv");
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        return error.what();
    }
    return "accepted";
}

TEST(Csv, ReadsWhatRfc4180Allows) {
    const auto records = parse_csv(
        "\xEF\xBB\xBF"
        "a,\"b,1\",\"say \"\"ja\"\"\"\r\n\r\n\"two\nlines\",,æøå\nlast",
        "x.csv");
    ASSERT_EQ(records.size(), 3U);
    EXPECT_THAT(records[0].fields, ElementsAre("a", "b,1", "say \"ja\""));
    EXPECT_EQ(records[0].line, 1);
    EXPECT_THAT(records[1].fields, ElementsAre("two\nlines", "", "æøå"));
    EXPECT_EQ(records[1].line, 3);
    EXPECT_THAT(records[2].fields, ElementsAre("last"));
    EXPECT_EQ(records[2].line, 5);
    EXPECT_TRUE(parse_csv("", "x.csv").empty());
    EXPECT_TRUE(parse_csv("\n\r\n", "x.csv").empty());
    const auto old = parse_csv("a,\"b\rc\"\r\rd\r", "x.csv");
    ASSERT_EQ(old.size(), 2U);
    EXPECT_THAT(old[0].fields, ElementsAre("a", "b\rc"));
    EXPECT_EQ(old[1].line, 4);
    EXPECT_THAT(parse_csv("a, \"b, c\" ,d", "x.csv")[0].fields, ElementsAre("a", "b, c", "d"));
    EXPECT_THAT(parse_csv("a,", "x.csv")[0].fields, ElementsAre("a", ""));
}

TEST(Csv, NamesTheLineOfBadQuotesAndBytes) {
    const auto refusal = [](std::string_view text) -> std::string {
        try {
            (void)parse_csv(text, "x.csv");
        } catch (const base::Error& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(refusal("a\n\"b\nc"), "x.csv:2: column 1: '\"b': a quote that is never closed");
    EXPECT_EQ(
        refusal("a\n\"b\"c"),
        "x.csv:2: column 1: '\"b\"c': text after a closing quote, allowed is a separator or the "
        "line's end");
    EXPECT_EQ(refusal("a\nb\"c"),
              "x.csv:2: column 1: 'b\"c': a quote in the middle of a field, allowed is one around "
              "the whole field");
    EXPECT_EQ(refusal("a\nb\n\xff\n"), "x.csv:3: the text is not UTF-8");
    EXPECT_EQ(refusal("\""), "x.csv:1: column 1: '\"': a quote that is never closed");
}

TEST(Csv, WhatIsWrittenReadsBackTheSame) {
    const std::vector<std::vector<std::string>> rows{
        {"plain", "with, comma", "with \"quotes\""},
        {"line\nfeed", "carriage\rreturn", "both\r\n"},
        {"", "", ""},
        {"blåbærgrød", " blanks ", "\""},
        {""},
    };
    std::string text;
    for (const auto& row : rows) text += csv_line(row);
    const auto records = parse_csv(text, "x.csv");
    ASSERT_EQ(records.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(records[i].fields, rows[i]);
    EXPECT_EQ(csv_line({"a", "b,c", "d\"e"}), "a,\"b,c\",\"d\"\"e\"\n");
}

TEST(CountsFile, ReadsThePublishedVotes) {
    const Tally tally = read_counts(OBSCURA_SOURCE_DIR "/analysis/data/jakobsen2010.csv");
    ASSERT_EQ(tally.conditions.size(), 7U);
    EXPECT_EQ(*tally.n_participants, 36);
    EXPECT_FALSE(tally.order.has_value());
    EXPECT_FALSE(tally.kind.has_value());
    const ConditionVotes& fourth = tally.conditions[3];
    EXPECT_EQ(fourth.id, "IV");
    EXPECT_EQ(fourth.hypothesis, "H2");
    EXPECT_EQ(fourth.validity, "moderate");
    EXPECT_EQ(fourth.variant_a, "Blizzard8");
    EXPECT_EQ(fourth.variant_b, "RayMarching30");
    EXPECT_EQ(fourth.votes.a, 16);
    EXPECT_EQ(fourth.votes.b, 20);
}

TEST(CountsFile, TakesColumnsInAnyOrderAByteOrderMarkAndCrlf) {
    const Tally tally = parse_counts(
        "\xEF\xBB\xBF"
        "count_b,count_a,variant_b,variant_a,validity,hypothesis,condition\r\n"
        "2,1,\"B, the second\",A,low,,X\r\n",
        "votes.csv");
    ASSERT_EQ(tally.conditions.size(), 1U);
    EXPECT_EQ(tally.conditions[0].id, "X");
    EXPECT_EQ(tally.conditions[0].variant_b, "B, the second");
    EXPECT_EQ(tally.conditions[0].votes.a, 1);
    EXPECT_EQ(tally.conditions[0].votes.b, 2);
}

TEST(CountsFile, TheNumberOfParticipantsIsUnknownWhereConditionsDiffer) {
    const Tally tally =
        parse_counts(kCountsHeader + "I,H1,low,A,B,1,2\nII,H1,low,A,B,1,3\n", "votes.csv");
    EXPECT_EQ(tally.n_participants.reason, "the conditions have different numbers of votes");
}

TEST(CountsFile, SaysEverythingThatIsWrongAtOnce) {
    EXPECT_EQ(refusal_of_counts(kCountsHeader + "I,H1,low,A,B,-1,2.5\n"
                                                "I,H1,lofty,A,,1e13,NaN\n"
                                                "III,H1,low,A,B,1\n"
                                                ",H1,low,A,B,,2.5\n"),
              "votes.csv:2: column count_a: '-1', allowed is a whole number 0 to 1000000000000\n"
              "votes.csv:2: column count_b: '2.5', allowed is a whole number 0 to 1000000000000 "
              "(line 5 too)\n"
              "votes.csv:3: column variant_b is empty\n"
              "votes.csv:3: column count_a: '1e13', allowed is a whole number 0 to 1000000000000\n"
              "votes.csv:3: column count_b: 'NaN', allowed is a whole number 0 to 1000000000000\n"
              "votes.csv:3: column validity: 'lofty', allowed are low, moderate, high; --map "
              "validity= passes the column over\n"
              "votes.csv:3: column condition: 'I' is already in line 2, allowed is one row for "
              "each\n"
              "votes.csv:4: the row has 6 fields, the header has 7\n"
              "votes.csv:5: column count_a: '', allowed is a whole number 0 to 1000000000000\n"
              "votes.csv:5: column condition is empty");
}

TEST(CountsFile, NeedsOnlyTheVariantsAndTheirCountsInAnySpellingOfWholeNumbers) {
    const Tally tally = parse_counts(
        "Count A;count.b;Variant_A ;variant b;remark\n"
        "12,0;1e+05;none;crytek;x\n"
        "+3; 4 ;none;blizzard;y\n",
        "votes.csv");
    ASSERT_EQ(tally.conditions.size(), 2U);
    EXPECT_EQ(tally.conditions[0].votes.n(), 7);
    EXPECT_EQ(tally.conditions[1].id, "none - crytek");
    EXPECT_EQ(tally.conditions[1].votes.a, 12);
    EXPECT_EQ(tally.conditions[1].votes.b, 100'000);
    EXPECT_THAT(tally.notes, ElementsAre("columns that are not read: remark"));
    EXPECT_THAT(refusal_of_counts("variant_a,variant_b,count_a,count_b\nx,y,1,2\nx,y,3,4\n"),
                HasSubstr("votes.csv:3: 'x - y' is already in line 2; where they are two "
                          "conditions, a column condition names each"));
    EXPECT_THAT(refusal_of_counts("variant_a,variant_b,count_a,count_b\nx,y,\"12,0\",2\n"),
                HasSubstr("'12,0'"))
        << "where commas part fields, one within a number is no decimal comma";
}

TEST(CountsFile, RefusesHeadersAndFilesThatAreNone) {
    EXPECT_THAT(refusal_of_counts(""),
                HasSubstr("votes.csv: the file is empty, allowed is a header with "
                          "variant_a, variant_b, count_a, count_b"));
    EXPECT_EQ(refusal_of_counts(kCountsHeader), "votes.csv:1: there is no row below the header");
    EXPECT_EQ(
        refusal_of_counts("condition,condition,votes a,variant_a,variant_b,count_b\nI,I,2,x,y,3\n"),
        "votes.csv:1: columns 1 ('condition') and 2 ('condition') are both condition, allowed "
        "is one");
    EXPECT_EQ(refusal_of_counts("condition,votes a,variant_a,variant_b,count_b\nI,2,x,y,3\n"),
              "votes.csv:1: column count_a is missing; perhaps --map 'count_a=votes a'\n"
              "votes.csv:1: the file's columns are condition, votes a, variant_a, variant_b, "
              "count_b");
    const ColumnMap map({"count_a=votes a"});
    EXPECT_EQ(parse_counts("votes a,variant_a,variant_b,count_b\n2,x,y,3\n", "votes.csv", map)
                  .conditions.at(0)
                  .votes.a,
              2);
    EXPECT_THROW((void)read_counts("/nowhere/votes.csv"), base::Error);
    EXPECT_THROW((void)read_counts("/"), base::Error);
}

}  // namespace
}  // namespace obscura::analysis
