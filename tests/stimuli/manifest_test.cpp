// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/images/images.h"
#include "stimuli/study_reader.h"
#include "tests/stimuli/study_fixture.h"
#include "tests/support/temporary_folder.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The small study with its images, 4 x 3 pixels, and their manifest in a folder of its own.
class Stimuli : public testing::Test {
  protected:
    void SetUp() override {
        study_ = read_study(kSmallStudy, test_catalogue()).study;
        study_.width = 4;
        study_.height = 3;
        manifest_ = {study_.name, study_.seed, "a renderer \"quoted\" \xC3\xA9", {}};
        for (const Condition& condition : study_.conditions) {
            add_image(condition, "a", condition.a);
            add_image(condition, "b", condition.b);
        }
        save_manifest(folder_ / "manifest.json", manifest_);
    }

    void write_png(const fs::path& path, int width, int height) {
        const std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * height * 3,
                                                shade_);
        shade_ = static_cast<unsigned char>(shade_ + 40);
        std::string why;
        base::write_file_atomically(
            path, images::library().png({width, height, 3, 3, pixels.data()}, why));
    }

    void add_image(const Condition& condition, const std::string& side,
                   const renderer::Variant& choice) {
        ManifestImage image;
        image.file = condition.id + "-" + side + ".png";
        write_png(folder_ / image.file, study_.width, study_.height);
        image.sha256 = base::sha256_hex(base::read_file(folder_ / image.file));
        image.condition = condition.id;
        image.side = side;
        image.scene = condition.scene;
        image.source = "atrium";
        image.camera = "nave";
        image.validity = "high";
        image.variant = choice;
        if (choice.technique == "raymarch")
            image.variant.parameters["radius_m"] = 0.5;  // its standard
        image.width = study_.width;
        image.height = study_.height;
        image.passes = {"geometry", "ao", "composite"};
        image.milliseconds = 12.345678901234567;
        image.inputs_sha256 = base::sha256_hex(image.file);
        manifest_.images.push_back(image);
    }

    [[nodiscard]] std::vector<std::string> problems() const {
        return problems_of_stimuli(study_, folder_);
    }

    tests::TemporaryFolder temporary_;
    fs::path folder_ = temporary_.path();
    Study study_;
    Manifest manifest_;
    unsigned char shade_ = 10;
};

TEST_F(Stimuli, AManifestComesBackExactlyAsItWasSaved) {
    manifest_.images[1].variant.parameters = {{"radius_m", 0.1}, {"power", 1.0 / 3.0}};
    manifest_.images[1].mean_luminance = 0.21;
    manifest_.images[1].contrast = 1.0 / 7.0;
    manifest_.images[1].exposure_factor = 1.0625;
    manifest_.images[1].accuracy = Accuracy{0.039, -0.01, 0.2, 7321};
    save_manifest(folder_ / "manifest.json", manifest_);
    const Manifest back = load_manifest(folder_ / "manifest.json");
    EXPECT_EQ(back.study, manifest_.study);
    EXPECT_EQ(back.seed, manifest_.seed);
    EXPECT_EQ(back.gpu_renderer, manifest_.gpu_renderer);
    ASSERT_EQ(back.images.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const ManifestImage& x = back.images[i];
        const ManifestImage& y = manifest_.images[i];
        EXPECT_EQ(std::tie(x.mean_luminance, x.contrast, x.exposure_factor, x.accuracy),
                  std::tie(y.mean_luminance, y.contrast, y.exposure_factor, y.accuracy));
        EXPECT_EQ(
            std::tie(x.file, x.sha256, x.condition, x.side, x.scene, x.source, x.camera, x.validity,
                     x.variant, x.width, x.height, x.passes, x.milliseconds, x.inputs_sha256),
            std::tie(y.file, y.sha256, y.condition, y.side, y.scene, y.source, y.camera, y.validity,
                     y.variant, y.width, y.height, y.passes, y.milliseconds, y.inputs_sha256));
    }
    EXPECT_EQ(back.find("two", "b")->file, "two-b.png");
    EXPECT_EQ(back.find("two", "c"), nullptr);
}

TEST_F(Stimuli, AFolderWithEveryImageIsReady) { EXPECT_THAT(problems(), IsEmpty()); }

TEST_F(Stimuli, AFolderWithoutManifestSaysWhatMakesIt) {
    fs::remove(folder_ / "manifest.json");
    EXPECT_THAT(problems(),
                ElementsAre(AllOf(HasSubstr("manifest.json"), HasSubstr("obscura render"))));
}

TEST_F(Stimuli, MissingAndTamperedImagesAreEachNamed) {
    fs::remove(folder_ / "one-b.png");
    std::string bytes = base::read_file(folder_ / "two-a.png");
    bytes.back() = static_cast<char>(bytes.back() ^ 1);  // one bit
    base::write_file_atomically(folder_ / "two-a.png", bytes);
    EXPECT_THAT(problems(), ElementsAre(AllOf(HasSubstr("one-b.png"), HasSubstr("missing")),
                                        AllOf(HasSubstr("two-a.png"), HasSubstr("changed"),
                                              HasSubstr(manifest_.images[2].sha256))));
}

