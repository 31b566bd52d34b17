// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The kiosk's commands as the READMEs have them, in an X server and with a database of their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "analysis/store/store.h"
#include "tests/app/commands/readme_commands.h"
#include "tests/app/commands/run_program.h"
#include "tests/app/kiosk/shown_study.h"
#include "tests/app/kiosk/virtual_display.h"
#include "tests/support/postgres.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;

constexpr int kWidth = 1100;
constexpr int kHeight = 800;

/// Of all pages, those of the kiosk that name a study or ask for the PIN.
std::set<std::string> kiosk_commands() {
    std::set<std::string> commands;
    for (const char* page : kReadmes) {
        for (const auto& found : {readme_commands(page), readme_mentions(page)}) {
            for (const ReadmeCommand& command : found) {
                if (command.words.starts_with("run ")) commands.insert(command.words);
            }
        }
    }
    return commands;
}

/// A folder with my-study.toml, its images and my-study.zip.
class OperatorsCommands : public testing::Test {
  protected:
    OperatorsCommands() {
        fs::copy_file(shown_.file, shown_.data / "my-study.toml");
        fs::create_directories(shown_.data / "obscura-data/stimuli");
        fs::copy(shown_.folder, shown_.data / "obscura-data/stimuli" / shown_.study.name);
        const ProgramRun pack =
            run_program(shown_.temporary, "pack my-study.toml --out my-study.zip");
        EXPECT_EQ(pack.exit_code, 0) << pack.err;
    }

    /// Starts the kiosk, leaves it as the operator does, and gives its exit code.
    int open_and_leave(const std::string& words) {
        const std::string log = (shown_.data / "log.txt").string();
        // An X server without a screen has no refresh to wait for.
        kiosk::ChildProcess kiosk(
            {"sh", "-c",
             "cd '" + shown_.data.string() + "' && exec '" OBSCURA_PROGRAM "' " + words +
                 " --override 'a display for a test'"},
            -1, log);
        int code = -1;
        constexpr int kMostTries = 200;
        for (int tries = 0; tries < kMostTries && !kiosk.wait(0.6, code); ++tries) {
            display_.key("ctrl+shift+q");  // once more does nothing on the page that asks
            if (kiosk.wait(0.4, code)) break;
            display_.key("l");
        }
        if (code != 0) ADD_FAILURE() << words << "\n" << base::read_file(log);
        return code;
    }

    kiosk::ShownStudy shown_{2, 200, "input_delay_ms = 100\n"};
    kiosk::VirtualDisplay display_{kWidth, kHeight};
};

TEST_F(OperatorsCommands, OpenTheKioskAsPastedAndEndWithNothingWrong) {
    tests::PostgresServer& server = tests::PostgresServer::shared();
    const std::string owner = server.new_database();
    const std::string database = owner.substr(owner.rfind('/') + 1);
    { const analysis::Store tables(owner, analysis::Store::Access::kReadWrite); }
    server.execute(readme_blocks("README.md", "sql").at(0), database);
    const std::string in_page = "postgresql://kiosk@server/answers";
    const std::string here =
        fmt::format("postgresql://kiosk@127.0.0.1:{}/{}", server.port(), database);
    int opened = 0;
    int on_server = 0;
    for (std::string words : kiosk_commands()) {
        if (words.find("--selftest") != std::string::npos) {
            // Twice in place of 200 times: whether an interval holds is for a machine at rest.
            const ProgramRun run = run_program(shown_.temporary, words + " 2");
            EXPECT_TRUE(run.exit_code == 0 || run.exit_code == 3) << words << "\n" << run.err;
            EXPECT_THAT(run.err, testing::HasSubstr("selftest.json"));
            continue;
        }
        if (words.find("--set-pin") != std::string::npos) {
            const ProgramRun run = run_program(shown_.temporary, words + " </dev/null");
            EXPECT_EQ(run.exit_code, 0) << words << "\n" << run.err;
            continue;
        }
        if (const auto at = words.find(in_page); at != std::string::npos) {
            words.replace(at, in_page.size(), here);
            ++on_server;
        }
        opened += open_and_leave(words) == 0 ? 1 : 0;
    }
    EXPECT_GE(opened, 4);
    EXPECT_EQ(on_server, 1);
}

TEST_F(OperatorsCommands, OpenTheExplorerAsPastedWhichEndsWithItsWindow) {
    kiosk::ChildProcess explorer(
        {"sh", "-c",
         "cd '" + shown_.data.string() + "' && exec '" OBSCURA_PROGRAM "' explore atrium"},
        -1, (shown_.data / "log.txt").string());
    int code = -1;
    constexpr int kMostTries = 400;
    for (int tries = 0; tries < kMostTries && !explorer.wait(0.5, code); ++tries) {
        display_.ask_windows_to_close();
    }
    EXPECT_EQ(code, 0) << base::read_file(shown_.data / "log.txt");
}

}  // namespace
}  // namespace obscura::app
