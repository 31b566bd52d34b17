// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/model.h"
#include "app/explorer/cost_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <utility>

#include "app/explorer/flight.h"
#include "app/explorer/pixel_text.h"
#include "renderer/base/random.h"
#include "tests/app/explorer/made_model.h"

namespace obscura::app::explorer {
namespace {

/// Answers all that is asked for until nothing is, a second at a time from `now_s`.
double settled(Model& model, double now_s) {
    while (const auto wanted = model.next_request(now_s, false)) {
        answer(model, wanted->request, now_s);
        now_s += 1.0;
    }
    return now_s;
}

TEST(ExplorerModel, AnImageInMotionComesFirstThenAStillOneThenAFineOne) {
    Model model = made_model();
    model.change([](Choices& to) { to.supersampling = 2; }, "", 0.0);
    auto wanted = model.next_request(0.0, false);
    ASSERT_TRUE(wanted);
    EXPECT_EQ(wanted->request.quality, Quality::kMoving);
    answer(model, wanted->request, 0.05);
    EXPECT_FALSE(model.next_request(0.1, false)) << "it has not stood still for long enough";
    wanted = model.next_request(0.3, false);
    ASSERT_TRUE(wanted);
    EXPECT_EQ(wanted->request.quality, Quality::kStill);
    EXPECT_EQ(wanted->request.divisor, 1);
    EXPECT_TRUE(wanted->request.buffers);
    answer(model, wanted->request, 0.4);
    EXPECT_FALSE(model.next_truth(0.5)) << "the images come first";
    wanted = model.next_request(1.0, false);
    ASSERT_TRUE(wanted);
    EXPECT_EQ(wanted->request.quality, Quality::kFine);
    answer(model, wanted->request, 1.1);
    EXPECT_FALSE(model.next_request(5.0, false));
    const auto truth = model.next_truth(5.0);
    ASSERT_TRUE(truth);
    EXPECT_EQ(truth->width, 64);
    EXPECT_FALSE(model.next_truth(6.0)) << "asked for once";
}

TEST(ExplorerModel, MovingStopsAStillImageButNotAnImageInMotion) {
    Model model = made_model();
    answer(model, model.next_request(0.0, false)->request, 0.0);
    auto wanted = model.next_request(1.0, false);
    ASSERT_EQ(wanted->request.quality, Quality::kStill);
    model.look_from(flown(model.view().camera, {0.1F, 0.0F, 0.0F}), 1.1);
    wanted = model.next_request(1.1, true);
    ASSERT_TRUE(wanted);
    EXPECT_TRUE(wanted->stop);
    EXPECT_EQ(wanted->request.quality, Quality::kMoving);
    model.look_from(flown(model.view().camera, {0.1F, 0.0F, 0.0F}), 1.2);
    EXPECT_FALSE(model.next_request(1.2, true)) << "the one under way is let finish";
    wanted = model.next_request(9.0, true);
    ASSERT_TRUE(wanted) << "but not for ever";
    EXPECT_TRUE(wanted->stop);
}

TEST(ExplorerModel, ABetterImageTakesThePlaceOfAWorseOneOnly) {
    Model model = made_model();
    const auto moving = model.next_request(0.0, false);
    answer(model, moving->request, 0.0);
    answer(model, model.next_request(1.0, false)->request, 1.0);
    EXPECT_EQ(model.image('a')->quality, Quality::kStill);
    model.rendered(made_shot(moving->request, 'a'), 1.1);
    EXPECT_EQ(model.image('a')->quality, Quality::kStill) << "a late one changes nothing";
    ASSERT_TRUE(model.buffers('b'));
    model.look_from("side", 2.0);
    EXPECT_FALSE(model.buffers('b')) << "they are of another view";
    EXPECT_TRUE(model.image('b')) << "the last image stands until there is a new one";
}

TEST(ExplorerModel, EveryChangeOfChoicesCanBeUndoneAndRedone) {
    Model model = made_model();
    const Choices first = model.choices();
    model.change([](Choices& to) { to.b.samples = 8; }, "b samples", 1.0);
    model.change([](Choices& to) { to.b.samples = 16; }, "b samples", 1.1);
    model.settle();
    model.change([](Choices& to) { to.b.parameters["radius_m"] = 0.25; }, "b radius_m", 2.0);
    const Choices last = model.choices();
    model.undo(3.0);
    EXPECT_EQ(model.choices().b.samples, 16);
    EXPECT_FALSE(model.choices().b.parameters.contains("radius_m"));
    model.undo(3.0);
    EXPECT_EQ(model.choices(), first);
    model.redo(3.0);
    model.redo(3.0);
    EXPECT_EQ(model.choices(), last);
}

TEST(ExplorerModel, NothingThatCannotBeRenderedIsEverChosen) {
    Model model = made_model();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto change = [&](const std::function<void(Choices&)>& edit) {
        model.change(edit, "", 1.0);
        EXPECT_TRUE(renderer::problems_of(model.choices().a).empty());
        EXPECT_TRUE(renderer::problems_of(model.choices().b).empty());
    };
    change([](Choices& to) { to.b.technique = "no such"; });
    EXPECT_EQ(model.choices().b.technique, "blizzard");
    change([&](Choices& to) { to.b.parameters["radius_m"] = nan; });
    change([](Choices& to) { to.b.parameters["radius_m"] = 1e30; });
    change([](Choices& to) { to.b.samples = -7; });
    change([](Choices& to) { to.b.denoise = "mud"; });
    change([](Choices& to) { to.width = 0; });
    EXPECT_EQ(model.choices().width, 1);
    change([](Choices& to) { to.height = 1 << 30; });
    change([](Choices& to) { to.supersampling = 99; });
    EXPECT_LE(model.choices().height * model.choices().supersampling, kMostImageSide);
    change([](Choices& to) { to.scene.validity = stimuli::Validity::kHigh; });
    EXPECT_NE(model.choices().scene.validity, stimuli::Validity::kHigh) << "there is no such light";
    change([&](Choices& to) { to.scene.settings.exposure = static_cast<float>(nan); });
    EXPECT_FALSE(model.choices().scene.settings.exposure);
    change([&](Choices& to) { to.truth_radius_m = nan; });
    EXPECT_FALSE(model.choices().truth_radius_m);
}

TEST(ExplorerModel, VisitedViewsAreGoneThroughBackAndForward) {
    Model model = made_model();
    model.look_from("side", 1.0);
    model.look_from(flown(model.view().camera, {0.0F, 0.0F, 0.3F}), 2.0);
    const Visit own = model.view();
    model.visit();
    model.back(3.0);
    EXPECT_EQ(model.view().name, "side");
    model.back(4.0);
    EXPECT_EQ(model.view().name, "front");
    model.forward(5.0);
    model.forward(5.0);
    EXPECT_EQ(model.view(), own);
}

TEST(ExplorerModel, TheCamerasAreTheScenesAndThoseThatTheStudyHasOfIt) {
    Model model = made_model();
    OpenStudy open;
    renderer::Camera own = model.view().camera;
    own.position_m = {0.0F, 0.5F, 3.0F};
    stimuli::StudyScene seen;
    seen.id = "seen";
    seen.source = "wall";
    seen.settings.camera = own;
    stimuli::StudyScene elsewhere = seen;
    elsewhere.id = "elsewhere";
    elsewhere.source = "another";
    stimuli::StudyScene plain = seen;
    plain.id = "plain";
    plain.settings.camera.reset();
    open.study.scenes = {seen, elsewhere, plain};
    model.set_study(open);
    const auto cameras = model.cameras();
    ASSERT_EQ(cameras.size(), 3U);
    EXPECT_EQ(cameras[1].name, "side");
    EXPECT_EQ(cameras[2].name, "study: seen");
    model.look_from("study: seen", 1.0);
    EXPECT_TRUE(same_view(model.view().camera, own));
    EXPECT_EQ(model.view().name, "") << "the scene knows no camera of that name";
    model.look_from("side", 2.0);
    EXPECT_EQ(model.view().name, "side");
}

TEST(ExplorerModel, UndoingAnotherSceneAsksForTheOneBefore) {
    Model model = made_model();
    model.opened({made_choices("floor"), "", false, made_wall(), ""}, 1.0);
    EXPECT_FALSE(model.take_wanted_scene());
    model.undo(2.0);
    EXPECT_FALSE(model.next_request(2.0, false)) << "not with the wrong scene's triangles";
    const auto wanted = model.take_wanted_scene();
    ASSERT_TRUE(wanted);
    EXPECT_EQ(wanted->scene.source, "wall");
    EXPECT_FALSE(model.take_wanted_scene()) << "asked once";
}

TEST(ExplorerModel, ASceneThatCannotBeOpenedLeavesTheOneThatIsShown) {
    Model model = made_model();
    const auto scene = model.scene();
    model.opened({made_choices("broken.glb"), "", false, nullptr, "is broken"}, 1.0);
    EXPECT_EQ(model.scene(), scene);
    EXPECT_EQ(model.choices().scene.source, "wall");
}

TEST(ExplorerModel, TheTruthIsTracedAnewForAnotherViewAndNotForAnotherTechnique) {
    Model model = made_model();
    double now_s = settled(model, 0.0);
    ASSERT_TRUE(model.next_truth(now_s));
    model.change([](Choices& to) { to.b.samples = 8; }, "", now_s);
    EXPECT_TRUE(model.truth_waits(now_s, false)) << "something moves";
    now_s = settled(model, now_s);
    EXPECT_FALSE(model.next_truth(now_s + 1.0));
    model.change([](Choices& to) { to.b.parameters["radius_m"] = 0.77; }, "", now_s);
    now_s = settled(model, now_s + 1.0);
    const auto again = model.next_truth(now_s + 1.0);
    ASSERT_TRUE(again) << "R is B's";
    EXPECT_EQ(again->radius_m, 0.77);
}

TEST(ExplorerModel, CostsAreMediansOfTheImagesOfOneSetting) {
    Model model = made_model();
    answer(model, model.next_request(0.0, false)->request, 0.0);
    const auto still = model.next_request(1.0, false);
    for (const double ms : {5.0, 1.0, 3.0}) {
        Shot shot = made_shot(still->request, 'a');
        shot.times[0].milliseconds = ms;
        model.rendered(std::move(shot), 1.0);
    }
    ASSERT_EQ(model.costs('a').size(), 1U);
    EXPECT_EQ(model.costs('a')[0].median_ms, 3.0);
    EXPECT_EQ(model.costs('a')[0].history_ms.size(), 3U);
    model.time_again(2);
    EXPECT_EQ(model.next_request(2.0, false)->request.quality, Quality::kStill);
    EXPECT_TRUE(model.next_request(2.0, false));
    EXPECT_FALSE(model.next_request(2.0, false));
}

TEST(ExplorerModel, TheCostAsTextHasEveryPassBufferAndOmission) {
    Model model = made_model();
    answer(model, model.next_request(0.0, false)->request, 0.0);
    Shot shot = made_shot(model.next_request(1.0, false)->request, 'a');
    renderer::PlannedTarget target;
    target.name = "depth chain";
    target.format = "r32f";
    target.width = 640;
    target.height = 360;
    target.levels = 5;
    target.bytes = 1'227'600;
    shot.buffers_planned = {target};
    shot.bytes = target.bytes;
    shot.left_out = {{"shadow", "the scene has no directional light"}};
    model.rendered(std::move(shot), 1.0);
    const std::string text = cost_text(model, "a card");
    for (const char* part : {"a card", "geometry", "depth chain", "1227600 bytes",
                             "r32f 640x360, 5 levels", "without shadow: the scene has no"}) {
        EXPECT_THAT(text, testing::HasSubstr(part));
    }
}

/// Random events, some of them with numbers that are none.
class Monkey {
  public:
    explicit Monkey(std::uint64_t seed) : random_(seed) {}

