// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
//
// Tables as other programs write them: read as they are meant, or refused with what to do; nothing
// is passed over without a word.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "analysis/tally.h"
#include "analysis/trials_file.h"
#include "renderer/base/error.h"

namespace obscura::analysis {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

Tally tally_of_foreign(const std::string& bytes, const std::vector<std::string>& map = {}) {
    return tally_of(parse_trials(bytes, "t.csv", ColumnMap(map)), "", Kind::kParticipant);
}

std::string refusal_of_foreign(const std::string& bytes, const std::vector<std::string>& map = {}) {
    try {
        (void)tally_of_foreign(bytes, map);
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        return error.what();
    }
    return "accepted";
}

/// What a tally says, in one line.
std::string words(const Tally& tally) {
    std::string text = fmt::format("{} people", *tally.n_participants);
    for (const ConditionVotes& condition : tally.conditions) {
        text += fmt::format("; {}: {} {}:{} {}", condition.id, condition.variant_a,
                            condition.votes.a, condition.votes.b, condition.variant_b);
        for (const Answer& answer : condition.answers) {
            text += fmt::format(", {} s", answer.response_time_s);
        }
    }
    return text;
}

const std::string kPlain =
    "observer,scene,condition_A,condition_B,is_A_selected,response_time\n"
    "P01,hall,none,crytek,0,1.455\n"
    "P01,hall,blizzard,none,1,1.469\n"
    "P02,yard,blizzard,crytek,1,2.832\n";
const std::string kMeant =
    "2 people; hall: none - blizzard: none 0:1 blizzard, 1.469 s; hall: none - crytek: none 0:1 "
    "crytek, 1.455 s; yard: crytek - blizzard: crytek 0:1 blizzard, 2.832 s";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
    }
    return text;
}

/// Each line of kPlain changed.
template <typename Change>
std::string each_line(Change change) {
    std::string text;
    int number = 0;
    for (std::size_t begin = 0; begin < kPlain.size();) {
        const std::size_t end = kPlain.find('\n', begin);
        text += change(kPlain.substr(begin, end - begin), number++) + "\n";
        begin = end + 1;
    }
    return text;
}

std::string utf16(const std::string& ascii, bool little, bool mark) {
    std::string bytes;
    if (mark) bytes = little ? "\xFF\xFE" : "\xFE\xFF";
    for (const char letter : ascii) {
        bytes += little ? std::string{letter, '\0'} : std::string{'\0', letter};
    }
    return bytes;
}

const std::string kSemicolons = replaced(replaced(kPlain, ",", ";"), ".", ",");

TEST(ForeignTables, SeparatorsLineEndsAndEncodingsAreRecognised) {
    const std::string tabs = replaced(kPlain, ",", "\t");
    for (const std::string& bytes :
         {kPlain, kSemicolons, tabs, replaced(kPlain, ",", "|"), replaced(kPlain, ",", " "),
          "sep=;\r\n" + replaced(kSemicolons, "\n", "\r\n"), "\"sep=,\"\n" + kPlain,
          "sep=\t\n" + tabs, replaced(kPlain, "\n", "\r\n"), replaced(kPlain, "\n", "\r"),
          "\xEF\xBB\xBF" + replaced(kPlain, "\n", "\r\n"), "\n\r\n" + kPlain,
          replaced(kPlain, "\n", "\n\n")}) {
        EXPECT_EQ(words(tally_of_foreign(bytes)), kMeant) << bytes;
        EXPECT_THAT(tally_of_foreign(bytes).notes, IsEmpty()) << bytes;
    }
    for (const bool little : {true, false}) {
        for (const bool mark : {true, false}) {
            const Tally read = tally_of_foreign(utf16(replaced(tabs, "\n", "\r\n"), little, mark));
            EXPECT_EQ(words(read), kMeant);
            EXPECT_THAT(read.notes, ElementsAre(HasSubstr("UTF-16")));
        }
    }
}

