// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/generate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/gl/context.h"
#include "stimuli/explain.h"
#include "stimuli/png.h"
#include "stimuli/stimulus.h"
#include "tests/support/test_scenes.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;

renderer::Scene build_block() {
    renderer::Scene scene = tests::empty_scene();
    scene.materials[0].albedo = glm::vec3(0.7F);
    tests::add_quad(scene, {-20.0F, -1.0F, 0.0F}, {40.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -40.0F});
    tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {1.0F, 0.5F, -4.0F});
    scene.cameras.push_back(tests::forward_camera());
    return scene;
}

renderer::Lighting light_block(Validity validity) {
    renderer::Lighting lighting;
    if (validity != Validity::kLow) {
        lighting.environment = std::make_shared<renderer::Environment>(renderer::make_sky({}, 64));
    }
    if (validity == Validity::kHigh) {
        lighting.lights.push_back({glm::normalize(glm::vec3(1.0F, 2.0F, 1.0F)), glm::vec3(3.0F)});
        lighting.tone_mapping = renderer::ToneMapping{};
    }
    return lighting;
}

const std::vector<BuiltinScene>& catalogue() {
    static const std::vector<BuiltinScene> list = {
        {"block",
         "A block on a floor",
         "nothing",
         {Validity::kLow, Validity::kModerate, Validity::kHigh},
         {"forward"},
         build_block,
         light_block}};
    return list;
}

class Generate : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fs::path(testing::TempDir()) / ("obscura-generate-" + std::to_string(::getpid()));
        fs::remove_all(folder_);
        study_.name = "blocks";
        study_.width = 96;
        study_.height = 54;
        study_.scenes = {{"low", "block", "forward", Validity::kLow},
                         {"high", "block", "forward", Validity::kHigh}};
        Condition first;
        first.id = "I";
        first.scene = "low";
        first.hypothesis = "H2";
        first.a = {"crytek", 24, {}, "separable"};
        first.b = {"blizzard", 24, {}, "separable"};
        Condition second;
        second.id = "II";
        second.scene = "high";
        second.hypothesis = "H1";
        second.b = {"raymarch", 30, {}, "separable"};
        study_.conditions = {first, second};
    }
    void TearDown() override { fs::remove_all(folder_); }

    Generated make(const Selection& selection = {}) {
        return generate(study_, selection, folder_, true, catalogue());
    }
    [[nodiscard]] std::vector<std::string> check(const Selection& selection = {}) {
        return verify(study_, selection, folder_, true, catalogue()).problems;
    }
    [[nodiscard]] std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            names.push_back(entry.path().filename().string());
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    fs::path folder_;
    Study study_;
};

TEST_F(Generate, RendersWhatHasEqualSettingsOnce) {
    Condition again = study_.conditions[0];
    again.id = "again";
    again.repeats = study_.conditions[0].id;
    study_.conditions.push_back(again);
    const std::size_t images = 2 * study_.conditions.size();
    const Generated first = generate(study_, {}, folder_, true, catalogue());
    EXPECT_EQ(first.made, static_cast<int>(images));
    EXPECT_EQ(first.copied, 2);
    EXPECT_EQ(first.pairs.size(), study_.conditions.size());
    EXPECT_EQ(base::read_file(folder_ / "again-b.png"), base::read_file(folder_ / "I-b.png"));
    EXPECT_THAT(problems_of_stimuli(study_, folder_), testing::IsEmpty());
    EXPECT_THAT(verify(study_, {}, folder_, true, catalogue()).problems, testing::IsEmpty());

    const fs::path other = folder_ / "elsewhere";
    const Generated taken = generate(study_, {.known = folder_}, other, true, catalogue());
    EXPECT_EQ(taken.copied, static_cast<int>(images)) << "all of them were there";
    EXPECT_EQ(base::read_file(other / "II-a.png"), base::read_file(folder_ / "II-a.png"));
    EXPECT_THAT(problems_of_stimuli(study_, other), testing::IsEmpty());
}

