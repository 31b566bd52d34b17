// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "tests/renderer/reference/corner.h"
#include "tests/support/temporary_folder.h"

namespace obscura::renderer {
namespace {

namespace fs = std::filesystem;

class ReferenceCache : public testing::Test {
  protected:
    ReferenceImage ask() {
        traced_ = false;
        const auto tell = [this](double) { return traced_ = true; };
        return cached_reference(folder_.path() / "cache", scene_, view_.camera, 20, 12, options_,
                                tell);
    }
    [[nodiscard]] std::vector<fs::path> files() const {
        std::vector<fs::path> list;
        if (!fs::exists(folder_.path() / "cache")) return list;
        for (const auto& entry : fs::directory_iterator(folder_.path() / "cache")) {
            list.push_back(entry.path());
        }
        return list;
    }

    tests::TemporaryFolder folder_;
    tests::CornerView view_ = tests::corner_view();
    ReferenceScene scene_{view_.scene};
    ReferenceOptions options_ = tests::rays_within(1.0, 16);
    bool traced_ = false;
};

TEST_F(ReferenceCache, PaysOnceAndGivesTheSameAgain) {
    const ReferenceImage first = ask();
    EXPECT_TRUE(traced_);
    const ReferenceImage second = ask();
    EXPECT_FALSE(traced_);
    EXPECT_EQ(first.accessibility, second.accessibility);
    EXPECT_EQ(first.standard_error, second.standard_error);
    EXPECT_EQ(first.depth_m, second.depth_m);
    EXPECT_EQ(second.width, 20);
    EXPECT_EQ(second.height, 12);
}

TEST_F(ReferenceCache, EverythingThatChangesTheImageMakesAnotherFile) {
    (void)ask();
    std::size_t count = 1;
    const auto expect_another = [&](auto change) {
        change();
        (void)ask();
        EXPECT_TRUE(traced_);
        EXPECT_EQ(files().size(), ++count);
    };
    expect_another([this] { options_.radius_m = 1.0000000001; });
    expect_another([this] { options_.rays = 17; });
    expect_another([this] { options_.seed = 2; });
    expect_another([this] { options_.falloff = Falloff::kLinear; });
    expect_another([this] { options_.normal = NormalKind::kShading; });
    expect_another([this] { view_.camera.position_m.x += 1e-6F; });
    expect_another([this] { view_.camera.vertical_fov_rad += 1e-6F; });
    options_.threads = 1;
    (void)ask();
    EXPECT_FALSE(traced_);
}

TEST_F(ReferenceCache, ADamagedFileIsNoticedAndMadeAgain) {
    const ReferenceImage first = ask();
    ASSERT_EQ(files().size(), 1U);
    const fs::path file = files().front();
    const std::string whole = base::read_file(file);
    std::vector<std::string> damages = {"", whole.substr(0, whole.size() / 2), "no image at all",
                                        whole.substr(0, whole.size() - 1)};
    for (std::size_t at = whole.size() / 2; at < whole.size(); at += whole.size() / 7) {
        damages.push_back(whole);
        damages.back()[at] = static_cast<char>(damages.back()[at] ^ 0x10);
    }
    for (const std::string& damage : damages) {
        base::write_file_atomically(file, damage);
        const ReferenceImage again = ask();
        // A byte that no pixel comes from may change unnoticed; the values never do.
        EXPECT_EQ(again.accessibility, first.accessibility);
        EXPECT_EQ(again.standard_error, first.standard_error);
        if (damage.size() < whole.size() - 1) {
            EXPECT_TRUE(traced_);
        }
    }
    (void)ask();
    EXPECT_FALSE(traced_);
}

TEST_F(ReferenceCache, AnotherImagesFileUnderThisNameIsNotTaken) {
    const ReferenceImage first = ask();
    const fs::path file = files().front();
    options_.seed = 99;
    (void)ask();
    for (const fs::path& other : files()) {
        if (other != file) fs::copy_file(other, file, fs::copy_options::overwrite_existing);
    }
    options_.seed = 1;
    const ReferenceImage again = ask();
    EXPECT_TRUE(traced_);
    EXPECT_EQ(again.accessibility, first.accessibility);
}

TEST_F(ReferenceCache, StoppedWorkLeavesNothing) {
    const auto stop = [](double) { return false; };
    EXPECT_THROW((void)cached_reference(folder_.path() / "cache", scene_, view_.camera, 20, 12,
                                        options_, stop),
                 base::Error);
    EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace obscura::renderer