    [[nodiscard]] base::Random& random() { return random_; }

    void act(Model& model, double now_s) {
        using Deed = void (Monkey::*)(Model&, double);
        static constexpr std::array<Deed, 7> kDeeds{&Monkey::change_technique,
                                                    &Monkey::change_parameter,
                                                    &Monkey::change_image,
                                                    &Monkey::go_through_time,
                                                    &Monkey::fly,
                                                    &Monkey::change_layout,
                                                    &Monkey::open};
        (this->*kDeeds[random_.below(kDeeds.size())])(model, now_s);
    }

  private:
    [[nodiscard]] double number() {
        switch (random_.below(10)) {
            case 0:
                return std::numeric_limits<double>::quiet_NaN();
            case 1:
                return std::numeric_limits<double>::infinity();
            case 2:
                return random_.uniform(-1e12, 1e12);
            default:
                return random_.uniform(-2.0, 2.0);
        }
    }
    [[nodiscard]] float small() { return static_cast<float>(number()); }
    [[nodiscard]] int count() { return static_cast<int>(random_.below(150)) - 30; }
    [[nodiscard]] char side() { return random_.below(2) == 0 ? 'a' : 'b'; }

    void change_technique(Model& model, double now_s) {
        const auto& all = renderer::techniques();
        const char which = side();
        model.change(
            [&](Choices& to) {
                to.side(which) = switched_to(all[random_.below(all.size())], to.side(which));
            },
            "", now_s);
    }
    void change_parameter(Model& model, double now_s) {
        const char which = side();
        model.change(
            [&](Choices& to) {
                renderer::Variant& variant = to.side(which);
                variant.samples = count();
                const auto& all = renderer::find_technique(variant.technique)->parameters;
                if (!all.empty())
                    variant.parameters[all[random_.below(all.size())].name] = number();
            },
            "slider", now_s);
        if (random_.below(3) == 0) model.settle();
    }
    void change_image(Model& model, double now_s) {
        model.change(
            [&](Choices& to) {
                to.width = count();
                to.height = count();
                to.supersampling = count();
                to.truth_radius_m = number();
                to.scene.settings.exposure = small();
            },
            "", now_s);
        model.time_again(static_cast<int>(random_.below(4)));
    }
    void go_through_time(Model& model, double now_s) {
        const std::uint64_t way = random_.below(5);
        if (way == 0) model.undo(now_s);
        if (way == 1) model.redo(now_s);
        if (way == 2) model.back(now_s);
        if (way == 3) model.forward(now_s);
        if (way == 4) model.visit();
    }
    void fly(Model& model, double now_s) {
        const renderer::Camera& camera = model.view().camera;
        const glm::vec3 by{small(), small(), small()};
        model.look_from(
            random_.below(2) == 0 ? flown(camera, by) : orbited(camera, by, small(), small()),
            now_s);
    }
    void change_layout(Model& model, double now_s) {
        Layout layout = model.layout();
        layout.arrangement = kArrangements[random_.below(kArrangements.size())];
        layout.zoom = small();
        layout.middle = {small(), small()};
        layout.panes[random_.below(4)] = {side(), layer::kAll[random_.below(layer::kAll.size())]};
        model.set_layout(layout, now_s);
        model.set_region(Region{count(), count(), count(), count()});
    }
    void open(Model& model, double now_s) {
        if (random_.below(4) != 0) return;
        auto scene = random_.below(4) == 0 ? nullptr : made_wall();
        model.opened({made_choices(random_.below(2) == 0 ? "wall" : "floor"), "",
                      random_.below(2) == 0, std::move(scene), "broken"},
                     now_s);
    }

