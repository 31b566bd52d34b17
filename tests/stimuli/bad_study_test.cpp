// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/base/random.h"
#include "stimuli/study_reader.h"
#include "tests/stimuli/study_fixture.h"

namespace obscura::stimuli {
namespace {

/// One edit of the small study and the only problem that it makes.
struct BadText {
    const char* what;
    std::string_view from;  ///< replaced once; empty: `to` is the whole text
    std::string to;
    int line;
    const char* fragment;
};

const std::vector<BadText>& bad_texts() {
    static const std::vector<BadText> list = {
        {"unknown key", "seed = 7", "seed = 7\ngrey_mss = 3", 8, "did you mean \"grey_ms\"?"},
        {"unknown key far from all", "seed = 7", "seed = 7\nzzz = 3", 8,
         "\"zzz\" is an unknown key"},
        {"misspelt required key", "title =", "titel =", 3, "did you mean \"title\"?"},
        {"unknown table", "[[scene]]", "[scenes]\n[[scene]]", 9, "did you mean \"scene\"?"},
        {"missing key", "question = \"Which?\"\n", "", 1, "study: question is missing"},
        {"missing seed", "seed = 7\n", "", 1, "study: seed is missing"},
        {"missing camera", "camera = \"nave\"\n", "", 9, "scene \"court\": camera is missing"},
        {"missing side", "b = { technique = \"raymarch\" }\n", "", 21, "b is missing"},
        {"missing technique", "{ technique = \"raymarch\" }", "{ samples = 30 }", 25,
         "technique is missing"},
        {"wrong type of text", "\"Which?\"", "5", 4, "is an integer, allowed is a string"},
        {"wrong type of number", "seed = 7", "seed = \"7\"", 7,
         "is a string, allowed is an integer"},
        {"fraction for an integer", "seed = 7", "seed = 7.5", 7, "number with a fraction"},
        {"date", "seed = 7", "seed = 2026-01-01", 7, "is a date or time"},
        {"a language that is none", "seed = 7", "seed = 7\nlanguage = \"german\"", 8,
         "is no language, allowed is a tag of BCP 47"},
        {"a word that is none", "[[scene]]", "[texts]\nbegn = \"Go\"\n[[scene]]", 10,
         "did you mean \"begin\"?"},
        {"a place that a word has not", "[[scene]]",
         "[texts]\ndone = \"{don} of {count}\"\n[[scene]]", 10,
         "has {don}, allowed in braces are count, done"},
        {"an empty word", "[[scene]]", "[texts]\nbegin = \" \"\n[[scene]]", 10, "is empty"},
        {"consent to nothing", "[[scene]]", "[consent]\nversion = \"1\"\nitems = []\n[[scene]]", 11,
         "an array of 1 to 20 different texts"},
        {"consent without a version", "[[scene]]", "[consent]\nitems = [\"I agree\"]\n[[scene]]", 9,
         "consent: version is missing"},
        {"a form without fields", "[[scene]]", "[form]\nfeild = 1\n[[scene]]", 10,
         "did you mean \"field\"?"},
        {"a field of no kind", "[[scene]]",
         "[[form.field]]\nid = \"a\"\nkind = \"txt\"\nlabel = \"A\"\n[[scene]]", 11,
         "did you mean \"text\"?"},
        {"a key of another kind of field", "[[scene]]",
         "[[form.field]]\nid = \"a\"\nkind = \"text\"\nlabel = \"A\"\nunit = \"m\"\n[[scene]]", 13,
         "\"unit\" is a setting of number"},
        {"a range that is none", "[[scene]]",
         "[[form.field]]\nid = \"a\"\nkind = \"number\"\nlabel = \"A\"\nmin = 3\nmax = 3\n"
         "[[scene]]",
         14, "3 is not above min, which is 3"},
        {"a scale of too many steps", "[[scene]]",
         "[[form.field]]\nid = \"a\"\nkind = \"scale\"\nlabel = \"A\"\nmin = 0\nmax = 11\n"
         "[[scene]]",
         14, "allowed are 2 to 11 steps"},
        {"an id that is no column", "[[scene]]",
         "[[form.field]]\nid = \"A b\"\nkind = \"text\"\nlabel = \"A\"\n[[scene]]", 10,
         "is no name of a column"},
        {"side that is no table", "{ technique = \"none\" }", "\"none\"", 18, "allowed is a table"},
        {"parameter that is no number", "radius_m = 0.8", "radius_m = true", 19,
         "is a truth value, allowed is a number"},
        {"empty text", "\"Look.\"", "\"  \"", 5, "is empty"},
        {"control character", "\"Look.\"", "\"Lo\\u0007ok\"", 5, "control character"},
        {"one side of a resolution", "seed = 7", "seed = 7\nresolution = [1280]", 8,
         "has 1 values"},
        {"zero width", "seed = 7", "seed = 7\nresolution = [0, 720]", 8, "0 is out of range"},
        {"giant height", "seed = 7", "seed = 7\nresolution = [1280, 16385]", 8,
         "16385 is out of range"},
        {"resolution in words", "seed = 7", "seed = 7\nresolution = \"1280x720\"", 8,
         "[width, height]"},
        {"grey too long", "seed = 7", "seed = 7\ngrey_ms = 60001", 8, "0 to 60000"},
        {"grey not a code value", "seed = 7", "seed = 7\ngrey_level = 256", 8, "0 to 255"},
        {"more samples than a pixel may take", "seed = 7", "seed = 7\nsupersampling = 5", 8,
         "1 to 4"},
        {"a surface of no opacity", "seed = 7", "seed = 7\noccluding_opacity = 0", 8, "0.01 to 1"},
        {"an input delay before the page", "seed = 7", "seed = 7\ninput_delay_ms = -1", 8,
         "0 to 5000"},
        {"an input delay nobody would wait", "seed = 7", "seed = 7\ninput_delay_ms = 5001", 8,
         "0 to 5000"},
        {"an input delay in words", "seed = 7", "seed = 7\ninput_delay_ms = \"300\"", 8,
         "allowed is an integer"},
        {"a pointer that is no truth value", "seed = 7", "seed = 7\npointer = 1", 8,
         "allowed is true or false"},
        {"one key instead of a list", "seed = 7", "seed = 7\nadvance = \"space\"", 8,
         "is a string, allowed is an array of space"},
        {"a key that is not there", "seed = 7", "seed = 7\nadvance = [\"spacebar\"]", 8,
         "\"spacebar\" is no key"},
        {"a key that is no letter", "seed = 7", "seed = 7\nadvance = [\"\u00e4\"]", 8, "is no key"},
        {"a key that is a number", "seed = 7", "seed = 7\nadvance = [1]", 8,
         "something else than a string"},
        {"no way to leave an image", "seed = 7", "seed = 7\nadvance = []", 8,
         "nobody could leave an image"},
        {"negative seed", "seed = 7", "seed = -7", 7, "-7 is out of range"},
        {"unknown order", "latin-square", "latin", 6, "did you mean \"latin-square\"?"},
        {"name that is a path", "\"small\"", "\"../small\"", 2, "cannot be part of a file name"},
        {"hidden name", "\"small\"", "\".small\"", 2, "cannot be part of a file name"},
        {"id with a blank", "id = \"one\"", "id = \"o ne\"", 16, "cannot be part of a file name"},
        {"empty id", "id = \"one\"", "id = \"\"", 16, "cannot be part of a file name"},
        {"unknown scene source", "\"atrium\"", "\"atrum\"", 11, "did you mean \"atrium\"?"},
        {"unknown camera", "\"nave\"", "\"front\"", 12, "\"front\" is unknown, allowed are nave"},
        {"unknown validity", "\"high\"", "\"highest\"", 13, "allowed are low, moderate, high"},
        {"validity without light", "\"high\"", "\"low\"", 13, "allowed are moderate, high"},
        {"undefined scene", "id = \"two\"\nscene = \"court\"", "id = \"two\"\nscene = \"cuort\"",
         23, "did you mean \"court\"?"},
        {"duplicate condition", "id = \"two\"", "id = \"one\"", 22, "used twice"},
        {"duplicate scene", "[[condition]]",
         "[[scene]]\nid = \"court\"\nsource = \"atrium\"\ncamera = \"nave\"\nvalidity = \"high\"\n"
         "[[condition]]",
         16, "used twice"},
        {"unknown technique", "\"blizzard\"", "\"blizard\"", 19, "did you mean \"blizzard\"?"},
        {"negative samples", "samples = 32", "samples = -8", 24, "takes 8 to 128"},
        {"samples no multiple", "samples = 32", "samples = 12", 24, "multiples of 8"},
        {"samples beyond an int", "samples = 32", "samples = 99999999999", 24, "out of range"},
        {"samples for none", "\"none\"", "\"none\", samples = 8", 18, "none takes no samples"},
        {"unknown denoise", "samples = 32", "samples = 32, denoise = \"box\"", 24,
         "allowed are none, box4, separable"},
        {"denoise for none", "\"none\"", "\"none\", denoise = \"box4\"", 18, "no buffer to smooth"},
        {"parameter of another technique", "samples = 32", "samples = 32, radius_m = 1", 24,
         "\"radius_m\" is an unknown key"},
        {"misspelt parameter", "radius_m", "radius", 19, "did you mean \"radius_m\"?"},
        {"parameter out of range", "0.8", "1000.5", 19, "0 to 1000 m"},
        {"parameter beyond exact doubles", "0.8", "9007199254740993", 19, "out of range"},
        {"parameter not a number", "0.8", "nan", 19, "nan is out of range"},
        {"parameter infinite", "0.8", "inf", 19, "inf is out of range"},
        {"two equal images", "\"crytek\", samples = 32", "\"raymarch\", samples = 30", 25,
         "the same as a in every way"},
        {"condition as one table", "",
         "[study]\nname='n'\ntitle='t'\nquestion='q'\n"
         "instructions='i'\nseed=1\n[condition]\n",
         7, "[[condition]]"},
        {"no condition", "",
         "[study]\nname='n'\ntitle='t'\nquestion='q'\ninstructions='i'\nseed=1\n", 0,
         "no [[condition]]"},
        {"key twice", "seed = 7", "seed = 7\nseed = 8", 8, "not TOML: "},
        {"no value", "seed = 7", "seed =", 7, "not TOML: "},
        {"quote not closed", "\"Which?\"", "\"Which?", 4, "not TOML: "},
        {"not UTF-8", "Look.", "Lo\xFFok", 5, "not TOML: "},
        {"half a character at the end", "", "[study]\nname = \"\xE2\x82", 2, "not TOML: "},
    };
    return list;
}

TEST(BadStudy, EachMistakeIsOneProblemAtItsLineWithWhatIsAllowed) {
    for (const BadText& bad : bad_texts()) {
        std::string text(kSmallStudy);
        if (bad.from.empty()) {
            text = bad.to;
        } else {
            const std::size_t at = text.find(bad.from);
            ASSERT_NE(at, std::string::npos) << bad.what;
            text.replace(at, bad.from.size(), bad.to);
        }
        const auto problems = read_study(text, test_catalogue()).problems;
        ASSERT_FALSE(problems.empty()) << bad.what;
        EXPECT_EQ(problems.front().line, bad.line) << bad.what << ": " << problems.front().message;
        EXPECT_THAT(problems.front().message, testing::HasSubstr(bad.fragment)) << bad.what;
        EXPECT_EQ(problems.size(), 1U) << bad.what << "\n" << to_lines(problems, "text");
    }
}

TEST(BadStudy, MoreConditionsThanAnOrderHoldsAreRefusedAtTheFirstTooMany) {
    std::string text(kSmallStudy.substr(0, kSmallStudy.find("[[condition]]")));
    for (int i = 0; i <= kMostConditions; ++i) {
        text += fmt::format(
            "[[condition]]\nid='c{}'\nscene='court'\na={{technique='none'}}\n"
            "b={{technique='crytek'}}\n",
            i);
    }
    const auto problems = read_study(text, test_catalogue()).problems;
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].line, 15 + 5 * kMostConditions);
}

