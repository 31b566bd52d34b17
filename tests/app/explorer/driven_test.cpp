// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <epoxy/gl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <unistd.h>
// After epoxy, which brings the OpenGL declarations.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <functional>

#include "app/explorer/explorer.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/random.h"
#include "renderer/export/gltf_export.h"
#include "stimuli/study.h"
#include "tests/app/kiosk/virtual_display.h"

namespace obscura::app::explorer {
namespace {

namespace fs = std::filesystem;

/// Two walls and a floor that meet, as a glTF file with two cameras.
void write_corner(const fs::path& file) {
    renderer::Scene scene;
    renderer::Mesh mesh;
    const auto wall = [&](const glm::vec3& normal, const glm::vec3& u, const glm::vec3& v) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const glm::vec2& at :
             {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
            renderer::Vertex vertex;
            vertex.position_m = at.x * u + at.y * v;
            vertex.normal = normal;
            mesh.vertices.push_back(vertex);
        }
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) {
            mesh.indices.push_back(first + corner);
        }
    };
    const glm::vec3 x(1, 0, 0);
    const glm::vec3 y(0, 1, 0);
    const glm::vec3 z(0, 0, 1);
    wall(y, z, x);
    wall(x, y, z);
    wall(z, x, y);
    scene.meshes = {mesh};
    renderer::Material material;
    material.double_sided = true;
    scene.materials = {material};
    renderer::Camera near;
    near.name = "near";
    near.position_m = {1.4F, 1.1F, 1.3F};
    near.target_m = {0.2F, 0.2F, 0.2F};
    renderer::Camera far = near;
    far.name = "far";
    far.position_m = {2.1F, 1.6F, 2.4F};
    scene.cameras = {near, far};
    base::write_file_atomically(file, renderer::to_glb(scene, renderer::Lighting{}));
}

MATCHER(one_level_apart, "") {
    return std::abs(static_cast<int>(std::get<0>(arg)) - static_cast<int>(std::get<1>(arg))) <= 1;
}

/// An explorer in an X server of its own, and a folder of its own.
class ExplorerDriven : public testing::Test {
  protected:
    ExplorerDriven() {
        fs::create_directories(folder_);
        write_corner(folder_ / "corner.glb");
        ExploreOptions options;
        options.what = (folder_ / "corner.glb").string();
        options.data = folder_ / "data";
        options.image = WindowSize{160, 90};
        options.window = WindowSize{1280, 800};
        explorer_ = std::make_unique<Explorer>(options);
    }
    ~ExplorerDriven() override {
        explorer_.reset();
        std::error_code error;
        fs::remove_all(folder_, error);
    }

    [[nodiscard]] Model& model() { return explorer_->model(); }
    /// Frames until it is so; false: not in that many seconds.
    [[nodiscard]] bool wait_until(const std::function<bool()>& so, double longest_s = 60.0) {
        const double end_s = ExplorerWindow::now_s() + longest_s;
        while (!so()) {
            if (ExplorerWindow::now_s() > end_s || !explorer_->step()) return false;
        }
        return true;
    }
    [[nodiscard]] bool wait_for_images() {
        return wait_until([&] {
            return model().scene() && explorer_->at_rest() && model().buffers('a') &&
                   model().buffers('b');
        });
    }
    void frames(int count) {
        for (int i = 0; i < count; ++i) {
            ExplorerWindow::wake();  // no frame waits for an event
            explorer_->step();
        }
    }
    [[nodiscard]] glm::vec2 place(const std::string& field) {
        frames(2);
        const auto found = explorer_->state().places.find(field);
        if (found == explorer_->state().places.end()) {
            ADD_FAILURE() << "no field " << field;
            return {5.0F, 5.0F};
        }
        return found->second;
    }
    /// The exit code of the program itself.
    [[nodiscard]] int program(const std::vector<std::string>& words) const {
        std::vector<std::string> command{OBSCURA_PROGRAM, "--data", (folder_ / "data").string()};
        command.insert(command.end(), words.begin(), words.end());
        int exit_code = -1;
        kiosk::ChildProcess child(command, -1, (folder_ / "log").string());
        EXPECT_TRUE(child.wait(120.0, exit_code));
        EXPECT_EQ(exit_code, 0) << base::read_file(folder_ / "log");
        return exit_code;
    }
    void point_at(const glm::vec2& at) {
        display_.tool({"xdotool", "mousemove", std::to_string(std::lround(at.x)),
                       std::to_string(std::lround(at.y))});
        frames(3);
    }
    void click(const std::string& field) {
        point_at(place(field));
        display_.tool({"xdotool", "mousedown", "1"});
        frames(2);
        display_.tool({"xdotool", "mouseup", "1"});
        frames(3);
    }
    void choose(const std::string& field, const std::string& word) {
        click(field);
        click(field + '/' + word);
    }
    void key(const std::string& name) {
        display_.key(name);
        frames(3);
    }

