// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/export/export.h"

#include <fmt/format.h>

#include "analysis/export/formats.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/log.h"

namespace obscura::analysis {

std::string_view to_string(ExportFormat format) {
    switch (format) {
        case ExportFormat::kCsv:
            return "csv";
        case ExportFormat::kTsv:
            return "tsv";
        case ExportFormat::kJsonLines:
            return "json";
        case ExportFormat::kBids:
            return "bids";
        case ExportFormat::kPsychDs:
            return "psych-ds";
    }
    return "";
}

std::optional<ExportFormat> export_format_from(std::string_view name) {
    for (const ExportFormat format : kExportFormats) {
        if (to_string(format) == name) return format;
    }
    return std::nullopt;
}

void add_studies(const ExportJob& job, const std::string& folder) {
    for (const ExportedStudy& study : job.options.studies) {
        const std::string place = folder + '/' + study.name + '/';
        if (!study.file_text.empty()) job.folder.add(place + "study.toml", study.file_text);
        if (!study.manifest_text.empty()) {
            job.folder.add(place + "manifest.json", study.manifest_text);
        }
        for (const ExportedImage& image : study.images) {
            const std::filesystem::path file = study.image_folder / image.file;
            if (!std::filesystem::exists(file)) {
                base::log::warn("{} is not there: the export goes without it", file.string());
                continue;
            }
            const std::string bytes = base::read_file(file);
            const std::string sha256 = base::sha256_hex(bytes);
            if (sha256 != image.sha256) {
                throw base::bad_input("{}: its SHA-256 is {}, allowed is the manifest's {}",
                                      file.string(), sha256, image.sha256);
            }
            job.folder.add(place + image.file, bytes);
        }
    }
}

std::string readme_text(const ExportJob& job) {
    std::string text =
        "Answers of a psychophysical study: two images that differ only in their ambient\n"
        "occlusion are shown one after the other, and the observer chooses one of them.\n"
        "Ambient occlusion is the darkening of places that little light can reach.\n\n";
    for (const ExportedStudy& study : job.options.studies) {
        text +=
            fmt::format("Study {}{}{}\n", study.name, study.title.empty() ? "" : ": ", study.title);
        if (!study.question.empty()) text += fmt::format("Question: {}\n", study.question);
    }
    text += fmt::format(
        "\nRows whose kind is simulated were answered by a program, not by a person. Catch trials\n"
        "(attention checks) and rows with an entry in repeats are no votes. Only sessions whose\n"
        "state is completed are analysed: rows whose is_vote is 1 and whose excluded is 0. The\n"
        "scripts main_tests.R and main_tests.py repeat the main tests from the tables.\n\n"
        "Written by {}.\n",
        job.options.software);
    if (job.source.anonymous()) {
        text +=
            "Anonymous: age, gender, times of day and the place in the sequence of participants\n"
            "are left out, and participants and sessions are numbered anew in a random order.\n";
    }
    return text;
}

Exported export_store(Store& store, const ExportOptions& options) {
    Exported exported;
    ExportFolder folder(options.folder, options.overwrite);
    store.of_one_moment([&] {
        ExportSource source(store, options);
        const ExportJob job{options, source, folder, exported};
        switch (options.format) {
            case ExportFormat::kCsv:
            case ExportFormat::kTsv:
            case ExportFormat::kJsonLines:
                export_tables(job);
                break;
            case ExportFormat::kBids:
                export_bids(job);
                break;
            case ExportFormat::kPsychDs:
                export_psych_ds(job);
                break;
        }
    });
    store.require_whole();
    folder.keep();
    return exported;
}

}  // namespace obscura::analysis
