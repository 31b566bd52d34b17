// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A researcher's day as README.md has it, typed by somebody who knows nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/commands/readme_commands.h"
#include "tests/app/commands/run_program.h"

namespace obscura::app {
namespace {

/// Small images, so that software renders all of them in seconds.
void make_small(const std::filesystem::path& study) {
    std::string text = base::read_file(study);
    const std::string large = "resolution = [1280, 720]";
    text.replace(text.find(large), large.size(), "resolution = [96, 54]");
    base::write_file_atomically(study, text);
}

TEST(ResearchersDay, WorksAsPastedWithASceneOfOnesOwn) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "step.obj",
                                "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nv 0 1 -2\nv 4 1 -2\n"
                                "v 4 0 -2\nv 0 0 -2\nf 1 2 3 4\nf 8 7 6 5\n");
    ASSERT_EQ(run_program(folder, "scene export step.obj --out my-scene.glb").exit_code, 0);
    const auto commands = readme_commands("README.md", "## A researcher's day");
    ASSERT_GE(commands.size(), 12U);
    for (const ReadmeCommand& command : commands) {
        // It simulates studies for a minute; SimulationCommands runs it on fewer.
        if (command.words.starts_with("power ")) continue;
        const ProgramRun run = run_program(folder, command.words);
        EXPECT_EQ(run.exit_code, 0) << command.words << "\n" << run.err << run.out;
        if (command.words.starts_with("new ")) make_small(folder / "my-study.toml");
    }
    for (const ReadmeCommand& command : readme_commands("README.md", "## An operator's day")) {
        if (!command.words.starts_with("check ")) continue;  // the others ask for a display
        EXPECT_EQ(run_program(folder, command.words + " --data elsewhere").exit_code, 0)
            << command.words;
    }
}

}  // namespace
}  // namespace obscura::app
