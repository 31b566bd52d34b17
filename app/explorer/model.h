// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/explorer/choices.h"
#include "app/explorer/comparison.h"
#include "app/explorer/history.h"
#include "app/explorer/layout.h"
#include "app/explorer/opener.h"
#include "app/explorer/pacer.h"
#include "app/explorer/shot.h"
#include "app/explorer/truth_worker.h"

namespace obscura::app::explorer {

/// A study that is open beside the scene.
struct OpenStudy {
    std::string name;            ///< as it was asked for: a file, or a built-in study's
    std::filesystem::path file;  ///< empty: built in
    std::string text_sha256;     ///< of the file as it was read
    stimuli::Study study;
};

/// Where one looked from.
struct Visit {
    renderer::Camera camera;
    std::string name;  ///< the scene's camera that it is; empty: one's own
    [[nodiscard]] bool operator==(const Visit& other) const;
};

/// What the explorer shows, is to show and is computing, without window, clock or threads. Times
/// are seconds of any one clock that does not go back.
class Model {
  public:
    /// `software`: images are drawn smaller while something moves, where they must.
    explicit Model(Choices first, bool software = true);

    // What is shown.
    [[nodiscard]] const Choices& choices() const { return history_.now(); }
    [[nodiscard]] const std::shared_ptr<LoadedScene>& scene() const { return scene_; }
    [[nodiscard]] const Visit& view() const { return view_; }
    [[nodiscard]] float aspect() const;
    [[nodiscard]] const Layout& layout() const { return layout_; }
    [[nodiscard]] const std::optional<Region>& region() const { return region_; }
    [[nodiscard]] const std::optional<OpenStudy>& study() const { return study_; }

    // Choices. Each is one step of undo; those that follow under one name are one together.
    void change(const std::function<void(Choices&)>& edit, const std::string& name, double now_s);
    /// A change that goes on (a slider) has ended.
    void settle() { history_.settle(); }
    void undo(double now_s);
    void redo(double now_s);
    [[nodiscard]] bool can_undo() const { return history_.can_go_back(); }
    [[nodiscard]] bool can_redo() const { return history_.can_go_forward(); }

    // Where one looks from.
    void look_from(const renderer::Camera& camera, double now_s);
    /// One of `cameras`; unknown names are ignored.
    void look_from(const std::string& camera_name, double now_s);
    struct NamedCamera {
        std::string name;  ///< for people
        renderer::Camera camera;
        bool of_scene = true;  ///< else the open study describes it, and the scene knows none such
    };
    /// The scene's own, then those that the open study has of it.
    [[nodiscard]] std::vector<NamedCamera> cameras() const;
    /// Remembers the view as one that was visited, where it is another than the last.
    void visit();
    void back(double now_s);
    void forward(double now_s);
    [[nodiscard]] bool can_go_back() const { return visits_.can_go_back(); }
    [[nodiscard]] bool can_go_forward() const { return visits_.can_go_forward(); }

    void set_layout(const Layout& layout, double now_s);
    void set_region(const std::optional<Region>& region);
    void set_study(std::optional<OpenStudy> study) { study_ = std::move(study); }
    void set_software(bool software);

    // Scenes.
    /// What has to be opened because undo went back to it; asked once.
    [[nodiscard]] std::optional<Choices> take_wanted_scene();
    /// A scene is open: it is shown with the choices that it was opened for.
    void opened(Opened opening, double now_s);

    // Images.
    /// The next image to render, if any; `stop` says that what is under way is of no use any more.
    struct Wanted {
        ShotRequest request;
        bool stop = false;
    };
    [[nodiscard]] std::optional<Wanted> next_request(double now_s, bool busy);
    void rendered(Shot shot, double now_s);
    /// The best image of a side there is, of this look or else of the last one; may be nothing.
    [[nodiscard]] std::shared_ptr<const Shot> image(char side) const;
    /// The same with buffers, of this look only.
    [[nodiscard]] std::shared_ptr<const Shot> buffers(char side) const;
    /// Median milliseconds of each pass over the images of this variant and size so far.
    struct PassCost {
        std::string name;
        double median_ms = 0.0;
        std::vector<float> history_ms;  ///< the latest last
    };
    [[nodiscard]] std::vector<PassCost> costs(char side) const;
    /// Renders the still images so many times more, to time them.
    void time_again(int times) { timings_left_ = times; }
    [[nodiscard]] int timings_left() const { return timings_left_; }

    // The truth.
    /// Another truth than before is wanted: the one that is being traced is of no use any more.
    [[nodiscard]] std::optional<TruthRequest> next_truth(double now_s);
    /// Whether tracing has to make room: something moves, or images are due.
    [[nodiscard]] bool truth_waits(double now_s, bool rendering) const;
    void set_truth(std::shared_ptr<const Truth> truth) { truth_ = std::move(truth); }
    [[nodiscard]] const std::shared_ptr<const Truth>& truth() const { return truth_; }
    [[nodiscard]] std::uint64_t truth_look() const { return truth_look_; }

    /// Whether something moved lately.
    [[nodiscard]] bool moving(double now_s) const { return now_s - changed_s_ < kStill_s; }
    /// 1, 2 or 4: width and height of what is drawn while something moves are divided by it.
    [[nodiscard]] int divisor() const { return pacer().divisor(); }
    [[nodiscard]] std::uint64_t look() const { return look_; }
    /// How good its images get while it stands.
    [[nodiscard]] Quality finest() const;

    static constexpr double kStill_s = 0.15;
    static constexpr double kFine_s = 0.6;

  private:
    enum class Motion { kCamera, kSettings };
    /// Something else is to be seen.
    void moved(Motion motion, double now_s);
    [[nodiscard]] std::string visible_sides() const;
    [[nodiscard]] bool shows_buffers() const;
    [[nodiscard]] ShotRequest request_of(Quality quality, int divisor) const;
    [[nodiscard]] const Pacer& pacer() const { return pacers_[static_cast<std::size_t>(motion_)]; }
    [[nodiscard]] Pacer& pacer() { return pacers_[static_cast<std::size_t>(motion_)]; }
    void note_cost(const Shot& shot);
    [[nodiscard]] std::string truth_key() const;

    History<Choices> history_;
    std::shared_ptr<LoadedScene> scene_;
    Choices loaded_;  ///< what scene_ was opened for
    bool wants_scene_ = false;
    Visit view_;
    History<Visit> visits_{Visit{}};
    Layout layout_;
    std::optional<Region> region_;
    std::optional<OpenStudy> study_;

    Motion motion_ = Motion::kCamera;
    std::array<Pacer, 2> pacers_;
    std::uint64_t look_ = 1;
    double changed_s_ = -1e9;
    std::array<std::uint64_t, 3> asked_{};  ///< the look that was last asked for, by Quality
    Quality asked_last_ = Quality::kMoving;
    double asked_s_ = 0.0;
    std::string moving_sides_;  ///< of the last request in motion that are not there yet
    double moving_ms_ = 0.0;    ///< that those there took
    int timings_left_ = 0;
    std::map<char, std::shared_ptr<const Shot>> image_;
    std::map<char, std::shared_ptr<const Shot>> buffers_;
    std::map<char, std::vector<std::vector<renderer::PassTime>>> times_;
    std::map<char, std::string> times_of_;  ///< the variant and size that times_ are of

    std::shared_ptr<const Truth> truth_;
    std::uint64_t truth_look_ = 0;  ///< of the truth that is wanted
    std::string truth_key_;         ///< what it is of
};

}  // namespace obscura::app::explorer
