// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/package/package.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/hash.h"
#include "renderer/base/version.h"
#include "stimuli/manifest.h"
#include "stimuli/package/licence.h"
#include "stimuli/package/zip.h"
#include "stimuli/scenes/open_scene.h"
#include "stimuli/stimulus.h"

namespace obscura::stimuli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Contents = std::map<std::string, std::string>;  ///< bytes by name

constexpr int kFormat = 1;
constexpr std::string_view kList = "package.json";
constexpr std::string_view kStudyFolder = "study/";
constexpr std::string_view kImageFolder = "stimuli/";
constexpr std::string_view kReadMe =
    "A study of Obscura, packed by `obscura pack`: the study file with its scenes in study/, the\n"
    "images and their manifest in stimuli/, and in package.json the hash of every file and the\n"
    "licence of every scene. Nothing has to be unpacked by hand:\n\n"
    "    obscura check FILE.zip               what is in it\n"
    "    obscura run FILE.zip                 shows it to people\n"
    "    obscura analyze FILE.zip             tests their answers\n"
    "    obscura render FILE.zip --verify     does this machine render the same images?\n";

/// A relative path of the file below the folder; empty where it lies elsewhere.
std::string below(const fs::path& folder, const fs::path& file) {
    const auto whole = [](const fs::path& path) {
        return fs::weakly_canonical(fs::absolute(path.empty() ? "." : path));
    };
    const std::string name = whole(file).lexically_relative(whole(folder)).generic_string();
    return is_inside(name) ? name : "";
}

/// The scenes' own files and those that they name, under study/. What cannot go along is a problem.
void add_scenes(const Study& study, Contents& contents, std::vector<std::string>& problems) {
    for (const StudyScene& scene : study.scenes) {
        for (const renderer::ImportedFile& file : scene.files) {
            const std::string name = below(study.folder, file.path);
            if (name.empty()) {
                problems.push_back(fmt::format(
                    "scene {}: {} lies outside the study's folder; copy it into there and name it "
                    "from there",
                    scene.id, file.path.string()));
                continue;
            }
            std::string bytes = base::read_file(file.path);
            if (base::sha256_hex(bytes) != file.sha256) {
                problems.push_back(fmt::format("scene {}: {} was changed meanwhile", scene.id,
                                               file.path.string()));
            }
            contents[std::string(kStudyFolder) + name] = std::move(bytes);
        }
    }
}

Json listed(const Contents& contents) {
    Json files = Json::array();
    for (const auto& [name, bytes] : contents) {
        files.push_back(
            {{"name", name}, {"bytes", bytes.size()}, {"sha256", base::sha256_hex(bytes)}});
    }
    return files;
}

Json to_json(const std::vector<SceneLicence>& licences) {
    Json scenes = Json::array();
    for (const SceneLicence& one : licences) {
        scenes.push_back({{"id", one.scene},
                          {"source", one.source},
                          {"licence", one.licence.empty() ? Json(nullptr) : Json(one.licence)},
                          {"said_by", one.said_by}});
    }
    return scenes;
}

std::vector<SceneLicence> licences_from(const Json& scenes) {
    std::vector<SceneLicence> licences;
    for (const Json& one : scenes) {
        const Json& licence = one.at("licence");
        licences.push_back({one.at("id"), one.at("source"),
                            licence.is_null() ? std::string() : licence.get<std::string>(),
                            one.at("said_by")});
    }
    return licences;
}

/// A package that was read and holds what it lists.
struct Opened {
    Package package;
    std::string study_file;  ///< its name without study/
    Contents contents;       ///< without the list
};

/// Every listed file is there and that of its hash, and nothing else is.
void hold_against_list(const Json& files, const Contents& contents, const std::string& where) {
    std::vector<std::string> problems;
    std::set<std::string> known;
    for (const Json& file : files) {
        const auto name = file.at("name").get<std::string>();
        known.insert(name);
        const auto found = contents.find(name);
        if (found == contents.end()) {
            problems.push_back(fmt::format("{}: {} is missing", where, name));
            continue;
        }
        const std::string met = base::sha256_hex(found->second);
        if (met != file.at("sha256")) {
            problems.push_back(fmt::format("{}: {} was changed: its SHA-256 is {}, {} says {}",
                                           where, name, met, kList,
                                           file.at("sha256").get<std::string>()));
        }
    }
    for (const auto& [name, bytes] : contents) {
        if (!known.contains(name)) {
            problems.push_back(fmt::format("{}: {} does not list {}", where, kList, name));
        }
    }
    if (!problems.empty()) throw base::bad_input("{}", fmt::join(problems, "\n"));
}

