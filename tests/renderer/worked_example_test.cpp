// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
// The technique that renderer/README.md shows: its C++ is compiled from the page into this program,
// its shader is read from the page here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "renderer/base/files.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test_scenes.h"

namespace obscura::renderer {

Technique cross_technique();  // of the page

namespace {

namespace fs = std::filesystem;

/// The block of code that follows the line `name:`.
std::string block_after(const std::string& page, const std::string& name) {
    const std::size_t title = page.find("`" + name + "`:\n```");
    EXPECT_NE(title, std::string::npos) << name;
    const std::size_t begin = page.find('\n', page.find("```", title)) + 1;
    return page.substr(begin, page.find("```", begin) - begin);
}

class WorkedExample : public testing::Test {
  protected:
    WorkedExample() {
        const fs::path house = fs::path(OBSCURA_SOURCE_DIR) / "renderer";
        const fs::path shaders = folder_ / "shaders";
        for (const char* part : {"passes", "technique"}) fs::create_directories(shaders / part);
        for (const char* part : {"passes", "technique"}) {
            fs::copy(house / part, shaders / part, fs::copy_options::recursive);
        }
        base::write_file_atomically(
            shaders / "technique/cross.glsl",
            block_after(base::read_file(house / "README.md"), "technique/cross.glsl"));
        setenv("OBSCURA_SHADERS", shaders.c_str(), 1);
    }
    ~WorkedExample() override { unsetenv("OBSCURA_SHADERS"); }

    /// Accessibility of a box on a floor, before a camera that looks at both.
    std::vector<float> drawn(const Variant& variant) {
        Scene scene = tests::empty_scene();
        tests::add_box(scene, {-1.0F, -1.0F, -6.0F}, {0.5F, 0.5F, -4.0F});
        tests::add_quad(scene, {-3.0F, -1.0F, -1.0F}, {9.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -9.0F});
        const Lighting lighting;
        const GpuScene gpu(scene);
        const FramePlan plan =
            plan_frame(needs_of(scene, lighting), technique_, variant, 64, 48, {});
        return renderer_.draw({gpu, lighting, tests::forward_camera(), {}}, plan)
            .read_accessibility();
    }

    tests::TemporaryFolder folder_;
    HeadlessContext context_;
    Renderer renderer_;
    Technique technique_ = cross_technique();
};

TEST_F(WorkedExample, OfThePageIsBuiltDrawsAndReadsWhatItDeclares) {
    Variant variant = standard_variant(technique_);
    const std::vector<float> open = drawn(variant);
    EXPECT_TRUE(std::all_of(open.begin(), open.end(),
                            [](float value) { return value >= 0.0F && value <= 1.0F; }));
    EXPECT_EQ(*std::max_element(open.begin(), open.end()), 1.0F);
    EXPECT_LT(*std::min_element(open.begin(), open.end()), 0.9F) << "where box and floor meet";
    EXPECT_THAT(renderer_.mismatches(), testing::IsEmpty());
    variant.parameters["strength"] = 0.0;
    const std::vector<float> nothing = drawn(variant);
    EXPECT_EQ(*std::min_element(nothing.begin(), nothing.end()), 1.0F);
}

}  // namespace
}  // namespace obscura::renderer
