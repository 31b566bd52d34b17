// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/list.h"
#include "app/commands/study_argument.h"
#include "app/commands/variants_help.h"
#include "renderer/base/log.h"
#include "stimuli/explain.h"
#include "stimuli/generate.h"
#include "stimuli/package/package.h"
#include "stimuli/study_warnings.h"

namespace obscura::app {
namespace {

struct RenderOptions {
    std::string study;
    std::string out;
    std::string shard;
    stimuli::Selection selection;
    bool verify = false;
    bool explain = false;
    bool json = false;
};

/// "K/N" as two whole numbers.
void parse_shard(const std::string& text, stimuli::Selection& selection) {
    const char* const end = text.data() + text.size();
    const auto [slash, first] = std::from_chars(text.data(), end, selection.shard);
    if (first == std::errc() && slash != end && *slash == '/') {
        const auto [rest, second] = std::from_chars(slash + 1, end, selection.shards);
        if (second == std::errc() && rest == end) return;
    }
    throw base::bad_input("--shard: \"{}\" is not K/N, such as 2/8", text);
}

base::ExitCode verify(const stimuli::Study& study, const RenderOptions& options,
                      const std::filesystem::path& folder, bool quiet) {
    const stimuli::Verified verified = stimuli::verify(study, options.selection, folder, quiet);
    for (const std::string& problem : verified.problems) fmt::print(stderr, "{}\n", problem);
    for (const std::string& warning : verified.warnings) base::log::warn("warning: {}", warning);
    if (!verified.problems.empty()) {
        throw base::check_failed("{} of {} images in {} do not hold", verified.problems.size(),
                                 verified.checked, folder.string());
    }
    base::log::info("{}: {} images checked, each is what this program renders", folder.string(),
                    verified.checked);
    return base::ExitCode::kDone;
}

/// How far the images of each pair are apart.
void print_pairs(const std::vector<stimuli::ManifestPair>& pairs) {
    std::size_t width = 0;
    for (const stimuli::ManifestPair& pair : pairs) width = std::max(width, pair.condition.size());
    for (const stimuli::ManifestPair& pair : pairs) {
        fmt::print("{:{}} {:6.2f} % of the pixels differ visibly, the most by {:.1f} in CIELAB\n",
                   pair.condition, width, 100.0 * pair.difference.over_threshold,
                   pair.difference.largest_delta_e);
    }
}

void print_made_as_json(const stimuli::Generated& generated, const std::filesystem::path& folder) {
    auto pairs = nlohmann::ordered_json::array();
    for (const stimuli::ManifestPair& pair : generated.pairs) {
        pairs.push_back({{"condition", pair.condition},
                         {"noticeable_share", pair.difference.over_threshold},
                         {"visible", pair.difference.visible},
                         {"largest_delta_e", pair.difference.largest_delta_e}});
    }
    const nlohmann::ordered_json json = {{"folder", folder.string()},      {"made", generated.made},
                                         {"copied", generated.copied},     {"kept", generated.kept},
                                         {"complete", generated.complete}, {"pairs", pairs},
                                         {"warnings", generated.warnings}};
    fmt::print("{}\n", json.dump(2));
}

base::ExitCode render(RenderOptions options, const Globals& globals) {
    if (stimuli::is_package(options.study) && options.out.empty() && !options.verify &&
        !options.explain) {
        throw base::bad_input(
            "STUDY: {} has its images; --verify compares them with this machine's, --out FOLDER "
            "makes others",
            options.study);
    }
    const stimuli::Study study = stimuli::load_study(study_named(options.study, globals));
    for (const std::string& warning : stimuli::warnings_of(study))
        base::log::warn("warning: {}", warning);
    if (!options.shard.empty()) parse_shard(options.shard, options.selection);
    const std::filesystem::path folder = options.out.empty()
                                             ? stimuli::stimuli_folder(globals.data, study)
                                             : std::filesystem::path(options.out);
    if (options.explain) {
        const auto& say = options.json ? stimuli::explain_json : stimuli::explain;
        fmt::print("{}", say(study, options.selection, globals.quiet, stimuli::builtin_scenes()));
        return base::ExitCode::kDone;
    }
    if (options.verify) return verify(study, options, folder, globals.quiet);
    const stimuli::Generated generated =
        stimuli::generate(study, options.selection, folder, globals.quiet);
    if (options.json) {
        print_made_as_json(generated, folder);
        return base::ExitCode::kDone;
    }
    print_pairs(generated.pairs);
    for (const std::string& warning : generated.warnings) base::log::warn("warning: {}", warning);
    base::log::info(
        "{}: {} images made{}, {} kept; {}", folder.string(), generated.made,
        generated.copied > 0 ? fmt::format(" ({} as copies of equal ones)", generated.copied) : "",
        generated.kept,
        generated.complete ? "the study is complete; next: obscura rehearse" +
                                 (options.study.empty() ? "" : " " + options.study)
                           : "the study is not complete yet");
    return base::ExitCode::kDone;
}

}  // namespace

Command render_command() {
    return {
        "render", "Make the stimulus images of a study and their manifest",
        [](const Options& app, const Globals& globals) -> std::function<base::ExitCode()> {
            const auto options = std::make_shared<RenderOptions>();
            add_study(app, options->study);
            app.add("--out", options->out, "Folder of the images (default: DATA/stimuli/STUDY)")
                .folder();
            app.add("--condition", options->selection.condition, "Only this condition").type("ID");
            app.add("--shard", options->shard, "Only part K of N, so that N jobs share the work")
                .type("K/N");
            app.add_flag("--json", options->json, "Print JSON");
            const Option verify_flag = app.add_flag(
                "--verify", options->verify,
                "Render in memory, write nothing, and name the files that differ (exit code 3)");
            app.add_flag("--explain", options->explain,
                         "Render in memory, write nothing, and print each image's passes (ms), "
                         "buffers (bytes) and what was left out; then what each would "
                         "cost if nothing were left out")
                .excludes({verify_flag});
            app.add_flag("--aov", options->selection.buffers,
                         "Also write CONDITION-a.exr and -b.exr: depth (m), view-space normal, "
                         "albedo, accessibility and light, with the camera's matrices")
                .excludes({verify_flag});
            app.footer(
                "A variant in a study file: { technique = NAME, samples = N, PARAMETER = NUMBER, "
                "denoise = FILTER, SETTING = \"WORD\" }\n" +
                variants_help());
            return [options, &globals] { return render(*options, globals); };
        }};
}

}  // namespace obscura::app
