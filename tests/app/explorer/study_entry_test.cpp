// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/study_entry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "app/explorer/flight.h"
#include "app/explorer/starting_point.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/random.h"
#include "tests/app/explorer/made_model.h"

namespace obscura::app::explorer {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

namespace fs = std::filesystem;

/// A folder of its own with a study of one pair, whose lines have comments.
class ExplorerStudy : public testing::Test {
  protected:
    ExplorerStudy() {
        fs::create_directories(folder_);
        base::write_file_atomically(file_, kText);
    }
    ~ExplorerStudy() override {
        std::error_code error;
        fs::remove_all(folder_, error);
    }

    /// The relic, looked at from where nobody has been.
    [[nodiscard]] Model shown(int seed = 1) const {
        Choices choices = made_choices("relic");
        choices.width = 320;
        choices.height = 180;
        choices.b.parameters["radius_m"] = 0.123456789012345;
        Model model(choices);
        model.opened({choices, "", false, made_wall(), ""}, 0.0);
        base::Random random(static_cast<std::uint64_t>(seed));
        const auto number = [&] { return static_cast<float>(random.uniform(-1.0, 1.0)); };
        renderer::Camera camera = flown(model.view().camera, {number(), number(), number()});
        camera = turned(camera, number(), number());
        model.look_from(with_fov(camera, 40.0F + 10.0F * number()), 1.0);
        return model;
    }
    [[nodiscard]] StudyEntry entry() const {
        StudyEntry entry;
        entry.file = file_;
        entry.scene_id = "relic-view-1";
        entry.condition_id = "pair-1";
        entry.known_sha256 = base::sha256_hex(base::read_file(file_));
        return entry;
    }
    [[nodiscard]] std::string refusal(const Model& model, const StudyEntry& entry) const {
        const bool exists = fs::exists(entry.file);
        const std::string before = exists ? base::read_file(entry.file) : "";
        std::string message;
        try {
            (void)write_into_study(model, entry);
        } catch (const base::Error& error) {
            message = error.what();
        }
        EXPECT_NE(message, "") << "nothing was refused";
        EXPECT_EQ(fs::exists(entry.file), exists);
        if (exists) {
            EXPECT_EQ(base::read_file(entry.file), before) << "the file was touched";
        }
        return message;
    }