    fs::path folder_ = fs::temp_directory_path() / fmt::format("obscura-explorer-{}", ::getpid());
    kiosk::VirtualDisplay display_{1280, 800};
    std::unique_ptr<Explorer> explorer_;
};

TEST_F(ExplorerDriven, WhatIsSavedIntoAStudyIsRenderedToTheByteAsItIsSeen) {
    ASSERT_TRUE(wait_for_images());
    // Dropped: no tool makes X drop a file, so the callback is called as GLFW calls it.
    write_corner(folder_ / "dropped.glb");
    const std::string dropped = (folder_ / "dropped.glb").string();
    const char* path = dropped.c_str();
    GLFWwindow* const handle = explorer_->window().handle();
    const GLFWdropfun drop = glfwSetDropCallback(handle, nullptr);
    glfwSetDropCallback(handle, drop);
    drop(handle, 1, &path);
    ASSERT_TRUE(wait_until([&] { return model().choices().scene.id == "dropped"; }));
    key("c");
    EXPECT_EQ(model().view().name, "far");
    choose("a/technique", "none");
    choose("b/technique", "hbao");
    EXPECT_EQ(model().choices().a.technique, "none");
    EXPECT_EQ(model().choices().b.technique, "hbao");
    // The slider, dragged.
    const glm::vec2 slider = place("b/radius_m");
    point_at(slider - glm::vec2(40.0F, 0.0F));
    display_.tool({"xdotool", "mousedown", "1"});
    frames(2);
    point_at(slider + glm::vec2(10.0F, 0.0F));
    display_.tool({"xdotool", "mouseup", "1"});
    frames(2);
    EXPECT_TRUE(model().choices().b.parameters.contains("radius_m"));
    // Flown to a view of its own.
    display_.tool({"xdotool", "keydown", "w"});
    frames(4);
    display_.tool({"xdotool", "keyup", "w"});
    frames(4);
    ASSERT_TRUE(wait_for_images());
    EXPECT_EQ(model().view().name, "");
    ASSERT_TRUE(wait_until([&] { return model().truth() && model().truth()->least_rays() > 0; }));
    // Into a study, by the dialog.
    key("ctrl+t");
    display_.tool({"xdotool", "type", "--delay", "20", (folder_ / "found.toml").string()});
    frames(5);
    key("Return");
    ASSERT_TRUE(wait_until([&] { return fs::exists(folder_ / "found.toml"); }, 20.0));
    key("ctrl+s");
    const fs::path images = folder_ / "data" / "explore";
    ASSERT_TRUE(wait_until([&] { return explorer_->at_rest() && fs::exists(images); }));
    const stimuli::RgbImage seen{model().image('b')->width, model().image('b')->height,
                                 model().image('b')->rgb};
    explorer_.reset();

    // The commands take it as it is.
    const std::string found = (folder_ / "found.toml").string();
    EXPECT_EQ(program({"check", found}), 0);
    EXPECT_EQ(program({"render", found, "--out", (folder_ / "stimuli").string()}), 0);
    const stimuli::Study study = stimuli::load_study(found);
    ASSERT_EQ(study.conditions.size(), 1U);
    const std::string rendered =
        base::read_file(folder_ / "stimuli" / (study.conditions[0].id + "-b.png"));
    EXPECT_EQ(stimuli::decode_png(rendered, "rendered").rgb, seen.rgb);
    int alike = 0;
    for (const auto& file : fs::directory_iterator(images)) {
        if (base::read_file(file.path()) == rendered) ++alike;
    }
    EXPECT_EQ(alike, 1) << "one of the saved PNGs is the rendered one to the byte";
}

TEST_F(ExplorerDriven, OneFliesWhileTheMouseTurns) {
    ASSERT_TRUE(wait_for_images());
    const renderer::Camera before = model().view().camera;
    point_at({300.0F, 400.0F});
    display_.tool({"xdotool", "mousedown", "1", "keydown", "w"});
    frames(3);
    point_at({340.0F, 400.0F});
    const auto flown_m = [&] {
        return glm::distance(model().view().camera.position_m, before.position_m);
    };
    frames(10);
    for (int i = 0; i < 500 && flown_m() < 0.02F; ++i) frames(1);
    display_.tool({"xdotool", "keyup", "w", "mouseup", "1"});
    frames(2);
    const renderer::Camera& after = model().view().camera;
    EXPECT_GT(flown_m(), 0.01F);
    const auto ahead = [](const renderer::Camera& of) {
        return glm::normalize(of.target_m - of.position_m);
    };
    EXPECT_GT(glm::distance(ahead(after), ahead(before)), 0.01F);
}