Opened open_package(const fs::path& file) {
    const std::string where = file.string();
    Opened opened;
    for (ArchivedFile& one : ZipReader(file).read_all()) {
        opened.contents.emplace(std::move(one.name), std::move(one.bytes));
    }
    const auto list = opened.contents.extract(std::string(kList));
    if (list.empty()) {
        throw base::bad_input("{}: it holds no {}: it was not made by obscura pack", where, kList);
    }
    try {
        const Json json = Json::parse(list.mapped());
        const int format = json.at("format");
        if (format != kFormat) {
            throw base::bad_input("its format is {}, this program reads {}", format, kFormat);
        }
        opened.package.study = json.at("study").at("name");
        opened.study_file = json.at("study").at("file");
        opened.package.program = json.at("program");
        opened.package.gpu_renderer = json.at("gpu_renderer");
        opened.package.licences = licences_from(json.at("scenes"));
        opened.package.files = opened.contents.size();
        hold_against_list(json.at("files"), opened.contents, where);
    } catch (const nlohmann::json::exception& error) {
        throw base::bad_input("{}: {}: {}", where, kList, error.what());
    } catch (const base::Error& error) {
        if (std::string_view(error.what()).starts_with(where)) throw;
        throw base::bad_input("{}: {}: {}", where, kList, error.what());
    }
    return opened;
}

/// The study's file is one of those, has no problem of its own, and finds each scene's file.
Study study_in(const Opened& opened, const std::string& where) {
    const auto text = opened.contents.find(std::string(kStudyFolder) + opened.study_file);
    if (opened.study_file.find('/') != std::string::npos || text == opened.contents.end()) {
        throw base::bad_input("{}: {}: there is no study file \"{}\" in {}", where, kList,
                              opened.study_file, kStudyFolder);
    }
    Study study = parse_study(text->second, fmt::format("{}: {}", where, opened.study_file), {},
                              SceneFiles::kTrusted);
    if (study.name != opened.package.study) {
        throw base::bad_input("{}: {} is of the study {}, its study file of {}", where, kList,
                              opened.package.study, study.name);
    }
    for (const StudyScene& scene : study.scenes) {
        const auto require = [&](const std::string& name) {
            if (name.empty() || opened.contents.contains(std::string(kStudyFolder) + name)) return;
            throw base::bad_input("{}: scene {}: {} is missing", where, scene.id, name);
        };
        require(is_file_source(scene.source)
                    ? fs::path(scene.source).lexically_normal().generic_string()
                    : "");
        require(scene.settings.environment.lexically_normal().generic_string());
    }
    return study;
}

/// The images are those that the study asks for and the manifest lists.
void require_images(const Study& study, const Opened& opened, const std::string& where) {
    const auto bytes_of = [&](const std::string& name) -> const std::string& {
        const auto found = opened.contents.find(std::string(kImageFolder) + name);
        if (found == opened.contents.end()) {
            throw base::bad_input("{}: {}{} is missing", where, kImageFolder, name);
        }
        return found->second;
    };
    const Manifest manifest =
        parse_manifest(bytes_of("manifest.json"), fmt::format("{}: manifest.json", where));
    if (manifest.study != study.name) {
        throw base::bad_input("{}: manifest.json is of the study {}, not of {}", where,
                              manifest.study, study.name);
    }
    for (const Stimulus& stimulus : stimuli_of(study)) {
        const ManifestImage* entry =
            manifest.find(stimulus.condition->id, std::string(1, stimulus.side));
        if (entry == nullptr || !shows_what_is_asked(study, *entry)) {
            throw base::bad_input("{}: manifest.json has no image {} as the study asks for it",
                                  where, stimulus.file());
        }
        if (base::sha256_hex(bytes_of(entry->file)) != entry->sha256) {
            throw base::bad_input("{}: {} is not the image that manifest.json lists", where,
                                  entry->file);
        }
    }
}

