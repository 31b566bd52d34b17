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

/// What lies on the operator's memory stick lies in the data folder here, and a scene that opens at
/// once stands in for the large one.
std::string at_hand(std::string words) {
    for (const auto& [there, here] :
         {std::pair<std::string, std::string>("/media/usb/", "obscura-data/"),
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

/// Types a day's commands as they stand, with what `behind` adds to those that begin so (the
/// longest that fits); what is in `elsewhere` another test runs, and every line of it has to be
/// there.
void live(const tests::TemporaryFolder& folder, const std::string& day, const Lines& behind,
          std::set<std::string> elsewhere = {}) {
    for (const ReadmeCommand& command : readme_commands("README.md", day)) {
        if (elsewhere.erase(command.words) > 0) continue;
        std::string added;
        for (const auto& [begin, words] : behind) {
            if (command.words.starts_with(begin)) added = " " + words;
        }
        const ProgramRun run = run_program(folder, at_hand(command.words) + added);
        EXPECT_EQ(run.exit_code, 0) << command.words << added << "\n" << run.err << run.out;
        if (command.words.starts_with("new ")) make_small(folder / "my-study.toml");
    }
    for (const std::string& gone : elsewhere) ADD_FAILURE() << day << " has no more: " << gone;
}

TEST(ResearchersDay, AndTheOthersThatFollowWorkAsPastedWithASceneOfOnesOwn) {
    const tests::TemporaryFolder folder;
    add_step(folder);
    ASSERT_EQ(run_program(folder, "scene export step.obj --out my-scene.glb").exit_code, 0);
    // SimulationCommands runs it on fewer studies: as it stands it takes a minute.
    live(folder, "## A researcher's day", {}, {"power my-study.toml --share .65 --sd 1"});
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
    // A kiosk needs a display, and a server: the tests of tests/app/kiosk/ have both.
    live(folder, "## An operator's day",
         {{"check ", "--data elsewhere"}, {"analyze ", "--kind simulated"}},
         {"run my-study.zip --monitor 0", "run my-study.zip --windowed",
          "run my-study.zip --selftest",
          "run my-study.toml --db postgresql://kiosk@server/answers"});

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
          {"render", "my-study.toml"}},
         // ExplorerDriven, ClosedForms, HardCases and Measure run what is behind these.
         {"explore atrium", "ao --closed-forms", "measure --hard-cases",
          "measure --experiment front", "measure --experiment sunet-5.7"});
}

}  // namespace
}  // namespace obscura::app