TEST_F(ExplorerDriven, TheWayToWhereTheButtonIsPressedTurnsNothing) {
    ASSERT_TRUE(wait_for_images());
    point_at({300.0F, 400.0F});
    const renderer::Camera before = model().view().camera;
    display_.tool({"xdotool", "mousemove", "500", "300", "mousedown", "1"});
    frames(3);
    display_.tool({"xdotool", "mouseup", "1"});
    frames(3);
    EXPECT_EQ(model().view().camera.target_m, before.target_m);
}

TEST_F(ExplorerDriven, ThePanelsAreGoneThroughByKeysWithoutFlying) {
    ASSERT_TRUE(wait_for_images());
    point_at({300.0F, 400.0F});
    const renderer::Camera before = model().view().camera;
    key("F6");
    for (int i = 0; i < 5; ++i) key("Down");
    EXPECT_EQ(model().view().camera.position_m, before.position_m);
    EXPECT_EQ(model().view().camera.target_m, before.target_m);
    key("Escape");
    key("Down");
    EXPECT_NE(model().view().camera.target_m, before.target_m);
}

TEST_F(ExplorerDriven, PanelsLookTheSameWhileOneFlies) {
    ASSERT_TRUE(wait_for_images());
    point_at({300.0F, 400.0F});
    // What is above the error's panel, that changes.
    const auto panel = [this] {
        const stimuli::RgbImage screen = display_.screen();
        std::vector<std::uint8_t> seen;
        for (int y = 30; y < 300; ++y) {
            const auto row = screen.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * 1280);
            seen.insert(seen.end(), row + 3 * 920, row + 3 * 1280);
        }
        return seen;
    };
    // From a view without a name, that the panel would show.
    key("Right");
    frames(3);
    const auto standing = panel();
    display_.tool({"xdotool", "keydown", "Right"});
    frames(6);
    const auto flying = panel();
    display_.tool({"xdotool", "keyup", "Right"});
    // But for the rounding of what is drawn elsewhere.
    EXPECT_THAT(flying, testing::Pointwise(one_level_apart(), standing));
    frames(3);
    EXPECT_EQ(panel(), standing);
}

TEST_F(ExplorerDriven, WhatIsNoSceneIsSaidAndLosesNothing) {
    ASSERT_TRUE(wait_for_images());
    const auto scene = model().scene();
    base::write_file_atomically(folder_ / "zeros.glb", std::string(1 << 20, '\0'));
    base::write_file_atomically(folder_ / "picture.png", "no picture");
    // As large as they say, but with nothing on the disk.
    for (const char* name : {"vast.glb", "vast.gltf", "vast.obj", "vast.toml"}) {
        base::write_file_atomically(folder_ / name, "");
        fs::resize_file(folder_ / name, std::uintmax_t{4} << 30);
    }
    for (const char* name : {"zeros.glb", "picture.png", "gone.obj", "vast.glb", "vast.gltf",
                             "vast.obj", "vast.toml"}) {
        const std::size_t before = explorer_->state().messages.size();
        try {
            explorer_->open((folder_ / name).string());
        } catch (const std::exception&) {
            continue;
        }
        ASSERT_TRUE(wait_until([&] { return explorer_->state().messages.size() > before; }))
            << name;
        EXPECT_TRUE(explorer_->state().messages.back().problem);
        EXPECT_THAT(explorer_->state().messages.back().text, testing::HasSubstr(name));
        EXPECT_EQ(model().scene(), scene) << name;
    }
    // Deleted while it is opened, and cancelled.
    write_corner(folder_ / "brief.glb");
    explorer_->open((folder_ / "brief.glb").string());
    fs::remove(folder_ / "brief.glb");
    ASSERT_TRUE(wait_until([&] { return explorer_->at_rest(); }));
    ASSERT_TRUE(wait_for_images());
}

