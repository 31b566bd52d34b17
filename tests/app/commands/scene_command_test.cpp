// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/commands/run_program.h"

namespace obscura::app {
namespace {

using testing::HasSubstr;

constexpr std::string_view kTriangle =
    "mtllib none.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";

TEST(SceneCommand, InspectSaysWhatAFileHoldsNeedsAndLacks) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "triangle.obj", kTriangle);
    const ProgramRun run = run_program(folder, "scene inspect --all triangle.obj --size 320x200");
    EXPECT_EQ(run.exit_code, 0) << run.err;
    for (const char* what :
         {"triangles: 1 in 1 meshes", "overview: at", "none.mtl: the file is missing", "red",
          "level low", "level moderate", "level high", "320x200", "without light: "}) {
        EXPECT_THAT(run.out, HasSubstr(what));
    }
    EXPECT_THAT(run_program(folder, "scene inspect triangle.obj").out,
                HasSubstr("camera = \"overview\"      # the file has none; frames everything, at"));
}

TEST(SceneCommand, ExportWritesAFileThatInspectReads) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "triangle.obj", kTriangle);
    const ProgramRun made = run_program(folder, "scene export triangle.obj --out made.glb");
    ASSERT_EQ(made.exit_code, 0) << made.err;
    const ProgramRun read = run_program(folder, "scene inspect --all made.glb");
    EXPECT_EQ(read.exit_code, 0) << read.err;
    EXPECT_THAT(read.out, HasSubstr("triangles: 1 in 1 meshes"));
    EXPECT_THAT(read.out, HasSubstr("overview: at"));
    EXPECT_THAT(read.out, HasSubstr("directional light"));
    EXPECT_THAT(made.err + made.out, HasSubstr("tone mapping"));
}

TEST(SceneCommand, FilesOutsideTheScenesFolderAreReadOnlyWhereAllowed) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "scene/triangle.obj",
                                "mtllib ../more/red.mtl\n" + std::string(kTriangle));
    base::write_file_atomically(folder / "more/red.mtl", "newmtl red\nKd 1 0 0\n");
    const ProgramRun closed = run_program(folder, "scene inspect scene/triangle.obj");
    EXPECT_EQ(closed.exit_code, 0) << closed.err;
    EXPECT_THAT(closed.out, HasSubstr("--allow FOLDER"));
    for (const char* arguments :
         {"--allow more scene inspect --all scene/triangle.obj",
          "scene inspect --all --allow scene --allow more scene/triangle.obj"}) {
        const ProgramRun open = run_program(folder, arguments);
        EXPECT_EQ(open.exit_code, 0) << open.err;
        EXPECT_THAT(open.out, HasSubstr("red: albedo 1 0 0")) << arguments;
    }
    EXPECT_EQ(run_program(folder, "scene inspect scene/triangle.obj --allow nowhere").exit_code, 2);
}

TEST(SceneCommand, WhatCannotBeReadEndsInAMessageAndLeavesNoFile) {
    const tests::TemporaryFolder folder;
    base::write_file_atomically(folder / "bad.glb", "glTF");
    const ProgramRun bad = run_program(folder, "scene export bad.glb --out made.glb");
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.err, HasSubstr("bad.glb: cut off"));
    EXPECT_FALSE(std::filesystem::exists(folder / "made.glb"));
    EXPECT_EQ(run_program(folder, "scene inspect nothing").exit_code, 2);
    EXPECT_EQ(run_program(folder, "scene inspect bad.glb --size 3").exit_code, 2);
    EXPECT_EQ(run_program(folder, "scene export relic --out relic.obj").exit_code, 2);
    EXPECT_EQ(run_program(folder, "scene").exit_code, 2);
    EXPECT_EQ(run_program(folder, "scene inspect --help").exit_code, 0);
}

}  // namespace
}  // namespace obscura::app