TEST(ForeignTables, Latin1IsConvertedAndSaidAndWhatIsNeitherIsRefusedWithARemedy) {
    const Tally read = tally_of_foreign(replaced(kPlain, "hall", "G\xE5rd\x80"));
    EXPECT_EQ(read.conditions.at(0).id, "Gård€: none - blizzard");
    EXPECT_THAT(read.notes, ElementsAre(HasSubstr("Windows-1252")));
    EXPECT_THAT(refusal_of_foreign(replaced(replaced(kPlain, "hall", "Gård"), "yard", "G\xE5rd")),
                AllOf(HasSubstr("t.csv:4: the text is not UTF-8"), HasSubstr("save it as UTF-8")));
    EXPECT_THAT(refusal_of_foreign("\xEF\xBB\xBF" + replaced(kPlain, "hall", "G\xE5rd")),
                HasSubstr("t.csv:2: the text is not UTF-8"));
    EXPECT_THAT(refusal_of_foreign(replaced(replaced(kPlain, "hall", "G\x8Crd"), "\n", "\r")),
                AllOf(HasSubstr("t.csv:2: "), HasSubstr("Mac Roman")));
    EXPECT_THAT(refusal_of_foreign(replaced(kPlain, "yard", "ya\x81rd")),
                HasSubstr("save it as UTF-8"));
    EXPECT_THAT(refusal_of_foreign(kPlain + std::string("\0\0", 2)),
                HasSubstr("t.csv:5: there is a NUL"));
    EXPECT_THAT(refusal_of_foreign("\xFF\xFE" + std::string("o\0b\0\0\xD8s", 7)),
                HasSubstr("taken for UTF-16LE"));
}

TEST(ForeignTables, ColumnsThatAreNotNeededDoNoHarmAndAreNamedOnce) {
    const auto number = [](int row) { return row == 0 ? std::string() : std::to_string(row - 1); };
    for (const std::string& bytes :
         {each_line([&](const std::string&line, int row) { return number(row) + "," + line; }),
          each_line(
              [&](const std::string&line, int row) { return '"' + number(row) + "\"," + line; }),
          each_line([](const std::string&line, int) { return line + ","; }),
          each_line([](const std::string&line, int) { return line + ",,,"; }),
          each_line([](const std::string&line, int row) { return line + (row == 0 ? "" : ","); }),
          each_line([](const std::string&line, int row) { return line + (row == 0 ? "," : ""); }),
          replaced(kPlain, ",", " , "), replaced(kPlain, ",", ", "),
          "Observer,SCENE,Condition.A,condition B,isASelected,Response Time\n" +
              kPlain.substr(kPlain.find('\n') + 1),
          kPlain + ",,,,,\n"}) {
        EXPECT_EQ(words(tally_of_foreign(bytes)), kMeant) << bytes;
        EXPECT_THAT(tally_of_foreign(bytes).notes, IsEmpty()) << bytes;
    }
    const Tally wide = tally_of_foreign(each_line([](const std::string& line, int row) {
        return line + (row == 0 ? ",age,age,criterion" : ",23,\"f, m\",quality");
    }));
    EXPECT_EQ(words(wide), kMeant);
    EXPECT_THAT(wide.notes, ElementsAre("columns that are not read: age, age, criterion"));
    const Tally numbered = tally_of_foreign(each_line([](const std::string& line, int row) {
        return row == 0 ? line : std::to_string(row) + "," + line;
    }));
    EXPECT_EQ(words(numbered), kMeant);
    EXPECT_THAT(numbered.notes, ElementsAre(HasSubstr("each row begins with a number")));
    EXPECT_THAT(refusal_of_foreign(kPlain + "Smith, Ann,hall,none,crytek,0,1\n"),
                HasSubstr("t.csv:5: the row has 7 fields, the header has 6"));
    EXPECT_THAT(refusal_of_foreign(replaced(kPlain, "P0", "Smith, P0")),
                HasSubstr("the row has 7 fields"));
}

