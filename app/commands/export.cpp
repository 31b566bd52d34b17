// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>

#include "analysis/conclusions/exported_conclusions.h"
#include "analysis/store/store.h"
#include "app/commands/exported_study.h"
#include "app/commands/list.h"
#include "app/commands/store_argument.h"
#include "app/commands/study_argument.h"
#include "renderer/base/log.h"
#include "renderer/base/version.h"
#include "stimuli/study.h"

namespace obscura::app {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
    std::string db;  ///< empty: the data folder's
    fs::path out;
    std::string format = "csv";
    std::vector<std::string> studies;
    bool force = false;
    bool anonymous = false;
    std::optional<std::uint64_t> seed;
};

/// By the name of a study, the hashes of its file that sessions began with, and how many did.
using Hashes = std::map<std::string, std::map<std::string, std::size_t>>;

[[nodiscard]] std::string counted(std::size_t count, const char* thing) {
    return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

Hashes hashes_in(analysis::Store& store) {
    Hashes hashes;
    store.each_session([&](const analysis::SessionRecord& session) {
        ++hashes[session.study][session.study_sha256];
    });
    return hashes;
}

void warn_of_other_versions(const stimuli::Study& study,
                            const std::map<std::string, std::size_t>& hashes) {
    for (const auto& [sha256, sessions] : hashes) {
        if (sha256 == study.sha256) continue;
        base::log::warn("{} of study {} began with another version of its file (SHA-256 {})",
                        counted(sessions, "session"), study.name, sha256);
    }
}

/// A study given on the command line must be one that the sessions saw.
stimuli::Study require_seen(const std::string& option, const stimuli::StudySource& source,
                            const Hashes& hashes) {
    stimuli::Study study =
        stimuli::parse_study(source.text, source.name, {}, stimuli::SceneFiles::kTrusted);
    const auto met = hashes.find(study.name);
    if (met == hashes.end()) {
        std::vector<std::string> names;
        for (const auto& [name, ignored] : hashes) names.push_back(name);
        throw base::bad_input("STUDY: {}: the store has no session of study {}; it has {}", option,
                              study.name,
                              names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")));
    }
    if (!met->second.contains(study.sha256)) {
        throw base::bad_input(
            "STUDY: {}: its SHA-256 is {}, the sessions of study {} began with {}: it is another "
            "version of the file",
            option, study.sha256, study.name, met->second.begin()->first);
    }
    return study;
}

/// A built-in study of that name whose hash the sessions have; nothing where there is none.
std::optional<stimuli::StudySource> find_builtin(const std::string& name,
                                                 const std::map<std::string, std::size_t>& hashes) {
    try {
        stimuli::StudySource source = stimuli::study_source(name);
        if (hashes.contains(
                stimuli::parse_study(source.text, source.name, {}, stimuli::SceneFiles::kTrusted)
                    .sha256))
            return source;
    } catch (const base::Error&) {  // no such study, or one that has changed since
    }
    return std::nullopt;
}

std::vector<analysis::ExportedStudy> studies_of(const ExportOptions& options,
                                                const Globals& globals, const Hashes& hashes) {
    std::map<std::string, stimuli::StudySource> sources;
    for (const std::string& option : options.studies) {
        stimuli::StudySource source = stimuli::study_source(study_named(option, globals));
        const std::string name = require_seen(option, source, hashes).name;
        if (!sources.emplace(name, std::move(source)).second) {
            throw base::bad_input("STUDY: {}: study {} is given twice", option, name);
        }
    }
    std::vector<analysis::ExportedStudy> exported;
    for (const auto& [name, seen] : hashes) {
        if (!sources.contains(name)) {
            if (auto builtin = find_builtin(name, seen)) sources.emplace(name, std::move(*builtin));
        }
        const fs::path images = globals.data / "stimuli" / name;
        const auto source = sources.find(name);
        if (source == sources.end()) {
            base::log::warn(
                "the file of study {} is not at hand: name it behind the command to add it", name);
            exported.push_back(exported_study(name, images));
        } else {
            const auto study = stimuli::parse_study(source->second.text, source->second.name, {},
                                                    stimuli::SceneFiles::kTrusted);
            warn_of_other_versions(study, seen);
            exported.push_back(exported_study(source->second, study, images));
        }
        if (exported.back().manifest_text.empty()) {
            base::log::warn("study {}: its images are not added, for there is no {}", name,
                            (images / "manifest.json").string());
        }
    }
    return exported;
}

std::uint64_t seed_of(const ExportOptions& options) {
    if (options.seed) return *options.seed;
    std::random_device device;
    return (static_cast<std::uint64_t>(device()) << 32U | device()) >> 1U;
}

base::ExitCode export_answers(const ExportOptions& options, const Globals& globals) {
    if (options.seed && !options.anonymous) {
        throw base::bad_input("--seed {}: it needs --anonymous", *options.seed);
    }
    refuse_no_answers(options.db, globals);
    const std::string url = store_url_from(options.db, globals);
    analysis::Store store(url, analysis::Store::Access::kReadOnly);
    analysis::ExportOptions wanted;
    wanted.format = *analysis::export_format_from(options.format);
    wanted.folder = options.out;
    wanted.overwrite = options.force;
    wanted.software = base::program_version();
    wanted.studies = studies_of(options, globals, hashes_in(store));
    if (options.anonymous) {
        wanted.anonymous_seed = seed_of(options);
        base::log::info("numbered in an order of seed {}: whoever knows it can undo that",
                        *wanted.anonymous_seed);
    }
    analysis::Exported exported;
    store.of_one_moment([&] {
        for (const std::string& note : analysis::add_conclusions(wanted, store, url)) {
            base::log::warn("{}", note);
        }
        exported = analysis::export_store(store, wanted);
    });
    const bool has_manifest = std::any_of(
        wanted.studies.begin(), wanted.studies.end(),
        [](const analysis::ExportedStudy& study) { return !study.manifest_text.empty(); });
    if (has_manifest && exported.unknown_images > 0) {
        base::log::warn("{} showed an image that no manifest lists",
                        counted(exported.unknown_images, "trial"));
    }
    base::log::info("in {}: {}, {} ({} simulated), {}", options.out.string(),
                    counted(exported.participants, "participant"),
                    counted(exported.sessions, "session"), exported.simulated,
                    counted(exported.trials, "trial"));
    return base::ExitCode::kDone;
}

std::function<base::ExitCode()> attach_export(const Options& app, const Globals& globals) {
    auto options = std::make_shared<ExportOptions>();
    std::vector<std::string> formats;
    for (const auto format : analysis::kExportFormats) formats.emplace_back(to_string(format));
    add_store(app, options->db);
    app.add("--out", options->out, "Folder for the files").folder().required();
    app.add("--format", options->format,
            "Kind of files: csv, tsv, json (JSON Lines), bids or psych-ds")
        .one_of(formats)
        .shows_default();
    app.add("STUDY", options->studies,
            "Study files or packages (.zip) to add, ones that the sessions began with; built-in "
            "ones are found without. Images and manifest are those of DATA/stimuli/STUDY");
    app.add_flag("--anonymous", options->anonymous,
                 "Leave out age, gender, times of day and place in the sequence, and number "
                 "participants anew in a shuffled order");
    app.add("--seed", options->seed,
            "Seed of that order, so that it can be had again (default: drawn anew)")
        .between(0, std::numeric_limits<std::int64_t>::max());
    app.add_flag("--force", options->force, "Replace an export and overwrite files that are there");
    return [options, &globals] { return export_answers(*options, globals); };
}

}  // namespace

Command export_command() {
    return {"export", "Write the answers as tables with a data dictionary", attach_export};
}

}  // namespace obscura::app
