// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// A researcher's day as README.md has it, typed by somebody who knows nothing else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

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

/// Of every pair by its condition: how far its images are apart where they are farthest (CIELAB).
using Apart = std::map<std::string, double>;

Apart apart_in(const std::filesystem::path& manifest) {
    Apart apart;
    const auto json = nlohmann::json::parse(base::read_file(manifest));
    for (const auto& pair : json.at("pairs")) {
        apart[pair.at("condition")] = pair.at("largest_delta_e");
    }
    return apart;
}

/// The operator's memory stick is a folder here, and a scene that opens at once stands in for the
/// large one.
std::string at_hand(std::string words) {
    for (const auto& [there, here] : {std::pair<std::string, std::string>("/media/usb/", "usb/"),
                                      {"--scene atrium", "--scene step.obj"}}) {
        const std::size_t at = words.find(there);
        if (at != std::string::npos) words.replace(at, there.size(), here);
    }
    return words;
}

void add_step(const tests::TemporaryFolder& folder) {
    base::write_file_atomically(folder / "step.obj",
                                "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nv 0 1 -2\nv 4 1 -2\n"
                                "v 4 0 -2\nv 0 0 -2\nf 1 2 3 4\nf 8 7 6 5\n");
}

using Lines = std::map<std::string, std::string>;

/// Types a day's lines as they stand, with what `behind` adds to those of the program that begin so
/// (the longest that fits).
void live(const tests::TemporaryFolder& folder, const std::string& day, const Lines& behind) {
    for (const std::string& line : readme_lines("README.md", day)) {
        const auto is_line = [&line](const RunOtherwise& other) { return other.line == line; };
        if (std::any_of(kRunOtherwise.begin(), kRunOtherwise.end(), is_line)) continue;
        if (!line.starts_with(kProgram)) {
            const std::string shell = "cd '" + folder.path().string() + "' && " + at_hand(line);
            EXPECT_EQ(std::system(shell.c_str()), 0) << line;
            continue;
        }
        const std::string words = line.substr(kProgram.size());
        std::string added;
        for (const auto& [begin, more] : behind) {
            if (words.starts_with(begin)) added = " " + more;
        }
        const ProgramRun run = run_program(folder, at_hand(words) + added);
        EXPECT_EQ(run.exit_code, 0) << line << added << "\n" << run.err << run.out;
        if (words.starts_with("new ")) make_small(folder / "my-study.toml");
    }
}

TEST(ResearchersDay, AndTheOthersThatFollowWorkAsPastedWithASceneOfOnesOwn) {
    const tests::TemporaryFolder folder;
    add_step(folder);
    ASSERT_EQ(run_program(folder, "scene export step.obj --out my-scene.glb").exit_code, 0);
    live(folder, "## A researcher's day", {});
    EXPECT_THAT(run_program(folder, "render my-study.toml").err,
                testing::EndsWith("the study is complete; next: obscura rehearse my-study.toml\n"));
    const Apart apart = apart_in(folder / "obscura-data/stimuli/my-study/manifest.json");
    ASSERT_THAT(apart, testing::SizeIs(6));
    for (const auto& [condition, delta_e] : apart) {
        if (condition == "check") continue;
        EXPECT_GT(apart.at("check"), 2.0 * delta_e) << condition << " is no attention check";
    }

    for (const char* copy : {"obscura-data/responses.sqlite", "lab1.sqlite", "lab2.sqlite"}) {
        std::filesystem::copy_file(folder / "obscura-data/rehearsal/my-study.sqlite",
                                   folder / copy);
    }
    std::filesystem::create_directory(folder / "usb");
    live(folder, "## An operator's day",
         {{"check ", "--data elsewhere"}, {"analyze ", "--kind simulated"}});

    base::write_file_atomically(folder / "answers.csv",
                                "observer,condition_A,condition_B,is_A_selected\n"
                                "1,none,blizzard,no\n2,none,blizzard,yes\n");
    base::write_file_atomically(folder / "data.json",
                                R"([{"subject":"1","condition_A":"x","condition_B":"y","chose_B":1},
                                    {"subject":"2","condition_A":"x","condition_B":"y","chose_B":0}])");
    live(folder, "## An analyst's day",
         {{"analyze", "--kind simulated"},
          {"analyze --published", ""},
          {"analyze --trials", ""},
          {"power", ""}});

    std::string edited = base::read_file(folder / "my-study.toml");
    edited.replace(edited.find("strength = 20"), 13, "strength = 25");
    base::write_file_atomically(folder / "my-study.toml", edited);
    EXPECT_THAT(run_program(folder, "check my-study.toml").out,
                testing::HasSubstr("1 of 12 images are of before the study was edited"));
}

TEST(EngineersDay, WorksAsPastedWithFewerPixelsAndRays) {
    const tests::TemporaryFolder folder;
    add_step(folder);
    ASSERT_EQ(run_program(folder, "new my-study --scene step.obj").exit_code, 0);
    make_small(folder / "my-study.toml");
    constexpr const char* kSmall = "my-study.toml --quick --size 48x27 --rays 4 --technique ";
    live(folder, "## A graphics engineer's day",
         {{"ao --scene", "--size 64x36 --rays 4"},
          {"measure", std::string(kSmall) + "blizzard"},
          {"measure --fit", std::string(kSmall) + "hbao --samples 4"},
          {"measure --scene", "--size 64x36 --rays 4"},
          {"render", "my-study.toml"}});
}

}  // namespace
}  // namespace obscura::app