TEST(ForeignTables, EverySpellingOfYesNoAndMissingIsKnown) {
    constexpr std::pair<const char*, const char*> kSpellings[]{
        {"1", "0"},        {"1.0", "0.0"},     {"TRUE", "FALSE"}, {"True", "False"},
        {"true", "false"}, {"T", "F"},         {"yes", "no"},     {"Y", "N"},
        {"1e0", "0e0"},    {"\"1\"", "\"0\""}, {"WAHR", "FALSCH"}};
    for (const auto& [yes, no] : kSpellings) {
        const std::string bytes = replaced(replaced(kPlain, ",1,", fmt::format(",{},", yes)), ",0,",
                                           fmt::format(",{},", no));
        EXPECT_EQ(words(tally_of_foreign(bytes)), kMeant) << bytes;
    }
    for (const char* missing : {"", "NA", "N/A", "n/a", "NaN", "nan", "None", "null", "NULL",
                                "<NA>", "#N/A", "undefined", ".", "-", "--"}) {
        EXPECT_EQ(words(tally_of_foreign(replaced(kPlain, "1.455", missing))),
                  replaced(kMeant, "1.455", "0"))
            << missing;
        const Tally unanswered = tally_of_foreign(
            kPlain + fmt::format("P09,hall,none,crytek,{},1\nP02,hall,none,crytek,{},1\n", missing,
                                 missing));
        EXPECT_EQ(words(unanswered), kMeant) << missing;
        EXPECT_THAT(unanswered.notes,
                    ElementsAre("2 rows are passed over, without an answer (lines 5, 6)"))
            << missing;
    }
    EXPECT_EQ(tally_of_foreign(replaced(kPlain, "none", "None")).conditions.at(0).variant_a, "None")
        << "a variant's name";
    EXPECT_THAT(refusal_of_foreign(replaced(kSemicolons, "2,832", "2.832")), HasSubstr("t.csv:4: "))
        << "a decimal comma and a decimal point in one table";
}

TEST(ForeignTables, ARefusalNamesTheLikeliestColumnsAndMapTakesThem) {
    const std::string bytes = replaced(replaced(replaced(replaced(kPlain, "observer", "Subject ID"),
                                                         "condition_A", "stimulus_left"),
                                                "condition_B", "stimulus_right"),
                                       "is_A_selected", "picked_left");
    EXPECT_EQ(refusal_of_foreign(bytes),
              "t.csv:1: column observer is missing; perhaps --map 'observer=Subject ID'\n"
              "t.csv:1: column condition_A is missing; perhaps --map condition_A=stimulus_left\n"
              "t.csv:1: column condition_B is missing; perhaps --map condition_B=stimulus_right\n"
              "t.csv:1: column is_A_selected is missing, allowed instead: chosen, chose_B; perhaps "
              "--map chosen=picked_left\n"
              "t.csv:1: the file's columns are Subject ID, scene, stimulus_left, stimulus_right, "
              "picked_left, response_time");
    std::vector<std::string> map{"observer=subject id", "condition_A=stimulus_left",
                                 "condition_B=stimulus_right", "is_A_selected=picked_left"};
    EXPECT_EQ(words(tally_of_foreign(bytes, map)), kMeant);
    EXPECT_EQ(tally_of_foreign(kPlain, {"scene="}).conditions.at(0).id, "crytek - blizzard");
    EXPECT_EQ(refusal_of_foreign(kPlain, {"observer=nobody"}),
              "t.csv:1: --map observer=nobody: there is no column 'nobody'\n"
              "t.csv:1: the file's columns are observer, scene, condition_A, condition_B, "
              "is_A_selected, response_time");
    EXPECT_THAT(refusal_of_foreign(kPlain, {"winner=scene"}),
                HasSubstr("there is no column winner"));
    EXPECT_THAT(refusal_of_foreign(kPlain, {"observer"}), HasSubstr("allowed is OURS=THEIRS"));
    EXPECT_THAT(refusal_of_foreign(kPlain, {"scene=a", "Scene=b"}), HasSubstr("is named twice"));
    EXPECT_THAT(
        refusal_of_foreign("observer,Observer.,condition_A,condition_B,is_A_selected\na,b,x,y,1\n"),
        Not(HasSubstr("both observer")))
        << "just our name comes first";
    EXPECT_THAT(
        refusal_of_foreign("Observer,observer.,condition_A,condition_B,is_A_selected\na,b,x,y,1\n"),
        HasSubstr("columns 1 ('Observer') and 2 ('observer.') are both observer"));
}

