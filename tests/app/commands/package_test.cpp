// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/package/package.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/hash.h"
#include "stimuli/package/zip.h"
#include "tests/app/commands/run_program.h"
#include "tests/app/commands/study_text.h"

namespace obscura::app {
namespace {

using stimuli::ArchivedFile;
using testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// A study over a file of its own, packed: `tiny.zip` beside `tiny.toml` and `stone.obj`.
class Packages : public testing::Test {
  protected:
    void SetUp() override {
        base::write_file_atomically(folder_ / "stone.obj",
                                    "v 0 0 0\nv 4 0 0\nv 4 0 -4\nv 0 0 -4\nv 0 1 -2\nv 4 1 -2\n"
                                    "v 4 0 -2\nv 0 0 -2\nf 1 2 3 4\nf 8 7 6 5\n");
        base::write_file_atomically(
            folder_ / "tiny.toml",
            study_head("tiny", "fixed", "resolution = [64, 48]\n") +
                "[[scene]]\nid = \"stone\"\nsource = \"stone.obj\"\ncamera = \"overview\"\n"
                "validity = \"low\"\nlicence = \"CC0\"\n" +
                condition_text("one", "stone", "\"none\"", "\"crytek\", samples = 8"));
        ASSERT_EQ(run_program(folder_, "render tiny.toml").exit_code, 0);
        const ProgramRun packed = run_program(folder_, "pack tiny.toml");
        ASSERT_EQ(packed.exit_code, 0) << packed.err;
    }

    [[nodiscard]] std::vector<ArchivedFile> files() const {
        return stimuli::ZipReader(folder_ / "tiny.zip").read_all();
    }
    static ArchivedFile& named(std::vector<ArchivedFile>& files, const std::string& name) {
        return *std::find_if(files.begin(), files.end(),
                             [&](const auto& file) { return file.name == name; });
    }
    /// The list with the hashes that the files have now.
    static void list_anew(std::vector<ArchivedFile>& files) {
        ArchivedFile& list = named(files, "package.json");
        Json json = Json::parse(list.bytes);
        json["files"] = Json::array();
        for (const ArchivedFile& file : files) {
            if (file.name == "package.json") continue;
            json["files"].push_back({{"name", file.name},
                                     {"bytes", file.bytes.size()},
                                     {"sha256", base::sha256_hex(file.bytes)}});
        }
        list.bytes = json.dump();
    }
    /// What `check` says of the package after a change; nothing may be left of it.
    std::string said_of(const std::function<void(std::vector<ArchivedFile>&)>& change) {
        std::vector<ArchivedFile> changed = files();
        change(changed);
        stimuli::write_zip(folder_ / "bad.zip", changed);
        const ProgramRun run = run_program(folder_, "check bad.zip --data elsewhere");
        EXPECT_EQ(run.exit_code, 2) << run.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "elsewhere")) << run.err;
        return run.err;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(Packages, AreTheSameToTheByteAndCheckedRenderedAndRehearsedOnAnotherMachine) {
    EXPECT_EQ(run_program(folder_, "pack tiny.toml --out again.zip").exit_code, 0);
    EXPECT_EQ(base::read_file(folder_ / "again.zip"), base::read_file(folder_ / "tiny.zip"));
    std::filesystem::create_directory(folder_ / "other");
    std::filesystem::rename(folder_ / "again.zip", folder_ / "other" / "tiny.zip");
    for (const char* words :
         {"check other/tiny.zip", "render other/tiny.zip --verify",
          "plan other/tiny.zip --participants 2", "rehearse other/tiny.zip --participants 2"}) {
        const ProgramRun run = run_program(folder_, std::string(words) + " --data other/data");
        EXPECT_EQ(run.exit_code, 0) << words << run.err << run.out;
    }
    const ProgramRun analysed =
        run_program(folder_,
                    "analyze other/tiny.zip --data other/data --kind simulated "
                    "--db sqlite3://other/data/rehearsal/tiny.sqlite");
    EXPECT_EQ(analysed.exit_code, 0) << analysed.err;
    EXPECT_EQ(base::read_file(folder_ / "other/data/packages/tiny/tiny.toml"),
              base::read_file(folder_ / "tiny.toml"));
    EXPECT_EQ(base::read_file(folder_ / "other/data/stimuli/tiny/one-b.png"),
              base::read_file(folder_ / "obscura-data/stimuli/tiny/one-b.png"));
}

TEST_F(Packages, SayWhatMadeThemAndUnderWhichLicenceTheirScenesAre) {
    std::vector<ArchivedFile> held = files();
    const Json list = Json::parse(named(held, "package.json").bytes);
    EXPECT_THAT(list.at("program").get<std::string>(), HasSubstr("obscura "));
    EXPECT_EQ(list.at("scenes").at(0).at("licence"), "CC0");
    EXPECT_EQ(list.at("scenes").at(0).at("said_by"), "the study");
    EXPECT_EQ(Json::parse(named(held, "stimuli/manifest.json").bytes).at("program"),
              list.at("program"));
}

TEST_F(Packages, LeadNowhereOutsideTheirFolder) {
    for (const char* name :
         {"../evil.txt", "/tmp/evil.txt", "study/../../evil.txt", "a\\b", "C:x"}) {
        EXPECT_FALSE(stimuli::is_inside(name)) << name;
        EXPECT_THAT(said_of([&](auto& files) {
                        files.push_back({name, "x"});
                    }),
                    HasSubstr("would not lie below the folder"))
            << name;
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "evil.txt"));
}

TEST_F(Packages, AreRefusedWhereAPieceIsMissingChangedOrOneTooMany) {
    EXPECT_THAT(said_of([](auto& files) { named(files, "stimuli/one-a.png").bytes += "x"; }),
                HasSubstr("stimuli/one-a.png was changed"));
    EXPECT_THAT(said_of([](auto& files) {
                    files.push_back({"study/more.bin", "x"});
                }),
                HasSubstr("does not list study/more.bin"));
    const auto without = [this](const std::string& name, bool lists_anew) {
        return said_of([&](auto& files) {
            std::erase_if(files, [&](const auto& file) { return file.name == name; });
            if (lists_anew) list_anew(files);
        });
    };
    EXPECT_THAT(without("stimuli/one-b.png", false), HasSubstr("one-b.png is missing"));
    EXPECT_THAT(without("stimuli/one-b.png", true), HasSubstr("one-b.png is missing"));
    EXPECT_THAT(without("study/stone.obj", true), HasSubstr("stone.obj is missing"));
    EXPECT_THAT(without("stimuli/manifest.json", true), HasSubstr("manifest.json is missing"));
    EXPECT_THAT(without("study/tiny.toml", true), HasSubstr("no study file"));
    EXPECT_THAT(without("package.json", false), HasSubstr("not made by obscura pack"));
    EXPECT_THAT(said_of([](auto& files) {
                    std::swap(named(files, "stimuli/one-a.png").bytes,
                              named(files, "stimuli/one-b.png").bytes);
                    list_anew(files);
                }),
                HasSubstr("is not the image that manifest.json lists"));
}

TEST_F(Packages, ThatAreCutOffOrNoArchiveAreRefused) {
    const std::string whole = base::read_file(folder_ / "tiny.zip");
    for (const std::string& bytes : {whole.substr(0, whole.size() / 2), std::string("PK"),
                                     std::string("no archive"), std::string()}) {
        base::write_file_atomically(folder_ / "bad.zip", bytes);
        const ProgramRun run = run_program(folder_, "run bad.zip --data elsewhere");
        EXPECT_EQ(run.exit_code, 2) << run.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "elsewhere"));
    }
    EXPECT_EQ(run_program(folder_, "check nowhere.zip").exit_code, 2);
}

