// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "stimuli/variant_format.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <nlohmann/json.hpp>

#include "renderer/technique/technique.h"
#include "stimuli/table_reader.h"

namespace obscura::stimuli {
namespace {

using Need = TableReader::Need;
using renderer::Variant;
using renderer::VariantOption;

/// The keys of a variant whose technique is unknown are not judged: nobody knows what they mean.
void report_unknown_technique(TableReader& reader, const std::string& name) {
    std::vector<std::string> names;
    for (const renderer::Technique& technique : renderer::techniques()) {
        names.push_back(technique.name);
    }
    reader.add("technique", fmt::format("{} is unknown, allowed are {}{}", in_quotes(name),
                                        listed(names), did_you_mean(name, names)));
}

/// Without a technique any setting of any technique may be meant; only the rest is reported.
void allow_any_setting(TableReader& reader) {
    reader.allow("samples");
    reader.allow("denoise");
    reader.allow("preset");
    for (const VariantOption& option : renderer::variant_options()) reader.allow(option.name);
    for (const renderer::Technique& technique : renderer::techniques()) {
        for (const renderer::Parameter& parameter : technique.parameters) {
            reader.allow(parameter.name);
        }
    }
}

std::optional<std::string> read_option(TableReader& reader, const VariantOption& option) {
    if (!option.number) return reader.text(option.name, Need::kOptional);
    const std::optional<double> value = reader.number(option.name, Need::kOptional);
    return value ? std::optional(fmt::format("{}", *value)) : std::nullopt;
}

void read_settings(TableReader& reader, const renderer::Technique& technique, Variant& variant) {
    constexpr std::int64_t kMost = std::numeric_limits<int>::max();
    variant.samples = static_cast<int>(reader.integer("samples", Need::kOptional, -kMost, kMost)
                                           .value_or(technique.samples.standard));
    variant.denoise =
        reader.text("denoise", Need::kOptional).value_or(renderer::standard_denoise(technique));
    for (const VariantOption& option : renderer::variant_options()) {
        variant.*option.value = read_option(reader, option).value_or(option.standard());
    }
    for (const renderer::Parameter& parameter : technique.parameters) {
        const std::optional<double> value = reader.number(parameter.name, Need::kOptional);
        if (value) variant.parameters[parameter.name] = *value;
    }
    if (const auto preset = reader.text("preset", Need::kOptional)) {
        const std::string wrong = renderer::apply_preset(*preset, variant);
        if (!wrong.empty()) reader.add("preset", wrong);
    }
    for (const renderer::Technique& other : renderer::techniques()) {
        for (const renderer::Parameter& parameter : other.parameters) {
            reader.known_elsewhere(parameter.name, other.name);
        }
    }
    for (const renderer::VariantProblem& problem : renderer::problems_of(variant)) {
        reader.add(problem.key, problem.message);
    }
}

}  // namespace

std::string toml_float(double value) {
    char digits[40];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    std::string text(digits, end.ptr);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

Variant read_variant(const toml::table& table, const std::string& where,
                     std::vector<StudyProblem>& problems) {
    TableReader reader(table, where, problems);
    Variant variant;
    const std::optional<std::string> name = reader.text("technique", Need::kRequired);
    if (name) {
        variant.technique = *name;
        const renderer::Technique* technique = renderer::find_technique(*name);
        if (technique == nullptr) {
            report_unknown_technique(reader, *name);
            return variant;
        }
        read_settings(reader, *technique, variant);
    } else {
        allow_any_setting(reader);
    }
    reader.finish();
    return variant;
}

std::string to_toml(const Variant& variant) {
    std::string text = fmt::format("{{ technique = \"{}\"", variant.technique);
    const renderer::Technique* technique = renderer::find_technique(variant.technique);
    if (technique != nullptr && technique->samples.high > 0) {
        text += fmt::format(", samples = {}, denoise = \"{}\"", variant.samples, variant.denoise);
    }
    for (const auto& [name, value] : variant.parameters) {
        text += fmt::format(", {} = {}", name, toml_float(value));
    }
    for (const VariantOption& option : renderer::variant_options()) {
        const std::string& value = variant.*option.value;
        if (value == option.standard()) continue;
        text += option.number ? fmt::format(", {} = {}", option.name, value)
                              : fmt::format(", {} = \"{}\"", option.name, value);
    }
    return text + " }";
}

void put_variant(nlohmann::ordered_json& object, const Variant& variant) {
    object["technique"] = variant.technique;
    object["samples"] = variant.samples;
    object["parameters"] = variant.all_parameters();
    object["denoise"] = variant.denoise;
    for (const VariantOption& option : renderer::variant_options()) {
        const std::string& value = variant.*option.value;
        if (value != option.standard()) object[option.name] = value;
    }
}

Variant variant_from(const nlohmann::ordered_json& object) {
    Variant variant;
    object.at("technique").get_to(variant.technique);
    object.at("samples").get_to(variant.samples);
    object.at("parameters").get_to(variant.parameters);
    object.at("denoise").get_to(variant.denoise);
    for (const VariantOption& option : renderer::variant_options()) {
        variant.*option.value = object.value(option.name, option.standard());
    }
    return variant;
}

}  // namespace obscura::stimuli