TEST_F(Generate, GoesIntoNoFolderThatHoldsOtherFiles) {
    base::write_file_atomically(folder_ / "photo.png", "mine");
    EXPECT_THROW((void)generate(study_, {}, folder_, true, catalogue()), base::Error);
    fs::remove(folder_ / "photo.png");
    EXPECT_NO_THROW((void)generate(study_, {.condition = "I"}, folder_, true, catalogue()));
}

TEST_F(Generate, MakesTwoImagesAPairAndAManifestThatHolds) {
    const Generated generated = make();
    EXPECT_EQ(generated.made, 4);
    EXPECT_TRUE(generated.complete);
    EXPECT_THAT(files(), testing::ElementsAre("I-a.png", "I-b.png", "II-a.png", "II-b.png",
                                              "manifest.json"));
    EXPECT_THAT(problems_of_stimuli(study_, folder_), testing::IsEmpty());
    EXPECT_THAT(check(), testing::IsEmpty());
}

TEST_F(Generate, KeepsWhatIsFinishedAndMakesAgainWhatIsNot) {
    make();
    EXPECT_EQ(make().kept, 4);
    fs::remove(folder_ / "I-b.png");
    base::write_file_atomically(folder_ / "II-a.png", "no image");
    const Generated again = make();
    EXPECT_EQ(again.kept, 2);
    EXPECT_EQ(again.made, 2);
    EXPECT_THAT(check(), testing::IsEmpty());
}

TEST_F(Generate, MakesAgainWhatAChangedStudyAsksFor) {
    make();
    study_.conditions[0].b.parameters["radius_m"] = 0.9;
    const Generated again = make();
    EXPECT_EQ(again.made, 1);
    EXPECT_EQ(
        load_manifest(folder_ / "manifest.json").find("I", "b")->variant.parameters.at("radius_m"),
        0.9);
}

TEST_F(Generate, ADamagedManifestIsMadeAgain) {
    make();
    base::write_file_atomically(folder_ / "manifest.json", "{ not json");
    EXPECT_EQ(make().made, 4);
    EXPECT_THAT(problems_of_stimuli(study_, folder_), testing::IsEmpty());
}

TEST_F(Generate, VerifyNamesATamperedAMissingAndAChangedImage) {
    make();
    // A whole other PNG with a manifest that agrees: only rendering again tells.
    RgbImage image = decode_png(base::read_file(folder_ / "I-a.png"), "I-a.png");
    image.rgb[0] ^= 1;
    base::write_file_atomically(folder_ / "I-a.png", encode_png(image));
    Manifest manifest = load_manifest(folder_ / "manifest.json");
    manifest.images[0].sha256 = base::sha256_hex(base::read_file(folder_ / "I-a.png"));
    save_manifest(folder_ / "manifest.json", manifest);
    base::write_file_atomically(folder_ / "II-a.png", "tampered");
    fs::remove(folder_ / "II-b.png");
    const std::vector<std::string> problems = check();
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_THAT(
        problems,
        testing::UnorderedElementsAre(
            testing::AllOf(testing::HasSubstr("I-a.png"), testing::HasSubstr("rendered again")),
            testing::AllOf(testing::HasSubstr("II-a.png"), testing::HasSubstr("changed")),
            testing::AllOf(testing::HasSubstr("II-b.png"), testing::HasSubstr("missing"))));
}

TEST_F(Generate, PartsTogetherMakeTheWholeAndTheLastWritesTheManifest) {
    EXPECT_FALSE(make({"", 1, 3}).complete);
    EXPECT_FALSE(make({"", 3, 3}).complete);
    EXPECT_FALSE(fs::exists(folder_ / "manifest.json"));
    EXPECT_TRUE(make({"", 2, 3}).complete);
    EXPECT_EQ(load_manifest(folder_ / "manifest.json").images.size(), 4U);
    EXPECT_EQ(make().kept, 4);
}

TEST_F(Generate, AnOldListOfAPartSpoilsNothing) {
    make();
    Manifest old = load_manifest(folder_ / "manifest.json");
    for (ManifestImage& image : old.images) image.inputs_sha256 = "of another program";
    save_manifest(folder_ / "manifest-1-of-2.json", old);
    const Generated again = make();
    EXPECT_EQ(again.kept, 4);
    EXPECT_TRUE(again.complete);
    EXPECT_THAT(problems_of_stimuli(study_, folder_), testing::IsEmpty());
    EXPECT_FALSE(fs::exists(folder_ / "manifest-1-of-2.json"));
}

