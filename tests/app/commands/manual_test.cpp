// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/manual.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/commands/list.h"
#include "tests/app/commands/run_program.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;

TEST(Manual, NamesEveryCommandAndTheOptionsThatItsHelpNames) {
    const tests::TemporaryFolder folder;
    const std::string manual = run_program(folder, "--manual").out;
    for (const Command& command : commands()) {
        EXPECT_THAT(manual, HasSubstr("\n.SS " + command.name + "\n")) << command.name;
    }
    EXPECT_THAT(manual, HasSubstr("\\fB\\-\\-hard\\-cases\\fR\n"));
    EXPECT_THAT(manual, HasSubstr(".SS scene export\n"));
}

TEST(Manual, HelpOfACommandIsAskedForInEitherOrder) {
    const tests::TemporaryFolder folder;
    const std::string help = run_program(folder, "scene export --help").out;
    EXPECT_THAT(help, HasSubstr("--scale"));
    EXPECT_EQ(run_program(folder, "help scene export").out, help);
    EXPECT_EQ(run_program(folder, "help").out, run_program(folder, "--help").out);
    EXPECT_EQ(run_program(folder, "help nothing").exit_code, 2);
}

TEST(Manual, CompletionOfAShellOffersCommandsAndTheirOptions) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "complete.bash",
                                "source obscura.bash\n"
                                "COMP_WORDS=(obscura \"$@\"); COMP_CWORD=$#\n"
                                "_obscura; printf '%s\\n' \"${COMPREPLY[@]}\"\n");
    base::write_file_atomically(folder / "obscura.bash",
                                run_program(folder, "--completion bash").out);
    const auto completed = [&](const std::string& words) {
        const std::string command = "cd '" + folder.path().string() + "' && bash complete.bash " +
                                    words + " >offered.txt 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0);
        return base::read_file(folder / "offered.txt");
    };
    EXPECT_THAT(completed("mea"), HasSubstr("measure\n"));
    EXPECT_THAT(completed("measure --hard"), HasSubstr("--hard-cases\n"));
    EXPECT_THAT(completed("scene ex"), HasSubstr("export\n"));
    EXPECT_THAT(completed("scene export --sc"), HasSubstr("--scale\n"));
    EXPECT_THAT(run_program(folder, "--completion fish").out,
                HasSubstr("-l hard-cases -d 'Instead: numerical stability"));
    EXPECT_EQ(run_program(folder, "--completion csh").exit_code, 2);
}

}  // namespace
}  // namespace obscura::app
