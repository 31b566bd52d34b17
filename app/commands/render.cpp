// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <charconv>
#include <memory>

#include "app/commands/list.h"
#include "app/commands/variants_help.h"
#include "renderer/base/log.h"
#include "stimuli/generate.h"
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

base::ExitCode render(RenderOptions options, const Globals& globals) {
    const stimuli::Study study = stimuli::load_study(options.study);
    for (const std::string& warning : stimuli::warnings_of(study))
        base::log::warn("warning: {}", warning);
    if (!options.shard.empty()) parse_shard(options.shard, options.selection);
    const std::filesystem::path folder = options.out.empty()
                                             ? stimuli::stimuli_folder(globals.data, study)
                                             : std::filesystem::path(options.out);
    if (options.explain) {
        fmt::print("{}", stimuli::explain(study, options.selection, globals.quiet));
        return base::ExitCode::kDone;
    }
    if (options.verify) return verify(study, options, folder, globals.quiet);
    const stimuli::Generated generated =
        stimuli::generate(study, options.selection, folder, globals.quiet);
    for (const std::string& warning : generated.warnings) base::log::warn("warning: {}", warning);
    base::log::info("{}: {} images made, {} kept; {}\n", folder.string(), generated.made,
                    generated.kept,
                    generated.complete ? "the study is complete" : "the study is not complete yet");
    return base::ExitCode::kDone;
}

}  // namespace

Command render_command() {
    return {
        "render", "Makes the stimulus images of a study and their manifest",
        [](const Options& app, const Globals& globals) -> std::function<base::ExitCode()> {
            const auto options = std::make_shared<RenderOptions>();
            app.add("STUDY", options->study,
                    "Study file or built-in study (default: jakobsen2010)");
            app.add("--out", options->out, "Folder of the images (default: DATA/stimuli/STUDY)");
            app.add("--pair", options->selection.pair, "Only this condition");
            app.add("--shard", options->shard,
                    "K/N: only part K of N, so that N jobs share the work");
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