/// Either a study that can be run or problems that lie in the text.
void expect_sound(const std::string& text) {
    const StudyReading reading = read_study(text, test_catalogue());
    if (reading.problems.empty()) {
        ASSERT_FALSE(reading.study.conditions.empty());
        for (const Condition& condition : reading.study.conditions) {
            (void)reading.study.scene_of(condition);
            ASSERT_TRUE(renderer::problems_of(condition.a).empty());
            ASSERT_TRUE(renderer::problems_of(condition.b).empty());
        }
        return;
    }
    const auto lines = std::count(text.begin(), text.end(), '\n') + 1;
    for (const StudyProblem& problem : reading.problems) {
        ASSERT_GE(problem.line, 0) << problem.message;
        ASSERT_LE(problem.line, lines) << problem.message;
        ASSERT_FALSE(problem.message.empty());
        ASSERT_EQ(problem.message.find('\n'), std::string::npos) << problem.message;
    }
}

TEST(BadStudy, ATextCutAnywhereIsReadOrRefusedWithItsLine) {
    const std::string text = builtin_text();
    for (std::size_t length = 0; length < text.size(); length += 7) {
        expect_sound(text.substr(0, length));
    }
    for (std::size_t length = 0; length <= kSmallStudy.size(); ++length) {
        expect_sound(std::string(kSmallStudy.substr(0, length)));
    }
}