TEST_F(Generate, MakingOnePairAnewKeepsTheOtherSoundImagesListed) {
    make();
    Manifest old = load_manifest(folder_ / "manifest.json");
    for (ManifestImage& image : old.images) image.inputs_sha256 = "of another program";
    save_manifest(folder_ / "manifest.json", old);
    const Generated one = make({"I", 1, 1});
    EXPECT_EQ(one.made, 2);
    EXPECT_FALSE(one.complete);
    EXPECT_THAT(problems_of_stimuli(study_, folder_), testing::IsEmpty());
}

TEST_F(Generate, FilesOfTheUsersOwnStay) {
    make();
    fs::copy_file(folder_ / "manifest.json", folder_ / "manifest-of-session-1.json");
    make();
    EXPECT_TRUE(fs::exists(folder_ / "manifest-of-session-1.json"));
}

TEST_F(Generate, AnEntryThatSaysSomethingElseIsFoundAndMadeAnew) {
    make();
    Manifest manifest = load_manifest(folder_ / "manifest.json");
    manifest.images[1].variant.samples = 99;
    save_manifest(folder_ / "manifest.json", manifest);
    EXPECT_EQ(check().size(), 1U);
    EXPECT_EQ(make().made, 1);
    EXPECT_THAT(check(), testing::IsEmpty());
    EXPECT_THAT(problems_of_stimuli(study_, folder_), testing::IsEmpty());
}

TEST_F(Generate, AFolderOfAnotherStudyIsRefusedAndLeftAlone) {
    make();
    study_.name = "others";
    EXPECT_THROW(make(), base::Error);
    EXPECT_EQ(load_manifest(folder_ / "manifest.json").study, "blocks");
}

TEST_F(Generate, UnknownPairsAndPartsAreRefusedBeforeAnythingIsWritten) {
    EXPECT_THROW(make({"VIII", 1, 1}), base::Error);
    EXPECT_THROW(make({"", 0, 2}), base::Error);
    EXPECT_THROW(make({"", 3, 2}), base::Error);
    EXPECT_FALSE(fs::exists(folder_));
}

/// Runs `act` in a process of its own and gives its exit code. Neither OpenGL nor the ray tracer
/// must have been used before: threads do not survive a fork.
template <typename Act>
int in_a_process(const Act& act) {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(act());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// In a program of its own, which has used neither OpenGL nor threads when it forks.
class GenerateApart : public Generate {};

TEST_F(GenerateApart, AFullDiskFailsClearlyAndLeavesOnlyWholeFiles) {
    ASSERT_EQ(in_a_process([this] { return make({"I", 1, 1}).made; }), 2);
    const std::vector<std::string> before = files();
    const int code = in_a_process([this] {
        // Files end after 200 bytes, as on a disk that is full; the driver has its own made before.
        const renderer::HeadlessContext warm_up;
        ::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{200, 200};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        try {
            make();
        } catch (const base::Error& error) {
            const bool named = std::string(error.what()).find("II-b.png") != std::string::npos;
            return error.code() == base::ExitCode::kFailed && named ? 1 : 8;
        }
        return 9;
    });
    EXPECT_EQ(code, 1);
    EXPECT_EQ(files(), before);
    EXPECT_EQ(in_a_process([this] { return make().kept; }), 2);
}

TEST_F(GenerateApart, BeingKilledLeavesNoHalfFile) {
    for (const int delay_ms : {0, 3, 10, 30, 100, 300}) {
        fs::remove_all(folder_);
        const pid_t child = ::fork();
        if (child == 0) {
            for (;;) {
                make();
                fs::remove(folder_ / "II-b.png");
            }
        }
        // From the first image on, so that there is one to look at on any machine and build.
        const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (!fs::exists(folder_ / "I-a.png") && std::chrono::steady_clock::now() < limit) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(delay_ms));
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the program ended before it was killed";
        ASSERT_TRUE(fs::exists(folder_ / "I-a.png"));
        for (const std::string& name : files()) {
            EXPECT_TRUE(name.ends_with(".png") || name == "manifest.json") << name;
            if (!name.ends_with(".png")) continue;
            const RgbImage image = decode_png(base::read_file(folder_ / name), name);
            EXPECT_EQ(image.width, 96) << name;
        }
    }
    EXPECT_EQ(in_a_process([this] { return make().complete ? 1 : 0; }), 1);
    EXPECT_THAT(check(), testing::IsEmpty());
}

