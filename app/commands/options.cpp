// SPDX-FileCopyrightText: 2026 The Obscura authors
// SPDX-License-Identifier: MIT
#include "app/commands/options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <type_traits>

#include "renderer/base/error.h"

namespace obscura::app {

Option Option::required() const { return Option(*option_->required()); }
Option Option::shows_default() const { return Option(*option_->capture_default_str()); }
Option Option::type(const std::string& word) const { return Option(*option_->type_name(word)); }
Option Option::one_of(const std::vector<std::string>& words) const {
    return Option(*option_->check(CLI::IsMember(words)));
}
Option Option::between(std::int64_t least, std::int64_t most) const {
    return Option(*option_->check(CLI::Range(least, most)));
}
Option Option::existing_folder() const { return Option(*option_->check(CLI::ExistingDirectory)); }
Option Option::comma_separated() const { return Option(*option_->delimiter(',')); }
Option Option::repeatable() const { return Option(*option_->allow_extra_args(false)); }
Option Option::value_optional() const { return Option(*option_->expected(0, 1)); }
Option Option::needs(const Option& other) const { return Option(*option_->needs(other.option_)); }
Option Option::excludes(const std::vector<Option>& others) const {
    for (const Option& other : others) option_->excludes(other.option_);
    return *this;
}

template <class T>
Option Options::add(const std::string& name, T& value, const std::string& what) const {
    const Option option(*app_->add_option(name, value, what));
    if constexpr (std::is_same_v<T, std::filesystem::path> ||
                  std::is_same_v<T, std::vector<std::filesystem::path>>) {
        return option.type("PATH");
    } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::vector<double>>) {
        return option.type("NUMBER");
    } else if constexpr (!std::is_same_v<T, std::string> &&
                         !std::is_same_v<T, std::vector<std::string>>) {
        return option.type("N");
    } else {
        return option;
    }
}
template Option Options::add(const std::string&, std::string&, const std::string&) const;
template Option Options::add(const std::string&, std::filesystem::path&, const std::string&) const;
template Option Options::add(const std::string&, std::uint64_t&, const std::string&) const;
template Option Options::add(const std::string&, int&, const std::string&) const;
template Option Options::add(const std::string&, double&, const std::string&) const;
template Option Options::add(const std::string&, std::optional<int>&, const std::string&) const;
template Option Options::add(const std::string&, std::optional<std::int64_t>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::optional<std::uint64_t>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<std::string>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<std::filesystem::path>&,
                             const std::string&) const;
template Option Options::add(const std::string&, std::vector<int>&, const std::string&) const;
template Option Options::add(const std::string&, std::vector<double>&, const std::string&) const;

Option Options::add_flag(const std::string& name, bool& value, const std::string& what) const {
    return Option(*app_->add_flag(name, value, what));
}
void Options::footer(const std::string& text) const { app_->footer(text); }
Options Options::add_command(const std::string& name, const std::string& what) const {
    return Options(*app_->add_subcommand(name, what));
}
void Options::require_command() const { app_->require_subcommand(1); }
void Options::when_given(const std::function<void()>& act) const { app_->callback(act); }

CommandLine::CommandLine(const std::string& what, const std::string& program,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(what, program)) {
    app_->set_version_flag("--version", version);
    app_->fallthrough();
}
CommandLine::~CommandLine() = default;

Options CommandLine::options() const { return Options(*app_); }

namespace {

DescribedCommand described_app(const CLI::App& app) {
    DescribedCommand command{app.get_name(), app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option* option : app.get_options()) {
        DescribedOption one;
        one.by_place = option->get_positional();
        for (const std::string& name : option->get_snames()) one.names.push_back("-" + name);
        for (const std::string& name : option->get_lnames()) one.names.push_back("--" + name);
        if (one.by_place) one.names = {option->get_name(true)};
        if (option->get_expected_max() > 0) one.value = option->get_type_name();
        one.what = option->get_description();
        if (const std::string standard = option->get_default_str(); !standard.empty()) {
            one.what += " (default: " + standard + ")";
        }
        command.options.push_back(std::move(one));
    }
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        command.commands.push_back(described_app(*sub));
    }
    return command;
}

}  // namespace

DescribedCommand CommandLine::described() const { return described_app(*app_); }

bool CommandLine::parse(std::vector<std::string> words) {
    std::reverse(words.begin(), words.end());
    try {
        app_->parse(std::move(words));
    } catch (const CLI::Success& asked) {
        app_->exit(asked);
        return false;
    } catch (const CLI::ParseError& error) {
        throw base::bad_input("{}\nRun with --help for more information.", error.what());
    }
    return true;
}

}  // namespace obscura::app
