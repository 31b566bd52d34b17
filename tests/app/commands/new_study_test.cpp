// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/base/error.h"
#include "stimuli/scenes/good_views.h"
#include "stimuli/starter_study.h"
#include "stimuli/study_reader.h"
#include "tests/app/commands/run_program.h"
#include "tests/support/test_scenes.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;

constexpr std::string_view kStep =
    "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nv 0 1 -2\nv 4 1 -2\nv 4 0 -2\nv 0 0 -2\n"
    "f 1 2 3 4\nf 8 7 6 5\n";

TEST(NewStudy, RunsAtOnceWithoutAProblemOrAWarning) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(run_program(folder, "new mine --scene relic --scene machine").exit_code, 0);
    const ProgramRun checked = run_program(folder, "check mine.toml");
    EXPECT_EQ(checked.exit_code, 0) << checked.out;
    EXPECT_THAT(checked.out, HasSubstr("no problems\n"));
    EXPECT_EQ(run_program(folder, "plan mine.toml --participants 4").exit_code, 0);
}

TEST(NewStudy, IsMadeOverAFileWithoutACameraAndFindsOne) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "step.obj", kStep);
    const ProgramRun made = run_program(folder, "new steps --scene step.obj");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const std::string text = base::read_file(folder / "steps.toml");
    EXPECT_THAT(text, HasSubstr("camera = { position_m = ["));
    EXPECT_THAT(text, HasSubstr("kind = \"interaction\""));
    EXPECT_EQ(run_program(folder, "check steps.toml").exit_code, 0);
}

TEST(NewStudy, RehearsesAsItsFirstLinesSayAndLeadsFromThereToTheAnalysis) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "step.obj", kStep);
    ASSERT_EQ(run_program(folder, "new mine --scene step.obj").exit_code, 0);
    EXPECT_THAT(base::read_file(folder / "mine.toml"),
                testing::AllOf(HasSubstr("#   obscura rehearse mine.toml "),
                               HasSubstr("#   obscura analyze mine.toml ")));
    const ProgramRun rehearsed = run_program(folder, "rehearse mine.toml --quiet");
    ASSERT_EQ(rehearsed.exit_code, 0) << rehearsed.err;
    EXPECT_THAT(rehearsed.out, HasSubstr("36 observers"));
    const ProgramRun nobody = run_program(folder, "analyze mine.toml");
    EXPECT_EQ(nobody.exit_code, 2);
    constexpr const char* kSimulated = "--db obscura-data/rehearsal/mine.sqlite --kind simulated";
    EXPECT_THAT(nobody.err, testing::AllOf(HasSubstr("there are no answers yet"),
                                           HasSubstr("obscura run"), HasSubstr(kSimulated)));
    const std::string words = std::string("analyze mine.toml ") + kSimulated;
    const ProgramRun analysed = run_program(folder, words);
    EXPECT_EQ(analysed.exit_code, 0) << analysed.err;
    EXPECT_EQ(analysed.err, "");
    const std::string edited = base::read_file(folder / "mine.toml") + "# later\n";
    base::write_file_atomically(folder / "mine.toml", edited);
    EXPECT_THAT(run_program(folder, words).err,
                HasSubstr("36 sessions of mine began with another version of its file"));
}

TEST(NewStudy, LeavesAFileThatIsThereAndRefusesWhatIsNoName) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "mine.toml", "mine\n");
    const ProgramRun again = run_program(folder, "new mine");
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_THAT(again.err, HasSubstr("mine.toml is there already"));
    EXPECT_EQ(base::read_file(folder / "mine.toml"), "mine\n");
    for (const char* name : {"a/b", "x.toml", "-x", "'a b'"}) {
        EXPECT_EQ(run_program(folder, std::string("new -- ") + name).exit_code, 2) << name;
    }
    EXPECT_EQ(run_program(folder, "new other --scene nowhere.obj").exit_code, 2);
    EXPECT_FALSE(std::filesystem::exists(folder / "other.toml"));
}

TEST(FoundViews, SeeTheSceneDifferFromEachOtherAndAreTheSameAgain) {
    const renderer::Scene scene = tests::scene_of_all_kinds();
    const auto views = stimuli::find_views(scene, 4);
    ASSERT_GE(views.size(), 2U);
    for (const stimuli::FoundView& view : views) {
        EXPECT_GT(view.seen, 0.02);
        EXPECT_GE(view.occluded, 0.0);
    }
    EXPECT_NE(stimuli::study_line(views[0].camera), stimuli::study_line(views[1].camera));
    EXPECT_EQ(stimuli::study_line(stimuli::find_views(scene, 1).front().camera),
              stimuli::study_line(views[0].camera));
}

TEST(FoundViews, OfASceneInWhichNothingCanBeSeenAreRefused) {
    EXPECT_THROW((void)stimuli::find_views(tests::empty_scene(), 3), base::Error);
}

TEST(FoundViews, APreviewAndAContactSheetAreWrittenWithTheLineToPaste) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "step.obj", kStep);
    const ProgramRun sheet = run_program(folder, "scene cameras step.obj --count 2 --out s.png");
    ASSERT_EQ(sheet.exit_code, 0) << sheet.err;
    EXPECT_THAT(sheet.out, HasSubstr("camera = { position_m = ["));
    EXPECT_TRUE(std::filesystem::exists(folder / "s.png"));
    const ProgramRun one = run_program(
        folder,
        "scene preview step.obj --position 2,3,4 --look-at 2,0,-2 --size 64x36 --out p.png");
    ASSERT_EQ(one.exit_code, 0) << one.err;
    EXPECT_THAT(one.out, HasSubstr("position_m = [2, 3, 4], target_m = [2, 0, -2]"));
    for (const char* wrong :
         {"--position 1,2 --look-at 0,0,0", "--position 1,2,3", "--position 1,2,3 --look-at 1,2,3",
          "--position 1,2,nan --look-at 0,0,0", "--camera none",
          "--fov 0 --position 1,2,3 --look-at 0,0,0"}) {
        const ProgramRun bad =
            run_program(folder, std::string("scene preview step.obj --out q.png ") + wrong);
        EXPECT_EQ(bad.exit_code, 2) << wrong;
        EXPECT_FALSE(std::filesystem::exists(folder / "q.png")) << wrong;
    }
}

}  // namespace
}  // namespace obscura::app