    static constexpr const char* kText =
        "# my study\n[study]\nname = \"mine\"\ntitle = \"T\"   # a title\nquestion = \"Q?\"\n"
        "instructions = \"I\"\nresolution = [320, 180]\nseed = 1\norder = \"fixed\"\n\n"
        "[[scene]] # the first\nid = \"relic-low\"\nsource = \"relic\"\ncamera = \"front\"\n"
        "validity = \"low\"\n\n[[condition]]\nid = \"I\"\nscene = \"relic-low\"\n"
        "a = { technique = \"none\" } # nothing\n"
        "b = { technique = \"crytek\", samples = 16 } # something\n"
        "# the end, without an end of line";
    fs::path folder_ = fs::temp_directory_path() / fmt::format("obscura-entry-{}", ::getpid());
    fs::path file_ = folder_ / "mine.toml";
};

TEST_F(ExplorerStudy, WhatIsSavedIsAddedAndEverythingElseStaysAsItWas) {
    const Model model = shown();
    (void)write_into_study(model, entry());
    const std::string text = base::read_file(file_);
    EXPECT_THAT(text, StartsWith(kText));
    const stimuli::Study study = stimuli::load_study(file_.string());
    ASSERT_EQ(study.conditions.size(), 2U);
    EXPECT_EQ(study.conditions[1].a, model.choices().a);
    EXPECT_EQ(study.conditions[1].b, model.choices().b);
    EXPECT_EQ(study.conditions[1].b.parameters.at("radius_m"), 0.123456789012345);
}

TEST_F(ExplorerStudy, EveryFlownCameraComesBackToTheBit) {
    for (int seed = 1; seed <= 200; ++seed) {
        const Model model = shown(seed);
        StudyEntry one = entry();
        const std::string text = study_with(model, one, kText);
        const stimuli::Study study =
            stimuli::parse_study(text, "t", folder_, stimuli::SceneFiles::kTrusted);
        ASSERT_TRUE(same_view(*study.scenes[1].settings.camera, model.view().camera)) << seed;
    }
}

TEST_F(ExplorerStudy, AConditionThatIsThereGetsTheNewPairOnlyWhereThatIsAskedFor) {
    Model model = shown();
    StudyEntry one = entry();
    one.condition_id = "I";
    EXPECT_THAT(refusal(model, one), AllOf(HasSubstr("\"I\""), HasSubstr("replace")));
    one.replaces = true;
    EXPECT_THAT(refusal(model, one), HasSubstr("would not be the pair")) << "it is of another view";
    one.scene_id = "relic-low";
    EXPECT_THAT(refusal(model, one), HasSubstr("shows something else"));
    Choices choices = model.choices();
    choices.scene.validity = stimuli::Validity::kLow;
    Model same(choices);
    const auto scene = made_wall();
    same.opened({choices, "front", false, scene, ""}, 0.0);
    (void)write_into_study(same, one);
    const std::string text = base::read_file(file_);
    EXPECT_THAT(text, HasSubstr("# nothing\n"));
    EXPECT_THAT(text, HasSubstr("# something\n# the end"));
    const stimuli::Study study = stimuli::load_study(file_.string());
    ASSERT_EQ(study.conditions.size(), 1U);
    EXPECT_EQ(study.conditions[0].b, choices.b);
}

TEST_F(ExplorerStudy, AFileThatChangedMeanwhileIsTakenOnlyWhereThatIsAskedFor) {
    const Model model = shown();
    StudyEntry one = entry();
    const std::string theirs = std::string(kText) + "\n# another hand was here\n";
    base::write_file_atomically(file_, theirs);
    EXPECT_THAT(refusal(model, one), HasSubstr("has changed on disk"));
    one.known_sha256.reset();
    EXPECT_THAT(refusal(model, one), HasSubstr("is there already"));
    one.takes_changed_file = true;
    (void)write_into_study(model, one);
    EXPECT_THAT(base::read_file(file_), StartsWith(theirs));
}

TEST_F(ExplorerStudy, AReadOnlyStudyIsRefusedAndSaysWhatIsAllowed) {
    fs::permissions(file_, fs::perms::owner_read);
    EXPECT_THAT(refusal(shown(), entry()), AllOf(HasSubstr("read-only"), HasSubstr("allowed")));
}

TEST_F(ExplorerStudy, AFullDiskLosesNothingAndIsSaid) {
    // No more bytes go into a file than this, as on a disk with that much left.
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    const auto on_signal = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit little{100, before.rlim_max};
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
    const std::string message = refusal(shown(), entry());
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    std::signal(SIGXFSZ, on_signal);
    EXPECT_THAT(message, AllOf(HasSubstr("mine.toml"), HasSubstr("File too large"),
                               HasSubstr("allowed is a folder that may be written and has room")));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1)
        << "something is left beside the study";
    (void)write_into_study(shown(), entry());
    EXPECT_EQ(stimuli::load_study(file_.string()).conditions.size(), 2U);
}

TEST_F(ExplorerStudy, SidesThatAreTablesOfTheirOwnAreLeftAloneAndSaid) {
    const std::string text =
        "[study]\nname = \"mine\"\ntitle = \"T\"\nquestion = \"Q?\"\ninstructions = \"I\"\n"
        "resolution = [320, 180]\nseed = 1\norder = \"fixed\"\n[[scene]]\nid = \"relic-low\"\n"
        "source = \"relic\"\ncamera = \"front\"\nvalidity = \"low\"\n[[condition]]\nid = \"I\"\n"
        "scene = \"relic-low\"\n[condition.a]\ntechnique = \"none\"\n[condition.b]\n"
        "technique = \"crytek\"\nsamples = 16\n";
    base::write_file_atomically(file_, text);
    StudyEntry one = entry();
    one.scene_id = "relic-low";
    one.condition_id = "I";
    one.replaces = true;
    Model model = shown();
    model.look_from("front", 3.0);
    one.scene_id = "relic-view-1";
    EXPECT_THAT(refusal(model, one), HasSubstr("allowed is an inline table"));
    // Beside them there is room.
    one.condition_id = "II";
    one.replaces = false;
    (void)write_into_study(model, one);
    EXPECT_THAT(base::read_file(file_), StartsWith(text));
}