TEST(BadStudy, ATextChangedAtRandomIsReadOrRefusedWithItsLine) {
    const std::string original = builtin_text();
    const std::string_view alphabet = "\"'[]{}=,.#\\\n\t -_09azn\x01\x80\xC3\xFF";
    base::Random random(42);
    for (int i = 0; i < 1500; ++i) {
        std::string text = i % 2 == 0 ? original : std::string(kSmallStudy);
        for (std::uint64_t edits = 1 + random.below(4); edits > 0; --edits) {
            const std::size_t at = random.below(text.size());
            const std::size_t length = std::min<std::size_t>(random.below(12), text.size() - at);
            switch (random.below(4)) {
                case 0:
                    text[at] = alphabet[random.below(alphabet.size())];
                    break;
                case 1:
                    text.erase(at, length);
                    break;
                case 2:
                    text.insert(at, text.substr(random.below(text.size()), length));
                    break;
                default:
                    text.insert(at, 1, static_cast<char>(random.below(256)));
            }
        }
        expect_sound(text);
        if (HasFatalFailure()) FAIL() << "in round " << i;
    }
}

TEST(BadStudy, ADeepNestIsRefusedAndDoesNotOverflowTheStack) {
    expect_sound("a = " + std::string(100000, '['));
    std::string tables = "a = ";
    for (int i = 0; i < 10000; ++i) tables += "{ a = ";
    expect_sound(tables);
}

}  // namespace
}  // namespace obscura::stimuli