    base::Random random_;
};

TEST(ExplorerModel, NoSequenceOfEventsBreaksIt) {
    Monkey monkey(20261126);
    Model model = made_model();
    double now_s = 0.0;
    std::optional<ShotRequest> under_way;
    int images = 0;
    for (int i = 0; i < 4000; ++i) {
        now_s += monkey.random().below(2) == 0 ? 0.01 : 0.4;
        monkey.act(model, now_s);
        if (auto wanted = model.take_wanted_scene()) {
            model.opened({*wanted, "", true, made_wall(), ""}, now_s);
        }
        if (auto wanted = model.next_request(now_s, under_way.has_value())) {
            under_way = std::move(wanted->request);
        }
        if (under_way && monkey.random().below(2) == 0) {
            answer(model, *under_way, now_s);
            under_way.reset();
            ++images;
        }
        if (const auto wanted = model.next_truth(now_s)) {
            model.set_truth(std::make_shared<Truth>(wanted->width, wanted->height));
        }
        const Choices& choices = model.choices();
        ASSERT_TRUE(renderer::problems_of(choices.a).empty()) << i;
        ASSERT_TRUE(renderer::problems_of(choices.b).empty()) << i;
        ASSERT_GE(choices.width, 1);
        ASSERT_LE(choices.width * choices.supersampling, kMostImageSide);
        ASSERT_EQ(model.layout(), model.layout().sane());
        (void)pixel_text(model, {static_cast<float>(monkey.random().uniform(-50.0, 350.0)), 3.0F});
        (void)model.costs('a');
    }
    EXPECT_GT(images, 200);
}

}  // namespace
}  // namespace obscura::app::explorer
