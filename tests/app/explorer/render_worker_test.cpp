// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/explorer/render_worker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "renderer/base/error.h"
#include "tests/app/explorer/made_model.h"

namespace obscura::app::explorer {
namespace {

/// What drivers do, and how often they were asked.
struct Drivers {
    std::atomic<int> resets = 0;      ///< so many images are still to be lost
    std::atomic<int> missing = 0;     ///< so many times there is still none
    std::atomic<int> good_first = 0;  ///< before the next is lost
    std::atomic<int> opened = 0;
    std::atomic<int> got_ready = 0;  ///< to move
};

class MadeStudio : public Studio {
  public:
    explicit MadeStudio(Drivers& drivers) : drivers_(drivers) {
        ++drivers.opened;
        if (drivers.missing > 0) {
            --drivers.missing;
            throw base::failure("no driver");
        }
    }
    [[nodiscard]] std::string device() const override { return "made"; }
    [[nodiscard]] bool software() const override { return true; }
    [[nodiscard]] Shot take(const ShotRequest& request, char side,
                            const std::function<bool()>& /*wanted*/) override {
        if (drivers_.good_first > 0) {
            --drivers_.good_first;
        } else if (drivers_.resets > 0) {
            --drivers_.resets;
            throw base::failure("rendering failed: OpenGL error 0x507");
        }
        return made_shot(request, side);
    }
    void get_ready_to_move(const ShotRequest& /*request*/,
                           const std::function<bool()>& /*wanted*/) override {
        ++drivers_.got_ready;
    }

  private:
    Drivers& drivers_;
};

/// A worker whose driver is reset when a test says so.
class RenderWorkerLost : public testing::Test {
  protected:
    void ask(Quality quality) {
        ShotRequest request;
        request.look = ++look_;
        request.quality = quality;
        request.choices = made_choices("wall");
        request.sides = "ab";
        worker_.ask(std::move(request), false);
    }
    /// All that it says until it has nothing to do.
    [[nodiscard]] RenderAnswers answers() {
        RenderAnswers all;
        while (true) {
            const bool busy = worker_.busy();
            RenderAnswers some = worker_.take();
            if (some.shots.size() == 1) ++alone_;
            std::move(some.shots.begin(), some.shots.end(), std::back_inserter(all.shots));
            std::move(some.problems.begin(), some.problems.end(), std::back_inserter(all.problems));
            if (!busy) return all;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    Drivers drivers_;
    std::uint64_t look_ = 0;
    int alone_ = 0;  ///< images that came without the other side's
    RenderWorker worker_{[] {}, [this] { return std::make_unique<MadeStudio>(drivers_); }};
};

TEST_F(RenderWorkerLost, WhatADriverWasResetAtIsMadeByANewOne) {
    drivers_.good_first = 1;  // lost at B
    drivers_.resets = 1;
    ask(Quality::kMoving);
    const RenderAnswers made = answers();
    ASSERT_EQ(made.shots.size(), 2U);
    EXPECT_EQ(made.shots[0].look, look_);
    EXPECT_THAT(made.problems, testing::ElementsAre(testing::HasSubstr("started anew")));
    EXPECT_EQ(drivers_.opened, 2);
    // And again, when all was well meanwhile.
    ask(Quality::kStill);
    EXPECT_EQ(answers().shots.size(), 2U);
    drivers_.resets = 1;
    ask(Quality::kStill);
    EXPECT_EQ(answers().shots.size(), 2U);
    EXPECT_EQ(drivers_.opened, 3);
}

TEST_F(RenderWorkerLost, AnImageThatResetsEveryDriverIsGivenUpAndTheNextOneIsMade) {
    drivers_.resets = 2;
    ask(Quality::kStill);
    const RenderAnswers lost = answers();
    EXPECT_TRUE(lost.shots.empty());
    EXPECT_THAT(lost.problems, testing::ElementsAre(testing::HasSubstr("started anew"),
                                                    testing::HasSubstr("cannot be rendered")));
    ask(Quality::kStill);
    const RenderAnswers made = answers();
    EXPECT_EQ(made.shots.size(), 2U);
    EXPECT_TRUE(made.problems.empty());
}

TEST_F(RenderWorkerLost, WithoutADriverEveryRequestSaysSoOnceAndOneThatComesIsTaken) {
    drivers_.resets = 1;
    drivers_.missing = 2;
    // The first driver may be there before `missing` is read: it is lost at once then.
    ask(Quality::kStill);
    RenderAnswers said = answers();
    for (int i = 0; i < 3 && said.shots.empty(); ++i) {
        EXPECT_FALSE(said.problems.empty());
        EXPECT_LE(said.problems.size(), 3U);
        ask(Quality::kStill);
        said = answers();
    }
    EXPECT_EQ(said.shots.size(), 2U);
}

TEST_F(RenderWorkerLost, AfterImagesAtRestItGetsReadyForThoseInMotion) {
    ask(Quality::kMoving);
    (void)answers();
    EXPECT_EQ(drivers_.got_ready, 0);
    ask(Quality::kStill);
    EXPECT_EQ(answers().shots.size(), 2U);
    EXPECT_EQ(drivers_.got_ready, 1);
}

TEST_F(RenderWorkerLost, ImagesInMotionComeTogether) {
    for (int i = 0; i < 20; ++i) {
        ask(Quality::kMoving);
        EXPECT_EQ(answers().shots.size(), 2U);
    }
    EXPECT_EQ(alone_, 0);
}

}  // namespace
}  // namespace obscura::app::explorer