TEST_F(ExplorerDriven, NoRandomInputBreaksTheWindow) {
    ASSERT_TRUE(wait_for_images());
    const char* long_run = std::getenv("OBSCURA_MONKEY_EVENTS");
    const int events = long_run != nullptr ? std::atoi(long_run) : 1000;
    base::Random random(42);
    GLFWwindow* const handle = explorer_->window().handle();
    // The very callbacks that GLFW calls, the explorer's own and Dear ImGui's behind them.
    const GLFWkeyfun on_key = glfwSetKeyCallback(handle, nullptr);
    const GLFWmousebuttonfun on_button = glfwSetMouseButtonCallback(handle, nullptr);
    const GLFWscrollfun on_wheel = glfwSetScrollCallback(handle, nullptr);
    const GLFWcharfun on_character = glfwSetCharCallback(handle, nullptr);
    const GLFWdropfun on_drop = glfwSetDropCallback(handle, nullptr);
    glfwSetDropCallback(handle, on_drop);
    static constexpr std::array kKeys{GLFW_KEY_W,       GLFW_KEY_A,       GLFW_KEY_S,
                                      GLFW_KEY_D,       GLFW_KEY_Q,       GLFW_KEY_E,
                                      GLFW_KEY_F,       GLFW_KEY_C,       GLFW_KEY_V,
                                      GLFW_KEY_X,       GLFW_KEY_N,       GLFW_KEY_T,
                                      GLFW_KEY_Z,       GLFW_KEY_Y,       GLFW_KEY_F1,
                                      GLFW_KEY_F2,      GLFW_KEY_F6,      GLFW_KEY_TAB,
                                      GLFW_KEY_1,       GLFW_KEY_3,       GLFW_KEY_8,
                                      GLFW_KEY_0,       GLFW_KEY_LEFT,    GLFW_KEY_UP,
                                      GLFW_KEY_DOWN,    GLFW_KEY_ENTER,   GLFW_KEY_SPACE,
                                      GLFW_KEY_ESCAPE,  GLFW_KEY_HOME,    GLFW_KEY_EQUAL,
                                      GLFW_KEY_MINUS,   GLFW_KEY_PAGE_UP, GLFW_KEY_LEFT_CONTROL,
                                      GLFW_KEY_LEFT_ALT};
    base::write_file_atomically(folder_ / "zeros.glb", std::string(1 << 16, '\0'));
    const std::array dropped{(folder_ / "corner.glb").string(), (folder_ / "zeros.glb").string(),
                             (folder_ / "gone.obj").string()};
    int to_come = 0;
    for (int i = 0; i < events; ++i) {
        const int key = kKeys[random.below(kKeys.size())];
        switch (random.below(6)) {
            case 0:
            case 1:
                on_key(handle, key, 0, random.below(2) == 0 ? GLFW_PRESS : GLFW_RELEASE, 0);
                break;
            case 2:
                on_button(handle, static_cast<int>(random.below(3)),
                          random.below(2) == 0 ? GLFW_PRESS : GLFW_RELEASE, 0);
                break;
            case 3:
                on_wheel(handle, 0.0, random.uniform(-3.0, 3.0));
                break;
            case 4:
                on_character(handle, static_cast<unsigned>(random.below(0x250)));
                break;
            default:
                glfwSetCursorPos(handle, random.uniform(-50.0, 1330.0),
                                 random.uniform(-50.0, 850.0));
        }
        if (i % 100 == 50) {
            const bool least = i % 1000 == 950;
            glfwSetWindowSize(handle, least ? 1 : 1 + static_cast<int>(random.below(1280)),
                              least ? 1 : 1 + static_cast<int>(random.below(800)));
        }
        if (i % 250 == 100) {
            const char* path = dropped[random.below(dropped.size())].c_str();
            on_drop(handle, 1, &path);
        }
        // A slow frame has several.
        if (to_come-- > 0) continue;
        to_come = static_cast<int>(random.below(8));
        frames(1);
        ASSERT_EQ(model().layout(), model().layout().sane()) << i;
        ASSERT_TRUE(renderer::problems_of(model().choices().b).empty()) << i;
    }
}

TEST_F(ExplorerDriven, ADriverThatIsResetEndsTheWindowAndLosesNothing) {
    ASSERT_TRUE(wait_for_images());
    model().change([](Choices& to) { to.b.parameters["radius_m"] = 0.25; }, "", 0.0);
    model().look_from("far", ExplorerWindow::now_s());
    const renderer::Camera camera = model().view().camera;
    const renderer::Variant pair_b = model().choices().b;
    explorer_->window().lose();
    std::string said;
    try {
        frames(1);
    } catch (const base::Error& error) {
        EXPECT_EQ(error.code(), base::ExitCode::kFailed);
        said = error.what();
    }
    const fs::path kept = folder_ / "data" / "explore" / "kept.toml";
    EXPECT_THAT(said, testing::HasSubstr(kept.string()));
    ASSERT_TRUE(fs::exists(kept)) << said;
    explorer_.reset();
    // Where it names, it goes on.
    ExploreOptions options;
    options.what = kept.string();
    options.data = folder_ / "data";
    explorer_ = std::make_unique<Explorer>(options);
    ASSERT_TRUE(wait_for_images());
    EXPECT_EQ(model().view().camera.position_m, camera.position_m);
    EXPECT_EQ(model().view().camera.target_m, camera.target_m);
    EXPECT_EQ(model().choices().b, pair_b);
}

TEST_F(ExplorerDriven, AWindowOfOnePixelShowsNothingAndBreaksNothing) {
    ASSERT_TRUE(wait_for_images());
    glfwSetWindowSize(explorer_->window().handle(), 1, 1);
    frames(5);
    glfwSetWindowSize(explorer_->window().handle(), 1000, 700);
    frames(5);
    EXPECT_TRUE(wait_for_images());
}

}  // namespace
}  // namespace obscura::app::explorer
