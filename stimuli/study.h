// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/frame/plan.h"
#include "renderer/import/import.h"
#include "renderer/technique/technique.h"
#include "stimuli/hypothesis.h"
#include "stimuli/order/order.h"
#include "stimuli/participant_form.h"
#include "stimuli/presentation.h"
#include "stimuli/scenes/scene_settings.h"
#include "stimuli/scenes/validity.h"
#include "stimuli/words.h"

namespace obscura::stimuli {

/// A scene as a study uses it.
struct StudyScene {
    std::string id;
    std::string source;  ///< a built-in scene, or a glTF or OBJ file relative to the study's
    std::string camera;  ///< kStudyCamera: the one in `settings`
    Validity validity = Validity::kLow;
    SceneSettings settings = {};
    std::vector<renderer::ImportedFile> files = {};  ///< that the source and its light consist of
    std::vector<std::string> notes = {};  ///< what of the source is not shown, or replaced
};

/// What a camera is called that the study file describes itself.
inline constexpr std::string_view kStudyCamera = "study";

/// Whether the files that a study's scenes are made of are looked into.
enum class SceneFiles {
    kOpened,  ///< each is read, and what is wrong with it is a problem of the study
    kTrusted  ///< none is: enough to show images that were made before
};

/// One stimulus pair.
struct Condition {
    std::string id;
    std::string scene;  ///< id of a StudyScene
    /// H1, H2, ...; may be empty. Where the study has hypotheses a label only: they say themselves
    /// which conditions they take.
    std::string hypothesis;
    renderer::Variant a;
    renderer::Variant b;
    char expected =
        '\0';  ///< 'A' or 'B': the side an attentive observer picks, of an attention check
    /// Condition that is shown again: scene, hypothesis and both sides are that one's; empty: none.
    std::string repeats;
    bool identical = false;  ///< its images are meant to be alike, to see what people answer then
    /// Shown before the pairs that count; with `expected` the participant is told whether the
    /// answer was the expected one.
    bool practice = false;

    /// Whether people vote on it: no practice, attention check, repeat, nor pair that is alike.
    [[nodiscard]] bool is_votable() const {
        return !practice && expected == '\0' && repeats.empty() && !identical;
    }
};

/// Whom a study leaves out, fixed before there are data. What is not given is not asked.
struct ExclusionRule {
    std::optional<double> min_catch_correct;     ///< share of attention checks as expected, 0 to 1
    std::optional<double> min_repeat_agreement;  ///< share of repeats answered alike, 0 to 1
    std::optional<double> min_response_time_s;   ///< median of the answers

    /// As a JSON object with the members' names; empty text where nothing is asked.
    [[nodiscard]] std::string to_json() const;
};

/// When a study looks at its answers, fixed before there are data.
struct StoppingRule {
    std::vector<int> looks;         ///< participants at each, rising; empty: it is not fixed
    std::string spending = "none";  ///< one of kSpendings; none for one look only
};

/// How the level may be shared out over looks.
inline constexpr std::array kSpendings{"none", "obrien-fleming", "pocock"};

/// A text of a study file that a participant may read.
struct ShownText {
    std::string key;  ///< where it is in the file: study: question
    int line = 0;     ///< of the file, from 1
    std::string text;
};

/// All that a study file says, checked.
struct Study {
    std::string name;
    std::string title;
    std::string question;
    std::string instructions;
    std::string thanks;       ///< text of the last page; empty: the kiosk's own
    Words words;              ///< the kiosk's own, in the study's language and as it replaces them
    std::string information;  ///< page before all others; empty: none
    std::optional<Consent> consent;  ///< on a page of its own; nothing: a tick on the form
    std::vector<FormField> form;     ///< instead of the kiosk's own questions; empty: those
    int width = 1280;
    int height = 720;
    int supersampling = 1;  ///< samples of surfaces and light along each side of a pixel
    /// Blended surfaces at least this opaque are seen by the techniques; nothing: none are.
    std::optional<float> occluding_opacity;
    /// The second image of each pair (b) is made as bright as the first by an exposure.
    bool match_luminance = false;
    Presentation presentation;
    OrderKind order = OrderKind::kLatinSquare;
    SideOrder sides = SideOrder::kSession;
    std::uint64_t seed = 0;
    std::vector<StudyScene> scenes;
    std::vector<Condition> conditions;   ///< those of practice last
    std::vector<Hypothesis> hypotheses;  ///< the family; empty: the labels of the conditions are it
    ExclusionRule exclusion;
    StoppingRule stopping;
    std::vector<ShownText> shown_texts;  ///< all that it gives
    std::string sha256;                  ///< of the file's bytes
    std::filesystem::path folder;        ///< of the file; what its paths are relative to

    [[nodiscard]] const StudyScene& scene_of(const Condition& condition) const;
    /// The pairs that a session is complete with: all but practice.
    [[nodiscard]] int pair_count() const;
    /// Whether one button leads to the next pair, instead of a list.
    [[nodiscard]] bool has_next_button() const;
    /// How every image of the study is rendered, whoever asks for it.
    [[nodiscard]] renderer::FrameOptions frame_options() const;
    /// What the participant of that slot sees.
    [[nodiscard]] SessionOrder session_order(std::uint64_t slot) const;
    /// What the study fixes before it has data, but the rule of exclusion, as a JSON object:
    /// `hypotheses` with the members of Hypothesis, `stopping` with those of StoppingRule, and
    /// `sides` where they are of a trial. Empty text where it fixes nothing.
    [[nodiscard]] std::string plan_json() const;
    /// The condition of that id, or nullptr.
    [[nodiscard]] const Condition* find_condition(std::string_view id) const;
};

/// Something wrong with a study file.
struct StudyProblem {
    int line = 0;              ///< from 1; 0 where the whole file is meant
    std::string message;       ///< key, value met, what is allowed
    std::string where = {};    ///< the part of the file, as the message begins
    std::string mistake = {};  ///< the same wherever the same was written; empty: said each time
};

/// Everything wrong with the text of a study file, ordered by line; empty when it can be run.
/// `folder` is what the paths in it are relative to.
[[nodiscard]] std::vector<StudyProblem> problems_of_study(std::string_view text,
                                                          const std::filesystem::path& folder = {});

/// The text of a study file, how messages call it, and the folder its paths are relative to.
struct StudySource {
    std::string name;
    std::string text;
    std::filesystem::path folder = {};
};

/// The text of the file, or of the built-in study of that name (`jakobsen2010`, also for ""). A
/// built-in name wins over a file of the same name; write ./jakobsen2010 for the file. Throws bad
/// input for neither, naming the built-in studies.
[[nodiscard]] StudySource study_source(const std::string& file_or_name);

/// The problems as messages show them, one line each: `name:line: message`.
[[nodiscard]] std::string to_lines(const std::vector<StudyProblem>& problems,
                                   const std::string& name);

/// Parses and checks. `name` stands for the text in messages. Throws bad input that lists every
/// problem as `name:line: message`.
[[nodiscard]] Study parse_study(std::string_view text, const std::string& name,
                                const std::filesystem::path& folder = {},
                                SceneFiles files = SceneFiles::kOpened);

/// parse_study of study_source.
[[nodiscard]] Study load_study(const std::string& file_or_name,
                               SceneFiles files = SceneFiles::kOpened);

}  // namespace obscura::stimuli
