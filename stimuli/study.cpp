// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/study.h"

#include <algorithm>
#include <cassert>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/nearest.h"
#include "stimuli/embedded.h"
#include "stimuli/study_reader.h"

namespace obscura::stimuli {
namespace {

constexpr std::string_view kDefaultStudy = "jakobsen2010";

std::string embedded_file_of(std::string_view study) {
    return fmt::format("studies/{}.toml", study);
}

std::string builtin_names() {
    std::string names;
    for (const std::string_view file : embedded_names()) {
        if (!file.starts_with("studies/")) continue;
        names += (names.empty() ? "" : ", ") + std::filesystem::path(file).stem().string();
    }
    return names;
}

}  // namespace

std::string ExclusionRule::to_json() const {
    nlohmann::ordered_json json;
    if (min_catch_correct) json["min_catch_correct"] = *min_catch_correct;
    if (min_repeat_agreement) json["min_repeat_agreement"] = *min_repeat_agreement;
    if (min_response_time_s) json["min_response_time_s"] = *min_response_time_s;
    return json.empty() ? "" : json.dump();
}

const StudyScene& Study::scene_of(const Condition& condition) const {
    const auto found = std::find_if(scenes.begin(), scenes.end(),
                                    [&](const auto& scene) { return scene.id == condition.scene; });
    assert(found != scenes.end());  // a checked study has every scene that it names
    return *found;
}

std::string Study::plan_json() const {
    nlohmann::ordered_json json;
    for (const Hypothesis& hypothesis : hypotheses) {
        const bool is_preference = hypothesis.kind == HypothesisKind::kPreference;
        nlohmann::ordered_json entry = {{"id", hypothesis.id},
                                        {"statement", hypothesis.statement},
                                        {"kind", to_string(hypothesis.kind)}};
        if (is_preference) {
            entry["conditions"] = hypothesis.conditions;
        } else {
            entry["pairs"] = hypothesis.pairs;
        }
        entry["margin"] = hypothesis.margin;
        entry["role"] = to_string(hypothesis.role);
        json["hypotheses"].push_back(std::move(entry));
    }
    if (!stopping.looks.empty()) {
        json["stopping"] = {{"looks", stopping.looks}, {"spending", stopping.spending}};
    }
    if (sides != SideOrder::kSession) json["sides"] = to_string(sides);
    return json.empty() ? "" : json.dump();
}

int Study::pair_count() const {
    return static_cast<int>(
        std::count_if(conditions.begin(), conditions.end(),
                      [](const Condition& condition) { return !condition.practice; }));
}

bool Study::has_next_button() const {
    const PairsPage usual = pair_count() > kMostListed ? PairsPage::kNext : PairsPage::kList;
    return presentation.pairs_page.value_or(usual) == PairsPage::kNext;
}

SessionOrder Study::session_order(std::uint64_t slot) const {
    return stimuli::session_order(order, pair_count(), seed, slot, sides);
}

renderer::FrameOptions Study::frame_options() const {
    return {.supersampling = supersampling, .occluding_opacity = occluding_opacity};
}

const Condition* Study::find_condition(std::string_view id) const {
    const auto found = std::find_if(conditions.begin(), conditions.end(),
                                    [&](const auto& condition) { return condition.id == id; });
    return found != conditions.end() ? &*found : nullptr;
}

std::vector<StudyProblem> problems_of_study(std::string_view text,
                                            const std::filesystem::path& folder) {
    return read_study(text, builtin_scenes(), folder).problems;
}

namespace {
/// Texts and conditions of thousands of pairs are a hundredth of this.
constexpr std::uintmax_t kMostStudyBytes = 64 << 20;

/// The study files and packages of the folder in which one is looked for, as a command line names
/// them.
std::vector<std::string> studies_beside(const std::filesystem::path& wanted) {
    const std::filesystem::path folder = wanted.parent_path();
    std::vector<std::string> found;
    std::error_code none;
    for (const auto& entry :
         std::filesystem::directory_iterator(folder.empty() ? "." : folder, none)) {
        const std::filesystem::path name = entry.path().filename();
        if (name.extension() != ".toml" && name.extension() != ".zip") continue;
        found.push_back((folder / name).string());
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace

StudySource study_source(const std::string& file_or_name) {
    const std::string wanted = file_or_name.empty() ? std::string(kDefaultStudy) : file_or_name;
    const std::string_view builtin = embedded(embedded_file_of(wanted));
    if (builtin.data() != nullptr) return {wanted, std::string(builtin), {}};
    std::error_code ignored;
    if (!std::filesystem::exists(wanted, ignored)) {
        throw base::bad_input(
            "there is no study file {} and no built-in study of that name; "
            "built in are {}{}",
            wanted, builtin_names(), base::did_you_mean(wanted, studies_beside(wanted)));
    }
    const std::uintmax_t bytes = std::filesystem::file_size(wanted, ignored);
    if (!ignored && bytes > kMostStudyBytes) {
        throw base::bad_input("{} has {} bytes; allowed are study files of at most {}", wanted,
                              bytes, kMostStudyBytes);
    }
    return {wanted, base::read_file(wanted), std::filesystem::path(wanted).parent_path()};
}

std::string to_lines(const std::vector<StudyProblem>& problems, const std::string& name) {
    std::string lines;
    for (const StudyProblem& problem : problems) {
        if (!lines.empty()) lines += '\n';
        lines += problem.line > 0 ? fmt::format("{}:{}: {}", name, problem.line, problem.message)
                                  : fmt::format("{}: {}", name, problem.message);
    }
    return lines;
}

Study parse_study(std::string_view text, const std::string& name,
                  const std::filesystem::path& folder, SceneFiles files) {
    StudyReading reading = read_study(text, builtin_scenes(), folder, files);
    if (!reading.problems.empty()) throw base::bad_input("{}", to_lines(reading.problems, name));
    return std::move(reading.study);
}

Study load_study(const std::string& file_or_name, SceneFiles files) {
    const StudySource source = study_source(file_or_name);
    return parse_study(source.text, source.name, source.folder, files);
}

}  // namespace obscura::stimuli