TEST_F(Generate, ExplainTellsPassesBuffersAndWhatIsLeftOut) {
    const std::string text = explain(study_, {"I", 1, 1}, true, catalogue());
    EXPECT_THAT(text, testing::HasSubstr("I-a.png: Crytek24"));
    EXPECT_THAT(text, testing::HasSubstr("without light: constant ambient light needs no buffer"));
    EXPECT_THAT(text, testing::HasSubstr("20736 bytes  r32f 96x54"));
    EXPECT_THAT(text, testing::HasSubstr(" ms\n"));
    EXPECT_THAT(text, testing::HasSubstr("the middle one of up to 4 runs"));
}

TEST_F(Generate, ExplainTellsOfEqualImagesOnceAndWithWhichImageSharedPassesWereMeasured) {
    Condition again = study_.conditions[0];
    again.id = "again";
    std::swap(again.a, again.b);
    study_.conditions.push_back(again);
    const std::string text = explain(study_, {}, true, catalogue());
    EXPECT_THAT(text, testing::HasSubstr("\nI-a.png, again-b.png: Crytek24"));
    EXPECT_THAT(text, testing::HasSubstr("\nI-b.png, again-a.png: Blizzard24"));
    EXPECT_THAT(text, testing::ContainsRegex("pass    geometry +[0-9.]+ ms\n"));
    EXPECT_THAT(text,
                testing::ContainsRegex("pass    geometry +[0-9.]+ ms  shared with II-b.png\n"));
    EXPECT_THAT(text, testing::ContainsRegex("runs    in all +[0-9.]+ .*ms in .*runs?\n  runs    "
                                             "not shared +[0-9.]+ to [0-9.]+ ms in [234]"));
}

TEST_F(Generate, ExplainTellsOfEveryImageThePassesAndBuffersThatItHasAlone) {
    const auto json = nlohmann::json::parse(explain_json(study_, {}, true, catalogue()));
    ASSERT_EQ(json.size(), 4U);
    const renderer::HeadlessContext context;
    StimulusRenderer alone(study_, catalogue());
    for (const Stimulus& stimulus : stimuli_of(study_)) {
        const auto told = std::find_if(json.begin(), json.end(), [&](const auto& one) {
            return one.at("file") == stimulus.file();
        });
        ASSERT_NE(told, json.end());
        const renderer::Frame frame = alone.render(stimulus);
        std::vector<std::string> passes;
        for (const auto& pass : told->at("passes")) passes.push_back(pass.at("name"));
        std::vector<std::string> expected;
        for (const auto& time : renderer::by_name(frame.times)) expected.push_back(time.name);
        EXPECT_EQ(passes, expected) << stimulus.file();
        EXPECT_EQ(told->at("bytes"), frame.plan().bytes());
        EXPECT_EQ(told->at("everything_bytes"), alone.render_everything(stimulus).plan().bytes());
        EXPECT_EQ(told->at("left_out").size(), frame.plan().left_out.size());
        EXPECT_GE(told->at("own_runs_ms").size(), 2U);
    }
}

TEST(Png, RoundTripsEveryByte) {
    RgbImage image{16, 16, {}};
    for (int i = 0; i < 3 * 256; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i));
    EXPECT_EQ(decode_png(encode_png(image), "x").rgb, image.rgb);
    EXPECT_EQ(encode_png(image), encode_png(image));
    EXPECT_THROW((void)decode_png("GIF89a", "x.png"), base::Error);
}

}  // namespace
}  // namespace obscura::stimuli
