// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "renderer/technique/variant_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "renderer/technique/technique.h"

namespace obscura::renderer {
namespace {

/// Everything that can differ between two choices with the same technique and samples, as words, in
/// the order in which it is named.
std::vector<std::string> settings_of(const Variant& choice) {
    std::vector<std::string> settings;
    if (const Technique* technique = find_technique(choice.technique)) {
        const auto add = [&](const Parameter& parameter, const std::string& name) {
            settings.push_back(fmt::format("{} {}", name, choice.value_of(parameter)));
        };
        const Parameter* radius = technique->find_parameter("radius_m");
        if (radius != nullptr) add(*radius, "R");
        for (const Parameter& parameter : technique->parameters) {
            if (&parameter != radius) add(parameter, parameter.name);
        }
    }
    settings.push_back("denoise " + choice.denoise);
    for (const VariantOption& option : variant_options()) {
        settings.push_back(option.name + ' ' + choice.*option.value);
    }
    return settings;
}

/// Choices of one technique with as many samples, by their places in the list.
using Group = std::vector<std::size_t>;

class Namer {
  public:
    explicit Namer(const std::vector<Variant>& choices) {
        std::map<std::string, Group> alike;
        for (std::size_t i = 0; i < choices.size(); ++i) {
            names_.push_back(choices[i].variant_name());
            settings_.push_back(settings_of(choices[i]));
            alike[names_.back()].push_back(i);
        }
        for (const auto& [name, group] : alike) part(group, 0);
    }

    std::vector<std::string> take() { return std::move(names_); }

  private:
    /// Names what parts the group, from that setting on.
    void part(const Group& group, std::size_t setting) {
        if (setting == settings_[group.front()].size()) return;
        std::map<std::string, Group> parts;
        for (const std::size_t choice : group) {
            parts[settings_[choice][setting]].push_back(choice);
        }
        for (const auto& [words, own] : parts) {
            if (parts.size() > 1) {
                for (const std::size_t choice : own) names_[choice] += ' ' + words;
            }
            part(own, setting + 1);
        }
    }

    std::vector<std::string> names_;
    std::vector<std::vector<std::string>> settings_;  ///< of each choice, as many in a group
};

}  // namespace

std::vector<std::string> variant_names(const std::vector<Variant>& choices) {
    return Namer(choices).take();
}

}  // namespace obscura::renderer