TEST_F(Packages, NeverReplaceWhatLiesInTheDataFolder) {
    EXPECT_EQ(run_program(folder_, "check tiny.zip").exit_code, 0);  // beside what it was made of
    base::write_file_atomically(folder_ / "obscura-data/stimuli/tiny/one-a.png", "mine");
    const ProgramRun run = run_program(folder_, "check tiny.zip");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("one-a.png is there and is another one"));
    EXPECT_EQ(base::read_file(folder_ / "obscura-data/stimuli/tiny/one-a.png"), "mine");
    EXPECT_THAT(run_program(folder_, "render tiny.zip").err, HasSubstr("has its images"));
}

TEST_F(Packages, AreNotMadeOfWhatIsMissingOrLiesOutside) {
    std::filesystem::create_directory(folder_ / "sub");
    std::string text = base::read_file(folder_ / "tiny.toml");
    text.replace(text.find("stone.obj"), 9, "../stone.obj");
    base::write_file_atomically(folder_ / "sub/tiny.toml", text);
    const ProgramRun run = run_program(folder_, "pack sub/tiny.toml --out out.zip");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_THAT(run.err, HasSubstr("lies outside the study's folder"));
    std::filesystem::remove(folder_ / "obscura-data/stimuli/tiny/one-a.png");
    const ProgramRun missing = run_program(folder_, "pack tiny.toml --out out.zip");
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_THAT(missing.err, HasSubstr("the file is missing"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out.zip"));
}

}  // namespace
}  // namespace obscura::app