TEST_F(ExplorerStudy, WhatAStudyWouldBeRefusedForIsSaidWithItsLine) {
    const Model model = shown();
    StudyEntry one = entry();
    one.scene_id = "no good id!";
    EXPECT_THAT(refusal(model, one), AllOf(HasSubstr("mine.toml:"), HasSubstr("no good id!")));
    one = entry();
    one.condition_id = "../x";
    EXPECT_THAT(refusal(model, one), HasSubstr("../x"));
    one = entry();
    one.file = folder_ / "mine.txt";
    EXPECT_THAT(refusal(model, one), HasSubstr(".toml"));
    base::write_file_atomically(file_, "[study\n");
    one = entry();
    EXPECT_THAT(refusal(model, one), HasSubstr("mine.toml:"));
}

TEST_F(ExplorerStudy, AFileThatIsNotThereBeginsAsAStudyThatRuns) {
    const Model model = shown();
    StudyEntry one = entry();
    one.file = folder_ / "new.toml";
    one.known_sha256.reset();
    (void)write_into_study(model, one);
    const stimuli::Study study = stimuli::load_study(one.file.string());
    EXPECT_EQ(study.width, 320);
    EXPECT_EQ(study.height, 180);
    EXPECT_EQ(study.conditions.size(), 1U);
    EXPECT_EQ(study.name, "new");
}

TEST_F(ExplorerStudy, TwoSidesThatAreTheSameAreRefused) {
    Model model = shown();
    model.change([](Choices& to) { to.a = to.b; }, "", 2.0);
    EXPECT_THAT(refusal(model, entry()), HasSubstr("identical"));
}

TEST_F(ExplorerStudy, IdsThatAreOfferedAreFreeAndAllowed) {
    const OpenStudy study = open_study(file_.string());
    EXPECT_EQ(free_condition_id(study), "pair-1");
    EXPECT_EQ(free_scene_id(study, "relic"), "relic-1");
    EXPECT_EQ(free_scene_id(study, "a b/c.d"), "a-b-c-d-1");
    EXPECT_EQ(free_scene_id(study, "-x"), "view-x-1");
    EXPECT_LE(free_scene_id(study, std::string(300, 'x')).size(), 64U);
}

TEST(ExplorerStart, AWordThatIsNothingSaysWhatIsAllowed) {
    for (const char* what : {"atriom", "", "/no/such/file.glb", "no-such.toml", "picture.png"}) {
        try {
            (void)starting_point(what, Choices{});
            ADD_FAILURE() << what;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput) << what;
        }
    }
}

TEST(ExplorerStart, AStudyStartsWithItsFirstPairAndASceneWithTheOneThatItIsShownWith) {
    const StartingPoint study = starting_point("jakobsen2010", Choices{});
    ASSERT_TRUE(study.study);
    EXPECT_EQ(study.choices.a, study.study->study.conditions.front().a);
    EXPECT_EQ(study.choices.supersampling, 2);
    const StartingPoint scene = starting_point("atrium", Choices{});
    EXPECT_FALSE(scene.study);
    EXPECT_EQ(scene.choices.scene.source, "atrium");
    EXPECT_EQ(scene.choices.b.technique, "blizzard");
    const StartingPoint other = starting_point("garden", Choices{});
    EXPECT_EQ(other.choices.a.technique, "none");
    EXPECT_NE(other.choices.b.technique, "none");
}

}  // namespace
}  // namespace obscura::app::explorer
