// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "analysis/registration.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "renderer/base/error.h"
#include "renderer/base/files.h"

namespace obscura::analysis {
namespace {

using RegistrationJson = nlohmann::ordered_json;

constexpr const char* kFence = "```json\n";
constexpr const char* kEndOfFence = "\n```";
constexpr int kFormat = 1;

RegistrationJson object_of(const std::string& text) {
    return text.empty() ? RegistrationJson() : RegistrationJson::parse(text);
}

std::string text_of_object(const RegistrationJson& object) {
    return object.is_null() ? "" : object.dump();
}

/// Whether two texts say the same, in whatever order a program wrote their keys.
bool is_same_json(const std::string& one, const std::string& other) {
    if (one.empty() || other.empty()) return one == other;
    return nlohmann::json::parse(one, nullptr, false) ==
           nlohmann::json::parse(other, nullptr, false);
}

void compare_study(const Registration& registration, const Tally& tally,
                   RegistrationResult& result) {
    if (tally.study != registration.study) {
        result.deviations.push_back(
            fmt::format("The answers are to the study {}, registered is {}.",
                        tally.study.empty() ? "of no name" : tally.study, registration.study));
    }
    std::vector<std::string> others;
    for (const std::string& sha256 : tally.study_files) {
        if (sha256 != registration.study_sha256) others.push_back(sha256.substr(0, 12));
    }
    if (!others.empty()) {
        result.deviations.push_back(
            fmt::format("Sessions were run with a study file other than the registered one "
                        "(SHA-256 {}..., registered {}...).",
                        fmt::join(others, "..., "), registration.study_sha256.substr(0, 12)));
    } else if (tally.study_files.empty()) {
        result.unknown.emplace_back("Which study file the sessions were run with is not known.");
    }
    if (!tally.plan.has_value() && !registration.study_plan.empty()) {
        result.deviations.push_back(
            fmt::format("The registered hypotheses and looks are not those of the sessions: {}.",
                        tally.plan.reason));
    } else if (tally.plan.has_value() && !is_same_json(tally.plan_text, registration.study_plan)) {
        result.deviations.emplace_back(
            "The hypotheses, their conditions, margins or roles, the looks or the sides that the "
            "sessions carry are not the registered ones.");
    }
    if (!is_same_json(tally.exclusion_text, registration.exclusion)) {
        result.deviations.push_back(
            fmt::format("The rule on whom to leave out is {}, registered is {}.",
                        tally.exclusion_text.empty() ? "none" : tally.exclusion_text,
                        registration.exclusion.empty() ? "none" : registration.exclusion));
    }
}

void compare_participants(const Registration& registration, const Tally& tally,
                          RegistrationResult& result) {
    const auto now = static_cast<std::int64_t>(tally.participants.size());
    if (now == registration.participants) return;
    if (tally.plan.has_value() && tally.plan->stopping) {
        const auto& looks = tally.plan->stopping->looks;
        if (std::find(looks.begin(), looks.end(), now) != looks.end()) return;
    }
    result.deviations.push_back(fmt::format(
        "{} participants completed the study, registered are {}.", now, registration.participants));
}

void compare_images(const Registration& registration, const Conducted& conducted,
                    RegistrationResult& result) {
    if (!conducted.images.has_value()) {
        result.unknown.push_back(
            fmt::format("Which images were shown is not known: {}.", conducted.images.reason));
        return;
    }
    std::vector<std::string> others;
    for (const auto& [file, hashes] : *conducted.images) {
        const auto registered = registration.images.find(file);
        const bool is_same =
            registered != registration.images.end() &&
            std::all_of(hashes.begin(), hashes.end(),
                        [&](const std::string& hash) { return hash == registered->second; });
        if (!is_same) others.push_back(file);
    }
    if (others.empty()) return;
    result.deviations.push_back(fmt::format(
        "Images were shown that are not the registered ones: {}.", fmt::join(others, ", ")));
}

Registration parsed_registration(const std::string& text) {
    const auto json = RegistrationJson::parse(text);
    if (json.at("format") != kFormat) throw std::invalid_argument("another format");
    Registration registration;
    registration.study = json.at("study").get<std::string>();
    registration.study_sha256 = json.at("study_sha256").get<std::string>();
    registration.study_plan = text_of_object(json.at("study_plan"));
    registration.exclusion = text_of_object(json.at("exclusion"));
    registration.participants = json.at("participants").get<std::int64_t>();
    registration.analysis_seed = json.at("analysis_seed").get<std::uint64_t>();
    registration.software = json.at("software").get<std::string>();
    registration.written_utc = json.at("written_utc").get<std::string>();
    registration.images = json.at("images").get<std::map<std::string, std::string>>();
    return registration;
}

}  // namespace

std::string registration_block(const Registration& registration) {
    const RegistrationJson json = {{"format", kFormat},
                                   {"study", registration.study},
                                   {"study_sha256", registration.study_sha256},
                                   {"study_plan", object_of(registration.study_plan)},
                                   {"exclusion", object_of(registration.exclusion)},
                                   {"participants", registration.participants},
                                   {"analysis_seed", registration.analysis_seed},
                                   {"software", registration.software},
                                   {"written_utc", registration.written_utc},
                                   {"images", registration.images}};
    return kFence + json.dump(2) + kEndOfFence + '\n';
}

Registration read_registration(const std::filesystem::path& document) {
    const std::string text = base::read_file(document);
    const std::size_t begin = text.rfind(kFence);
    const std::size_t end = begin == std::string::npos ? begin : text.find(kEndOfFence, begin);
    if (end == std::string::npos) {
        throw base::bad_input(
            "{}: it has no block ```json, allowed is a document that obscura plan --preregister "
            "wrote",
            document.string());
    }
    const std::size_t from = begin + std::string(kFence).size();
    try {
        return parsed_registration(text.substr(from, end - from));
    } catch (const std::exception& error) {
        throw base::bad_input(
            "{}: its block ```json is not one that obscura plan --preregister wrote: {}",
            document.string(), error.what());
    }
}

RegistrationResult compare_registration(const Registration& registration,
                                        const std::string& document, const Tally& tally,
                                        const Conducted& conducted) {
    RegistrationResult result;
    result.document = document;
    result.written_utc = registration.written_utc;
    compare_study(registration, tally, result);
    compare_participants(registration, tally, result);
    compare_images(registration, conducted, result);
    if (conducted.asks_validity) {
        result.deviations.emplace_back(
            "It is also asked whether the preference depends on validity, which is not "
            "registered.");
    }
    if (conducted.analysis_seed != registration.analysis_seed) {
        result.deviations.push_back(fmt::format("The seed of the analysis is {}, registered is {}.",
                                                conducted.analysis_seed,
                                                registration.analysis_seed));
    }
    if (conducted.software != registration.software) {
        result.deviations.push_back(fmt::format("The analysis is by {}, registered is {}.",
                                                conducted.software, registration.software));
    }
    return result;
}

std::string registration_words(const RegistrationResult& result) {
    std::string text =
        fmt::format("Pre-registered on {} in {}. ", result.written_utc, result.document);
    if (result.deviations.empty()) {
        text += "Nothing deviates from it.";
    } else {
        text += fmt::format("What deviates from it: {}", fmt::join(result.deviations, " "));
    }
    for (const std::string& unknown : result.unknown) text += ' ' + unknown;
    return text;
}

}  // namespace obscura::analysis