/// The choices of kPlain in a column of their own, by whether A was chosen.
std::string with_choices(const std::string& name, const std::string& a, const std::string& b) {
    const std::string text = replaced(kPlain, "is_A_selected", name);
    return replaced(replaced(replaced(text, ",1,", ",#,"), ",0,", "," + b + ","), "#", a);
}

TEST(ForeignTables, TheChosenVariantIsReadWhereItIsClearAndRefusedWhereItIsNot) {
    const std::string named =
        replaced(replaced(replaced(with_choices("chosen", "?", "crytek"), "blizzard,none,?",
                                   "blizzard,none,BLIZZARD"),
                          "blizzard,crytek,?", "blizzard,crytek,blizzard"),
                 "?", "");
    EXPECT_EQ(words(tally_of_foreign(named)), kMeant);
    EXPECT_EQ(words(tally_of_foreign(with_choices("chosen", "A", "b"))), kMeant);
    EXPECT_EQ(words(tally_of_foreign(with_choices("chosen", "1", "2"))), kMeant);
    EXPECT_EQ(words(tally_of_foreign(with_choices("chosen", "1.0", "2.0"))), kMeant);
    EXPECT_EQ(words(tally_of_foreign(with_choices("chose_B", "no", "yes"))), kMeant);
    EXPECT_THAT(
        refusal_of_foreign(with_choices("chosen", "left", "right")),
        AllOf(HasSubstr("t.csv:2: column chosen: 'right'"), HasSubstr("left and right are")));
    EXPECT_THAT(refusal_of_foreign(with_choices("chosen", "1", "0")),
                AllOf(HasSubstr("t.csv:2: column chosen: '0'"),
                      HasSubstr("--map is_A_selected=chosen if 1 means A")));
    EXPECT_THAT(refusal_of_foreign(with_choices("chosen", "1", "1")), HasSubstr("no number but 1"));
    EXPECT_THAT(refusal_of_foreign(with_choices("chosen", "first", "second")),
                HasSubstr("'second'"));
    EXPECT_THAT(refusal_of_foreign(with_choices("chosen", "A", "neither")), HasSubstr("'neither'"));
    EXPECT_THAT(refusal_of_foreign(with_choices("is_A_selected", "left", "right")),
                HasSubstr("--map chosen=is_A_selected"));

    const std::vector<std::string> sides{"condition_A=left.png", "condition_B=right.png"};
    const auto sided = [](std::string bytes, const std::string& a, const std::string& b) {
        return replaced(replaced(std::move(bytes), "condition_A", a), "condition_B", b);
    };
    for (const auto& [left, right] : {std::pair("left", "right"), {"ArrowLeft", "arrow_right"}}) {
        EXPECT_EQ(words(tally_of_foreign(
                      sided(with_choices("chosen", left, right), "left.png", "right.png"), sides)),
                  kMeant);
        EXPECT_EQ(words(tally_of_foreign(
                      sided(with_choices("chosen", right, left), "right.png", "left.png"),
                      {"condition_A=right.png", "condition_B=left.png"})),
                  kMeant);
    }
    EXPECT_EQ(
        words(tally_of_foreign(sided(with_choices("chosen", "0", "1"), "image[0]", "image[1]"),
                               {"condition_A=image[0]", "condition_B=image[1]"})),
        kMeant);
    const std::string ordered = each_line([](const std::string& line, int row) {
        return line + (row == 0 ? ",first_shown" : row == 1 ? ",B" : ",A");
    });
    EXPECT_EQ(words(tally_of_foreign(
                  replaced(replaced(replaced(ordered, "is_A_selected", "chosen"), ",1,", ",first,"),
                           ",0,", ",first,"))),
              kMeant);
}