/// Where a file of the package lies in a data folder; empty: it stays in the package.
fs::path place_of(const std::string& name, const Unpacked& unpacked) {
    if (name.starts_with(kStudyFolder)) {
        return unpacked.study.parent_path() / name.substr(kStudyFolder.size());
    }
    if (name.starts_with(kImageFolder)) return unpacked.images / name.substr(kImageFolder.size());
    return {};
}

/// Files that are not there yet; one that is another is a problem.
std::vector<std::pair<fs::path, const std::string*>> missing_files(const Opened& opened,
                                                                   const Unpacked& unpacked,
                                                                   const std::string& where) {
    std::vector<std::pair<fs::path, const std::string*>> missing;
    for (const auto& [name, bytes] : opened.contents) {
        const fs::path place = place_of(name, unpacked);
        std::error_code ignored;
        if (place.empty()) continue;
        if (!fs::exists(fs::symlink_status(place, ignored))) {
            missing.emplace_back(place, &bytes);
        } else if (!fs::is_regular_file(place, ignored) || base::read_file(place) != bytes) {
            throw base::bad_input(
                "{}: {} is there and is another one than the package's; name another folder for "
                "this package with --data",
                where, place.string());
        }
    }
    // The list of the images comes last: images without it are not taken for finished ones.
    std::stable_partition(missing.begin(), missing.end(), [](const auto& file) {
        return file.first.filename() != "manifest.json";
    });
    return missing;
}

}  // namespace

bool is_package(const std::string& word) { return word.ends_with(".zip"); }

Package pack(const StudySource& source, const fs::path& images, const fs::path& out) {
    const Study study = parse_study(source.text, source.name, source.folder);
    std::vector<std::string> problems = problems_of_stimuli(study, images);
    if (!is_package(out.string())) {
        problems.push_back(fmt::format("--out: \"{}\" does not end in .zip", out.string()));
    }
    Contents contents;
    add_scenes(study, contents, problems);
    if (!problems.empty()) throw base::bad_input("{}", fmt::join(problems, "\n"));

    const std::string manifest = base::read_file(images / "manifest.json");
    for (const ManifestImage& image : load_manifest(images / "manifest.json").images) {
        contents[std::string(kImageFolder) + image.file] = base::read_file(images / image.file);
    }
    contents[std::string(kImageFolder) + "manifest.json"] = manifest;
    std::string study_file = fs::path(source.name).filename().string();
    if (!study_file.ends_with(".toml")) study_file += ".toml";  // a built-in study
    contents[std::string(kStudyFolder) + study_file] = source.text;
    contents["README.txt"] = kReadMe;

    const Package package{study.name, base::program_version(),
                          load_manifest(images / "manifest.json").gpu_renderer,
                          licences_of(study, source.text), contents.size()};
    const Json list = {
        {"format", kFormat},
        {"program", package.program},
        {"study", {{"name", study.name}, {"title", study.title}, {"file", study_file}}},
        {"gpu_renderer", package.gpu_renderer},
        {"scenes", to_json(package.licences)},
        {"files", listed(contents)}};
    std::vector<ArchivedFile> files{{std::string(kList), list.dump(2) + "\n"}};
    for (auto& [name, bytes] : contents) files.push_back({name, std::move(bytes)});
    write_zip(out, files);
    return package;
}

Unpacked unpack(const fs::path& package, const fs::path& data) {
    const std::string where = package.string();
    const Opened opened = open_package(package);
    const Study study = study_in(opened, where);
    require_images(study, opened, where);
    const Unpacked unpacked{opened.package, data / "packages" / study.name / opened.study_file,
                            stimuli_folder(data, study)};
    for (const auto& [place, bytes] : missing_files(opened, unpacked, where)) {
        base::write_file_atomically(place, *bytes);
    }
    return unpacked;
}

}  // namespace obscura::stimuli
