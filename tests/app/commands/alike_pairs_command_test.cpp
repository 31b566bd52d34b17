// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include "renderer/base/files.h"
#include "tests/app/commands/run_program.h"
#include "tests/support/temporary_folder.h"

namespace obscura::app {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A floor and a wall whose maker counted in centimetres.
constexpr std::string_view kRoom = R"(v -200 0 200
v 200 0 200
v 200 0 -200
v -200 0 -200
v 200 300 -200
v -200 300 -200
f 1 2 3 4
f 4 3 5 6
)";

constexpr std::string_view kStudy = R"([study]
name = "room"
title = "A room"
question = "Which?"
instructions = "Look."
seed = 1
resolution = [64, 36]
order = "fixed"

[[scene]]
id = "s"
source = "room.obj"
camera = { position_m = [0, 150, 190], target_m = [0, 80, -200], near_m = 1, far_m = 2000, vertical_fov_deg = 60 }
validity = "moderate"

[[condition]]
id = "c"
scene = "s"
a = { technique = "none" }
b = { technique = "blizzard" }
)";

class AlikePairsOfAProgram : public testing::Test {
  protected:
    void write(const std::string& study) {
        base::write_file_atomically(folder_.path() / "study.toml", study);
    }
    void SetUp() override {
        // The kiosk must not come to stand on a screen that happens to be there.
        ::unsetenv("DISPLAY");
        ::unsetenv("WAYLAND_DISPLAY");
        base::write_file_atomically(folder_.path() / "room.obj", kRoom);
        write(std::string(kStudy));
    }
    /// The study with a key added to its condition.
    [[nodiscard]] static std::string with(const std::string& key) {
        return std::string(kStudy) + key;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(AlikePairsOfAProgram, AreToldByRenderVerifyAndCheckAndRefusedByRun) {
    const auto named = AllOf(HasSubstr("condition \"c\""), HasSubstr("the same to the byte"),
                             HasSubstr("radius_m"));
    const ProgramRun render = run_program(folder_, "render study.toml");
    EXPECT_EQ(render.exit_code, 0) << render.err;
    EXPECT_THAT(render.err, named);
    EXPECT_THAT(run_program(folder_, "render study.toml --verify").err, named);
    const ProgramRun check = run_program(folder_, "check study.toml");
    EXPECT_EQ(check.exit_code, 0) << check.err;
    EXPECT_THAT(check.out, AllOf(named, HasSubstr(" warning")));
    const ProgramRun run = run_program(folder_, "run study.toml");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, AllOf(named, HasSubstr("identical = true")));
}

TEST_F(AlikePairsOfAProgram, AreLetThroughWhereTheStudyMeansThem) {
    write(with("identical = true\n"));
    EXPECT_THAT(run_program(folder_, "render study.toml").err, Not(HasSubstr("condition \"c\"")));
    EXPECT_THAT(run_program(folder_, "check study.toml").out, Not(HasSubstr("condition \"c\"")));
    // Without a display it comes as far as the window.
    EXPECT_THAT(run_program(folder_, "run study.toml").err,
                Not(HasSubstr("nobody can tell apart")));
}

}  // namespace
}  // namespace obscura::app