TEST_F(Stimuli, AnImageOfAnotherSizeIsRefusedWhateverTheManifestSays) {
    write_png(folder_ / "one-a.png", 5, 3);
    manifest_.images[0].sha256 = base::sha256_hex(base::read_file(folder_ / "one-a.png"));
    save_manifest(folder_ / "manifest.json", manifest_);
    EXPECT_THAT(problems(), ElementsAre(AllOf(HasSubstr("one-a.png"), HasSubstr("5x3"),
                                              HasSubstr("asks for 4x3"))));
}

TEST_F(Stimuli, AFileThatIsNoImageIsRefused) {
    base::write_file_atomically(folder_ / "one-a.png", "no image");
    manifest_.images[0].sha256 = base::sha256_hex("no image");
    save_manifest(folder_ / "manifest.json", manifest_);
    EXPECT_THAT(problems(), ElementsAre(HasSubstr("one-a.png: no image that can be read")));
}

TEST_F(Stimuli, AnImageWithoutEntryIsNamedByConditionAndSide) {
    manifest_.images.erase(manifest_.images.begin() + 1);
    save_manifest(folder_ / "manifest.json", manifest_);
    EXPECT_THAT(problems(), ElementsAre(HasSubstr("no entry for condition one, image b")));
}

TEST_F(Stimuli, ImagesOfBeforeTheStudyWasEditedAreRefusedWithWhatChanged) {
    Study edited = study_;
    edited.conditions[0].b.parameters["radius_m"] = 0.25;
    edited.conditions[1].a.samples = 48;
    EXPECT_THAT(
        problems_of_stimuli(edited, folder_),
        ElementsAre(
            AllOf(HasSubstr("one-b.png: it shows radius_m 0.8, the study asks for 0.25;"),
                  Not(HasSubstr("power"))),
            HasSubstr("two-a.png: it shows variant Crytek32, the study asks for Crytek48;")));
    edited = study_;
    edited.conditions[0].b.denoise = "box4";
    EXPECT_THAT(problems_of_stimuli(edited, folder_),
                ElementsAre(HasSubstr("denoise separable, the study asks for box4;")));
    edited = study_;
    edited.scenes[0].camera = "gallery";
    EXPECT_EQ(problems_of_stimuli(edited, folder_).size(), 4U);
    edited = study_;
    edited.scenes[0].validity = Validity::kModerate;
    EXPECT_EQ(problems_of_stimuli(edited, folder_).size(), 4U);
}

TEST_F(Stimuli, AParameterWrittenOutAtItsStandardIsNoChange) {
    study_.conditions[1].b.parameters["radius_m"] = 0.5;
    EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(Stimuli, AManifestOfAnotherStudyIsRefused) {
    manifest_.study = "other";
    save_manifest(folder_ / "manifest.json", manifest_);
    EXPECT_THAT(problems(), ElementsAre(HasSubstr("belongs to the study other, not to small")));
}

TEST_F(Stimuli, AMalformedManifestIsOneProblemThatNamesTheFile) {
    const std::string good = base::read_file(folder_ / "manifest.json");
    std::string wrong_type = good;
    wrong_type.replace(wrong_type.find("\"samples\": 0"), 12, "\"samples\": \"many\"");
    std::string outside = good;
    outside.replace(outside.find("one-a.png"), 9, "../one-a.png");
    for (const std::string& text :
         {std::string(), std::string("[]"), std::string("{}"), good.substr(0, good.size() / 2),
          wrong_type, outside,
          std::string(R"({"study":"s","seed":1,"gpu_renderer":"","images":3})"),
          std::string(R"({"study":"s","seed":1,"gpu_renderer":"","images":[4]})")}) {
        base::write_file_atomically(folder_ / "manifest.json", text);
        EXPECT_THAT(problems(), ElementsAre(HasSubstr("manifest.json: not a manifest"))) << text;
        try {
            (void)load_manifest(folder_ / "manifest.json");
            FAIL() << "nothing was thrown for " << text;
        } catch (const base::Error& error) {
            EXPECT_EQ(error.code(), base::ExitCode::kBadInput);
        }
    }
}

TEST_F(Stimuli, EveryTruncationOfAManifestIsRefusedOrWhole) {
    const std::string good = base::read_file(folder_ / "manifest.json");
    for (std::size_t length = 0; length + 2 < good.size(); length += 97) {
        base::write_file_atomically(folder_ / "manifest.json", good.substr(0, length));
        EXPECT_THROW((void)load_manifest(folder_ / "manifest.json"), base::Error) << length;
    }
}

TEST_F(Stimuli, AStudysFolderLiesInTheDataFolder) {
    EXPECT_EQ(stimuli_folder("data", study_), fs::path("data/stimuli/small"));
}

}  // namespace
}  // namespace obscura::stimuli