TEST(ForeignTables, JsonOfJspsychIsReadAndTrialsOfOtherKindsAreCountedAloud) {
    const std::string welcome =
        R"({"rt": 900, "stimulus": "<p>Welcome, \"you\" {[</p>", "response": 0, "subject": "s1"})";
    const std::string trials =
        R"({"rt":1455,"stimulus":["none","crytek"],"response":1,"subject":"s1","trial_index":1},
           {"rt":null,"stimulus":["blizzard","none"],"response":0,"subject":"s1","trial_index":2})";
    const std::vector<std::string> map{"observer=subject", "condition_A=stimulus[0]",
                                       "condition_B=stimulus[1]", "chosen=response",
                                       "response_time_ms=rt"};
    for (const std::string& bytes :
         {"[" + welcome + ",\n" + trials + "]", "[[" + welcome + "],\n[" + trials + "]]",
          welcome + "\n" + trials}) {
        const Tally read = tally_of_foreign(bytes, map);
        EXPECT_EQ(words(read),
                  "1 people; none - blizzard: none 0:1 blizzard, 0 s; none - crytek: none 0:1 "
                  "crytek, 1.455 s");
        EXPECT_THAT(read.notes,
                    ElementsAre("columns that are not read: stimulus",
                                "1 row is passed over, without the two variants (line 1)"));
    }
    EXPECT_THAT(
        refusal_of_foreign("[" + trials + "]"),
        AllOf(HasSubstr("--map observer=subject"), HasSubstr("--map 'condition_A=stimulus[0]'"),
              HasSubstr("--map 'condition_B=stimulus[1]'"), HasSubstr("--map chosen=response")));
    EXPECT_THAT(refusal_of_foreign("[" + welcome + "]", map),
                HasSubstr("there is no column 'stimulus[0]'"));
    EXPECT_EQ(words(tally_of_foreign(replaced(kPlain, "observer", "[name]"), {"observer=[name]"})),
              kMeant);
    EXPECT_THAT(refusal_of_foreign("[1, 2]"),
                HasSubstr("t.csv:1: '1, 2]' stands where JSON has an object"));
    EXPECT_THAT(refusal_of_foreign("[{\"a\": 1},\n{\"b\": tru}]"),
                HasSubstr("t.csv:2: '{\"b\": tru}'"));
    EXPECT_THAT(refusal_of_foreign("[\n{\"a\": {"),
                HasSubstr("t.csv:2: the object that begins here"));
    EXPECT_THAT(refusal_of_foreign("[{\"a\": 1}"), HasSubstr("ends within an array"));
    EXPECT_THAT(refusal_of_foreign("{\"a\": " + std::string(10'000, '[')), HasSubstr("too deep"));
}

TEST(ForeignTables, RowsThatAreEqualAndRepeatedVotesAreSaid) {
    EXPECT_THAT(tally_of_foreign(kPlain + "P01,hall,none,crytek,1,3\n").notes,
                ElementsAre(AllOf(HasSubstr("1 vote is more than the first of a participant"),
                                  HasSubstr("line 5"), HasSubstr("P01, hall: none - crytek"),
                                  HasSubstr("counts as a vote of its own"))));
    const Tally twice = tally_of_foreign(kPlain + "P02,yard,blizzard,crytek,1,2.832\n");
    EXPECT_EQ(twice.conditions.at(2).votes.b, 2);
    EXPECT_THAT(twice.notes, ElementsAre(HasSubstr("1 vote is"),
                                         AllOf(HasSubstr("1 row is equal in every column"),
                                               HasSubstr("line 5; the first of them to line 4"))));
}

TEST(ForeignTables, APairOfOneNameTwiceIsSaidSinceNothingTellsWhichIsA) {
    const std::string table =
        "observer,condition,condition_A,condition_B,is_A_selected\n"
        "P01,I,blizzard,blizzard,1\n"
        "P01,II,none,blizzard,0\n";
    EXPECT_THAT(tally_of_foreign(table).notes,
                ElementsAre(HasSubstr("condition I compares two variants of one name")));
}

TEST(ForeignTables, MillisecondsTakenForSecondsAreSaid) {
    const std::string bytes = replaced(kPlain, ".", "");
    EXPECT_THAT(tally_of_foreign(bytes).notes,
                ElementsAre(HasSubstr("--map response_time_ms=response_time")));
    EXPECT_EQ(words(tally_of_foreign(bytes, {"response_time_ms=response_time", "response_time="})),
              kMeant);
}

}  // namespace
}  // namespace obscura::analysis
